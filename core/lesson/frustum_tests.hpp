// The tests of a box against a frustum that a lesson can show.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "fit/catalogue.hpp"
#include "lesson/frustum_box.hpp"

namespace snug::lesson {

/// A lesson's volume where it has a box and a frustum in place of points.
inline constexpr std::string_view kFrustumBox = "frustum_box";

/// "p_n_vertex", "corners_per_plane", and the wrong one, "corners_outside". As box_tests() otherwise.
[[nodiscard]] std::span<const fit::Algorithm> frustum_tests();
/// pair: as places() accepts it.
[[nodiscard]] fit::Recording record_frustum(const fit::Algorithm& test, const BoxPair& pair);

/// What that test says of the box.
[[nodiscard]] query::Culling says_of_box(const fit::Algorithm& test, const BoxPair& pair);

/// Whether box and frustum share a point, exactly. None where the frustum is so thin that it has no corners.
[[nodiscard]] std::optional<bool> share_a_point(const BoxPair& pair);

}  // namespace snug::lesson
