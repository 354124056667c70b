// What an exercise asks of a query that goes through a tree: which node is next, and what is left out.
#include <algorithm>

#include "geometry/ray.hpp"
#include "lesson/decide.hpp"
#include "lesson/subjects/tree/entries.hpp"
#include "lesson/subjects/tree/tree_methods.hpp"
#include "query/overlap/ray_aabb.hpp"

namespace snug::lesson {
namespace {

/// The nodes that wait, by their numbers: their order on the stack is what is asked.
std::vector<Index> waiting_at(const Asked& asked, const Run& run) {
  std::vector<Index> waiting = tree_run(run).state(asked.fact).waiting;
  std::sort(waiting.begin(), waiting.end());
  return waiting;
}

/// How far a point is outside a box, along the axis where it is farthest; below 0 inside.
double outside_of(const Box2& box, const Point2& p) { return (box.min - p).cwiseMax(p - box.max).maxCoeff(); }

/// How far two boxes are apart, along the axis where they are farthest; below 0 where they overlap.
double gap_between(const Box2& a, const Box2& b) { return (a.min - b.max).cwiseMax(b.min - a.max).maxCoeff(); }

OneChoice choice_of(const Asked& asked, const Run& run, Index node) {
  const std::vector<Index> waiting = waiting_at(asked, run);
  return {static_cast<int>(std::find(waiting.begin(), waiting.end(), node) - waiting.begin())};
}

/// The node that a step takes up; none if it was taken up before.
Index taken_up(const Asked& asked, const Run& run) {
  const TreeRun& own = tree_run(run);
  const auto& fact = own.trace()[asked.fact].step.fact;
  const auto* tested = std::get_if<hierarchy::BodyTested>(&fact);
  const Index node = tested != nullptr ? own.leaf_of(tested->body) : std::get_if<hierarchy::NodeVisited>(&fact)->node;
  const Index taken = tested == nullptr && own.tests_before() ? own.forest(asked.fact).parent_of(node) : node;
  const std::vector<Index> waiting = waiting_at(asked, run);
  return std::find(waiting.begin(), waiting.end(), taken) == waiting.end() ? kNoIndex : taken;
}

Ray<double, 2> unit_ray_of(const QueryPlaces& query) { return {query.at[0], (query.at[1] - query.at[0]).normalized()}; }

/// How far along the ray a box begins, scene units; none if it misses it.
std::optional<double> enters(const Box2& box, const Run& run) {
  return query::ray_enters(box, unit_ray_of(tree_run(run).query()));
}

/// How far a ray is from meeting a box, or from missing it, along the ray.
double ray_gap(const Box2& box, const Ray<double, 2>& ray) {
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 2; ++i) {
    const double a = (box.min[i] - ray.origin[i]) / ray.direction[i],
                 b = (box.max[i] - ray.origin[i]) / ray.direction[i];
    enter = std::max(enter, std::min(a, b)), leave = std::min(leave, std::max(a, b));
  }
  return leave - enter;
}

}  // namespace

const char* offer_waiting(Asked& asked, const Run& run) {
  const std::vector<Index> waiting = waiting_at(asked, run);
  if (waiting.size() < 2 || taken_up(asked, run) == kNoIndex)
    return "\"next_node\" can only be asked where several nodes wait, and one is taken up";
  const Forest& forest = tree_run(run).forest(asked.fact);
  for (const Index node : waiting) asked.add_choice(tree_run(run).name_of(forest, node), forest.at(node).boxes);
  return nullptr;
}

const char* offer_visited(Asked& asked, const Run& run) {
  const TreeWhere where{tree_run(run), asked.fact, nullptr};
  asked.of = where.beside_name(tree_fact<hierarchy::NodeVisited>(asked, run).node);
  return offer_yes_no(asked, run);
}

Truth next_node_truth(const Asked& asked, const Run& run) {
  const Index next = taken_up(asked, run);
  const std::string name = tree_run(run).name_of(tree_run(run).forest(asked.fact), next);
  const bool first = tree_run(run).tests_before();
  return {{choice_of(asked, run, next).choice},
          {},
          name,
          name + (first ? " is taken: the nearer of two children comes first, and what lies beyond a hit is left out."
                        : " is on top of the stack.")};
}

/// Where a ray looks for the first box: by how much the nodes that wait and the boxes it has hit are apart along it.
double next_node_margin(const Asked& asked, const Run& run) {
  const TreeRun& own = tree_run(run);
  double least = no_tie(asked, run);
  if (!own.tests_before()) return least;
  std::vector<double> at;
  for (const Index node : waiting_at(asked, run))
    if (const auto t = enters(own.forest(asked.fact).at(node).box, run)) at.push_back(*t);
  for (const Index box : own.state(asked.fact).found())
    if (const auto t = enters(own.boxes()[box], run)) at.push_back(*t);
  std::sort(at.begin(), at.end());
  for (std::size_t i = 1; i < at.size(); ++i) least = std::min(least, at[i] - at[i - 1]);
  return least / extent_of(*asked.subject);
}

/// As if the left child always came first.
std::optional<Answer> left_child_first(const Asked& asked, const Run& run) {
  const Forest& forest = tree_run(run).forest(asked.fact);
  const Index parent = forest.parent_of(tree_run(run).state(asked.fact).waiting.back());
  return parent == kNoIndex ? std::nullopt
                            : std::optional<Answer>(choice_of(asked, run, forest.at(parent).children[0]));
}

/// As if the nodes waited in a queue.
std::optional<Answer> first_waiting(const Asked& asked, const Run& run) {
  return choice_of(asked, run, tree_run(run).state(asked.fact).waiting.front());
}

/// Only point, box and ray queries are decided by hand.
double left_out_margin(const Asked& asked, const Run& run) {
  const TreeRun& own = tree_run(run);
  const Box2& node = own.forest(asked.fact).at(tree_fact<hierarchy::NodeVisited>(asked, run).node).box;
  const std::string_view method = asked.question->gate.algorithm;
  const double gap = method == "point_query"                      ? outside_of(node, own.query().at[0])
                     : method == "box_query"                      ? gap_between(node, box_of(own.query()))
                     : shape_of_query(method) == QueryShape::kRay ? ray_gap(node, unit_ray_of(own.query()))
                                                                  : 0;
  return std::abs(gap) / extent_of(*asked.subject);
}

/// As if a node were left out unless the query is in one of its boxes.
std::optional<Answer> by_its_boxes(const Asked& asked, const Run& run) {
  if (asked.question->gate.algorithm != "point_query") return std::nullopt;
  const TreeRun& own = tree_run(run);
  const Branch& node = own.forest(asked.fact).at(tree_fact<hierarchy::NodeVisited>(asked, run).node);
  const bool inside = std::any_of(node.boxes.begin(), node.boxes.end(),
                                  [&](Index box) { return outside_of(own.boxes()[box], own.query().at[0]) <= 0; });
  return by_choice(inside ? kNo : kYes);
}

const char* offer_pair_tested(Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::PairTested>(asked, run);
  const TreeRun& own = tree_run(run);
  asked.of = fact.bodies ? "boxes " + box_name(fact.a) + " and " + small(box_name(fact.b))
                         : pair_name(own.forest(asked.fact), own.pairing()->copy, {fact.a, fact.b});
  return offer_yes_no(asked, run);
}

double pair_apart_margin(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::PairTested>(asked, run);
  const TreeRun& own = tree_run(run);
  const TreePairing& pairing = *own.pairing();
  const Box2& a = fact.bodies ? own.boxes()[fact.a] : own.forest(asked.fact).at(fact.a).box;
  const Box2& b = fact.bodies ? pairing.moved[fact.b] : pairing.copy.at(fact.b).box;
  return std::abs(gap_between(a, b)) / extent_of(*asked.subject);
}

}  // namespace snug::lesson
