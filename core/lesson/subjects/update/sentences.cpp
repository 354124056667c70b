// What is said of an update's steps.
#include <cmath>

#include "lesson/figures.hpp"
#include "lesson/subjects/update/entries.hpp"
#include "lesson/subjects/update/update_figures.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostNeighborsNamed = 4;  // more neighbours are counted, not named

/// "neighbour P3", "neighbours P3 and P9", "6 neighbours"
std::string neighbors_text(const fit::NeighborsCompared& fact, const UpdateWhere& where) {
  if (fact.neighbors.size() > kMostNeighborsNamed) return std::to_string(fact.neighbors.size()) + " neighbours";
  std::string text = fact.neighbors.size() == 1 ? "neighbour " : "neighbours ";
  for (std::size_t i = 0; i < fact.neighbors.size(); ++i) {
    if (i > 0) text += i + 1 == fact.neighbors.size() ? " and " : ", ";
    text += where.name(fact.neighbors[i]);
  }
  return text;
}

/// "x = −1.23"
std::string bound_words(const std::string& axis, double bound) { return axis + " = " + number_text(bound); }

double climbed_bound(const fit::ExtremeClimbed& fact, const UpdateWhere& where) {
  return where.run.axis(fact.axis).dot(where.run.placed(fact.path.back()));
}

}  // namespace

std::string Entry<fit::ReachFound>::sentence(const fit::ReachFound& fact, const UpdateWhere& where) {
  return where.name(fact.point) + " is farthest from the pivot, at " + number_text(fact.distance) +
         ": no rotation takes any point farther out. This is found once, not in every frame.";
}

std::string Entry<PointPlaced>::sentence(const PointPlaced& fact, const UpdateWhere& where) {
  if (where.i == 0) return "The AABB begins as a single point, " + where.name(fact.point) + ".";
  return where.name(fact.point) + " lies outside the AABB so far, which grows to it.";
}

std::string Entry<fit::NeighborsCompared>::sentence(const fit::NeighborsCompared& fact, const UpdateWhere& where) {
  const std::string side = where.side(fact.axis, fact.greatest), vertex = where.name(fact.vertex);
  const std::string begins =
      where.begins_climb() ? "Towards " + side + ", the climb begins at " + vertex + ", the last frame’s extreme. "
                           : "";
  if (fact.best == fact.vertex) return begins + "No neighbour of " + vertex + " reaches farther towards " + side + ".";
  const std::string looks = "Of its " + neighbors_text(fact, where) + ", ";
  const std::string goes = fact.neighbors.size() == 1
                               ? "Its next " + neighbors_text(fact, where) + " reaches farther: go there."
                               : looks + where.name(fact.best) + " reaches farthest: go there.";
  return begins.empty() ? vertex + " is not the extreme towards " + side + ". " + goes : begins + goes;
}

std::string Entry<fit::NeighborsCompared>::predicate(const fit::NeighborsCompared& fact, const UpdateWhere&, bool) {
  return fact.best == fact.vertex ? "is the extreme already" : "is where the climb goes next";
}

std::string Entry<fit::ExtremeClimbed>::sentence(const fit::ExtremeClimbed& fact, const UpdateWhere& where) {
  const std::size_t edges = fact.path.size() - 1;
  const std::string way = edges == 0   ? "without a step"
                          : edges == 1 ? "after one edge"
                                       : "after " + std::to_string(edges) + " edges";
  return where.name(fact.path.back()) + " is the extreme towards " + where.side(fact.axis, fact.greatest) + ", " + way +
         ": the bound is " + bound_words(where.axis(fact.axis), climbed_bound(fact, where)) + ".";
}

std::string Entry<fit::ExtremeClimbed>::predicate(const fit::ExtremeClimbed& fact, const UpdateWhere& where, bool) {
  return "is the extreme towards " + where.side(fact.axis, fact.greatest);
}

std::string Entry<fit::BoundsRotated>::sentence(const fit::BoundsRotated& fact, const UpdateWhere& where) {
  const std::string bounds = bound_words(where.axis(fact.axis), fact.min) + " to " + number_text(fact.max);
  const std::string_view name = where.run.strategy().name;
  const std::string what = name.ends_with("loose")
                               ? std::string("the ") + ball_word(where.run.dim()) + " about the pivot"
                           : name.ends_with("rebuild") ? "all points"
                                                       : "the rotated local " + where.volume();
  return "The bounds of " + what + ": " + bounds + ".";
}

std::string Entry<fit::CenterMoved>::sentence(const fit::CenterMoved&, const UpdateWhere& where) {
  if (where.run.strategy().volume == "aabb")
    return "The AABB reaches equally far on every side of the pivot, however the body has rotated.";
  return "The centre moves with the body.";
}

std::string Entry<fit::AxesTurned>::sentence(const fit::AxesTurned&, const UpdateWhere&) {
  return "The axes rotate with the body.";
}

std::string Entry<VolumeUpdated>::sentence(const VolumeUpdated&, const UpdateWhere& where) {
  const std::string done = "The " + where.volume() + " is updated";
  if (where.hides(kUpdateSlack)) return done + ".";
  const fit::UpdatedFrame& frame = where.run.recording().frame;
  const double slack = fit::slack(frame.measure, frame.tightest);
  if (!std::isfinite(slack)) return done + ". The tightest is flat.";
  if (is_tight(slack)) return done + ": no " + where.volume() + " of this body in this pose is tighter.";
  return done + ": " + looseness_words(slack) + ".";
}

Truth extreme_truth(const Asked& asked, const Run& run) {
  const UpdateWhere where{update_run(run), asked.fact, nullptr};
  const auto& fact = *std::get_if<fit::NeighborsCompared>(&where.step().fact);
  const std::string side = where.side(fact.axis, fact.greatest);
  if (fact.best == fact.vertex)
    return yes("No neighbour of " + where.name(fact.vertex) + " reaches farther towards " + side + ".");
  return no(where.name(fact.best) + ", a neighbour of " + where.name(fact.vertex) + ", reaches farther towards " +
            side + ".");
}

}  // namespace snug::lesson
