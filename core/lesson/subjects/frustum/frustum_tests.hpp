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

/// A lesson's volume where it has a box and a frustum.
inline constexpr std::string_view kFrustumBox = "frustum_box";

/// In 3-D: in 2-D z is 0, and vertices keep their bits.
using FrustumStep = query::ClassifyStep<double, 3>;
using FrustumTrace = std::vector<Recorder<FrustumStep>::Entry>;
using FrustumSteps = std::span<const Recorder<FrustumStep>::Entry>;

/// "p_n_vertex", "corners_per_plane", and the wrong one, "corners_outside".
[[nodiscard]] std::span<const Method> frustum_tests();
/// pair: with a frustum that can be made.
[[nodiscard]] FrustumTrace record_frustum(std::string_view test, const BoxPair& pair);

/// What that test says of the box.
[[nodiscard]] query::Culling says_of_box(std::string_view test, const BoxPair& pair);

/// Whether box and frustum share a point, exactly. None where the frustum is so thin that it has no corners.
[[nodiscard]] std::optional<bool> share_a_point(const BoxPair& pair);

}  // namespace snug::lesson
