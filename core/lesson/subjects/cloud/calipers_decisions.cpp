#include "lesson/subjects/cloud/calipers_decisions.hpp"

#include <algorithm>

#include "lesson/decide.hpp"
#include "lesson/subjects/cloud/decisions.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using Tried = fit::BoxTried<double, 3>;

const Tried& tried_at(const Asked& asked, const Run& run) { return fact_of<Tried>(asked, run); }

/// Along an edge, back, and away from it into the hull.
std::array<Point3, 3> other_sides(const Tried& tried, const Run& run) {
  const Point3 a = fit::point_of(fit_run(run).points(), tried.on[0]);
  const Point3 b = fit::point_of(fit_run(run).points(), tried.on[1]);
  const Point3 along = (b - a).normalized(), across(-along.y(), along.x(), 0);
  const Point3 center = tried.box.center;
  return {along, -along, (center - a).dot(across) > 0 ? across : -across};
}

/// The points that sides touch, but for the edge's ends.
std::vector<int> touching(const Tried& tried, const Run& run, std::span<const Point3> sides) {
  std::vector<int> points;
  for (const Point3& side : sides) {
    const int point = reach_along(run, side).greatest();
    const bool end = point == tried.on[0] || point == tried.on[1];
    if (!end && std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
  }
  return points;
}

std::vector<const Tried*> tried_before(const Asked& asked, const Run& run) {
  std::vector<const Tried*> all;
  for (int i = 0; i < asked.fact; ++i)
    if (const auto* tried = std::get_if<Tried>(&fit_run(run).trace()[i].step.fact)) all.push_back(tried);
  return all;
}

std::string edge_words(const Asked& asked, const Tried& tried) {
  return asked.subject->name_of(tried.on[0]) + " to " + asked.subject->name_of(tried.on[1]);
}

/// The edges that were tried, the least first in what measures them.
template <class Measure>
Scores least_first(const Asked& asked, const Run& run, Measure measure) {
  Scores scores;
  int choice = 0;
  for (const Tried* tried : tried_before(asked, run)) scores.add(choice++, -measure(*tried));
  return scores;
}

Scores by_area(const Asked& asked, const Run& run) {
  return least_first(asked, run, [](const Tried& tried) { return tried.measure; });
}

}  // namespace

const char* offer_touched(Asked& asked, const Run& run) {
  const Tried& tried = tried_at(asked, run);
  if (asked.dim != 2 || tried.on.size() < 3) return "\"touched\" can only be asked of a box on an edge in the plane";
  asked.of = edge_words(asked, tried);
  for (Index i = 0; i < fit::count_of(fit_run(run).points()); ++i)
    if (i != tried.on[0] && i != tried.on[1]) asked.stage_points.push_back(i);
  asked.on_stage = asked.many = true;
  return nullptr;
}

Truth touched_truth(const Asked& asked, const Run& run) {
  const Tried& tried = tried_at(asked, run);
  const std::vector<int> points = touching(tried, run, other_sides(tried, run));
  Truth truth;
  truth.points.assign(points.begin(), points.end());
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + (points.size() == 1 ? " touches" : " touch") + " the other sides of the rectangle.";
  return truth;
}

double touched_margin(const Asked& asked, const Run& run) {
  double least = no_tie(asked, run);
  for (const Point3& side : other_sides(tried_at(asked, run), run))
    least = std::min(least, reach_along(run, side).lead());
  return least / extent_of(*asked.subject);
}

/// The opposite side alone.
std::optional<Answer> only_opposite(const Asked& asked, const Run& run) {
  const auto sides = other_sides(tried_at(asked, run), run);
  return by_handles(touching(tried_at(asked, run), run, std::span(sides).last(1)));
}

/// As if the sides ran along the axes.
std::optional<Answer> touched_by_aabb(const Asked& asked, const Run& run) {
  const std::array<Point3, 4> sides{Point3::UnitX(), -Point3::UnitX(), Point3::UnitY(), -Point3::UnitY()};
  const std::vector<int> points = touching(tried_at(asked, run), run, sides);
  return points.empty() ? std::nullopt : std::optional(by_handles(points));
}

const char* offer_tried_edges(Asked& asked, const Run& run) {
  constexpr std::size_t kMostEdges = 10;
  const std::vector<const Tried*> all = tried_before(asked, run);
  if (asked.dim != 2 || all.size() < 2) return "\"smallest_edge\" can only be asked once boxes on edges were tried";
  if (all.size() > kMostEdges) return "the hull has more than 10 edges";
  for (const Tried* tried : all) asked.add_choice(edge_words(asked, *tried), {tried->on[0], tried->on[1]});
  return nullptr;
}

Truth smallest_edge_truth(const Asked& asked, const Run& run) {
  const Scores areas = by_area(asked, run);
  const int choice = areas.greatest();
  const std::string& name = asked.choices[choice];
  return {{choice},
          {},
          name,
          "The smallest rectangle lies on the edge from " + name + ", with area " + number_text(-areas.values[choice]) +
              "."};
}

/// The difference between the two smallest areas, as a share of the larger.
double smallest_edge_margin(const Asked& asked, const Run& run) {
  const Scores areas = by_area(asked, run);
  const double least = -areas.values[areas.greatest()];
  return areas.lead() / (least + areas.lead());
}

std::optional<Answer> last_tried(const Asked& asked, const Run&) {
  return by_choice(static_cast<int>(std::ssize(asked.choices)) - 1);
}

std::optional<Answer> least_perimeter(const Asked& asked, const Run& run) {
  return by_choice(least_first(asked, run, [](const Tried& tried) {
                     return tried.box.half_extents[0] + tried.box.half_extents[1];
                   }).greatest());
}

}  // namespace snug::lesson
