#include "lesson/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/convert.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"

namespace snug::lesson {
namespace {

using V3 = Vector<double, 3>;
using Box = Obb<double, 3>;
using PlaceKind = BoxHandle::Kind;

int knobs(int dim) { return dim - 1; }

/// The shortest rotation that takes one unit direction to another.
Matrix<double, 3> turn_from_to(const V3& from, const V3& to) {
  const Quaternion half{1 + from.dot(to), from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
                        from[0] * to[1] - from[1] * to[0]};
  return matrix_of(normalized(half));
}

/// Opposite directions have no shortest rotation: a half turn about `across` will do.
Matrix<double, 3> turn_to(const V3& from, const V3& to, const V3& across) {
  if (1 + from.dot(to) < 1e-12) return turn(across, 3.14159265358979323846);
  return turn_from_to(from, to);
}

/// The first knob rotates its axis towards the hand; the second rotates the box about the first knob's axis.
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

/// A box's width at its near or far end, over its half extent: only B tapers, and only across its depth.
double share_at(const BoxPair& pair, int box, int axis, bool far) {
  return box == 1 && axis > 0 && !far ? pair.taper : 1;
}

/// The box with a vertex moved to the hand and the opposite one fixed. Pulled past that one, the box becomes flat.
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

int places_of(const BoxPair& pair, int box) {
  if (box == 1 || pair.form == Form::kBox) return places_of_box(pair.dim);
  return pair.form == Form::kBall ? 2 : 1;
}

BoxHandle place_of(const BoxPair& pair, Index i) {
  const int box = i < places_of(pair, 0) ? 0 : 1, own = box == 0 ? i : i - places_of(pair, 0);
  if (own == 0) return {PlaceKind::kCenter, box, 0};
  if (box == 0 && pair.form == Form::kBall) return {PlaceKind::kRadius, 0, 0};
  if (own <= knobs(pair.dim)) return {PlaceKind::kTurn, box, own - 1};
  return {PlaceKind::kCorner, box, own - 1 - knobs(pair.dim)};
}

Index index_of(const BoxPair& pair, const BoxHandle& place) {
  const int first = place.box == 0 ? 0 : places_of(pair, 0);
  switch (place.kind) {
    case PlaceKind::kCenter: return first;
    case PlaceKind::kRadius:
    case PlaceKind::kTurn: return first + 1 + place.number;
    case PlaceKind::kCorner: break;
  }
  return first + 1 + knobs(pair.dim) + place.number;
}

BoxHandle place_of(int dim, Index i) { return place_of(BoxPair{.dim = dim}, i); }
Index index_of(int dim, const BoxHandle& place) { return index_of(BoxPair{.dim = dim}, place); }

std::string place_name(int dim, Index i) {
  const BoxHandle place = place_of(dim, i);
  const std::string box = place.box == 0 ? "A" : "B";
  if (place.kind == PlaceKind::kCenter) return box;
  if (place.kind == PlaceKind::kCorner) return box + std::to_string(place.number);
  return box + (place.number == 0 ? " turn" : " roll");
}

std::vector<Index> vertices_of(int dim, int box) {
  std::vector<Index> all;
  for (int bits = 0; bits < 1 << dim; ++bits) all.push_back(index_of(dim, {PlaceKind::kCorner, box, bits}));
  return all;
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
  const BoxHandle place = place_of(pair, i);
  const Box& box = pair.boxes[place.box];
  if (place.kind == PlaceKind::kCenter) return box.center;
  if (place.kind == PlaceKind::kRadius) return box.center + V3::UnitX() * box.half_extents[0];
  if (place.kind == PlaceKind::kCorner) return corner_of(pair, place.box, place.number);
  return beyond_face(pair, place.box, place.number, pair.knob);
}

BoxPair rounded_to_float(const BoxPair& pair) {
  BoxPair rounded = pair;
  rounded.in_float = true;
  for (Box& box : rounded.boxes) box = converted<double, 3>(converted<float, 3>(box));
  return rounded;
}

namespace {

template <class Scalar>
Done check_places_in(const BoxPair& pair) {
  std::vector<Vector<Scalar, 3>> all;
  for (Index i = 0; i < places_of(pair, 0) + places_of(pair, 1); ++i)
    all.push_back(at_place(pair, i).template cast<Scalar>());
  if (auto set = PointSet<Scalar, 3>::make(std::move(all)); !set) return tl::unexpected(std::move(set.error()));
  return {};
}

}  // namespace

Done check_places(const BoxPair& pair) {
  return pair.in_float ? check_places_in<float>(pair) : check_places_in<double>(pair);
}

tl::expected<BoxPair, InputError> moved(const BoxPair& pair, Index i, const V3& hand) {
  V3 to = hand;
  if (pair.dim == 2) to[2] = 0;
  if (auto fine = PointSet<double, 3>::make({to}); !fine) return tl::unexpected(std::move(fine.error()));
  BoxPair next = pair;
  const BoxHandle place = place_of(pair, i);
  Box& box = next.boxes[place.box];
  switch (place.kind) {
    case PlaceKind::kCenter: box.center = to; break;
    case PlaceKind::kRadius: box.half_extents.head(pair.dim).setConstant((to - box.center).norm()); break;
    case PlaceKind::kTurn: box = turned_to(box, place.number, to); break;
    case PlaceKind::kCorner: box = stretched(pair, place.box, place.number, to); break;
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

BoxPair read_pair(TomlTable& table, int dim, double taper, Form form) {
  BoxPair pair{.dim = dim, .form = form, .taper = taper};
  const auto list_of = [&](std::string_view key, int numbers, std::size_t due, const char* words) {
    auto list = table.points(key, numbers);
    if (list.size() != due) table.wrong(key, words);
    list.resize(due, V3::Zero());
    if (due == 1) list.insert(list.begin(), V3::Zero());
    return list;
  };
  const bool boxes = form == Form::kBox;
  const char* two = boxes ? "must be two, for A and for B" : "must be two, of the body and of the frustum";
  const std::size_t sized = boxes ? 2 : 1;
  const char* sizes = boxes ? two : "must be one, of the frustum";
  const auto centers = list_of("center", dim, 2, two);
  auto halves = list_of("half_extents", dim, sized, sizes);
  const auto turns = list_of("turn", dim == 2 ? 1 : 3, sized, sizes);
  if (form == Form::kBall) halves[0].head(dim).setConstant(table.number("radius", 1e9));
  double largest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (halves[i].minCoeff() < 0) table.wrong("half_extents", "must not be negative");
    Box box{centers[i], Matrix<double, 3>::Identity(), halves[i]};
    for (int axis = 0; axis < (dim == 2 ? 1 : 3); ++axis)
      box = turned_by(box, dim == 2 ? 2 : axis, turns[i][axis] * std::numbers::pi / 180);
    pair.boxes[i] = box;
    largest = std::max(largest, halves[i].maxCoeff());
  }
  pair.knob = 0.4 * largest;
  if (const Done fine = check_places(pair); !fine) table.wrong("center", fine.error().what);
  return pair;
}

}  // namespace snug::lesson
