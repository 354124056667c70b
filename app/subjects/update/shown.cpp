#include "app/subjects/update/shown.hpp"

#include "fit/catalogue.hpp"

namespace snug::app {
namespace {

constexpr Index kMostOfHullShown = 400;  // of more points the hull's edges are a blur

/// Follows the facts up to a step.
struct UpdateTeller {
  UpdateShown& shown;
  const lesson::UpdateRun& run;

  void operator()(const auto&) const {}
  void operator()(const fit::ReachFound& fact) const {
    shown.farthest = fact.point;
    shown.spoken_of = {fact.point};
  }
  void operator()(const lesson::PointPlaced& fact) const { shown.spoken_of = {fact.point}; }
  void operator()(const fit::NeighborsCompared& fact) const {
    const bool goes_on = shown.climb && !shown.climb->over;
    if (!goes_on) shown.climb.emplace();
    UpdateShown::Climb& climb = *shown.climb;
    climb.axis = fact.axis, climb.greatest = fact.greatest;
    climb.vertex = fact.vertex, climb.best = fact.best, climb.neighbors = fact.neighbors;
    if (fact.best != fact.vertex) climb.edges.push_back({fact.vertex, fact.best});
  }
  void operator()(const fit::ExtremeClimbed& fact) const {
    shown.climb->over = true;
    shown.climb->vertex = shown.climb->best = fact.path.back();
    shown.climb->neighbors.clear();
    const Point3 axis = run.axis(fact.axis);
    shown.bounds.push_back({axis, axis.dot(run.placed(fact.path.back())), true});
  }
  void operator()(const fit::BoundsRotated& fact) const {
    for (const double at : {fact.min, fact.max}) shown.bounds.push_back({run.axis(fact.axis), at, true});
  }
  void operator()(const lesson::VolumeUpdated&) const { shown.climb.reset(), shown.bounds.clear(); }
};

/// While a question about a climb is open, shows where the climb is, and not what it finds there.
void show_climb_asked(UpdateShown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  if (asked == nullptr) return;
  const lesson::BodyStep::Fact& fact = shown.run->trace()[asked->fact].step.fact;
  if (asked->fact != session.player().step() || !std::holds_alternative<fit::NeighborsCompared>(fact)) return;
  UpdateTeller{shown, *shown.run}(*std::get_if<fit::NeighborsCompared>(&fact));
  UpdateShown::Climb& climb = *shown.climb;
  climb.neighbors.clear();
  if (climb.best != climb.vertex) climb.edges.pop_back();
  climb.best = climb.vertex;
}

std::optional<Polytope> hull_in_world(const lesson::UpdateSubject& body) {
  if (lesson::count_of(body) > kMostOfHullShown) return std::nullopt;
  const fit::Result found = fit::find_algorithm("hull", "quickhull")->fit(*body.points(), {});
  Polytope hull = polytope_of(*std::get_if<ConvexHull<double, 3>>(&found.volume), body.dim());
  for (Point3& corner : hull.corners) corner = placed(body.pose(), corner);
  return hull;
}

}  // namespace

UpdateShown update_shown_at(const lesson::Session& session) {
  UpdateShown shown{shown_at(session)};
  shown.body = &lesson::body_of(session.stage().subject());
  shown.run = &lesson::update_run(session.player().run(0));
  shown.hull = hull_in_world(*shown.body);
  const UpdateTeller teller{shown, *shown.run};
  for (int i = 0; i < session.player().step(); ++i) {
    for (UpdateShown::Bound& bound : shown.bounds) bound.fresh = false;
    shown.spoken_of.clear();
    std::visit(teller, shown.run->trace()[i].step.fact);
  }
  show_climb_asked(shown, session);
  return shown;
}

}  // namespace snug::app
