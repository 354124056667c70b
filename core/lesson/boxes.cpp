#include "lesson/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "lesson/frustum_box.hpp"

namespace snug::lesson {
namespace {

using V3 = Vector<double, 3>;
using Box = Obb<double, 3>;
using Kind = Place::Kind;

int knobs(int dim) { return dim - 1; }

/// The shortest turn that takes one unit direction to another.
Matrix<double, 3> turn_from_to(const V3& from, const V3& to) {
  const Quaternion half{1 + from.dot(to), from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
                        from[0] * to[1] - from[1] * to[0]};
  return matrix_of(normalized(half));
}

/// Opposite directions have no shortest turn: any half turn across them does.
Matrix<double, 3> turn_to(const V3& from, const V3& to, const V3& across) {
  if (1 + from.dot(to) < 1e-12) return turn(across, 3.14159265358979323846);
  return turn_from_to(from, to);
}

/// The first knob turns its axis to the hand; the second turns the box about the first's.
Box turned_to(const Box& box, int axis, const V3& hand) {
  V3 way = hand - box.center;
  if (axis == 1) way -= box.axes.col(0) * box.axes.col(0).dot(way);
  const double length = way.norm();
  if (!(length > 0)) return box;
  Box turned = box;
  turned.axes =
      orthonormal<double, 3>(turn_to(box.axes.col(axis), way / length, box.axes.col(axis == 0 ? 2 : 0)) * box.axes);
  return turned;
}

/// How wide B is at its near or far end, of its half extents: what tapers is its sides, not its depth.
double share_at(const BoxPair& pair, int box, int axis, bool far) {
  return box == 1 && axis > 0 && !far ? pair.taper : 1;
}

/// The corner at the hand, the opposite one where it was. A corner pulled past it makes the box flat.
Box stretched(const BoxPair& pair, int which, int bits, const V3& hand) {
  const Box& box = pair.boxes[which];
  Box stretched = box;
  const V3 opposite = corner_of(pair, which, ~bits & 7);
  const V3 across = box.axes.transpose() * (hand - opposite);
  const bool far = (bits & 1) != 0;
  V3 half = V3::Zero();
  for (int axis = 0; axis < pair.dim; ++axis) {
    const double side = (bits >> axis & 1) != 0 ? 1 : -1;
    const double own = share_at(pair, which, axis, far), other = share_at(pair, which, axis, !far);
    stretched.half_extents[axis] = std::max(0.0, side * across[axis] / (own + other));
    half += box.axes.col(axis) * (side * stretched.half_extents[axis] * other);
  }
  stretched.center = opposite + half;
  return stretched;
}

}  // namespace

int places_of_box(int dim) { return 1 + knobs(dim) + (1 << dim); }

Place place_of(int dim, Index i) {
  const int box = i / places_of_box(dim), own = i % places_of_box(dim);
  if (own == 0) return {Kind::kCenter, box, 0};
  if (own <= knobs(dim)) return {Kind::kTurn, box, own - 1};
  return {Kind::kCorner, box, own - 1 - knobs(dim)};
}

Index index_of(int dim, const Place& place) {
  const int own = place.kind == Kind::kCenter ? 0
                  : place.kind == Kind::kTurn ? 1 + place.number
                                              : 1 + knobs(dim) + place.number;
  return place.box * places_of_box(dim) + own;
}

std::string place_name(int dim, Index i, bool frustum) {
  const Place place = place_of(dim, i);
  const std::string box = place.box == 0 ? (frustum ? "Box" : "A") : frustum ? "Frustum" : "B";
  if (place.kind == Kind::kCenter) return box;
  if (place.kind == Kind::kCorner && frustum && place.box == 0) return sign_name(dim, place.number);
  if (place.kind == Kind::kCorner) return box.front() + std::to_string(place.number);
  return box + (place.number == 0 ? " turn" : " roll");
}

V3 corner_of(const Box& box, int bits) {
  V3 corner = box.center;
  for (int axis = 0; axis < 3; ++axis)
    corner += box.axes.col(axis) * ((bits >> axis & 1) != 0 ? box.half_extents[axis] : -box.half_extents[axis]);
  return corner;
}

V3 corner_of(const BoxPair& pair, int box, int bits) {
  Box own = pair.boxes[box];
  for (int axis = 1; axis < 3; ++axis) own.half_extents[axis] *= share_at(pair, box, axis, (bits & 1) != 0);
  return corner_of(own, bits);
}

V3 beyond_face(const BoxPair& pair, int box, int axis, double by) {
  const Box& own = pair.boxes[box];
  return own.center + own.axes.col(axis) * (own.half_extents[axis] * (1 + share_at(pair, box, axis, false)) / 2 + by);
}

V3 at_place(const BoxPair& pair, Index i) {
  const Place place = place_of(pair.dim, i);
  const Box& box = pair.boxes[place.box];
  if (place.kind == Kind::kCenter) return box.center;
  if (place.kind == Kind::kCorner) return corner_of(pair, place.box, place.number);
  return beyond_face(pair, place.box, place.number, pair.knob);
}

tl::expected<AnyPointSet, InputError> places(const BoxPair& pair) {
  if (has_frustum(pair)) {
    const auto wrong = [](auto frustum) { return frustum ? std::optional<InputError>() : std::move(frustum.error()); };
    if (auto error = pair.dim == 2 ? wrong(frustum_of<2>(pair)) : wrong(frustum_of<3>(pair)))
      return tl::unexpected(*std::move(error));
  }
  const Index count = 2 * places_of_box(pair.dim);
  if (pair.dim == 2) {
    std::vector<Vector<double, 2>> all;
    for (Index i = 0; i < count; ++i) all.push_back(at_place(pair, i).head<2>());
    return PointSet<double, 2>::make(std::move(all)).map([](auto&& set) { return AnyPointSet(std::move(set)); });
  }
  std::vector<V3> all;
  for (Index i = 0; i < count; ++i) all.push_back(at_place(pair, i));
  return PointSet<double, 3>::make(std::move(all)).map([](auto&& set) { return AnyPointSet(std::move(set)); });
}

tl::expected<BoxPair, InputError> moved(const BoxPair& pair, Index i, const V3& hand) {
  V3 to = hand;
  if (pair.dim == 2) to[2] = 0;
  if (auto fine = PointSet<double, 3>::make({to}); !fine) return tl::unexpected(std::move(fine.error()));
  BoxPair next = pair;
  const Place place = place_of(pair.dim, i);
  Box& box = next.boxes[place.box];
  switch (place.kind) {
    case Kind::kCenter: box.center = to; break;
    case Kind::kTurn: box = turned_to(box, place.number, to); break;
    case Kind::kCorner: box = stretched(pair, place.box, place.number, to); break;
  }
  return next;
}

Box turned_by(const Box& box, int axis, double radians) {
  Box turned = box;
  turned.axes = orthonormal<double, 3>(turn(V3::Unit(axis), radians) * box.axes);
  return turned;
}

double angle_of(const Box& box) { return std::atan2(box.axes(1, 0), box.axes(0, 0)); }

BoxPair scattered(const BoxPair& like, std::uint64_t seed) {
  Random random(seed);
  BoxPair pair = like;
  double reach = 0;
  for (const Box& box : like.boxes) reach = std::max(reach, box.half_extents.norm());
  for (Box& box : pair.boxes) {
    Quaternion spin{1, 0, 0, random.between(-1, 1)};
    if (like.dim == 3)
      spin = {random.between(0.2, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    box.axes = matrix_of(normalized(spin));
    for (int axis = 0; axis < like.dim; ++axis) box.center[axis] = random.between(-1.2, 1.2) * reach;
  }
  return pair;
}

Obb<double, 2> flat(const Box& box) {
  return {box.center.head<2>(), box.axes.topLeftCorner<2, 2>(), box.half_extents.head<2>()};
}

}  // namespace snug::lesson
