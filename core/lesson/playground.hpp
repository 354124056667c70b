// The course's playground: a lesson in which any points can be tried, and to which every other lesson leads with its
// own.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/session.hpp"

namespace snug::lesson {

/// The points that a lesson takes along to the playground, as they are on its stage: those of a cloud, or the farthest
/// of its first volume in many directions, which are a box's vertices. None if it has neither.
[[nodiscard]] std::optional<io::PointFile> points_to_try(const Session& session);

/// The words of the link: "Try every volume on these points".
[[nodiscard]] std::string_view playground_text(const Session& session);
/// Those of the link back: "Back to Ritter's sphere".
[[nodiscard]] std::string way_back_text(std::string_view title);

}  // namespace snug::lesson
