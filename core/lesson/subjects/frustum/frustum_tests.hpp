// The tests of a box against a frustum that a lesson can show, and their steps.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lesson/subjects/frustum/frustum_box.hpp"
#include "query/classify_steps.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The volume of a lesson about a box and a frustum.
inline constexpr std::string_view kFrustumBox = "frustum_box";

/// A step in 3-D; from 2-D it has z = 0, and vertices keep their bits.
using FrustumStep = query::ClassifyStep<double, 3>;
using FrustumTrace = std::vector<Recorder<FrustumStep>::Entry>;
using FrustumSteps = std::span<const Recorder<FrustumStep>::Entry>;

/// "p_n_vertex", "corners_per_plane", and the wrong one, "corners_outside".
[[nodiscard]] std::span<const Method> frustum_tests();
/// pair: with a frustum that can be made.
[[nodiscard]] FrustumTrace record_frustum(std::string_view test, const BoxPair& pair);

/// What that test says of the box.
[[nodiscard]] query::Culling says_of_box(std::string_view test, const BoxPair& pair);

/// Whether the box and the frustum share a point, exactly. None if the frustum is so thin that it has no vertices.
[[nodiscard]] std::optional<bool> share_a_point(const BoxPair& pair);

}  // namespace snug::lesson
