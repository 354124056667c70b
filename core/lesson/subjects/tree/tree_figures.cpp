#include "lesson/subjects/tree/tree_figures.hpp"

#include <algorithm>

#include "hierarchy/cost.hpp"

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

std::vector<Figure> figures_of_growth(const TreeRun& run, int step) {
  const Forest& forest = run.forest(step);
  int depth = 0;
  for (const Index root : forest.roots) depth = std::max(depth, depth_of(forest, root));
  const bool done = step == run.steps();
  const double cost = run.cost(), median = hierarchy::expected_cost(build_tree("top_down_median", run.boxes()));
  const double share = 100 * (cost / median);
  return {count(done ? "Nodes" : "Nodes so far", "nodes", static_cast<std::int64_t>(forest.there().size())),
          count(done ? "Depth" : "Depth so far", "depth", depth),
          at_end("SAH cost", "cost", number_text(cost) + " tests", cost, "tests", done),
          at_end("Of the median tree's cost", "of_median", number_text(share) + " %", share, "%", done)};
}

/// How many tests front to back, of those that back to front takes.
Figure share_of_far_first(const TreeRun& run, int step) {
  const auto far = run_query("ray_far_first", run.query(), run.tree(), run.boxes()).counts.volume_tests();
  const double share = 100 * (static_cast<double>(run.state(run.steps()).tests()) / static_cast<double>(far));
  return at_end("Of the tests back to front", "of_far_first", number_text(share) + " %", share, "%",
                step == run.steps());
}

std::vector<Figure> figures_of_query(const TreeRun& run, int step) {
  const QueryState& state = run.state(step);
  const auto taken = std::count(state.boxes.begin(), state.boxes.end(), Met::kTaken);
  const auto left_out =
      std::count_if(state.boxes.begin(), state.boxes.end(), [](Met met) { return met == Met::kUnder; });
  std::vector<Figure> figures{count("Nodes visited", "visited", state.visited),
                              count("Tests of nodes", "node_tests", state.node_tests),
                              count("Tests of boxes", "box_tests", state.box_tests),
                              count("Tests in all", "tests", state.tests()),
                              count("Boxes left out untested", "left_out", left_out),
                              count("Boxes taken untested", "taken", taken),
                              count("Boxes met", "found", static_cast<std::int64_t>(state.found().size()))};
  if (run.tests_before()) figures.push_back(share_of_far_first(run, step));
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

}  // namespace

std::vector<Figure> tree_figures(const View& view) {
  const TreeRun& run = tree_run(view.run());
  return run.is_query() ? figures_of_query(run, view.step) : figures_of_growth(run, view.step);
}

std::vector<Proof> tree_proofs(const View& view, const QueryPlaces* query) {
  if (!view.at_end()) return {};
  const TreeRun& run = tree_run(view.run());
  if (!run.is_query())
    return {
        {"each box is in one leaf, and each node's box is the smallest around those below it", is_sound(run), true}};
  const bool same = run.result().found == found_one_by_one(view.method().name, *query, run.boxes());
  return {{same ? "testing every box finds the same" : "testing every box finds others", same, true}};
}

}  // namespace snug::lesson
