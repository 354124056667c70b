#include "lesson/subjects/tree/tree_figures.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "geometry/tolerance.hpp"
#include "hierarchy/cost.hpp"
#include "lesson/subjects/tree/entries.hpp"

namespace snug::lesson {
namespace {

Figure count(std::string name, std::string key, std::int64_t value, std::string unit = "") {
  return {std::move(name), std::move(key), count_text(value), static_cast<double>(value), std::move(unit)};
}

/// A figure of the finished tree; before, a dash.
Figure at_end(std::string name, std::string key, std::string text, double value, std::string unit, bool known) {
  return {std::move(name), std::move(key), known ? std::move(text) : "—", value, std::move(unit), known};
}

int depth_of(const Forest& forest, Index branch) {
  const Branch& own = forest.at(branch);
  if (!own.divides()) return 1;
  return 1 + std::max(depth_of(forest, own.children[0]), depth_of(forest, own.children[1]));
}

/// The tree's cost, refitted or rebuilt, and what it was when it was built.
void add_costs(std::vector<Figure>& figures, const TreeRun& run, bool done) {
  const double cost = run.cost(), rebuilt = hierarchy::expected_cost(build_tree("top_down_sah", run.boxes()));
  const double share = 100 * (cost / rebuilt);
  figures.push_back(at_end("SAH cost as built", "cost_built", number_text(run.cost_built()) + " tests",
                           run.cost_built(), "tests", true));
  figures.push_back(at_end("SAH cost now", "cost", number_text(cost) + " tests", cost, "tests", done));
  figures.push_back(
      at_end("Cost relative to the rebuilt tree", "of_rebuilt", number_text(share) + " %", share, "%", done));
}

std::vector<Figure> figures_of_growth(const TreeRun& run, int step) {
  const Forest& forest = run.forest(step);
  int depth = 0;
  for (const Index root : forest.roots) depth = std::max(depth, depth_of(forest, root));
  const bool done = step == run.steps() && run.is_whole();
  std::vector<Figure> figures{
      count(done ? "Nodes" : "Nodes so far", "nodes", static_cast<std::int64_t>(forest.there().size())),
      count(done ? "Depth" : "Depth so far", "depth", depth)};
  if (run.is_update()) return add_costs(figures, run, done), figures;
  const auto other = [&](std::string_view rule) {
    return cost_of_tree(build_tree(rule, run.boxes()), run.boxes(), run.nodes());
  };
  const double cost = run.is_whole() ? run.cost() : 0, median = other("top_down_median");
  const double share = 100 * (cost / median);
  figures.push_back(at_end("SAH cost", "cost", number_text(cost) + " tests", cost, "tests", done));
  figures.push_back(
      at_end("Cost relative to the median tree", "of_median", number_text(share) + " %", share, "%", done));
  if (run.is_by_hand()) {
    const double of_sah = 100 * (cost / other("top_down_sah"));
    figures.push_back(at_end("Cost relative to the SAH tree", "of_sah", number_text(of_sah) + " %", of_sah, "%", done));
  }
  if (run.nodes() == NodeKind::kAabb) return figures;
  const double of_aabb = done ? 100 * tests_of_lines(forest, forest_of(run.tree(), run.boxes())) : 0;
  figures.push_back(
      at_end("Tests relative to AABBs as nodes", "of_aabb", number_text(of_aabb) + " %", of_aabb, "%", done));
  return figures;
}

/// The run's tests in per cent of those that another order takes.
Figure share_of_order(const TreeRun& run, int step, std::string_view other, std::string name, std::string key) {
  const auto tests = run_query(other, run.query(), run.tree(), run.boxes()).counts.volume_tests();
  const double share = 100 * (static_cast<double>(run.state(run.steps()).tests()) / static_cast<double>(tests));
  const bool done = step == run.steps() && run.undecided() == kNoIndex;
  return at_end(std::move(name), std::move(key), number_text(share) + " %", share, "%", done);
}

std::vector<Figure> figures_of_pairing(const TreeRun& run, int step) {
  const PairState& state = run.pairing()->states[step];
  const auto all = static_cast<double>(run.boxes().size() * run.boxes().size());
  const double share = 100 * (static_cast<double>(state.tests()) / all);
  return {count("Pairs visited", "visited", state.visited),
          count("Tests of nodes", "node_tests", state.node_tests),
          count("Tests of boxes", "box_tests", state.box_tests),
          count("Tests in all", "tests", state.tests()),
          at_end("Tests relative to all pairs", "of_all", number_text(share) + " %", share, "%", step == run.steps()),
          count("Pairs left out untested", "left_out", state.left_out),
          count("Pairs that overlap", "found", static_cast<std::int64_t>(state.found.size()))};
}

std::vector<Figure> figures_of_query(const TreeRun& run, int step) {
  const QueryState& state = run.state(step);
  const auto taken = std::count(state.boxes.begin(), state.boxes.end(), Met::kTaken);
  const auto left_out =
      std::count_if(state.boxes.begin(), state.boxes.end(), [](Met met) { return met == Met::kUnder; });
  std::vector<Figure> figures{
      count("Nodes visited", "visited", state.visited), count("Tests of nodes", "node_tests", state.node_tests),
      count("Tests of boxes", "box_tests", state.box_tests), count("Tests in all", "tests", state.tests()),
      count("Boxes left out untested", "left_out", left_out)};
  if (!run.tests_before()) figures.push_back(count("Boxes taken untested", "taken", taken));
  figures.push_back(count("Boxes met", "found", static_cast<std::int64_t>(state.found().size())));
  if (run.is_steered())
    figures.push_back(share_of_order(run, step, "ray_nearest", "Tests relative to front to back", "of_near_first"));
  else if (run.tests_before())
    figures.push_back(share_of_order(run, step, "ray_far_first", "Tests relative to back to front", "of_far_first"));
  return figures;
}

std::vector<Figure> figures_of_merging(const TreeRun& run, int step) {
  const auto nodes = static_cast<Index>(run.tree().nodes.size());
  const Index node = std::max(nodes - step, Index{0});  // the last one that has got its volume
  const bool any = step > 0;
  const auto area = [&](std::string name, std::string key, const std::vector<fit::Volume3>& volumes) {
    const double value = any ? fit::measure_of(volumes[node], 2) : 0;
    return at_end(std::move(name), std::move(key), number_text(value) + " units²", value, "units²", any);
  };
  std::int64_t merged = 0;
  for (Index i = node; i < nodes; ++i) merged += any && !run.tree().nodes[i].is_leaf();
  const double loss = any ? merging_loss(run, node) : 0;
  std::vector<Figure> figures{
      area("Area, merged", "area", run.volumes().merged), area("Area, tightest", "area_points", run.volumes().tight),
      at_end("Loss by merging", "loss", percent_text(loss), 100 * loss, "%", any), count("Merges", "mergers", merged)};
  if (run.volume_word() == "AABB") add_costs(figures, run, step == run.steps());
  return figures;
}

/// Whether each box is in one leaf, and each node's box is the smallest around what is below it.
bool is_sound(const TreeRun& run) {
  const Forest& forest = run.forest(run.steps());
  std::vector<Index> leaves;
  bool tight = true;
  for (const Index i : forest.there()) {
    const Branch& branch = forest.at(i);
    if (!branch.divides()) leaves.insert(leaves.end(), branch.boxes.begin(), branch.boxes.end());
    Box2 all = run.boxes()[branch.boxes.front()];
    for (const Index box : branch.boxes)
      all = {all.min.cwiseMin(run.boxes()[box].min), all.max.cwiseMax(run.boxes()[box].max)};
    tight = tight && all.min == branch.box.min && all.max == branch.box.max;
  }
  std::sort(leaves.begin(), leaves.end());
  bool once = leaves.size() == run.boxes().size();
  for (std::size_t i = 0; once && i < leaves.size(); ++i) once = leaves[i] == static_cast<Index>(i);
  return once && tight;
}

bool has_point(const fit::Volume3& volume, const Point3& p) {
  const double reach = 1 + p.norm();
  return std::visit(
      [&]<class Kind>(const Kind& own) {
        if constexpr (std::is_same_v<Kind, Sphere<double, 3>>)
          return (p - own.center).norm() <= own.radius + tolerance::kBoxProof * reach;
        else if constexpr (std::is_same_v<Kind, Obb<double, 3>>)
          return ((own.axes.transpose() * (p - own.center)).cwiseAbs() - own.half_extents).head(2).maxCoeff() <=
                 tolerance::kBoxProof * reach;
        else if constexpr (std::is_same_v<Kind, Aabb<double, 3>>)
          return (p - own.min).minCoeff() >= 0 && (own.max - p).minCoeff() >= 0;
        else return false;
      },
      volume);
}

/// Whether a volume has every vertex of some boxes, but for rounding where it is no box along the axes.
bool contains_boxes(const fit::Volume3& volume, std::span<const Index> below, std::span<const Box2> boxes) {
  bool holds = true;
  for (const Index box : below) {
    const Box2& own = boxes[box];
    for (const double x : {own.min[0], own.max[0]})
      for (const double y : {own.min[1], own.max[1]}) holds = holds && has_point(volume, {x, y, 0});
  }
  return holds;
}

/// Whether each node's volume has every vertex of the boxes below it.
Proof contains_all(const TreeRun& run) {
  bool holds = true;
  if (run.is_merging())
    for (std::size_t i = 0; i < run.tree().nodes.size(); ++i)
      holds =
          holds && contains_boxes(run.volumes().merged[i], run.tree().bodies_below(static_cast<Index>(i)), run.boxes());
  else
    for (const Index i : run.forest(run.steps()).there()) {
      const Branch& branch = run.forest(run.steps()).at(i);
      holds = holds && contains_boxes(volume_in_space(branch.volume), branch.boxes, run.boxes());
    }
  return {"each node's volume contains all vertices of the boxes below it", holds, true};
}

}  // namespace

std::vector<Figure> tree_figures(const View& view) {
  const TreeRun& run = tree_run(view.run());
  if (run.pairing() != nullptr) return figures_of_pairing(run, view.step);
  if (run.is_query()) return figures_of_query(run, view.step);
  return run.is_merging() ? figures_of_merging(run, view.step) : figures_of_growth(run, view.step);
}

std::vector<Proof> tree_proofs(const View& view, const QueryPlaces* query) {
  if (!view.at_end()) return {};
  const TreeRun& run = tree_run(view.run());
  if (run.is_merging()) return {contains_all(run)};
  if (const TreePairing* pairing = run.pairing()) {
    std::vector<NodePair> found = pairing->found();
    std::sort(found.begin(), found.end());
    const bool same = found == pairs_one_by_one(run.boxes(), *query);
    return {
        {same ? "testing every pair of boxes finds the same pairs" : "testing every pair of boxes finds other pairs",
         same, true}};
  }
  if (run.undecided() != kNoIndex) return {};
  if (!run.is_query() && !run.is_whole()) return {};
  if (!run.is_query() && run.nodes() != NodeKind::kAabb) return {contains_all(run)};
  if (!run.is_query())
    return {
        {"each box is in one leaf, and each node's box is the smallest around those below it", is_sound(run), true}};
  const bool same = run.result().found == found_one_by_one(view.method().name, *query, run.boxes());
  return {{same ? "testing every box finds the same boxes" : "testing every box finds other boxes", same, true}};
}

}  // namespace snug::lesson
