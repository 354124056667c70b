// Every way to cull a field gives each box the exact answer, and counts what it tests.
#include "hierarchy/field.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "core/query/exact_planes.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "query/cull/frustum_sat.hpp"
#include "query/cull/vertices_along.hpp"

using namespace snug;
using hierarchy::Field;
using hierarchy::FieldCost;
using hierarchy::FieldRecord;
using hierarchy::FieldWay;
using query::Culling;

namespace {

constexpr std::array kWays{FieldWay::kAllVertices, FieldWay::kPnVertex, FieldWay::kSpheresFirst,
                           FieldWay::kLastPlane,   FieldWay::kTree,     FieldWay::kAtOnce};

/// Boxes of many sizes; on whole numbers many of them touch the planes of a frustum along the axes.
std::vector<Field::Box> any_boxes(int count, std::uint64_t seed, bool whole) {
  Random random(seed);
  std::vector<Field::Box> boxes(count);
  for (auto& box : boxes)
    for (int axis = 0; axis < 3; ++axis) {
      const double low = random.between(-12, 12), size = random.between(0, 3);
      box.min[axis] = whole ? std::floor(low) : low;
      box.max[axis] = box.min[axis] + (whole ? std::floor(size) : size);
    }
  return boxes;
}

Frustum<double, 3> any_frustum(std::uint64_t seed, bool whole) {
  Random random(seed);
  FrustumCamera<double, 3> camera{.near = 1, .far = 1 + random.between(1, 20)};
  for (int axis = 0; axis < 3; ++axis) camera.position[axis] = random.between(-12, 12);
  camera.half_tangents = {random.between(0.1, 1.5), random.between(0.1, 1.5)};
  const double x = random.between(-1, 1), y = random.between(-1, 1), angle = random.between(0, 3);
  if (!whole) {
    camera.axes = turn(Vector<double, 3>(x, y, 1), angle);
  } else {
    camera.half_tangents = {1, 1};
    for (int axis = 0; axis < 3; ++axis) camera.position[axis] = std::floor(camera.position[axis]);
    camera.far = std::floor(camera.far);
  }
  return *frustum_of_camera(camera);
}

std::vector<Culling> culled_by(FieldWay way, const Field& field, const Frustum<double, 3>& frustum,
                               std::vector<std::int8_t>& last, FieldCost& cost, FieldRecord* record = nullptr) {
  std::vector<Culling> verdicts(field.boxes.size());
  cost = hierarchy::cull_field(field, frustum, way, last, verdicts, record);
  return verdicts;
}

}  // namespace

TEST_CASE("every way to cull a field says of each box what exact arithmetic says, from frame to frame") {
  std::array<int, 3> seen{};
  int touching = 0;
  for (std::uint64_t seed = 1; seed <= 120; ++seed) {
    CAPTURE(seed);
    const bool whole = seed % 3 == 0;
    const Field field(any_boxes(seed % 4 == 1 ? 1 + static_cast<int>(seed % 9) : 203, seed, whole));
    std::vector<std::int8_t> last(field.boxes.size(), -1);
    for (std::uint64_t frame = 0; frame < 3; ++frame) {
      const auto frustum = any_frustum(3 * seed + frame, whole);
      std::vector<Culling> truth;
      for (const auto& box : field.boxes) truth.push_back(exact::classify(frustum, exact::sum_of(box)));
      for (const FieldWay way : kWays) {
        CAPTURE(hierarchy::kFieldWayNames[static_cast<std::size_t>(way)]);
        FieldCost cost;
        CHECK(culled_by(way, field, frustum, last, cost) == truth);
      }
      for (const Culling verdict : truth) ++seen[static_cast<std::size_t>(verdict)];
      for (const auto& box : field.boxes)
        for (const auto& plane : frustum.planes())
          for (int bits = 0; bits < 8; ++bits) touching += signed_distance(plane, query::corner_of(box, bits)) == 0;
    }
  }
  for (const int count : seen) CHECK(count > 500);
  CHECK(touching > 1000);
}

TEST_CASE("no way to cull a field loses a box that shares a point with the frustum") {
  int kept = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Field field(any_boxes(150, seed, false));
    const auto frustum = any_frustum(seed, false);
    const auto exact = query::FrustumSat<double, 3>::make(frustum);
    REQUIRE(exact.has_value());
    std::vector<std::int8_t> last(field.boxes.size(), static_cast<std::int8_t>(seed % 6));
    for (const FieldWay way : kWays) {
      FieldCost cost;
      const auto verdicts = culled_by(way, field, frustum, last, cost);
      for (std::size_t i = 0; i < field.boxes.size(); ++i)
        if (exact->overlaps(field.boxes[i])) {
          CHECK(verdicts[i] != Culling::kOutside);
          ++kept;
        }
    }
  }
  CHECK(kept > 1000);
}

TEST_CASE("the sphere around each box of a field contains it exactly") {
  const Field field(any_boxes(500, 7, false));
  for (std::size_t i = 0; i < field.boxes.size(); ++i)
    for (int bits = 0; bits < 8; ++bits)
      CHECK(side_of_sphere<double, 3>(query::corner_of(field.boxes[i], bits), field.spheres[i]) <= 0);
}

TEST_CASE("what is recorded of a culled field adds up to its cost") {
  const Field field(any_boxes(1000, 3, false));
  const auto frustum = any_frustum(5, false);
  std::vector<std::int8_t> last(field.boxes.size(), -1);
  FieldCost cost;
  FieldRecord record;

  culled_by(FieldWay::kAllVertices, field, frustum, last, cost, &record);
  CHECK(cost.planes == 6 * 1000);
  CHECK(cost.products == 48 * 1000);

  const auto one_by_one = culled_by(FieldWay::kPnVertex, field, frustum, last, cost, &record);
  std::int64_t planes = 0;
  for (std::size_t i = 0; i < one_by_one.size(); ++i)
    planes += one_by_one[i] == Culling::kOutside ? record.answers[i].rejected_by + 1 : 6;
  CHECK(cost.planes == planes);

  culled_by(FieldWay::kLastPlane, field, frustum, last, cost, &record);
  const FieldCost first = cost;
  culled_by(FieldWay::kLastPlane, field, frustum, last, cost, &record);
  CHECK(cost.planes < first.planes);
  for (std::size_t i = 0; i < one_by_one.size(); ++i)
    if (one_by_one[i] == Culling::kOutside) CHECK(record.answers[i].first == record.answers[i].rejected_by);

  culled_by(FieldWay::kTree, field, frustum, last, cost, &record);
  planes = 0;
  std::int64_t boxes = 0, skipped = 0;
  for (const hierarchy::LevelTests& level : record.levels) {
    planes += level.planes, boxes += level.left_out + level.taken, skipped += level.skipped;
    CHECK(level.planes + level.skipped <= 6 * level.volumes);
  }
  CHECK(cost.planes == planes);
  CHECK(skipped > 0);
  CHECK(boxes ==
        std::count_if(one_by_one.begin(), one_by_one.end(), [](Culling c) { return c != Culling::kIntersecting; }));
}
