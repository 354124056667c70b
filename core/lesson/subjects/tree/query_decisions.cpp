// What an exercise asks of a query that goes through a tree: which node is next, and what is left out.
#include <algorithm>

#include "lesson/decide.hpp"
#include "lesson/subjects/tree/entries.hpp"

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

/// The box between the two places of a query.
Box2 query_box(const QueryPlaces& query) {
  return {query.at[0].cwiseMin(query.at[1]), query.at[0].cwiseMax(query.at[1])};
}

Answer choice_of(const Asked& asked, const Run& run, Index node) {
  const std::vector<Index> waiting = waiting_at(asked, run);
  return by_choice(static_cast<int>(std::find(waiting.begin(), waiting.end(), node) - waiting.begin()));
}

}  // namespace

const char* offer_waiting(Asked& asked, const Run& run) {
  const std::vector<Index> waiting = waiting_at(asked, run);
  if (waiting.size() < 2) return "\"next_node\" can only be asked where several nodes wait";
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
  const Index next = tree_fact<hierarchy::NodeVisited>(asked, run).node;
  const std::string name = tree_run(run).name_of(tree_run(run).forest(asked.fact), next);
  return {{choice_of(asked, run, next).value}, {}, name, name + " is on top of the stack."};
}

/// As if the nodes waited in a queue.
std::optional<Answer> first_waiting(const Asked& asked, const Run& run) {
  return choice_of(asked, run, tree_run(run).state(asked.fact).waiting.front());
}

/// A point, or a box; other queries are not decided by hand.
double left_out_margin(const Asked& asked, const Run& run) {
  const TreeRun& own = tree_run(run);
  const Box2& node = own.forest(asked.fact).at(tree_fact<hierarchy::NodeVisited>(asked, run).node).box;
  const std::string_view method = asked.question->gate.algorithm;
  const double gap = method == "point_query" ? outside_of(node, own.query().at[0])
                     : method == "box_query" ? gap_between(node, query_box(own.query()))
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

double pair_apart_margin(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::PairTested>(asked, run);
  const TreeRun& own = tree_run(run);
  const TreePairing& pairing = *own.pairing();
  const Box2& a = fact.bodies ? own.boxes()[fact.a] : own.forest(asked.fact).at(fact.a).box;
  const Box2& b = fact.bodies ? pairing.moved[fact.b] : pairing.copy.at(fact.b).box;
  return std::abs(gap_between(a, b)) / extent_of(*asked.subject);
}

}  // namespace snug::lesson
