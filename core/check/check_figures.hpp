// Checks the figures of the run in a lesson's texts.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "lesson/subject.hpp"
#include "lesson/texts.hpp"

namespace snug::check {

using namespace lesson;

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

/// Complains about figures that the runs do not have: those of the situation that the text is about, or of any.
void check_figures(const Lesson& lesson, const toml::table& toml, std::span<const OpenSituation> situations,
                   Complaints& complaints);

}  // namespace snug::check
