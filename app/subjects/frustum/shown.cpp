#include "app/subjects/frustum/shown.hpp"

#include "lesson/subjects/frustum/frustum_figures.hpp"

namespace snug::app {
namespace {

using Corner = query::CornerTested<double, 3>;

/// The vertices tested for the current plane, or for all planes: they are tested in order.
std::vector<Corner> corners_tested(lesson::FrustumSteps up_to) {
  std::vector<Corner> corners;
  for (; !up_to.empty(); up_to = up_to.first(up_to.size() - 1)) {
    const auto* corner = std::get_if<Corner>(&up_to.back().step.fact);
    if (corner == nullptr || (!corners.empty() && corner->corner >= corners.front().corner)) break;
    corners.insert(corners.begin(), *corner);
  }
  return corners;
}

/// Fills in what has a picture of its own.
struct FrustumFiller {
  FrustumShown& shown;
  lesson::FrustumSteps steps;  // up to and with this one
  const lesson::Session& session;

  void operator()(const auto&) const { shown.spoken_of = named_now(session); }
  void operator()(const query::PlaneTested<double, 3>& fact) const {
    shown.plane = fact;
    shown.verdict = fact.so_far;
    for (const int corner : {fact.p_vertex, fact.n_vertex})
      if (corner >= 0)
        shown.vertices.push_back(
            lesson::index_of(session.stage().subject().dim(), {lesson::BoxHandle::Kind::kCorner, 0, corner}));
  }
  void operator()(const Corner&) const { shown.corners = corners_tested(steps); }
  /// Keeps the plane that the whole box is outside of. Without such a plane, the vertices tested last mean nothing, and
  /// are dropped.
  void operator()(const query::Classified& fact) const {
    const lesson::FrustumSteps before = steps.first(steps.size() - 1);
    const std::size_t once = std::size_t{1} << session.stage().subject().dim();
    if (fact.result.rejected_by >= 0 || before.size() <= once) shown.corners = corners_tested(before);
    const auto* plane = last_fact<query::PlaneTested<double, 3>>(steps);
    if (plane != nullptr && fact.result.rejected_by >= 0) (*this)(*plane);
    shown.verdict = fact.result.verdict;
  }
};

/// While a question about a plane is open, shows only the plane, and hides the answer.
void show_plane_asked(FrustumShown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  if (asked == nullptr) return;
  if (session.telling().asked_figure() == "verdict") shown.verdict.reset();
  const auto& fact = lesson::frustum_run(session.player().run(0)).trace()[asked->fact].step.fact;
  const auto* plane = std::get_if<query::PlaneTested<double, 3>>(&fact);
  if (plane == nullptr) return;
  shown.plane = *plane;
  shown.plane_at = plane->plane;
  shown.plane_asked = true;
  shown.vertices.clear();
}

}  // namespace

FrustumShown frustum_shown_at(const lesson::Session& session) {
  FrustumShown shown{shown_at(session)};
  const lesson::FrustumSteps steps =
      lesson::frustum_run(session.player().run(0)).trace().first(session.player().step());
  if (!steps.empty()) {
    shown.plane_at = lesson::plane_at(steps);
    std::visit(FrustumFiller{shown, steps, session}, steps.back().step.fact);
  }
  show_plane_asked(shown, session);
  return shown;
}

std::vector<MovedPlanes> moved_planes(const lesson::Session& session) {
  const lesson::BoxPair& pair = lesson::boxes_of(session.stage().subject());
  if (pair.form != lesson::Form::kBall) return {};
  const double radius = pair.boxes[0].half_extents[0];
  if (session.player().method(0)->name == "wrong_sign") return {{radius, false}, {-radius, true}};
  return {{-radius, false}, {radius, true}};
}

}  // namespace snug::app
