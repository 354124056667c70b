#include "lesson/subjects/tree/tree_methods.hpp"

#include <algorithm>

#include "hierarchy/build.hpp"
#include "hierarchy/cost.hpp"
#include "hierarchy/cull.hpp"
#include "hierarchy/shape.hpp"
#include "hierarchy/traverse_pair.hpp"
#include "query/contain/contains.hpp"
#include "query/overlap/overlaps.hpp"
#include "query/overlap/ray_aabb.hpp"

namespace snug::lesson {
namespace {

using BuildRecorder = Recorder<hierarchy::Step>;

constexpr double kNearShare = 0.1, kHalfTangent = 0.5;  // of the frustum: its near side's distance over its far side's

constexpr auto kHandPseudocode = [] {
  auto lines = hierarchy::kBottomUpPseudocode;
  lines[2] = "  a, b ← two that you choose";
  return lines;
}();

constexpr std::array kBuildMethods{
    Method{kTreeBuild, "top_down_median", "Top-down, median", "C. Ericson, Real-Time Collision Detection, 2005, 6.2.1",
           hierarchy::kMedianPseudocode},
    Method{kTreeBuild, "top_down_sah", "Top-down, surface area",
           "J. Goldsmith, J. Salmon, Automatic creation of object hierarchies, 1987; I. Wald, 2007",
           hierarchy::kSurfaceAreaPseudocode},
    Method{kTreeBuild, "bottom_up", "Bottom-up", "S. M. Omohundro, Five balltree construction algorithms, 1989",
           hierarchy::kBottomUpPseudocode},
    Method{kTreeBuild, "insertion", "Insertion", "J. Goldsmith, J. Salmon, 1987; A. Kensler, Tree rotations, 2008",
           hierarchy::kInsertionPseudocode},
    Method{.volume = kTreeBuild,
           .name = kByHand,
           .title = "By hand",
           .source = "your own choice of pairs",
           .pseudocode = kHandPseudocode,
           .by_hand = true},
};

constexpr auto kFarFirstPseudocode = [] {
  auto lines = hierarchy::kFirstHitPseudocode;
  lines[5] = "  open those hit, the farther one last";
  return lines;
}();

constexpr auto kYourOrderPseudocode = [] {
  auto lines = hierarchy::kFirstHitPseudocode;
  lines[5] = "  open those hit, the one that you choose last";
  return lines;
}();

constexpr std::string_view kEricsonOnTrees = "C. Ericson, Real-Time Collision Detection, 2005, 6.3";
constexpr std::array kQueryMethods{
    Method{kTreeQuery, "point_query", "Point query", kEricsonOnTrees, hierarchy::kTraversePseudocode},
    Method{kTreeQuery, "box_query", "Box query", kEricsonOnTrees, hierarchy::kTraversePseudocode},
    Method{kTreeQuery, "ray_query", "Ray: every box", kEricsonOnTrees, hierarchy::kTraversePseudocode},
    Method{kTreeQuery, "ray_far_first", "Ray: back to front",
           "T. L. Kay, J. T. Kajiya, Ray tracing complex scenes, 1986", kFarFirstPseudocode},
    Method{kTreeQuery, "ray_nearest", "Ray: front to back", "T. L. Kay, J. T. Kajiya, Ray tracing complex scenes, 1986",
           hierarchy::kFirstHitPseudocode},
    Method{.volume = kTreeQuery,
           .name = kRayByHand,
           .title = "Ray: your order",
           .source = "your own choice of the next child",
           .pseudocode = kYourOrderPseudocode,
           .by_hand = true},
    Method{kTreeQuery, "frustum_query", "Frustum query",
           "U. Assarsson, T. Möller, Optimized View Frustum Culling, 2000", hierarchy::kTraversePseudocode},
    Method{kTreeQuery, kTwoTrees, "Two trees", kEricsonOnTrees, hierarchy::kOverlapPseudocode},
};

/// Appends the steps that a lesson shows. That every node gets its volume is told by the last step alone.
void append(const BuildRecorder& recorder, TreeTrace* trace) {
  if (trace == nullptr) return;
  for (const auto& [step, counts] : recorder.entries)
    std::visit(
        [&, line = step.line, counts = counts](const auto& fact) {
          using Fact = std::remove_cvref_t<decltype(fact)>;
          if constexpr (requires { TreeStep::Fact(fact); } && !std::is_same_v<Fact, hierarchy::VolumeMade>)
            trace->push_back({TreeStep{line, fact}, counts});
        },
        step.fact);
}

TreeOfBoxes built(std::string_view method, std::span<const Box2> boxes, BuildRecorder& steps) {
  const hierarchy::Options single{.most_in_leaf = 1};
  if (method == "top_down_median") return hierarchy::build_median<Box2>(boxes, single, steps);
  if (method == "top_down_sah") return hierarchy::build_surface_area<Box2>(boxes, single, steps);
  if (method == "bottom_up") return hierarchy::build_bottom_up<Box2>(boxes, steps);
  return hierarchy::build_by_insertion<Box2>(boxes, steps);
}

Ray<double, 2> ray_of(const QueryPlaces& query) { return {query.at[0], query.at[1] - query.at[0]}; }

bool has_inside(const Box2& box, const Box2& inner) {
  return (box.min.array() <= inner.min.array()).all() && (inner.max.array() <= box.max.array()).all();
}

/// What a query says of a box; a frustum's is hierarchy::cull's.
hierarchy::Answer answer_of(QueryShape shape, const QueryPlaces& query, const Box2& box) {
  const auto met = [](bool meets) { return meets ? hierarchy::Answer::kDescend : hierarchy::Answer::kPrune; };
  switch (shape) {
    case QueryShape::kPoint: return met(query::contains(box, query.at[0]));
    case QueryShape::kRay: return met(query::ray_enters(box, ray_of(query)).has_value());
    case QueryShape::kBox:
      return has_inside(box_of(query), box) ? hierarchy::Answer::kAccept : met(query::overlaps(box, box_of(query)));
    case QueryShape::kFrustum:
    case QueryShape::kMove: break;
  }
  return met(query::classify(frustum_of(query).value(), box).verdict != query::Culling::kOutside);
}

/// Which of two children that a ray meets is taken first: by a rule or, by hand, as it was chosen.
struct FirstChild {
  std::string_view method;
  std::span<const Index> choices;
  const BuildRecorder& recorder;
  QueryResult& result;
  std::size_t known = 0;  // how many steps there are before the choice that is due

  bool operator()(Index node, double left, double right) {
    const bool by_rule = hierarchy::is_right_first(
        method == "ray_far_first" ? hierarchy::ChildOrder::kFar : hierarchy::ChildOrder::kNear, left, right);
    const bool right_first = method == kRayByHand ? chosen(node) : by_rule;
    if (right_first) result.right_first.push_back(node);
    return right_first;
  }

 private:
  bool chosen(Index node) {
    if (result.undecided != kNoIndex) return false;
    if (result.chosen < choices.size()) return choices[result.chosen++] == 1;
    result.undecided = node;
    known = recorder.entries.size();
    return false;
  }
};

/// Looks for the first box on a ray. Where a choice by hand is due, the steps end.
QueryResult first_box(std::string_view method, const QueryPlaces& query, const TreeOfBoxes& tree,
                      std::span<const Box2> boxes, std::span<const Index> choices, BuildRecorder& recorder) {
  QueryResult result;
  FirstChild first{method, choices, recorder, result};
  const auto enters = [&](const Box2& box) { return query::ray_enters(box, ray_of(query)); };
  const auto hit = hierarchy::first_hit<double>(tree, boxes, enters, recorder, first);
  result.counts = hit.counts;
  if (result.undecided == kNoIndex) {
    if (hit.body != kNoIndex) result.found = {hit.body};
    return result;
  }
  recorder.entries.erase(recorder.entries.begin() + static_cast<std::ptrdiff_t>(first.known), recorder.entries.end());
  result.counts = {};
  for (const auto& entry : recorder.entries)
    ++(std::holds_alternative<hierarchy::BodyTested>(entry.step.fact) ? result.counts.body_tests
                                                                      : result.counts.node_tests);
  result.counts.nodes_visited =
      result.counts.body_tests + result.counts.node_tests / 2;  // two tests for each but the root
  recorder(hierarchy::Step{5, hierarchy::Done{result.counts.nodes_visited, result.counts.volume_tests()}});
  return result;
}

}  // namespace

std::span<const Method> build_methods() { return std::span(kBuildMethods).first(kBuildMethods.size() - 1); }
std::span<const Method> build_methods_and_hand() { return kBuildMethods; }
std::span<const Method> query_methods() { return kQueryMethods; }

TreeOfBoxes build_tree(std::string_view method, std::span<const Box2> boxes, TreeTrace* trace) {
  BuildRecorder recorder;
  TreeOfBoxes tree = built(method, boxes, recorder);
  append(recorder, trace);
  return tree;
}

TreeOfBoxes tree_by_hand(std::span<const HandPair> pairs, std::span<const Box2> boxes) {
  const auto count = static_cast<Index>(boxes.size());
  const std::vector<std::array<Index, 2>> all(pairs.begin(), pairs.end());
  Ignore ignore;
  return hierarchy::fill<Box2>(hierarchy::shape_of(all, count, count + static_cast<Index>(pairs.size()) - 1), boxes, 4,
                               ignore);
}

double cost_of_tree(const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind) {
  return kind == NodeKind::kAabb ? hierarchy::expected_cost(tree) : expected_cost(forest_of(tree, boxes, kind));
}

Growth::Way way_of(std::string_view method) {
  return method == "bottom_up"   ? Growth::Way::kUp
         : method == "insertion" ? Growth::Way::kInserting
                                 : Growth::Way::kDown;
}

QueryShape shape_of_query(std::string_view method) {
  return method == "point_query"     ? QueryShape::kPoint
         : method == "box_query"     ? QueryShape::kBox
         : method == "frustum_query" ? QueryShape::kFrustum
         : method == kTwoTrees       ? QueryShape::kMove
                                     : QueryShape::kRay;
}

tl::expected<Frustum<double, 2>, InputError> frustum_of(const QueryPlaces& query) {
  const Point2 way = query.at[1] - query.at[0];
  const double far = way.norm();
  if (!(far > 0)) return tl::unexpected(InputError{.what = "Q and R are in one place"});
  FrustumCamera<double, 2> camera{.position = query.at[0], .near = kNearShare * far, .far = far};
  camera.axes.col(1) = -way / far;
  camera.axes.col(0) = Point2(way[1], -way[0]) / far;
  camera.half_tangents[0] = kHalfTangent;
  return frustum_of_camera(camera);
}

std::array<Point2, 4> corners_of_query(const QueryPlaces& query) {
  const Point2 way = query.at[1] - query.at[0], aside = kHalfTangent * Point2(way[1], -way[0]);
  const Point2 near = kNearShare * way, near_aside = kNearShare * aside;
  return {query.at[0] + near - near_aside, query.at[0] + near + near_aside, query.at[1] + aside, query.at[1] - aside};
}

Box2 box_of(const QueryPlaces& query) { return {query.at[0].cwiseMin(query.at[1]), query.at[0].cwiseMax(query.at[1])}; }

QueryResult run_query(std::string_view method, const QueryPlaces& query, const TreeOfBoxes& tree,
                      std::span<const Box2> boxes, TreeTrace* trace, std::span<const Index> choices) {
  BuildRecorder recorder;
  QueryResult result;
  const QueryShape shape = shape_of_query(method);
  const auto take = [&](Index box, auto) { result.found.push_back(box); };
  if (finds_first(method)) {
    result = first_box(method, query, tree, boxes, choices, recorder);
  } else if (shape == QueryShape::kFrustum) {
    const auto culled = hierarchy::cull(tree, boxes, frustum_of(query).value(), take, recorder);
    result.counts = culled.counts, result.planes_tested = culled.planes_tested;
  } else {
    const auto visit = [&](const Box2& box, const int&) { return answer_of(shape, query, box); };
    result.counts = hierarchy::traverse(tree, boxes, 0, visit, take, recorder);
  }
  std::sort(result.found.begin(), result.found.end());
  append(recorder, trace);
  return result;
}

std::vector<Index> found_one_by_one(std::string_view method, const QueryPlaces& query, std::span<const Box2> boxes) {
  std::vector<Index> found;
  for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i)
    if (answer_of(shape_of_query(method), query, boxes[i]) != hierarchy::Answer::kPrune) found.push_back(i);
  if (!finds_first(method) || found.empty()) return found;
  const auto at = [&](Index i) { return *query::ray_enters(boxes[i], ray_of(query)); };
  return {*std::min_element(found.begin(), found.end(), [&](Index a, Index b) { return at(a) < at(b); })};
}

}  // namespace snug::lesson
