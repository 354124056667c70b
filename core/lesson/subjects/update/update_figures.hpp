// The inspector's figures of an update.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/figures.hpp"
#include "lesson/subjects/update/update_run.hpp"

namespace snug::lesson {

/// Its looseness: how much larger the volume is than the tightest of its kind, in per cent.
inline constexpr std::string_view kUpdateSlack = "slack";

/// Keys: turn (2-D), cost, measure, slack, over_hull. All but the turn are known once the volume is updated. degrees:
/// how far the body is rotated.
[[nodiscard]] std::vector<Figure> update_figures(const UpdateRun& run, int step, double degrees);

/// Whether a volume is the tightest, but for rounding.
[[nodiscard]] bool is_tight(double slack);
/// "it is 35.0 % larger than the tightest"; from twice as large on, "it is 4.8 times the tightest (+385 %)".
[[nodiscard]] std::string looseness_words(double slack);

}  // namespace snug::lesson
