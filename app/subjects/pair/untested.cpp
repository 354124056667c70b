// The intervals of two AABBs along axes that the test has not reached.
#include <algorithm>
#include <string_view>

#include "app/subjects/pair/draw.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

const query::SlabTested* slab_of(const Recorder<lesson::PairStep>::Entry& entry) {
  return std::get_if<query::SlabTested>(&entry.step.fact);
}

/// Whether what is asked can be read from two intervals.
bool asks_of_intervals(std::string_view asks) { return asks == "separates" || asks == "apart" || asks == "first_axis"; }

const lesson::VolumePair& volumes_of(const lesson::Session& session) {
  return lesson::as<lesson::VolumesSubject>(session.stage().subject())->pair();
}

bool is_tested(int axis, lesson::PairSteps steps) {
  return std::any_of(steps.begin(), steps.end(), [&](const auto& entry) {
    const auto* slab = slab_of(entry);
    return slab != nullptr && slab->direction == Point3(Point3::Unit(axis));
  });
}

Intervals intervals_along(const lesson::VolumePair& pair, int axis) {
  Intervals both{.direction = Point3::Unit(axis),
                 .ends = {},
                 .farthest = {},
                 .reach = {},
                 .name = lesson::axis_name(Point3::Unit(axis)),
                 .tested = false};
  for (const std::size_t side : {0, 1}) {
    const auto& box = *std::get_if<Aabb<double, 3>>(&pair.held[side].volume);
    both.ends[side] = {box.min[axis], box.max[axis]};
    const std::vector<Point3> core = lesson::core_of(pair.held[side]);
    both.reach.insert(both.reach.end(), core.begin(), core.end());
  }
  return both;
}

}  // namespace

std::vector<int> untested_axes(const lesson::Session& session, lesson::PairSteps steps) {
  const auto& held = volumes_of(session).held;
  const auto is_box = [](const auto& one) { return std::holds_alternative<Aabb<double, 3>>(one.volume); };
  const auto trace = lesson::pair_run(session.player().run(0)).trace();
  const bool by_slabs =
      std::any_of(trace.begin(), trace.end(), [](const auto& one) { return slab_of(one) != nullptr; });
  if (!by_slabs || !std::all_of(held.begin(), held.end(), is_box)) return {};
  for (const lesson::Asked& asked : session.conversation().questions())
    if (session.conversation().is_open(*asked.question) && asks_of_intervals(asked.question->asks)) return {};
  std::vector<int> axes;
  for (int axis = 0; axis < session.stage().subject().dim(); ++axis)
    if (!is_tested(axis, steps)) axes.push_back(axis);
  return axes;
}

void draw_untested(Brush& brush, lesson::PairSteps steps) {
  for (const int axis : untested_axes(brush.session, steps))
    draw_intervals(brush, intervals_along(volumes_of(brush.session), axis));
}

}  // namespace snug::app
