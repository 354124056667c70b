#include "lesson/subjects/tree/tree_merge.hpp"

#include "fit/catalogue.hpp"
#include "fit/lift.hpp"
#include "geometry/point_set.hpp"
#include "hierarchy/build.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<std::string_view, 4> kMergePseudocode{
    "for each node, children before parents",
    "  leaf: volume ← around its box",
    "  else volume ← merged from both children",
    "the tree's shape stays as it was",
};

constexpr std::string_view kMerging = "C. Ericson, Real-Time Collision Detection, 2005, 6.5";
constexpr std::array kUpdateMethods{
    Method{kTreeUpdate, "merge_aabb", "Merge: AABBs", kMerging, kMergePseudocode},
    Method{kTreeUpdate, "merge_sphere", "Merge: circles", "D. Eberly, 3D Game Engine Design, 2000", kMergePseudocode},
    Method{kTreeUpdate, "merge_obb", "Merge: OBBs", kMerging, kMergePseudocode},
    Method{kTreeUpdate, "rebuild", "Rebuild, surface area",
           "J. Goldsmith, J. Salmon, Automatic creation of object hierarchies, 1987",
           hierarchy::kSurfaceAreaPseudocode},
};

/// The smallest volume around the vertices of some boxes.
fit::Volume3 tight_around(std::string_view kind, std::span<const Index> below, std::span<const Box2> boxes) {
  std::vector<Point2> vertices;
  for (const Index i : below) {
    const Box2& box = boxes[i];
    for (const double x : {box.min[0], box.max[0]})
      for (const double y : {box.min[1], box.max[1]}) vertices.emplace_back(x, y);
  }
  const AnyPointSet points = *PointSet<double, 2>::make(std::move(vertices));
  return fit::exact_algorithm(kind)->fit(points, {}).volume;
}

template <class Kind>
std::vector<fit::Volume3> merge_kind(NodeKind kind, const TreeOfBoxes& tree, std::span<const Box2> boxes,
                                     TreeTrace* trace) {
  hierarchy::Tree<Kind> own;
  own.bodies = tree.bodies;
  for (const auto& node : tree.nodes) own.nodes.push_back({Kind(), node.first, node.count});
  std::vector<Kind> volumes;
  for (const Box2& box : boxes) volumes.push_back(std::get<Kind>(volume_around(kind, box)));
  Recorder<hierarchy::Step> recorder;
  hierarchy::refit(own, std::span<const Kind>(volumes), recorder);
  if (trace != nullptr)
    for (const auto& entry : recorder.entries) {
      const auto* fact = std::get_if<hierarchy::VolumeMade>(&entry.step.fact);
      if (fact != nullptr) trace->push_back({{own.nodes[fact->node].is_leaf() ? 1 : 2, *fact}, entry.counts});
    }
  std::vector<fit::Volume3> lifted;
  for (const auto& node : own.nodes) lifted.emplace_back(fit::lift(node.volume));
  return lifted;
}

}  // namespace

std::span<const Method> update_methods() { return kUpdateMethods; }

MergedVolumes merge_volumes(std::string_view method, const TreeOfBoxes& tree, std::span<const Box2> boxes,
                            TreeTrace* trace) {
  const std::string_view kind = method.substr(std::string_view("merge_").size());
  MergedVolumes all;
  all.merged = kind == "sphere" ? merge_kind<Sphere<double, 2>>(NodeKind::kSphere, tree, boxes, trace)
               : kind == "obb"  ? merge_kind<Obb<double, 2>>(NodeKind::kObb, tree, boxes, trace)
                                : merge_kind<Box2>(NodeKind::kAabb, tree, boxes, trace);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    all.tight.push_back(tight_around(kind, tree.bodies_below(static_cast<Index>(i)), boxes));
  return all;
}

TreeOfBoxes refitted(TreeOfBoxes tree, std::span<const Box2> boxes) {
  hierarchy::refit(tree, boxes);
  return tree;
}

}  // namespace snug::lesson
