// What a lesson can offer to its student: algorithms that fit, tests, updates, by the lesson's volume.
#pragma once

#include <span>
#include <string_view>

#include "fit/catalogue.hpp"

namespace snug::lesson {

/// Whether a lesson's volume has boxes in place of points: kBoxPair or kFrustumBox.
[[nodiscard]] bool has_boxes(std::string_view volume);

/// box_tests() of kBoxPair, frustum_tests() of kFrustumBox, scene_methods() of kScene, fit::algorithms_of of any other.
[[nodiscard]] std::span<const fit::Algorithm> methods_of(std::string_view volume);
[[nodiscard]] const fit::Algorithm* find_method(std::string_view volume, std::string_view name);

}  // namespace snug::lesson
