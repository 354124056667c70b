#pragma once

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

/// The algorithms that the lesson offers, in order, without those that cannot take so many points.
[[nodiscard]] std::vector<std::string> playable(const Session& session);

}  // namespace snug::lesson
