#include "query/contain/contains.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/convert.hpp"
#include "geometry/tolerance.hpp"
#include "number/dyadic.hpp"
#include "number/exact_sum.hpp"
#include "number/exact_tally.hpp"
#include "number/power_of_two.hpp"
#include "number/tuple.hpp"

namespace snug::query {
namespace {

// -- Slabs ------------------------------------------------------------------------------------------------------------

template <int Dim>
int side_of_slab_exactly(const Vector<double, Dim>& point, const Vector<double, Dim>& center,
                         const Vector<double, Dim>& axis, double half_extent) {
  ++exact_decisions;
  const auto beyond = [&](double sign) {
    ExactSum sum;
    for (int i = 0; i < Dim; ++i) {
      sum.add_product(sign * point[i], axis[i]);
      sum.add_product(-sign * center[i], axis[i]);
    }
    sum.add_product(-half_extent, 1);
    return sum.sign();
  };
  return std::max(beyond(1), beyond(-1));
}

/// sum +-coordinate - bound, exactly.
template <int Dim>
int side_of_bound(const Vector<double, Dim>& point, const std::array<int, Dim>& axis, double bound) {
  double projection = 0;
  double size = std::abs(bound);
  for (int i = 0; i < Dim; ++i) {
    projection += axis[i] * point[i];
    size += std::abs(point[i]);
  }
  const double beyond = projection - bound;
  if (std::abs(beyond) > tolerance::kProjection * size) return beyond > 0 ? 1 : -1;
  ++exact_decisions;
  ExactSum sum;
  for (int i = 0; i < Dim; ++i) sum.add_product(axis[i], point[i]);
  sum.add_product(-bound, 1);
  return sum.sign();
}

// -- Points within a distance of a parallelogram or a segment ---------------------------------------------------------

/// The point from a corner of the parallelogram, its two edges (a segment's second is zero) and the radius. Scaled by a
/// power of two so that the largest number is between 1 and 2: no square of it over- or underflows to any effect.
template <int Dim>
struct Swept {
  Vector<double, Dim> point, edge, other_edge;
  double radius;
  double unscale;

  Swept(const Vector<double, Dim>& p, const Vector<double, Dim>& e, const Vector<double, Dim>& o, double r) {
    const double largest = std::max({p.cwiseAbs().maxCoeff(), e.cwiseAbs().maxCoeff(), o.cwiseAbs().maxCoeff(), r});
    const double scale = to_unit_size(largest);
    point = p * scale;
    edge = e * scale;
    other_edge = o * scale;
    radius = r * scale;
    unscale = 1 / scale;
  }
};

/// From the nearest place on the parallelogram to the point. It optimises one edge's coordinate after the other: with
/// perpendicular edges the first pass is already right, and the second changes nothing.
template <int Dim>
Vector<double, Dim> from_nearest(const Swept<Dim>& swept) {
  constexpr int kMostTurns = 64;
  const auto share = [](const Vector<double, Dim>& v, const Vector<double, Dim>& edge) {
    const double square = edge.squaredNorm();
    return square > 0 ? std::clamp(v.dot(edge) / square, 0.0, 1.0) : 0.0;
  };
  double s = 0, t = 0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double before_s = s, before_t = t;
    s = share(swept.point - t * swept.other_edge, swept.edge);
    t = share(swept.point - s * swept.edge, swept.other_edge);
    if (s == before_s && t == before_t) break;
  }
  return swept.point - (s * swept.edge + t * swept.other_edge);
}

/// Whether the point is within the radius, if double can tell. A place that is near enough proves inside, and a
/// direction along which the whole parallelogram is too far proves outside, whatever rounding led to them.
template <int Dim>
std::optional<bool> within_by_double(const Swept<Dim>& swept) {
  const Vector<double, Dim> direction = from_nearest(swept);
  const double distance = direction.norm();
  const double error_bound =
      tolerance::kSweptDistance * (swept.point.norm() + swept.edge.norm() + swept.other_edge.norm() + swept.radius);
  if (distance + error_bound < swept.radius) return true;
  const double least = direction.dot(swept.point) - std::max(0.0, direction.dot(swept.edge)) -
                       std::max(0.0, direction.dot(swept.other_edge));
  if (distance > error_bound && least > (swept.radius + error_bound) * distance) return false;
  return std::nullopt;
}

/// point, edge: the point and the segment's other end, relative to its first end.
template <std::size_t Dim>
bool within_of_segment(const Tuple<Dyadic, Dim>& point, const Tuple<Dyadic, Dim>& edge, const Dyadic& square) {
  const Dyadic along = dot(point, edge);
  if (along.sign() <= 0) return dot(point, point) <= square;
  const Dyadic length = dot(edge, edge);
  if (length <= along) {
    const auto from_end = point - edge;
    return dot(from_end, from_end) <= square;
  }
  return (dot(point, point) - square) * length <= along * along;
}

/// point: relative to the parallelogram's vertex. If it projects into the parallelogram, its distance from the plane
/// decides, by the edges' Gram determinant; otherwise the nearest of the four sides.
template <std::size_t Dim>
bool within_of_parallelogram(const Tuple<Dyadic, Dim>& point, const Tuple<Dyadic, Dim>& e, const Tuple<Dyadic, Dim>& f,
                             const Dyadic& square) {
  const Dyadic ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), pe = dot(point, e), pf = dot(point, f);
  const Dyadic determinant = ee * ff - ef * ef;
  const Dyadic s = pe * ff - pf * ef, t = pf * ee - pe * ef;  // the projection's, times the determinant
  const auto inside = [&](const Dyadic& share) { return share.sign() >= 0 && share <= determinant; };
  if (determinant.sign() > 0 && inside(s) && inside(t))
    return (dot(point, point) - square) * determinant <= pe * s + pf * t;
  return within_of_segment(point, e, square) || within_of_segment(point, f, square) ||
         within_of_segment(point - f, e, square) || within_of_segment(point - e, f, square);
}

template <int Dim>
Swept<Dim> swept(const Capsule<double, Dim>& capsule, const Vector<double, Dim>& point) {
  return {point - capsule.a, capsule.b - capsule.a, Vector<double, Dim>::Zero(), capsule.radius};
}

template <int Dim>
Swept<Dim> swept(const Lozenge<double, Dim>& lozenge, const Vector<double, Dim>& point) {
  return {point - lozenge.origin, lozenge.edges[0], lozenge.edges[1], lozenge.radius};
}

template <int Dim>
bool within_exactly(const Capsule<double, Dim>& capsule, const Vector<double, Dim>& point) {
  const auto a = tuple_of<Dyadic, Dim>(capsule.a);
  return within_of_segment(tuple_of<Dyadic, Dim>(point) - a, tuple_of<Dyadic, Dim>(capsule.b) - a,
                           Dyadic(capsule.radius) * Dyadic(capsule.radius));
}

template <int Dim>
bool within_exactly(const Lozenge<double, Dim>& lozenge, const Vector<double, Dim>& point) {
  return within_of_parallelogram(tuple_of<Dyadic, Dim>(point) - tuple_of<Dyadic, Dim>(lozenge.origin),
                                 tuple_of<Dyadic, Dim>(lozenge.edges[0]), tuple_of<Dyadic, Dim>(lozenge.edges[1]),
                                 Dyadic(lozenge.radius) * Dyadic(lozenge.radius));
}

template <class Volume, int Dim>
bool contains_swept(const Volume& volume, const Vector<double, Dim>& point) {
  const auto known = within_by_double(swept<Dim>(volume, point));
  if (known) return *known;
  ++exact_decisions;
  return within_exactly<Dim>(volume, point);
}

template <class Volume, int Dim>
double outside_swept_by(const Volume& volume, const Vector<double, Dim>& point) {
  if (contains_swept(volume, point)) return 0;
  const Swept<Dim> scaled = swept<Dim>(volume, point);
  return at_least_a_digit((from_nearest(scaled).norm() - scaled.radius) * scaled.unscale, volume.radius);
}

template <class Scalar, int Dim>
using Point = std::type_identity_t<Vector<Scalar, Dim>>;

}  // namespace

template <class Scalar, int Dim>
int side_of_slab(const Vector<Scalar, Dim>& point, const Vector<Scalar, Dim>& center, const Vector<Scalar, Dim>& axis,
                 std::type_identity_t<Scalar> half_extent) noexcept {
  const Vector<double, Dim> p = point.template cast<double>();
  const Vector<double, Dim> c = center.template cast<double>();
  const Vector<double, Dim> u = axis.template cast<double>();
  const auto h = static_cast<double>(half_extent);
  double projection = 0, size = h;
  for (int i = 0; i < Dim; ++i) {
    const double term = (p[i] - c[i]) * u[i];
    projection += term;
    size += std::abs(term);
  }
  const double beyond = std::abs(projection) - h;
  // What a product loses by underflow is negligible compared with this size.
  if (size > tolerance::kSoundProjection && std::abs(beyond) > tolerance::kProjection * size)
    return beyond > 0 ? 1 : -1;
  return side_of_slab_exactly<Dim>(p, c, u, h);
}

template <class Scalar, int Dim>
bool contains(const Obb<Scalar, Dim>& box, const Point<Scalar, Dim>& point) {
  for (int i = 0; i < Dim; ++i)
    if (side_of_slab<Scalar, Dim>(point, box.center, box.axes.col(i), box.half_extents[i]) > 0) return false;
  return true;
}

template <class Scalar, int Dim>
bool contains(const Capsule<Scalar, Dim>& capsule, const Point<Scalar, Dim>& point) {
  return contains_swept<Capsule<double, Dim>, Dim>(converted<double, Dim>(capsule), point.template cast<double>());
}

template <class Scalar, int Dim>
bool contains(const Lozenge<Scalar, Dim>& lozenge, const Point<Scalar, Dim>& point) {
  return contains_swept<Lozenge<double, Dim>, Dim>(converted<double, Dim>(lozenge), point.template cast<double>());
}

template <class Scalar, int Dim>
bool contains(const Kdop<Scalar, Dim>& kdop, const Point<Scalar, Dim>& point) {
  const Vector<double, Dim> p = point.template cast<double>();
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (side_of_bound<Dim>(p, axes[i], static_cast<double>(kdop.min[i])) < 0 ||
        side_of_bound<Dim>(p, axes[i], static_cast<double>(kdop.max[i])) > 0)
      return false;
  return true;
}

template <class Scalar, int Dim>
double outside_by(const Sphere<Scalar, Dim>& sphere, const Point<Scalar, Dim>& point) {
  if (contains(sphere, point)) return 0;
  const Vector<double, Dim> from_center = point.template cast<double>() - sphere.center.template cast<double>();
  const auto radius = static_cast<double>(sphere.radius);
  return at_least_a_digit(scaled_norm<double, Dim>(from_center) - radius, radius);
}

template <class Scalar, int Dim>
double outside_by(const Aabb<Scalar, Dim>& box, const Point<Scalar, Dim>& point) {
  const Vector<double, Dim> p = point.template cast<double>();
  const Vector<double, Dim> below = box.min.template cast<double>() - p;
  const Vector<double, Dim> above = p - box.max.template cast<double>();
  return scaled_norm<double, Dim>(below.cwiseMax(above).cwiseMax(0.0));
}

template <class Scalar, int Dim>
double outside_by(const Obb<Scalar, Dim>& box, const Point<Scalar, Dim>& point) {
  const Vector<double, Dim> from_center = point.template cast<double>() - box.center.template cast<double>();
  Vector<double, Dim> outside = Vector<double, Dim>::Zero();
  for (int i = 0; i < Dim; ++i) {
    if (side_of_slab<Scalar, Dim>(point, box.center, box.axes.col(i), box.half_extents[i]) <= 0) continue;
    const auto h = static_cast<double>(box.half_extents[i]);
    outside[i] = at_least_a_digit(std::abs(from_center.dot(box.axes.col(i).template cast<double>())) - h, h);
  }
  return scaled_norm<double, Dim>(outside);
}

template <class Scalar, int Dim>
double outside_by(const Capsule<Scalar, Dim>& capsule, const Point<Scalar, Dim>& point) {
  return outside_swept_by<Capsule<double, Dim>, Dim>(converted<double, Dim>(capsule), point.template cast<double>());
}

template <class Scalar, int Dim>
double outside_by(const Lozenge<Scalar, Dim>& lozenge, const Point<Scalar, Dim>& point) {
  return outside_swept_by<Lozenge<double, Dim>, Dim>(converted<double, Dim>(lozenge), point.template cast<double>());
}

template <class Scalar, int Dim>
double outside_by(const Kdop<Scalar, Dim>& kdop, const Point<Scalar, Dim>& point) {
  const Vector<double, Dim> p = point.template cast<double>();
  const auto axes = kdop_axes<Dim>(kdop.k);
  double most = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Vector<double, Dim> axis;
    for (int j = 0; j < Dim; ++j) axis[j] = axes[i][j];
    const double projection = axis.dot(p), length = axis.norm();
    const auto min = static_cast<double>(kdop.min[i]), max = static_cast<double>(kdop.max[i]);
    if (side_of_bound<Dim>(p, axes[i], min) < 0)
      most = std::max(most, at_least_a_digit(min - projection, std::abs(min)) / length);
    if (side_of_bound<Dim>(p, axes[i], max) > 0)
      most = std::max(most, at_least_a_digit(projection - max, std::abs(max)) / length);
  }
  return most;
}

#define SNUG_INSTANTIATE_OUTSIDE(Volume, Scalar, Dim)                                                                  \
  template double outside_by(const Volume<Scalar, Dim>&, const Point<Scalar, Dim>&);
#define SNUG_INSTANTIATE_VOLUME(Volume, Scalar, Dim)                                                                   \
  template bool contains(const Volume<Scalar, Dim>&, const Point<Scalar, Dim>&);                                       \
  SNUG_INSTANTIATE_OUTSIDE(Volume, Scalar, Dim)
#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template int side_of_slab(const Vector<Scalar, Dim>&, const Vector<Scalar, Dim>&, const Vector<Scalar, Dim>&,        \
                            std::type_identity_t<Scalar>) noexcept;                                                    \
  SNUG_INSTANTIATE_OUTSIDE(Sphere, Scalar, Dim)                                                                        \
  SNUG_INSTANTIATE_OUTSIDE(Aabb, Scalar, Dim)                                                                          \
  SNUG_INSTANTIATE_VOLUME(Obb, Scalar, Dim)                                                                            \
  SNUG_INSTANTIATE_VOLUME(Capsule, Scalar, Dim)                                                                        \
  SNUG_INSTANTIATE_VOLUME(Lozenge, Scalar, Dim)                                                                        \
  SNUG_INSTANTIATE_VOLUME(Kdop, Scalar, Dim)
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE
#undef SNUG_INSTANTIATE_VOLUME
#undef SNUG_INSTANTIATE_OUTSIDE

}  // namespace snug::query
