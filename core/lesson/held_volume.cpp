#include "lesson/held_volume.hpp"

#include <algorithm>
#include <cmath>

#include "fit/hull/quickhull.hpp"
#include "geometry/convert.hpp"
#include "geometry/kdop.hpp"
#include "geometry/pose.hpp"
#include "lesson/boxes.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using Kind = Handle::Kind;
using Box = Obb<double, 3>;
using Handles = std::vector<Handle>;
/// Empty, or why the move is impossible.
using Moved = std::string_view;

constexpr std::string_view kEmptySlabs = "the slabs would have no point in common";

void add_vertices(Handles& handles, int count) {
  for (int i = 0; i < count; ++i) handles.push_back({Kind::kVertex, i});
}
void add_knobs(Handles& handles, int dim) {
  for (int axis = 0; axis < dim - 1; ++axis) handles.push_back({Kind::kTurn, axis});
}

/// A unit direction perpendicular to another; in the plane, the one to its left.
Point3 across(const Point3& way, int dim) {
  if (!(way.norm() > 0)) return Point3::UnitY();
  Point3 across(-way[1], way[0], 0);
  if (dim == 3) {
    int least = 0;
    way.cwiseAbs().minCoeff(&least);
    const Point3 other = Point3::Unit(least);
    across = {way[1] * other[2] - way[2] * other[1], way[2] * other[0] - way[0] * other[2],
              way[0] * other[1] - way[1] * other[0]};
  }
  return across.normalized();
}

// ---- each kind's handles: which and where they are, and what moving one does -----------------------------------

template <class Volume>
struct Grip;

template <>
struct Grip<Sphere<double, 3>> {
  using Volume = Sphere<double, 3>;
  static Handles handles(const Volume&, const HeldVolume&) { return {{}, {Kind::kRadius, 0}}; }
  static Point3 center(const Volume& ball, const HeldVolume&) { return ball.center; }
  static Point3 at(const Volume& ball, const HeldVolume&, const Handle&) {
    return ball.center + Point3(ball.radius, 0, 0);
  }
  static Moved move(Volume& ball, HeldVolume&, const Handle&, const Point3& to) {
    ball.radius = std::max(0.0, to[0] - ball.center[0]);
    return {};
  }
};

template <>
struct Grip<Aabb<double, 3>> {
  using Volume = Aabb<double, 3>;
  static Handles handles(const Volume&, const HeldVolume& held) {
    Handles all{{}};
    add_vertices(all, 1 << held.dim);
    return all;
  }
  static Point3 center(const Volume& box, const HeldVolume&) { return (box.min + box.max) / 2; }
  static Point3 at(const Volume& box, const HeldVolume&, const Handle& handle) {
    Point3 corner = box.min;
    for (int i = 0; i < 3; ++i)
      if ((handle.number >> i & 1) != 0) corner[i] = box.max[i];
    return corner;
  }
  static Moved move(Volume& box, HeldVolume& held, const Handle& handle, const Point3& to) {
    for (int i = 0; i < held.dim; ++i)
      if ((handle.number >> i & 1) != 0) box.max[i] = std::max(box.min[i], to[i]);
      else box.min[i] = std::min(box.max[i], to[i]);
    return {};
  }
};

/// Has the same handles as the boxes of other lessons.
template <>
struct Grip<Box> {
  using Volume = Box;
  static BoxPair pair_of(const Box& box, const HeldVolume& held) {
    return {.dim = held.dim, .boxes = {box, box}, .knob = held.knob};
  }
  static Index place(const HeldVolume& held, const Handle& handle) {
    using To = BoxHandle::Kind;
    const To kind = handle.kind == Kind::kTurn ? To::kTurn : handle.kind == Kind::kVertex ? To::kCorner : To::kCenter;
    return index_of(held.dim, {kind, 0, handle.number});
  }
  static Handles handles(const Volume&, const HeldVolume& held) {
    Handles all{{}};
    add_knobs(all, held.dim);
    add_vertices(all, 1 << held.dim);
    return all;
  }
  static Point3 center(const Volume& box, const HeldVolume&) { return box.center; }
  static Point3 at(const Volume& box, const HeldVolume& held, const Handle& handle) {
    return at_place(pair_of(box, held), place(held, handle));
  }
  static Moved move(Volume& box, HeldVolume& held, const Handle& handle, const Point3& to) {
    box = lesson::moved(pair_of(box, held), place(held, handle), to)->boxes[0];  // to was checked to be finite
    return {};
  }
};

template <>
struct Grip<Capsule<double, 3>> {
  using Volume = Capsule<double, 3>;
  static Handles handles(const Volume&, const HeldVolume&) {
    return {{}, {Kind::kVertex, 0}, {Kind::kVertex, 1}, {Kind::kRadius, 0}};
  }
  static Point3 center(const Volume& capsule, const HeldVolume&) { return (capsule.a + capsule.b) / 2; }
  static Point3 at(const Volume& capsule, const HeldVolume& held, const Handle& handle) {
    if (handle.kind == Kind::kVertex) return handle.number == 0 ? capsule.a : capsule.b;
    return center(capsule, held) + capsule.radius * across(capsule.b - capsule.a, held.dim);
  }
  static Moved move(Volume& capsule, HeldVolume& held, const Handle& handle, const Point3& to) {
    if (handle.kind == Kind::kVertex) (handle.number == 0 ? capsule.a : capsule.b) = to;
    else capsule.radius = std::max(0.0, (to - center(capsule, held)).dot(across(capsule.b - capsule.a, held.dim)));
    return {};
  }
};

template <>
struct Grip<Lozenge<double, 3>> {
  using Volume = Lozenge<double, 3>;
  /// The lozenge's rectangle as a box without depth.
  static Box core(const Volume& lozenge, int dim) {
    Box box{lozenge.origin + (lozenge.edges[0] + lozenge.edges[1]) / 2};
    const double u = lozenge.edges[0].norm(), v = lozenge.edges[1].norm();
    Point3 x = u > 0 ? Point3(lozenge.edges[0] / u) : Point3(Point3::UnitX());
    if (!(u > 0) && v > 0) x = -across(lozenge.edges[1], dim);
    const Point3 y = v > 0 ? Point3(lozenge.edges[1] / v) : across(x, dim);
    box.axes.col(0) = x, box.axes.col(1) = y;
    box.axes.col(2) = Point3(x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]);
    box.axes = orthonormal<double, 3>(box.axes);
    box.half_extents = {u / 2, v / 2, 0};
    return box;
  }
  static void become(Volume& lozenge, const Box& core) {
    for (int i = 0; i < 2; ++i) lozenge.edges[i] = 2 * core.half_extents[i] * core.axes.col(i);
    lozenge.origin = core.center - (lozenge.edges[0] + lozenge.edges[1]) / 2;
  }
  /// Makes the edges perpendicular again.
  static void settle(Volume& lozenge, const HeldVolume& held) {
    Box box = core(lozenge, held.dim);
    box.axes = orthonormal<double, 3>(box.axes);
    become(lozenge, box);
  }
  static BoxPair pair_of(const Volume& lozenge, const HeldVolume& held) {
    const Box box = core(lozenge, held.dim);
    return {.dim = held.dim, .boxes = {box, box}, .knob = held.knob + lozenge.radius};
  }
  /// Where the handle of the radius is attached: above the rectangle in space, at its lower side in the plane.
  static Point3 foot(const Box& box, int dim) {
    return dim == 3 ? box.center : Point3(box.center - box.half_extents[1] * box.axes.col(1));
  }
  static Point3 outward(const Box& box, int dim) { return dim == 3 ? box.axes.col(2) : Point3(-box.axes.col(1)); }

  static Handles handles(const Volume&, const HeldVolume& held) {
    Handles all{{}};
    add_knobs(all, held.dim);
    add_vertices(all, 4);
    all.push_back({Kind::kRadius, 0});
    return all;
  }
  static Point3 center(const Volume& lozenge, const HeldVolume&) {
    return lozenge.origin + (lozenge.edges[0] + lozenge.edges[1]) / 2;
  }
  static Point3 at(const Volume& lozenge, const HeldVolume& held, const Handle& handle) {
    const Box box = core(lozenge, held.dim);
    if (handle.kind == Kind::kVertex) return corner_of(box, handle.number);
    if (handle.kind == Kind::kTurn)
      return at_place(pair_of(lozenge, held), index_of(held.dim, {BoxHandle::Kind::kTurn, 0, handle.number}));
    return foot(box, held.dim) + lozenge.radius * outward(box, held.dim);
  }
  static Moved move(Volume& lozenge, HeldVolume& held, const Handle& handle, const Point3& to) {
    Box box = core(lozenge, held.dim);
    if (handle.kind == Kind::kRadius) {
      lozenge.radius = std::max(0.0, (to - foot(box, held.dim)).dot(outward(box, held.dim)));
      return {};
    }
    if (handle.kind == Kind::kTurn) {
      const Index knob = index_of(held.dim, {BoxHandle::Kind::kTurn, 0, handle.number});
      become(lozenge, lesson::moved(pair_of(lozenge, held), knob, to)->boxes[0]);
      return {};
    }
    const Point3 opposite = corner_of(box, ~handle.number & 3);  // stays where it is
    box.center = opposite;
    for (int i = 0; i < 2; ++i) {
      const double side = (handle.number >> i & 1) != 0 ? 1 : -1;
      box.half_extents[i] = std::max(0.0, side * (to - opposite).dot(box.axes.col(i)) / 2);
      box.center += side * box.half_extents[i] * box.axes.col(i);
    }
    become(lozenge, box);
    return {};
  }
};

template <>
struct Grip<Kdop<double, 3>> {
  using Volume = Kdop<double, 3>;
  template <class Call>
  static auto in_dimension(const Volume& kdop, int dim, Call call) {
    return dim == 2 ? call(converted<double, 2>(kdop)) : call(kdop);
  }
  static std::vector<Point3> vertices(const Volume& kdop, int dim) {
    return in_dimension(kdop, dim, []<int Dim>(const Kdop<double, Dim>& own) {
      std::vector<Point3> lifted;
      for (const auto& vertex : kdop_vertices(own)) {
        convert_into(lifted.emplace_back(), vertex);
      }
      return lifted;
    });
  }
  static Point3 axis(const Volume& kdop, int dim, int slab) {
    Point3 axis = Point3::Zero();
    if (dim == 2)
      for (int i = 0; i < 2; ++i) axis[i] = kdop_axes<2>(kdop.k)[slab][i];
    else
      for (int i = 0; i < 3; ++i) axis[i] = kdop_axes<3>(kdop.k)[slab][i];
    return axis;
  }
  static Handles handles(const Volume& kdop, const HeldVolume&) {
    Handles all{{}};
    for (int i = 0; i < kdop.k; ++i) all.push_back({Kind::kBound, i});
    return all;
  }
  static Point3 center(const Volume& kdop, const HeldVolume& held) {
    const std::vector<Point3> all = vertices(kdop, held.dim);
    Point3 sum = Point3::Zero();
    for (const Point3& vertex : all) sum += vertex;
    return sum / static_cast<double>(std::max<std::size_t>(all.size(), 1));
  }
  /// The projection of the centre onto the bound's plane.
  static Point3 at(const Volume& kdop, const HeldVolume& held, const Handle& handle) {
    const Point3 middle = center(kdop, held), n = axis(kdop, held.dim, handle.number / 2);
    const double bound = handle.number % 2 == 1 ? kdop.max[handle.number / 2] : kdop.min[handle.number / 2];
    return middle + n * ((bound - n.dot(middle)) / n.squaredNorm());
  }
  static Moved move(Volume& kdop, HeldVolume& held, const Handle& handle, const Point3& to) {
    const int slab = handle.number / 2;
    const double bound = axis(kdop, held.dim, slab).dot(to);
    if (handle.number % 2 == 1) kdop.max[slab] = std::max(kdop.min[slab], bound);
    else kdop.min[slab] = std::min(kdop.max[slab], bound);
    return vertices(kdop, held.dim).empty() ? kEmptySlabs : Moved();
  }
};

template <>
struct Grip<ConvexHull<double, 3>> {
  using Volume = ConvexHull<double, 3>;
  /// Computes the hull of the points as they are now.
  static void settle(Volume& hull, const HeldVolume& held) {
    const auto wrapped = [&]<int Dim>(std::integral_constant<int, Dim>) {
      std::vector<Vector<double, Dim>> own;
      for (const Point3& p : held.points) own.push_back(p.head<Dim>());
      if (const auto set = PointSet<double, Dim>::make(std::move(own)))
        hull = converted<double, 3>(fit::quickhull(set->span()).volume);
    };
    if (held.dim == 2) wrapped(std::integral_constant<int, 2>());
    else wrapped(std::integral_constant<int, 3>());
  }
  static Handles handles(const Volume&, const HeldVolume& held) {
    Handles all{{}};
    add_vertices(all, static_cast<int>(held.points.size()));
    return all;
  }
  static Point3 center(const Volume&, const HeldVolume& held) {
    Point3 sum = Point3::Zero();
    for (const Point3& p : held.points) sum += p;
    return sum / static_cast<double>(held.points.size());
  }
  static Point3 at(const Volume&, const HeldVolume& held, const Handle& handle) { return held.points[handle.number]; }
  static Moved move(Volume& hull, HeldVolume& held, const Handle& handle, const Point3& to) {
    held.points[handle.number] = to;
    settle(hull, held);
    return {};
  }
};

template <class Call>
auto gripped(const HeldVolume& held, Call call) {
  return std::visit([&]<class Volume>(const Volume& volume) { return call(Grip<Volume>(), volume); }, held.volume);
}
template <class Call>
auto gripped(HeldVolume& held, Call call) {
  return std::visit([&]<class Volume>(Volume& volume) { return call(Grip<Volume>(), volume); }, held.volume);
}

Point3 center_of(const HeldVolume& held) {
  return gripped(held, [&](auto grip, const auto& volume) { return decltype(grip)::center(volume, held); });
}

/// Brings a volume whose numbers were moved or turned back into the form that its handles expect.
void settle(HeldVolume& held) {
  gripped(held, [&](auto grip, auto& volume) {
    if constexpr (requires { decltype(grip)::settle(volume, held); }) decltype(grip)::settle(volume, held);
  });
}

/// Replaces the volume by what call makes of it in its own dimension.
template <class Call>
void change(HeldVolume& held, Call call) {
  const auto changed = [&]<int Dim>(std::integral_constant<int, Dim>) {
    return std::visit(
        [&](const auto& own) { return fit::Volume3(converted<double, 3>(call(converted<double, Dim>(own)))); },
        held.volume);
  };
  held.volume = held.dim == 2 ? changed(std::integral_constant<int, 2>()) : changed(std::integral_constant<int, 3>());
}

void shift(HeldVolume& held, const Point3& by) {
  for (Point3& p : held.points) p += by;
  change(held, [&]<template <class, int> class Kind, int Dim>(const Kind<double, Dim>& own) {
    return moved(own, Vector<double, Dim>(by.head<Dim>()));
  });
  if (!held.points.empty()) settle(held);  // the others are what they were
}

/// Whether every handle has coordinates that a point may have.
Done check(const HeldVolume& held) {
  std::vector<Point3> all;
  for (const Handle& handle : handles_of(held)) all.push_back(at_handle(held, handle));
  if (auto set = PointSet<double, 3>::make(std::move(all)); !set) return tl::unexpected(std::move(set.error()));
  return {};
}

}  // namespace

std::vector<Handle> handles_of(const HeldVolume& held) {
  return gripped(held, [&](auto grip, const auto& volume) { return decltype(grip)::handles(volume, held); });
}

Point3 at_handle(const HeldVolume& held, const Handle& handle) {
  if (handle.kind == Kind::kCenter) return center_of(held);
  return gripped(held, [&](auto grip, const auto& volume) { return decltype(grip)::at(volume, held, handle); });
}

std::string handle_name(const HeldVolume& held, const Handle& handle) {
  switch (handle.kind) {
    case Kind::kCenter: return "";
    case Kind::kTurn: return handle.number == 0 ? " turn" : " roll";
    case Kind::kVertex: return std::to_string(handle.number);
    case Kind::kRadius: return " radius";
    case Kind::kBound: break;
  }
  const auto* kdop = std::get_if<Kdop<double, 3>>(&held.volume);
  const Point3 axis = Grip<Kdop<double, 3>>::axis(*kdop, held.dim, handle.number / 2);
  return " " + direction_name(handle.number % 2 == 1 ? axis : Point3(-axis));
}

tl::expected<HeldVolume, InputError> moved(const HeldVolume& held, const Handle& handle, const Point3& hand) {
  Point3 to = hand;
  if (held.dim == 2) to[2] = 0;
  if (auto fine = PointSet<double, 3>::make({to}); !fine) return tl::unexpected(std::move(fine.error()));
  HeldVolume next = held;
  const Moved why = gripped(next, [&](auto grip, auto& volume) -> Moved {
    using Held = decltype(grip);
    if (handle.kind != Kind::kCenter) return Held::move(volume, next, handle, to);
    shift(next, to - Held::center(volume, next));
    return {};
  });
  if (!why.empty()) return tl::unexpected(InputError{.what = std::string(why)});
  if (Done fine = check(next); !fine) return tl::unexpected(std::move(fine.error()));
  return next;
}

std::string fault_of(const HeldVolume& held) {
  if (const auto* box = std::get_if<Aabb<double, 3>>(&held.volume))
    if ((box->max - box->min).minCoeff() < 0) return "\"min\" is above \"max\"";
  if (const auto* box = std::get_if<Box>(&held.volume))
    if (box->half_extents.minCoeff() < 0) return "a half extent is below 0";
  if (const auto* kdop = std::get_if<Kdop<double, 3>>(&held.volume)) {
    for (int slab = 0; slab < kdop->k / 2; ++slab)
      if (kdop->min[slab] > kdop->max[slab]) return "\"min\" is above \"max\"";
    if (Grip<Kdop<double, 3>>::vertices(*kdop, held.dim).empty()) return "the slabs have no point in common";
  }
  if (const Done fine = check(held); !fine) return fine.error().what;
  return {};
}

HeldVolume rounded_to_float(const HeldVolume& held) {
  HeldVolume next = held;
  for (Point3& p : next.points) p = p.cast<float>().cast<double>();
  next.volume = std::visit([](const auto& own) { return fit::Volume3(converted<double, 3>(converted<float, 3>(own))); },
                           held.volume);
  if (!next.points.empty()) settle(next);
  return next;
}

HeldVolume placed(const HeldVolume& held, const Matrix<double, 3>& rotation, const Point3& by) {
  HeldVolume next = held;
  const Point3 middle = center_of(held);
  for (Point3& p : next.points) p = middle + rotation * (p - middle) + by;
  change(next, [&]<template <class, int> class Kind, int Dim>(const Kind<double, Dim>& own) {
    return placed(own, Pose<double, Dim>{rotation.topLeftCorner<Dim, Dim>(), by.head<Dim>()});
  });
  settle(next);
  return next;
}

}  // namespace snug::lesson
