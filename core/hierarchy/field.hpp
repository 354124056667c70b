// A field of boxes, and six ways to find out which of them a camera sees. All give the answer of query::classify for
// each box; they differ in how many planes they test.
// Source: U. Assarsson, T. Möller, "Optimized View Frustum Culling Algorithms for Bounding Boxes", 2000.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/frustum.hpp"
#include "geometry/sphere.hpp"
#include "hierarchy/tree.hpp"
#include "query/cull/batch/classify_batch.hpp"

namespace snug::hierarchy {

/// Boxes that stay where they are, and what is computed of them once.
struct Field {
  using Box = Aabb<double, 3>;
  /// boxes: at least one.
  explicit Field(std::vector<Box> boxes);

  std::vector<Box> boxes;
  std::vector<Sphere<double, 3>> spheres;  // around each box, which it contains exactly
  query::AabbArray<double> lanes;          // the boxes again, for query::classify_all
  Tree<Box> tree;                          // by the median
  std::vector<int> levels;                 // of the tree's nodes: 0 of the root
  std::vector<int> leaf_levels;            // for each box, that of its leaf
};

enum class FieldWay : std::uint8_t {
  kAllVertices,   // all eight vertices of each box against all six planes
  kPnVertex,      // one by one: two vertices for each plane, up to the first plane that rejects
  kSpheresFirst,  // first a sphere around the box, then the box against those planes that the sphere crosses
  kLastPlane,     // first the plane that rejected the box in the frame before
  kTree,          // down a tree, without those planes that the parent is inside of
  kAtOnce,        // query::classify_all: a box in each lane of the machine's vectors
};
inline constexpr std::array<std::string_view, 6> kFieldWayNames{"all_vertices", "p_n_vertex",   "spheres_first",
                                                                "last_plane",   "tree_masking", "at_once"};

/// How a box got its answer.
struct FieldAnswer {
  std::int8_t rejected_by = -1;  // the plane that the box itself was found outside of; -1 for none
  std::int8_t first = -1;        // the plane that was tested first, out of turn; -1 for none
  std::uint8_t planes = 0;       // the planes that the box itself was to be tested against: bit i for plane i
  std::uint8_t level = 0;        // of the tree: where its answer was found, a level below its leaf for its own test
};

/// What was tested on a level of the tree. Boxes that are tested themselves are a level below their leaf.
struct LevelTests {
  std::int64_t volumes = 0;   // nodes and boxes that were tested
  std::int64_t planes = 0;    // planes tested
  std::int64_t skipped = 0;   // planes skipped, since the parent is inside of them
  std::int64_t rejected = 0;  // of the volumes
  std::int64_t left_out = 0;  // boxes found outside: rejected, alone or with their node
  std::int64_t taken = 0;     // boxes found inside of all planes, alone or with their node
};

/// What a lesson shows of a culled field, besides the answers.
struct FieldRecord {
  std::vector<FieldAnswer> answers;
  std::int64_t sphere_planes = 0;  // planes tested against spheres
  std::vector<LevelTests> levels;
};

struct FieldCost {
  std::int64_t planes = 0;    // tests of a plane against a volume, whichever way
  std::int64_t products = 0;  // n · p + d computed, of a vertex or a centre
};

/// Writes to verdicts[i] what query::classify says of box i. last: for kLastPlane, as many as the boxes: the plane that
/// rejected each last, -1 for none; where this frame rejects one, its plane takes that place. verdicts: as many as the
/// boxes. record: null, or where to keep how it came about.
FieldCost cull_field(const Field& field, const Frustum<double, 3>& frustum, FieldWay way, std::span<std::int8_t> last,
                     std::span<query::Culling> verdicts, FieldRecord* record = nullptr);

/// Whether a way takes the boxes one after the other, so that it can be done in parts.
[[nodiscard]] constexpr bool one_by_one(FieldWay way) { return way != FieldWay::kTree && way != FieldWay::kAtOnce; }

/// The same for the boxes from `from` up to, and without, `to` alone. way: takes boxes one by one.
FieldCost cull_boxes(const Field& field, const Frustum<double, 3>& frustum, FieldWay way, std::size_t from,
                     std::size_t to, std::span<std::int8_t> last, std::span<query::Culling> verdicts);

}  // namespace snug::hierarchy
