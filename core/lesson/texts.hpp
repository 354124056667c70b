// The texts of a lesson's file: the markup of prompts, reasons and hints, and the figures of the run in all of them.
#pragma once

#include <string>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

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

/// A figure in a text of the file.
struct PlacedFigure {
  RunFigure figure;
  FilePlace place;
  std::string_view key;   // of the text
  std::string algorithm;  // in whose run the text is read; empty: in any
  std::string situation;  // the same
};
[[nodiscard]] std::vector<PlacedFigure> figures_in(const toml::table& toml, const Lesson& lesson);

[[nodiscard]] bool is_among_figures(const std::vector<RunFigure>& figures, const RunFigure& one);

}  // namespace snug::lesson
