// The names of volumes: for a ball, a student reads "circle" in the plane and "sphere" in space.
#pragma once

#include <string>
#include <string_view>

#include "geometry/vector.hpp"

namespace snug::lesson {

[[nodiscard]] inline const char* ball_word(int dim) { return dim == 2 ? "circle" : "sphere"; }

/// "circle", "sphere", "box", "capsule" …
/// name: one of kVolumeNames.
[[nodiscard]] std::string_view volume_word(std::string_view name, int dim);

/// A text written for the plane, in words for another dimension: in space, its circles are spheres.
[[nodiscard]] std::string in_words_of(int dim, std::string_view text);

/// The name of a k-DOP's direction, "+x−y"; and of its axis, "x−y".
[[nodiscard]] std::string direction_name(const Vector<double, 3>& direction);
[[nodiscard]] std::string axis_name(const Vector<double, 3>& direction);
/// The text, which is not empty, with a capital letter first.
[[nodiscard]] std::string capital(std::string text);

}  // namespace snug::lesson
