// What a step of a test of a box against a frustum shows.
#pragma once

#include "app/shown.hpp"
#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::app {

struct FrustumShown : Shown {
  /// The plane that the step is about (lesson::plane_at), -1 for none, and the result of its test, which is hidden
  /// while a question asks about it.
  int plane_at = -1;
  std::optional<query::PlaneTested<double, 3>> plane;
  bool plane_asked = false;
  std::vector<Index> vertices;  // the plane's p-vertex, then its n-vertex; none while a question asks about it
  /// The vertices tested against that plane, or against all planes, the current one last.
  std::vector<query::CornerTested<double, 3>> corners;
  std::optional<query::Culling> verdict;  // the verdict so far
};

[[nodiscard]] FrustumShown frustum_shown_at(const lesson::Session& session);

/// The frustum's planes moved by the radius of a ball, of which the centre alone is then tested.
struct MovedPlanes {
  double by;    // outwards; negative: inwards, which is wrong
  bool tested;  // whether the chosen method tests against these
};
/// Outwards and inwards, the tested ones last; none for anything but a ball.
[[nodiscard]] std::vector<MovedPlanes> moved_planes(const lesson::Session& session);

}  // namespace snug::app
