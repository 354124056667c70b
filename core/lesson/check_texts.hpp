// Checks the markup of prompts, reasons and hints, and the figures of the run in all texts.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The run of one of the lesson's algorithms in a situation; null if it cannot take what stands there.
using RunOf = std::function<const Run*(const std::string& algorithm)>;

/// A situation that opened.
struct OpenSituation {
  std::string_view name;
  const Subject* own = nullptr;
  RunOf run_of;
};
/// The one of that name, the lesson's own for an empty name; null if it did not open.
[[nodiscard]] const OpenSituation* find_open(std::span<const OpenSituation> situations, std::string_view name);

/// A text of the file, with what it is about.
struct PlacedText {
  const toml::table* table;  // where it stands, and
  std::string_view key;
  const toml::table* of;  // the question or task that it belongs to
  /// How it is called: by its key, or "wrong".
  [[nodiscard]] std::string_view name() const { return table == of ? key : "wrong"; }
  /// Its situation and its algorithm, as the question or task says; empty for the default.
  [[nodiscard]] std::string_view situation() const;
  [[nodiscard]] std::string_view algorithm() const;
};
/// The texts of questions and tasks, and what questions say to wrong answers.
[[nodiscard]] std::vector<PlacedText> prompts_of(const toml::table& toml);

/// Complains about the markup of the texts of questions and tasks, and about figures of algorithms that the lesson does
/// not offer; collects the figures of the lesson. toml: the lesson's file, whose sections were read.
void read_texts(const toml::table& toml, Lesson& lesson, Complaints& complaints);

/// Complains about figures that the runs do not have: those of the situation that the text is about, or of any.
void check_figures(const Lesson& lesson, const toml::table& toml, std::span<const OpenSituation> situations,
                   Complaints& complaints);

/// Why there is no such figure: "is none of radius or excess: exces; did you mean excess?"; empty if there is one.
/// algorithm: in whose run it is shown, if it names none itself; empty: in that of any.
[[nodiscard]] std::string lack_of(const RunFigure& figure, const std::string& algorithm, const Lesson& lesson,
                                  const Subject& own, const RunOf& run_of);

}  // namespace snug::lesson
