#include "desktop/cli/cull_tree.hpp"

#include "desktop/cli/fact_json.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/cost.hpp"
#include "hierarchy/cull.hpp"

namespace snug::desktop {
namespace {

using hierarchy::Step;

/// A kind of which a tree can be built: two of its volumes merge into one.
template <class Kind>
concept Mergeable = requires(const Kind& a, const Kind& b) {
  fit::merge(a, b);
};

template <class Kind>
hierarchy::Tree<Kind> build(const TreeRule& rule, std::span<const Kind> volumes, Recorder<Step>& steps) {
  const hierarchy::Options options{.most_in_leaf = static_cast<Index>(rule.most_in_leaf)};
  if (rule.name == "median") return hierarchy::build_median<Kind>(volumes, options, steps);
  if (rule.name == "surface_area") return hierarchy::build_surface_area<Kind>(volumes, options, steps);
  if (rule.name == "bottom_up") return hierarchy::build_bottom_up<Kind>(volumes, steps);
  return hierarchy::build_by_insertion<Kind>(volumes, steps);
}

void write(TraceFile& trace, std::string_view doing, const Recorder<Step>& steps, int dim) {
  if (!trace) return;
  for (const auto& entry : steps.entries) trace->write(trace_line({{"doing", doing}}, entry.step, dim));
}

template <class Scalar, int Dim, class Kind>
CulledByTree cull_kind(const TreeRule& rule, const Frustum<Scalar, Dim>& frustum, const std::vector<Kind>& volumes,
                       TraceFile& trace) {
  Recorder<Step> building, going;
  const std::span<const Kind> all(volumes);
  const hierarchy::Tree<Kind> tree = build<Kind>(rule, all, building);
  CulledByTree result{.classes = std::vector(volumes.size(), query::Culling::kOutside),
                      .nodes = static_cast<std::int64_t>(tree.nodes.size()),
                      .depth = tree.depth(),
                      .cost = hierarchy::expected_cost(tree)};
  const auto take = [&](Index body, query::Culling culling) { result.classes[body] = culling; };
  const auto cost_of = [](const hierarchy::Culled& culled) {
    return CullCost{culled.counts.volume_tests(), culled.planes_tested};
  };

  const hierarchy::Culled culled = hierarchy::cull(tree, all, frustum, take, going);
  result.nodes_visited = culled.counts.nodes_visited;
  result.by_tree = cost_of(culled);
  result.without_masks = cost_of(hierarchy::cull(
      tree, all, frustum, [](Index, query::Culling) {}, Ignore(), false));
  for (const Kind& volume : volumes) {
    ++result.one_by_one.volume_tests;
    result.one_by_one.planes_tested += query::classify(frustum, volume).planes_tested;
  }
  write(trace, "build", building, Dim), write(trace, "cull", going, Dim);
  return result;
}

}  // namespace

template <class Scalar, int Dim>
std::optional<CulledByTree> cull_by_tree(const TreeRule& rule, const Frustum<Scalar, Dim>& frustum,
                                         std::span<const Volume<Scalar, Dim>> volumes, TraceFile& trace) {
  if (volumes.empty()) return CulledByTree();
  return std::visit(
      [&]<class Kind>(const Kind&) -> std::optional<CulledByTree> {
        if constexpr (!Mergeable<Kind>) return std::nullopt;
        else {
          std::vector<Kind> of_kind;
          for (const auto& volume : volumes) of_kind.push_back(*std::get_if<Kind>(&volume));
          return cull_kind(rule, frustum, of_kind, trace);
        }
      },
      volumes.front());
}

template std::optional<CulledByTree> cull_by_tree(const TreeRule&, const Frustum<float, 2>&,
                                                  std::span<const Volume<float, 2>>, TraceFile&);
template std::optional<CulledByTree> cull_by_tree(const TreeRule&, const Frustum<float, 3>&,
                                                  std::span<const Volume<float, 3>>, TraceFile&);
template std::optional<CulledByTree> cull_by_tree(const TreeRule&, const Frustum<double, 2>&,
                                                  std::span<const Volume<double, 2>>, TraceFile&);
template std::optional<CulledByTree> cull_by_tree(const TreeRule&, const Frustum<double, 3>&,
                                                  std::span<const Volume<double, 3>>, TraceFile&);

}  // namespace snug::desktop
