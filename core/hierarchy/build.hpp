// Builds trees over volumes of any kind, in four ways, and refits them after their bodies have moved.
// Source: C. Ericson, Real-Time Collision Detection, 2005, 6.2, for building; each way's own stands with its shape, in
// top_down.hpp, sah.hpp, bottom_up.hpp and insertion.hpp. G. van den Bergen, "Efficient collision detection of complex
// deformable models using AABB trees", 1997, for refitting.
#pragma once

#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "fit/merge/merge.hpp"
#include "hierarchy/bottom_up.hpp"
#include "hierarchy/insertion.hpp"
#include "hierarchy/steps.hpp"
#include "hierarchy/top_down.hpp"
#include "hierarchy/tree.hpp"
#include "trace/observer.hpp"

namespace snug::hierarchy {

struct Options {
  Index most_in_leaf = 4;  // >= 1; for trees built from the root down
};

template <class VolumeType>
using Volumes = std::type_identity_t<std::span<const VolumeType>>;

/// Recomputes every node's volume after the bodies' volumes have changed, in one pass from the last node to the first,
/// so that children come before their parent. The tree keeps its shape, so it may get worse but never wrong. A node's
/// volume contains those of its bodies exactly, because merging does (fit/merge/merge.hpp). O(n) merges. volumes: as
/// many as the tree was built from. line: the pseudocode's line for its steps.
template <class VolumeType, StepObserver<Step> Observer = Ignore>
void refit(Tree<VolumeType>& tree, Volumes<VolumeType> volumes, Observer&& observe = {}, int line = 1) {
  const auto body = [&](Index i) -> const VolumeType& { return volumes[tree.bodies[i]]; };
  for (std::size_t i = tree.nodes.size(); i-- > 0;) {
    Node<VolumeType>& node = tree.nodes[i];
    if (node.is_leaf()) {
      node.volume = body(node.first);
      for (Index k = 1; k < node.count; ++k) node.volume = fit::merge(node.volume, body(node.first + k));
    } else {
      const std::size_t left = node.first;
      node.volume = fit::merge(tree.nodes[left].volume, tree.nodes[left + 1].volume);
    }
    observe(Step{line, VolumeMade{static_cast<Index>(i)}});
  }
}

/// Makes a tree of the shape, with the nodes' volumes.
template <class VolumeType, class Observer>
[[nodiscard]] Tree<VolumeType> fill(Shape&& shape, Volumes<VolumeType> volumes, int line, Observer& observe) {
  Tree<VolumeType> tree;
  tree.bodies = std::move(shape.bodies);
  tree.nodes.resize(shape.nodes.size());
  for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
    tree.nodes[i].first = shape.nodes[i].first;
    tree.nodes[i].count = shape.nodes[i].count;
  }
  refit(tree, volumes, observe, line);
  observe(Step{line, Done{static_cast<std::int64_t>(tree.nodes.size()), 0}});
  return tree;
}

/// Builds a tree's shape from the root down. line_of: the pseudocode's line for each fact, by its index in
/// TopDownFacts' variant.
template <class VolumeType, class Observer>
[[nodiscard]] Tree<VolumeType> build_top_down(Volumes<VolumeType> volumes, SplitRule rule, const Options& options,
                                              std::array<int, 3> line_of, Observer& observe) {
  TopDownFacts facts;
  Shape shape = lay_out_top_down(layout_of(volumes), rule, options.most_in_leaf, kWatched<Observer> ? &facts : nullptr);
  for (const auto& fact : facts) std::visit([&](const auto& f) { observe(Step{line_of[fact.index()], f}); }, fact);
  return fill<VolumeType>(std::move(shape), volumes, 5, observe);
}

/// Halves at the median of the centres, along the axis where they spread most: the shallowest tree. O(n log n) time.
/// volumes: any number, also 0; each hull has a vertex. As with all builders, nodes contain their bodies exactly, ties
/// are broken by index, and the same volumes make the same tree, bit for bit.
template <class VolumeType, StepObserver<Step> Observer = Ignore>
[[nodiscard]] Tree<VolumeType> build_median(Volumes<VolumeType> volumes, const Options& options = {},
                                            Observer&& observe = {}) {
  return build_top_down<VolumeType>(volumes, SplitRule::kMedian, options, {3, 3, 1}, observe);
}

/// Splits where a traversal is expected to be cheapest: where the sum of the children's surface areas, each times its
/// number of bodies, is least. O(n log n) time.
template <class VolumeType, StepObserver<Step> Observer = Ignore>
[[nodiscard]] Tree<VolumeType> build_surface_area(Volumes<VolumeType> volumes, const Options& options = {},
                                                  Observer&& observe = {}) {
  return build_top_down<VolumeType>(volumes, SplitRule::kSurfaceArea, options, {3, 4, 1}, observe);
}

/// Merges nearest pairs, from single bodies up. Each leaf has one body. O(n^2) time: enough for some ten thousand
/// bodies.
template <class VolumeType, StepObserver<Step> Observer = Ignore>
[[nodiscard]] Tree<VolumeType> build_bottom_up(Volumes<VolumeType> volumes, Observer&& observe = {}) {
  std::vector<NodesMerged> facts;
  Shape shape = lay_out_bottom_up(layout_of(volumes), kWatched<Observer> ? &facts : nullptr);
  for (const NodesMerged& fact : facts) observe(Step{3, fact});
  return fill<VolumeType>(std::move(shape), volumes, 4, observe);
}

/// Inserts one body after the other where the tree's surface areas grow least. Each leaf has one body.
template <class VolumeType, StepObserver<Step> Observer = Ignore>
[[nodiscard]] Tree<VolumeType> build_by_insertion(Volumes<VolumeType> volumes, Observer&& observe = {}) {
  InsertionFacts facts;
  Shape shape = lay_out_by_insertion(layout_of(volumes), kWatched<Observer> ? &facts : nullptr);
  for (const auto& fact : facts) std::visit([&](const auto& f) { observe(Step{fact.index() == 0 ? 4 : 5, f}); }, fact);
  return fill<VolumeType>(std::move(shape), volumes, 6, observe);
}

// Trees of boxes and of spheres, with a Recorder and without an observer, are compiled once, in build.cpp. The volume's
// type comes last, since its comma makes it two arguments.
#define SNUG_TREES_OF(EXTERN, Observer, ...)                                                                           \
  EXTERN template void refit(Tree<__VA_ARGS__>&, Volumes<__VA_ARGS__>, Observer, int);                                 \
  EXTERN template Tree<__VA_ARGS__> build_median<__VA_ARGS__>(Volumes<__VA_ARGS__>, const Options&, Observer);         \
  EXTERN template Tree<__VA_ARGS__> build_surface_area<__VA_ARGS__>(Volumes<__VA_ARGS__>, const Options&, Observer);   \
  EXTERN template Tree<__VA_ARGS__> build_bottom_up<__VA_ARGS__>(Volumes<__VA_ARGS__>, Observer);                      \
  EXTERN template Tree<__VA_ARGS__> build_by_insertion<__VA_ARGS__>(Volumes<__VA_ARGS__>, Observer);
#define SNUG_TREES(EXTERN, Scalar, Dim)                                                                                \
  SNUG_TREES_OF(EXTERN, Ignore&&, Aabb<Scalar, Dim>)                                                                   \
  SNUG_TREES_OF(EXTERN, Recorder<Step>&, Aabb<Scalar, Dim>)                                                            \
  SNUG_TREES_OF(EXTERN, Ignore&&, Sphere<Scalar, Dim>)                                                                 \
  SNUG_TREES_OF(EXTERN, Recorder<Step>&, Sphere<Scalar, Dim>)
SNUG_TREES(extern, float, 2)
SNUG_TREES(extern, float, 3)
SNUG_TREES(extern, double, 2)
SNUG_TREES(extern, double, 3)

}  // namespace snug::hierarchy
