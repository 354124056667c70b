#include "lesson/subjects/update/update_run.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "fit/catalogue.hpp"
#include "geometry/kdop.hpp"
#include "lesson/fact_run.hpp"
#include "lesson/subjects/update/entries.hpp"
#include "lesson/subjects/update/update.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {

template class FactRun<UpdateRun, BodyStep>;

namespace {

constexpr Index kMostPointsOfBody = 4000;  // of a body whose update is computed again in each frame of a drag

/// The name of an update in lessons. That of a sphere and that of an OBB, both called "transform", are the volume's.
std::string_view lesson_name(const fit::UpdateStrategy& strategy) {
  return strategy.name == "transform" ? strategy.volume : strategy.name;
}

std::vector<Method> methods_of_updates() {
  std::vector<Method> all;
  for (const fit::UpdateStrategy& strategy : fit::update_strategies())
    all.push_back({.volume = kUpdateVolume,
                   .name = lesson_name(strategy),
                   .title = strategy.title,
                   .source = strategy.source,
                   .pseudocode = strategy.pseudocode,
                   .max_points = kMostPointsOfBody,
                   .plane = strategy.plane,
                   .space = strategy.space});
  return all;
}

/// The point that each vertex of the body's hull is, in the hull's order, which is that of climbs.
std::vector<Index> points_of_hull(const AnyPointSet& points) {
  const fit::Result found = fit::find_algorithm("hull", "quickhull")->fit(points, {});
  std::vector<Index> all;
  for (const Point3& vertex : std::get_if<ConvexHull<double, 3>>(&found.volume)->vertices) {
    Index point = 0;
    while (fit::point_of(points, point) != vertex) ++point;  // its coordinates are copies of the point's
    all.push_back(point);
  }
  return all;
}

/// Says in a lesson's facts what an update says in its own.
struct LessonWords {
  const std::vector<Index>& hull;  // empty where no climb names its vertices

  [[nodiscard]] Index point(Index vertex) const { return hull.empty() ? vertex : hull[vertex]; }
  [[nodiscard]] std::vector<Index> points(std::vector<Index> vertices) const {
    for (Index& vertex : vertices) vertex = point(vertex);
    return vertices;
  }

  BodyStep::Fact operator()(const auto& fact) const { return fact; }
  BodyStep::Fact operator()(const fit::BoxWidened& fact) const { return PointPlaced{fact.point}; }
  BodyStep::Fact operator()(fit::NeighborsCompared fact) const {
    fact.vertex = point(fact.vertex), fact.best = point(fact.best);
    fact.neighbors = points(std::move(fact.neighbors));
    return fact;
  }
  BodyStep::Fact operator()(fit::ExtremeClimbed fact) const {
    fact.path = points(std::move(fact.path));
    return fact;
  }
  BodyStep::Fact operator()(const fit::Finished& fact) const {
    std::vector<Index> support = points({fact.support.begin(), fact.support.end()});
    std::sort(support.begin(), support.end());
    support.erase(std::unique(support.begin(), support.end()), support.end());
    return VolumeUpdated{std::move(support)};
  }
};

bool climbs_over_hull(const fit::UpdateStrategy& strategy) { return strategy.name.ends_with("hill_climb"); }

}  // namespace

std::span<const Method> body_update_methods() {
  static const std::vector<Method> all = methods_of_updates();
  return all;
}

const fit::UpdateStrategy& strategy_of(const Method& method) {
  return *std::find_if(fit::update_strategies().begin(), fit::update_strategies().end(),
                       [&](const fit::UpdateStrategy& one) { return lesson_name(one) == method.name; });
}

UpdateRecording record_update(const fit::UpdateStrategy& strategy, const AnyPointSet& points, const Pose3& was,
                              const Pose3& now) {
  UpdateRecording recording;
  if (climbs_over_hull(strategy)) recording.corners = points_of_hull(points);
  const LessonWords words{recording.corners};
  const auto keep = [&](const fit::UpdateStep3& step) {
    recording.steps.push_back({{step.line, step.has_volume, step.volume, std::visit(words, step.fact)}, {}});
  };
  const fit::UpdateBody body = fit::start_updates(strategy, points);
  // Of the frame before, only what is done once for all frames is kept.
  body(was, [&](const fit::UpdateStep3& step) {
    if (std::holds_alternative<fit::ReachFound>(step.fact)) keep(step);
  });
  recording.frame = body(now, keep);
  if (!recording.steps.empty()) recording.steps.back().counts = recording.frame.counts;
  std::sort(recording.corners.begin(), recording.corners.end());
  return recording;
}

Point3 UpdateRun::axis(int axis) const {
  if (strategy_.k == 0) return Point3::Unit(axis);
  Point3 direction = Point3::Zero();
  const std::size_t slab = axis;
  for (int i = 0; i < dim(); ++i)
    direction[i] = dim() == 2 ? kdop_axes<2>(strategy_.k)[slab][i] : kdop_axes<3>(strategy_.k)[slab][i];
  return direction;
}

std::vector<Index> UpdateRun::support(int steps) const {
  std::vector<Index> all;
  for (int i = 0; i < steps; ++i) {
    const BodyStep::Fact& fact = trace()[i].step.fact;
    if (const auto* climbed = std::get_if<fit::ExtremeClimbed>(&fact)) all.push_back(climbed->path.back());
    if (const auto* updated = std::get_if<VolumeUpdated>(&fact)) return updated->support;
  }
  return all;
}

std::vector<Index> UpdateRun::candidates(int i) const {
  if (std::holds_alternative<fit::NeighborsCompared>(trace()[i].step.fact)) return recording_.corners;
  std::vector<Index> all(fit::count_of(points_));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

std::string UpdateRun::Where::axis(int axis) const { return axis_name(run.axis(axis)); }
std::string UpdateRun::Where::side(int axis, bool greatest) const {
  return direction_name(greatest ? run.axis(axis) : Point3(-run.axis(axis)));
}

std::string UpdateRun::Where::volume() const {
  const fit::UpdateStrategy& own = run.strategy();
  if (own.k > 0) return std::to_string(own.k) + "-DOP";
  return own.volume == "aabb" ? "AABB" : own.volume == "obb" ? "OBB" : ball_word(run.dim());
}

bool UpdateRun::Where::begins_climb() const {
  const auto* now = std::get_if<fit::NeighborsCompared>(&step().fact);
  const auto* before = i > 0 ? std::get_if<fit::NeighborsCompared>(&run.trace()[i - 1].step.fact) : nullptr;
  return now != nullptr && (before == nullptr || before->axis != now->axis || before->greatest != now->greatest);
}

}  // namespace snug::lesson
