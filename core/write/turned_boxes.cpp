// The AABB of a rotated AABB, one row of the separating axis test of two oriented boxes, and the whole test.
#include <algorithm>

#include "fit/update/update_rotated_box.hpp"
#include "geometry/pose.hpp"
#include "query/overlap/overlaps.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace turned_boxes {
namespace {

using Rotation = Matrix<double, 3>;

/// One of the 24 that map the axes to axes.
Rotation quarter_turns(Cases& cases) {
  Rotation m = Rotation::Identity();
  for (int i = 0; i < 3; ++i) {
    Rotation turn = Rotation::Zero();
    const int axis = static_cast<int>(cases.random.below(3));
    turn(axis, axis) = 1;
    turn((axis + 2) % 3, (axis + 1) % 3) = 1;
    turn((axis + 1) % 3, (axis + 2) % 3) = -1;
    m = (turn * m).eval();
  }
  return m;
}

Vector3 whole_extents(Cases& cases, int least) {
  const double x = cases.whole(least, 8), y = cases.whole(least, 8);
  return {x, y, cases.whole(least, 8)};
}

bool is_rotation(const Rotation& m) { return (m.transpose() * m - Rotation::Identity()).cwiseAbs().maxCoeff() < kNear; }

// ---- the AABB of a rotated AABB ----------------------------------------------------------------------------------

enum RotatedKind { kRandom, kQuarter, kFlat, kTiny, kFar };
constexpr std::array kRotatedKinds{
    Kind{"random", "random rotations"},
    Kind{"quarter", "quarter turns, whose entries are 0, 1 and -1"},
    Kind{"flat", "boxes without a width, down to single points"},
    Kind{"tiny", "very small boxes"},
    Kind{"far", "boxes far from the origin"},
};

void make_rotated(Cases& cases) {
  each_kind(kRotatedKinds, [&](int kind, int) {
    const Scale scale = kind == kTiny ? kTinyScale : kind == kFar ? kFarScale : kPlain;
    Vector3 extents = whole_extents(cases, kind == kFlat ? 0 : 1);
    if (kind == kFlat) extents[static_cast<int>(cases.random.below(3))] = 0;
    const Rotation rotation = kind == kQuarter ? quarter_turns(cases) : random_rotation(cases);
    cases.add(kind, numbers_of(scale(whole_point(cases, 10)), Vector3(extents * scale.factor), rotation));
  });
}

/// The core's update rotates the box about the origin, so that the box keeps its digits however far away it lies.
Numbers rotated(const Numbers& input) {
  Take take(input);
  const Vector3 center = take.vector(), extents = take.vector();
  const Rotation rotation = take.rows();
  const Aabb<double, 3> box{-extents, extents};
  const auto updated = fit::update_rotated_box(box, Pose<double, 3>{rotation, Vector3::Zero()});
  return numbers_of(turned<double, 3>(rotation, center), updated.volume.max);
}

bool is_rotated(const Numbers& input, const Numbers& answer) {
  Take take(input);
  const Vector3 center = take.vector(), extents = take.vector();
  const Numbers right = rotated(input);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_near(answer[i], right[i], center.norm())) return false;
    if (!is_near(answer[i + 3], right[i + 3], extents.norm())) return false;
  }
  return true;
}

bool is_rotated_input(const Numbers& input) {
  Take take(input);
  take.vector();
  const Vector3 extents = take.vector();
  return extents.minCoeff() >= 0 && is_rotation(take.rows());
}

// ---- two oriented boxes ------------------------------------------------------------------------------------------

using Boxes = std::array<Obb<double, 3>, 2>;

Numbers boxes_input(const Boxes& boxes, const Scale& scale) {
  const auto& [a, b] = boxes;
  return numbers_of(scale(a.center), Rotation(a.axes.transpose()), Vector3(a.half_extents * scale.factor),
                    scale(b.center), Rotation(b.axes.transpose()), Vector3(b.half_extents * scale.factor));
}

Boxes take_boxes(Take& take) {
  Boxes boxes;
  for (auto& [center, axes, half_extents] : boxes)
    center = take.vector(), axes = take.rows().transpose().eval(), half_extents = take.vector();
  return boxes;
}

Boxes random_boxes(Cases& cases, int reach) {
  Boxes boxes;
  for (auto& [center, axes, half_extents] : boxes)
    center = whole_point(cases, reach), axes = random_rotation(cases), half_extents = whole_extents(cases, 1);
  return boxes;
}

bool are_boxes(const Boxes& boxes) {
  return std::all_of(boxes.begin(), boxes.end(),
                     [](const auto& box) { return box.half_extents.minCoeff() >= 0 && is_rotation(box.axes); });
}

/// The radius of the box's projection onto a unit axis.
double projected_radius(Obb<double, 3> box, const Vector3& axis) {
  box.center.setZero();
  return core_span<double>(Plane<double, 3>{axis, 0}, box).high;
}

// ---- one row of the test -----------------------------------------------------------------------------------------

enum RowKind { kAnyRow, kAligned, kFlatRow, kRowTiny, kRowFar };
constexpr std::array kRowKinds{
    Kind{"random", "random boxes and axes"},
    Kind{"aligned", "boxes whose axes are those of the world, also the other way round"},
    Kind{"flat", "boxes without a width, down to single points"},
    Kind{"tiny", "very small boxes"},
    Kind{"far", "boxes far from the origin"},
};

void make_rows(Cases& cases) {
  each_kind(kRowKinds, [&](int kind, int) {
    const Scale scale = kind == kRowTiny ? kTinyScale : kind == kRowFar ? kFarScale : kPlain;
    Boxes boxes = random_boxes(cases, 10);
    for (auto& box : boxes) {
      if (kind == kAligned) box.axes = quarter_turns(cases);
      if (kind == kFlatRow) box.half_extents[static_cast<int>(cases.random.below(3))] = 0;
    }
    const Vector3 axis = kind == kAligned ? quarter_turns(cases).col(0) : random_rotation(cases).col(0);
    Numbers input = boxes_input(boxes, scale);
    put(input, axis);
    cases.add(kind, std::move(input));
  });
}

Numbers row(const Numbers& input) {
  Take take(input);
  const auto [a, b] = take_boxes(take);
  const Vector3 axis = take.vector();
  return {std::abs((b.center - a.center).dot(axis)), projected_radius(a, axis), projected_radius(b, axis)};
}

bool is_row(const Numbers& input, const Numbers& answer) {
  Take take(input);
  const auto [a, b] = take_boxes(take);
  return are_near(answer, row(input), (b.center - a.center).norm() + a.half_extents.norm() + b.half_extents.norm());
}

bool is_row_input(const Numbers& input) {
  Take take(input);
  return are_boxes(take_boxes(take)) && std::abs(take.vector().norm() - 1) < kNear;
}

// ---- the whole test ----------------------------------------------------------------------------------------------

enum SatKind { kAnyBoxes, kFaces, kEdges, kParallel, kSatTouching, kSatInside, kSatTiny, kSatFar };
constexpr std::array kSatKinds{
    Kind{"random", "random boxes"},
    Kind{"faces", "boxes that a face of one of them alone separates"},
    Kind{"edges", "boxes that only the cross product of two edges separates"},
    Kind{"parallel", "boxes with parallel edges, whose cross product is zero, or almost"},
    Kind{"touching", "boxes that only touch, or almost"},
    Kind{"inside", "boxes of which one contains the other"},
    Kind{"tiny", "very small boxes"},
    Kind{"far", "boxes far from the origin"},
};

bool overlap(const Boxes& boxes) { return query::overlaps(boxes[0], boxes[1]); }

/// Whether rounding cannot change the answer.
bool is_clear(const Boxes& boxes) {
  constexpr double kClear = 1e-6;
  Boxes larger = boxes, smaller = boxes;
  for (std::size_t i = 0; i < 2; ++i) {
    const double by = kClear * (boxes[0].half_extents.sum() + boxes[1].half_extents.sum());
    larger[i].half_extents.array() += by;
    smaller[i].half_extents = (boxes[i].half_extents.array() - by).max(0).matrix();
  }
  return overlap(larger) == overlap(smaller);
}

/// How many of the axes of this kind separate the boxes.
int separating(const Boxes& boxes, bool of_edges) {
  const Obb<double, 3>&a = boxes[0], &b = boxes[1];
  int count = 0;
  const auto test = [&](const Vector3& axis) {
    const double reach = projected_radius(a, axis) + projected_radius(b, axis);
    count += std::abs((b.center - a.center).dot(axis)) > reach ? 1 : 0;
  };
  for (int i = 0; i < 3; ++i) {
    if (!of_edges) test(a.axes.col(i)), test(b.axes.col(i));
    for (int j = 0; j < 3 && of_edges; ++j) test(a.axes.col(i).cross(b.axes.col(j)));
  }
  return count;
}

/// Boxes with the same axes: the second has a quarter turn of the first one's rotation, which rounds differently. Boxes
/// that only touch are not rotated.
Boxes parallel_boxes(Cases& cases, Relation relation, const Rotation& rotation) {
  const std::uint32_t chosen = cases.random.below(3);
  Boxes boxes;
  Vector3 center[2], extents[2];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Intervals pair = related(cases, i == chosen ? relation : Relation::kCrossing);
    for (std::size_t box = 0; box < 2; ++box) {
      center[box][i] = (pair[box].low + pair[box].high) / 2;
      extents[box][i] = (pair[box].high - pair[box].low) / 2;
    }
  }
  const Rotation turns = quarter_turns(cases);
  boxes[0] = {turned<double, 3>(rotation, center[0]), rotation, extents[0]};
  boxes[1] = {turned<double, 3>(rotation, center[1]), Rotation(rotation * turns),
              Vector3((turns.transpose() * extents[1]).cwiseAbs())};
  if (!rotation.isIdentity(0)) boxes[1].axes = orthonormal<double, 3>(boxes[1].axes);
  return boxes;
}

/// Rods that cross at a small angle, each on an edge: the cross product of the long edges is short, and it alone
/// separates them.
Boxes crossing_rods(Cases& cases) {
  const double half_angle = cases.random.between(0.01, 0.15);
  const double eighth = std::sqrt(2.0) - 1;  // the tangent of an eighth of a half turn
  const Rotation rotation = random_rotation(cases), on_edge = matrix_of(normalized({1, eighth, 0, 0}));
  Boxes boxes;
  for (const double side : {-1.0, 1.0}) {
    const Rotation axes = rotation * matrix_of(normalized({1, 0, 0, side * half_angle})) * on_edge;
    const Vector3 center = rotation.col(2) * side * (std::sqrt(2.0) + 0.01);
    boxes[side > 0 ? 1 : 0] = {center, axes, Vector3(20, 1, 1)};
  }
  return boxes;
}

Boxes box_pair(Cases& cases, int kind, bool overlaps) {
  if (kind == kSatTouching)
    return parallel_boxes(cases, overlaps ? Relation::kTouching : Relation::kAlmost, Rotation::Identity());
  if (kind == kParallel)
    return parallel_boxes(cases, overlaps ? Relation::kCrossing : Relation::kApart, random_rotation(cases));
  for (;;) {
    const bool rods = kind == kEdges && !overlaps && cases.coin();
    Boxes boxes = rods ? crossing_rods(cases) : random_boxes(cases, kind == kSatInside && overlaps ? 2 : 10);
    if (kind == kSatInside && overlaps) {
      boxes[0].half_extents.array() += 12;
      boxes[1].half_extents.array() = 1;
    }
    if (overlap(boxes) != overlaps || !is_clear(boxes)) continue;
    if (kind == kFaces && !overlaps && separating(boxes, false) != 1) continue;
    if (kind == kEdges && !overlaps && separating(boxes, false) != 0) continue;
    return boxes;
  }
}

void make_sat(Cases& cases) {
  each_kind(kSatKinds, [&](int kind, int i) {
    const Scale scale = kind == kSatTiny ? kTinyScale : kind == kSatFar ? kFarScale : kPlain;
    Boxes boxes = box_pair(cases, kind, i % 2 == 0);
    if (cases.coin()) std::swap(boxes[0], boxes[1]);
    cases.add(kind, boxes_input(boxes, scale));
  });
}

Numbers sat(const Numbers& input) {
  Take take(input);
  return {overlap(take_boxes(take)) ? 1.0 : 0.0};
}

bool is_sat_input(const Numbers& input) {
  Take take(input);
  const Boxes boxes = take_boxes(take);
  return are_boxes(boxes) && is_clear(boxes);
}

constexpr std::array kFunctions{
    Function{"rotated-aabb", "rotated", "{box:{center:3n,half_extents:3n},rotation:33n}", "{center:3n,half_extents:3n}",
             "update/rotated_box", kRotatedKinds, make_rotated, rotated, is_rotated, is_rotated_input},
    Function{
        "sat-row", "row", "{a:{center:3n,axes:33n,half_extents:3n},b:{center:3n,axes:33n,half_extents:3n},axis:3n}",
        "{distance:n,r_a:n,r_b:n}", "volume_pair/separating_axes", kRowKinds, make_rows, row, is_row, is_row_input},
    Function{"sat", "overlap", "{a:{center:3n,axes:33n,half_extents:3n},b:{center:3n,axes:33n,half_extents:3n}}", "b",
             "volume_pair/separating_axes", kSatKinds, make_sat, sat, nullptr, is_sat_input},
};

}  // namespace
}  // namespace turned_boxes

std::span<const Function> turned_box_functions() { return turned_boxes::kFunctions; }

}  // namespace snug::write
