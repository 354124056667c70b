#include "hierarchy/field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fit/sphere/aabb_center.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/cull.hpp"
#include "query/cull/classify.hpp"
#include "query/cull/classify_corners.hpp"

namespace snug::hierarchy {
namespace {

using query::Culling;
using query::CullResult;
using FieldBox = Field::Box;

constexpr int kPlanes = kFrustumPlanes<3>, kVertices = 8;

Sphere<double, 3> sphere_around(const FieldBox& box) {
  std::vector<Vector<double, 3>> vertices;
  for (int bits = 0; bits < kVertices; ++bits) vertices.push_back(query::corner_of(box, bits));
  return fit::aabb_center<double, 3>(PointSet<double, 3>::make(std::move(vertices)).value().span()).volume;
}

/// How many vertices were compared with planes: two for each plane, but one for the plane that rejects.
std::int64_t products_of(const CullResult& result) {
  return 2 * std::int64_t{result.planes_tested} - (result.rejected_by >= 0 ? 1 : 0);
}

/// How many vertices of a box are in a plane's positive half-space.
int outside_exactly(const Plane<double, 3>& plane, const FieldBox& box) {
  int outside = 0;
  for (int bits = 0; bits < kVertices; ++bits) outside += query::corner_is_outside(plane, box, bits) ? 1 : 0;
  return outside;
}

/// Culls with one of the ways that take the boxes one after the other.
struct OneByOne {
  const Field& field;
  const Frustum<double, 3>& frustum;
  std::span<Culling> verdicts;
  FieldRecord* record;
  FieldCost cost = {};

  void answer(std::size_t i, const CullResult& result, PlaneSet planes, int first = -1) {
    verdicts[i] = result.verdict;
    if (record != nullptr)
      record->answers[i] = {static_cast<std::int8_t>(result.rejected_by), static_cast<std::int8_t>(first),
                            static_cast<std::uint8_t>(planes)};
  }
  void pay(std::int64_t planes, std::int64_t products) {
    cost.planes += planes;
    cost.products += products;
  }

  /// Compares all vertices with all planes: the naive way.
  void all_vertices(std::size_t i) {
    const FieldBox& box = field.boxes[i];
    const double size = magnitude_of(box);
    std::array<Vector<double, 3>, kVertices> vertices;
    for (int bits = 0; bits < kVertices; ++bits) vertices[bits] = query::corner_of(box, bits);
    CullResult result;
    for (int at = 0; at < kPlanes; ++at) {
      int outside = 0;
      double nearest = HUGE_VAL;
      for (const Vector<double, 3>& vertex : vertices) {
        const double value = value_at<double>(frustum[at], vertex);
        outside += value > 0 ? 1 : 0;
        nearest = std::min(nearest, std::abs(value));
      }
      if (nearest <= query::error_bound_of(frustum[at], size)) outside = outside_exactly(frustum[at], box);
      if (outside == kVertices && result.rejected_by < 0) result.rejected_by = at;
      if (outside > 0 && result.verdict == Culling::kInside) result.verdict = Culling::kIntersecting;
    }
    if (result.rejected_by >= 0) result.verdict = Culling::kOutside;
    pay(kPlanes, std::int64_t{kPlanes} * kVertices);
    answer(i, result, kAllPlanes<3>);
  }

  void p_n_vertex(std::size_t i) {
    const CullResult result = query::classify(frustum, field.boxes[i]);
    pay(result.planes_tested, products_of(result));
    answer(i, result, kAllPlanes<3>);
  }

  void sphere_first(std::size_t i) {
    const CullResult sphere = query::classify(frustum, field.spheres[i]);
    pay(sphere.planes_tested, sphere.planes_tested);
    if (record != nullptr) record->sphere_planes += sphere.planes_tested;
    if (sphere.verdict != Culling::kIntersecting) {
      CullResult result;
      result.verdict = sphere.verdict;
      return answer(i, result, 0);
    }
    const CullResult result = query::classify(frustum, field.boxes[i], {.planes = sphere.crossing});
    pay(result.planes_tested, products_of(result));
    answer(i, result, sphere.crossing);
  }

  /// The boxes from one up to another.
  void all(FieldWay way, std::size_t from, std::size_t to, std::span<std::int8_t> last) {
    for (std::size_t i = from; i < to; ++i) {
      if (way == FieldWay::kAllVertices) all_vertices(i);
      else if (way == FieldWay::kPnVertex) p_n_vertex(i);
      else if (way == FieldWay::kSpheresFirst) sphere_first(i);
      else last_plane(i, last[i]);
    }
  }

  void last_plane(std::size_t i, std::int8_t& last) {
    const int first = last;
    const CullResult result = query::classify(frustum, field.boxes[i], {.first = first});
    pay(result.planes_tested, products_of(result));
    answer(i, result, kAllPlanes<3>, first);
    if (result.rejected_by >= 0) last = static_cast<std::int8_t>(result.rejected_by);
  }
};

/// Adds up what a traversal tests, and keeps it by levels where that is wanted.
struct TreeTeller {
  const Field& field;
  FieldRecord* record;
  FieldCost cost = {};

  void operator()(const Step&) const {}
  void count(Operation, std::int64_t) const {}
  void tested(Place place, PlaneSet planes, const CullResult& result) {
    cost.planes += result.planes_tested;
    cost.products += products_of(result);
    if (record == nullptr) return;
    const std::size_t at = place.index;
    const int level = place.is_body ? field.leaf_levels[at] + 1 : field.levels[at];
    LevelTests& tests = record->levels[level];
    const PlaneSet reached = result.rejected_by >= 0 ? (PlaneSet{1} << result.rejected_by) - 1
                                                     : kAllPlanes<3>;  // tested, or skipped by the mask
    ++tests.volumes;
    tests.planes += result.planes_tested;
    tests.skipped += std::popcount(reached & ~planes);
    if (result.verdict == Culling::kIntersecting && !place.is_body) return;
    const std::span<const Index> below =
        place.is_body ? std::span(&place.index, 1) : field.tree.bodies_below(place.index);
    for (const Index body : below) record->answers[body].level = static_cast<std::uint8_t>(level);
    const auto boxes = static_cast<std::int64_t>(below.size());
    if (result.verdict == Culling::kOutside) {
      ++tests.rejected;
      tests.left_out += boxes;
    }
    if (result.verdict == Culling::kInside) tests.taken += boxes;
  }
};

FieldCost down_the_tree(const Field& field, const Frustum<double, 3>& frustum, std::span<Culling> verdicts,
                        FieldRecord* record) {
  std::fill(verdicts.begin(), verdicts.end(), Culling::kOutside);
  if (record != nullptr)
    record->levels.resize(
        static_cast<std::size_t>(2 + *std::max_element(field.leaf_levels.begin(), field.leaf_levels.end())));
  TreeTeller teller{field, record};
  cull<double, 3>(
      field.tree, std::span<const FieldBox>(field.boxes), frustum,
      [&](Index body, Culling verdict) { verdicts[body] = verdict; }, teller);
  return teller.cost;
}

FieldCost all_at_once(const Field& field, const Frustum<double, 3>& frustum, std::span<Culling> verdicts) {
  query::classify_all(frustum, field.lanes, verdicts);
  FieldCost cost;
  constexpr std::size_t kBlock = query::AabbArray<double>::kBlock;
  for (std::size_t begin = 0; begin < verdicts.size(); begin += kBlock) {
    const auto block = verdicts.subspan(begin, std::min(kBlock, verdicts.size() - begin));
    const bool empty = std::all_of(block.begin(), block.end(), [](Culling c) { return c == Culling::kOutside; });
    cost.planes += static_cast<std::int64_t>(kPlanes * block.size());
    cost.products += static_cast<std::int64_t>((empty ? 1 : 2) * kPlanes * block.size());
  }
  return cost;
}

}  // namespace

Field::Field(std::vector<Box> all) : boxes(std::move(all)), lanes(boxes) {
  spheres.reserve(boxes.size());
  for (const Box& box : boxes) spheres.push_back(sphere_around(box));
  tree = build_median<Box>(std::span<const Box>(boxes));
  levels.assign(tree.nodes.size(), 0);
  leaf_levels.assign(boxes.size(), 0);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const std::size_t first = tree.nodes[i].first;
    if (!tree.nodes[i].is_leaf()) levels[first] = levels[first + 1] = levels[i] + 1;
    else
      for (const Index body : tree.bodies_below(static_cast<Index>(i))) leaf_levels[body] = levels[i];
  }
}

FieldCost cull_field(const Field& field, const Frustum<double, 3>& frustum, FieldWay way, std::span<std::int8_t> last,
                     std::span<Culling> verdicts, FieldRecord* record) {
  if (record != nullptr) *record = {.answers = std::vector<FieldAnswer>(field.boxes.size())};
  if (way == FieldWay::kTree) return down_the_tree(field, frustum, verdicts, record);
  if (way == FieldWay::kAtOnce) return all_at_once(field, frustum, verdicts);
  OneByOne test{field, frustum, verdicts, record};
  test.all(way, 0, field.boxes.size(), last);
  return test.cost;
}

FieldCost cull_boxes(const Field& field, const Frustum<double, 3>& frustum, FieldWay way, std::size_t from,
                     std::size_t to, std::span<std::int8_t> last, std::span<Culling> verdicts) {
  OneByOne test{field, frustum, verdicts, nullptr};
  test.all(way, from, to, last);
  return test.cost;
}

}  // namespace snug::hierarchy
