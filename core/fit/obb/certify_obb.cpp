#include "fit/obb/certify_obb.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/certify_volume.hpp"
#include "fit/obb/obb_edge_pairs.hpp"
#include "fit/obb/obb_hull.hpp"
#include "geometry/pose.hpp"
#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"

namespace snug::fit {
namespace {

template <class Scalar, int Dim>
double largest_coordinate(const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points) {
  auto largest = static_cast<double>(box.center.cwiseAbs().maxCoeff() + box.half_extents.maxCoeff());
  for (const auto& p : points) largest = std::max(largest, static_cast<double>(p.cwiseAbs().maxCoeff()));
  return largest;
}

/// The point in the box's frame, from its centre.
template <class Scalar, int Dim>
Vector<double, Dim> from_middle(const Obb<Scalar, Dim>& box, const Vector<Scalar, Dim>& point) {
  const Vector<double, Dim> d = point.template cast<double>() - box.center.template cast<double>();
  return box.axes.template cast<double>().transpose() * d;
}

template <class Scalar, int Dim>
bool is_frame(const Matrix<Scalar, Dim>& axes) {
  const Matrix<double, Dim> m = axes.template cast<double>();
  const double off = (m.transpose() * m - Matrix<double, Dim>::Identity()).cwiseAbs().maxCoeff();
  return off <= static_cast<double>(tolerance::kObbAxes<Scalar>) && m.determinant() > 0;
}

template <class Scalar, int Dim>
bool support_on_faces(const Fit<Obb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, double rounding) {
  std::array<bool, 2 * Dim> touched{};
  for (const Index i : fit.support) {
    const Vector<double, Dim> along = from_middle(fit.volume, points[i]);
    bool on_face = false;
    for (int axis = 0; axis < Dim; ++axis) {
      if (std::abs(std::abs(along[axis]) - static_cast<double>(fit.volume.half_extents[axis])) > rounding) continue;
      on_face = true;
      if (along[axis] <= rounding) touched[2 * axis] = true;
      if (along[axis] >= -rounding) touched[2 * axis + 1] = true;
    }
    if (!on_face) return false;
  }
  return std::all_of(touched.begin(), touched.end(), [](bool t) { return t; });
}

/// The dimension of what the points span, beyond rounding: at most 2, and -1 if there are none.
template <class Scalar, int Dim>
int span_of(const std::vector<Index>& indices, PointSpan<Scalar, Dim> points, double rounding) {
  if (indices.empty()) return kNoIndex;
  using Point = Vector<double, Dim>;
  const auto from_first = [&](Index i) {
    return Point(points[i].template cast<double>() - points[indices[0]].template cast<double>());
  };
  Point farthest = Point::Zero();
  double most = 0;
  for (const Index i : indices)
    if (const double distance = scaled_norm<double, Dim>(from_first(i)); distance > most) {
      most = distance;
      farthest = from_first(i);
    }
  if (most <= rounding) return 0;
  const Point along = farthest / most;
  const bool off_line = std::any_of(indices.begin(), indices.end(), [&](Index i) {
    const Point d = from_first(i);
    return scaled_norm<double, Dim>(d - along.dot(d) * along) > rounding;
  });
  return off_line ? 2 : 1;
}

/// The points times 2^-exponent, exact but for underflow.
template <class Scalar, int Dim>
Vector<double, Dim> scaled_lengths(const Obb<Scalar, Dim>& box, int exponent) {
  Vector<double, Dim> lengths;
  for (int i = 0; i < Dim; ++i) lengths[i] = std::ldexp(2 * static_cast<double>(box.half_extents[i]), -exponent);
  return lengths;
}

/// A lower bound on the measure of any box, and how much its lengths were shortened for it relative to the smallest box
/// found. In units of 2^exponent of the hull's local points.
struct Bound {
  double measure = 0, shorter = 0;
};

template <class Scalar, int Dim>
Bound smallest_measure(const ConvexHull<Scalar, Dim>& hull, const Obb<Scalar, Dim>& box, int exponent) {
  if (hull.affine_dim < Dim) return {};
  if constexpr (Dim == 2) {
    Ignore ignore;
    Calipers<Scalar, Ignore> calipers(hull, ignore);
    return {calipers.run().area * std::ldexp(1.0, 2 * (calipers.unit() - exponent)), 0};
  } else {
    const HullSolid solid(hull);
    EdgePairSearch pairs(solid, orthonormal<double, 3>(box.axes.template cast<double>()));
    for (Index e = 0; e < static_cast<Index>(solid.edges().size()); ++e) pairs.search(e);
    return {pairs.lower_bound(), tolerance::kBoxProof * solid.size()};
  }
}

template <class Scalar, int Dim>
void prove_smallest(Certificate& certificate, const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points,
                    double rounding) {
  const ConvexHull<Scalar, Dim> hull = quickhull(points).volume;
  const int exponent = LocalPoints<Dim>(hull.vertices).exponent;
  const Bound bound = smallest_measure(hull, box, exponent);
  const Vector<double, Dim> lengths = scaled_lengths(box, exponent);
  const double allowed = std::ldexp(rounding, -exponent) + bound.shorter;
  certificate.lower_bound = std::ldexp(bound.measure, Dim * exponent);
  if (bound.measure > 0) certificate.excess = lengths.prod() / bound.measure - 1;
  certificate.optimal = certificate.contains && certificate.on_boundary &&
                        (lengths.array() - allowed).cwiseMax(0).prod() <= bound.measure;
}

}  // namespace

template <class Scalar, int Dim>
Certificate certify(const Fit<Obb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal) {
  Certificate certificate = containment(fit.volume, points);
  const double rounding =
      tolerance::kBoxBoundaryRoundoffs * tolerance::roundoff<Scalar>(largest_coordinate(fit.volume, points));
  certificate.on_boundary = is_frame<Scalar, Dim>(fit.volume.axes) && support_on_faces(fit, points, rounding);
  if (claims_optimal) prove_smallest(certificate, fit.volume, points, 2 * rounding);
  return certificate;
}

template <class Scalar, int Dim>
std::vector<FaceContact> contacts(const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points) {
  const double rounding =
      tolerance::kBoxBoundaryRoundoffs * tolerance::roundoff<Scalar>(largest_coordinate(box, points));
  std::vector<FaceContact> faces;
  for (int axis = 0; axis < Dim; ++axis)
    for (const bool upper : {false, true}) faces.push_back({axis, upper, {}, kNoIndex});
  for (Index i = 0; i < points.size(); ++i) {
    const Vector<double, Dim> along = from_middle(box, points[i]);
    for (FaceContact& face : faces) {
      const double beyond =
          (face.upper ? along[face.axis] : -along[face.axis]) - static_cast<double>(box.half_extents[face.axis]);
      if (std::abs(beyond) <= rounding) face.points.push_back(i);
    }
  }
  for (FaceContact& face : faces) face.affine_dim = span_of(face.points, points, rounding);
  return faces;
}

template <int Dim>
bool on_edges(const std::vector<FaceContact>& contacts) {
  for (const FaceContact& a : contacts)
    for (const FaceContact& b : contacts)
      if ((Dim == 2 || a.axis != b.axis) && a.has_edge() && b.has_edge()) return true;
  return false;
}

template bool on_edges<2>(const std::vector<FaceContact>&);
template bool on_edges<3>(const std::vector<FaceContact>&);

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template Certificate certify(const Fit<Obb<Scalar, Dim>>&, PointSpan<Scalar, Dim>, bool);                            \
  template std::vector<FaceContact> contacts(const Obb<Scalar, Dim>&, PointSpan<Scalar, Dim>);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::fit
