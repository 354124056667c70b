// A tree's volumes made anew from the leaves up, by merging, in three kinds of volume; and what that loses.
#pragma once

#include <string_view>
#include <vector>

#include "fit/any_step.hpp"
#include "lesson/subjects/tree/tree_methods.hpp"

namespace snug::lesson {

/// merge_aabb, merge_sphere, merge_obb, rebuild.
[[nodiscard]] std::span<const Method> update_methods();
[[nodiscard]] inline bool merges(std::string_view method) { return method.starts_with("merge_"); }

/// The volumes of a tree's nodes, lifted to 3-D.
struct MergedVolumes {
  std::vector<fit::Volume3> merged;  // of both children; a leaf's is the one around its box
  std::vector<fit::Volume3> tight;   // the smallest of the kind around the vertices of all boxes below
};

/// Keeps the tree's shape. trace: null, or where its steps are appended. method: one that merges.
[[nodiscard]] MergedVolumes merge_volumes(std::string_view method, const TreeOfBoxes& tree, std::span<const Box2> boxes,
                                          TreeTrace* trace = nullptr);

/// The same tree with the boxes that its nodes need now.
[[nodiscard]] TreeOfBoxes refitted(TreeOfBoxes tree, std::span<const Box2> boxes);

}  // namespace snug::lesson
