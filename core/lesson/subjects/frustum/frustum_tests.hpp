// The tests of a box against a frustum that a lesson can show, and their steps.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lesson/subjects/frustum/frustum_box.hpp"
#include "query/cull/classify_steps.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The volume of a lesson about a box and a frustum; about a ball; about a point.
inline constexpr std::string_view kFrustumBox = "frustum_box", kFrustumSphere = "frustum_sphere",
                                  kFrustumPoint = "frustum_point";

/// A step in 3-D; from 2-D it has z = 0, and vertices keep their bits.
using FrustumStep = query::ClassifyStep<double, 3>;
using FrustumTrace = std::vector<Recorder<FrustumStep>::Entry>;
using FrustumSteps = std::span<const Recorder<FrustumStep>::Entry>;

/// A box has "p_n_vertex", "corners_per_plane", and the wrong one, "corners_outside"; a ball "grown_planes" and the
/// wrong one, "wrong_sign"; a point "half_spaces".
[[nodiscard]] std::span<const Method> frustum_tests(std::string_view volume);
/// pair: with a frustum that can be made.
[[nodiscard]] FrustumTrace record_frustum(std::string_view test, const BoxPair& pair);

/// A ball's or a point's centre from a plane that was tested: positive outside, scene units.
[[nodiscard]] inline double center_distance(const query::PlaneTested<double, 3>& fact) {
  return fact.n_distance + (fact.p_distance - fact.n_distance) / 2;
}

/// What that test says.
[[nodiscard]] query::Culling verdict_of(std::string_view test, const BoxPair& pair);
[[nodiscard]] query::Culling verdict_of(FrustumSteps trace);

/// Whether the body and the frustum share a point: of a box and of a point exactly, of a ball within rounding. None if
/// the frustum is so thin that it has no vertices.
[[nodiscard]] std::optional<bool> share_a_point(const BoxPair& pair);

}  // namespace snug::lesson
