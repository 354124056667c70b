#include "geometry/frustum_corners.hpp"
#include "number/power_of_two.hpp"
#include "number/tuple.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace snug {
namespace {

template <int Dim>
using Exact = Tuple<Dyadic, Dim>;

/// A plane without rounding, scaled by a power of two so that its normal's largest coordinate is between 1 and 2.
template <int Dim>
struct ExactPlane {
  Exact<Dim> normal;
  Dyadic d;

  template <class Scalar>
  explicit ExactPlane(const Plane<Scalar, Dim>& plane) {
    const Dyadic scale = to_unit_size(static_cast<double>(plane.normal.cwiseAbs().maxCoeff()));
    for (int i = 0; i < Dim; ++i) normal[i] = scale * static_cast<double>(plane.normal[i]);
    d = scale * static_cast<double>(plane.d);
  }

  /// -1, 0 or +1: inside, on or outside.
  [[nodiscard]] int side(const ExactPoint<Dim>& point) const {
    return (d * point.weight + dot(normal, point.coordinates)).sign();
  }
};

Dyadic determinant(const Exact<2>& a, const Exact<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
Dyadic determinant(const Exact<3>& a, const Exact<3>& b, const Exact<3>& c) { return dot(a, cross(b, c)); }

/// The indices of as many planes as meet in a point.
template <int Dim>
using Meeting = std::array<std::size_t, Dim>;

/// All planes of a frustum without rounding.
template <class Scalar, int Dim>
class CornerSearch {
 public:
  using Point = ExactPoint<Dim>;
  using All = std::array<Point, kFrustumCorners<Dim>>;

  explicit CornerSearch(const Frustum<Scalar, Dim>& frustum) {
    for (const auto& plane : frustum.planes()) planes_.emplace_back(plane);
  }

  /// Three checks are enough: all vertices are inside all planes, opposite planes face different ways, and planes meet
  /// nowhere else inside all planes. At an unbounded edge, the two opposite planes that should end it would face the
  /// same way, meet it in the same vertex, and be parallel, or others would meet there too.
  [[nodiscard]] tl::expected<All, InputError> find() const {
    All corners;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto corner = meet(planes_of(c));
      if (!corner) return refused(said(planes_of(c)) + " do not meet in a vertex");
      if (const auto outside = outside_of(*corner))
        return refused("the vertex of " + said(planes_of(c)) + " lies outside of " + said(*outside));
      corners[c] = *corner;
    }
    if (const auto other = other_corner()) return refused("there is another vertex, of " + said(*other));
    for (std::size_t i = 0; i < planes_.size(); i += 2)
      if (same_way(planes_[i].normal, planes_[i + 1].normal))
        return refused(said(i) + " and " + said(i + 1) + " face the same way, and nothing bounds the other");
    return corners;
  }

 private:
  using Normals = Exact<Dim>;

  static tl::unexpected<InputError> refused(std::string what) {
    return tl::unexpected(InputError{.what = std::move(what)});
  }
  static std::string said(std::size_t plane) { return std::string(kFrustumPlaneNames<Dim>[plane]); }
  static std::string said(const Meeting<Dim>& planes) {
    std::string names = said(planes[0]);
    for (std::size_t i = 1; i < Dim; ++i) names += (i + 1 == Dim ? " and " : ", ") + said(planes[i]);
    return names;
  }

  static Meeting<Dim> planes_of(std::size_t corner) {
    Meeting<Dim> planes;
    for (std::size_t i = 0; i < Dim; ++i) planes[i] = 2 * i + (corner >> i & 1);
    return planes;
  }

  /// The point where the planes meet, by Cramer's rule.
  [[nodiscard]] std::optional<Point> meet(const Meeting<Dim>& at) const {
    Point point;
    std::array<Normals, Dim> columns;  // the columns of the matrix whose rows are the normals
    Normals right;
    for (std::size_t row = 0; row < Dim; ++row) {
      for (std::size_t i = 0; i < Dim; ++i) columns[i][row] = planes_[at[row]].normal[i];
      right[row] = -planes_[at[row]].d;
    }
    const auto of_columns = [&] {
      if constexpr (Dim == 2) return determinant(columns[0], columns[1]);
      else return determinant(columns[0], columns[1], columns[2]);
    };
    point.weight = of_columns();
    const int sign = point.weight.sign();
    if (sign == 0) return std::nullopt;
    for (std::size_t i = 0; i < Dim; ++i) {
      std::swap(columns[i], right);
      point.coordinates[i] = sign < 0 ? -of_columns() : of_columns();
      std::swap(columns[i], right);
    }
    if (sign < 0) point.weight = -point.weight;
    return point;
  }

  [[nodiscard]] std::optional<std::size_t> outside_of(const Point& point) const {
    for (std::size_t i = 0; i < planes_.size(); ++i)
      if (planes_[i].side(point) > 0) return i;
    return std::nullopt;
  }

  /// Planes, two of them opposite, that meet inside all planes.
  [[nodiscard]] std::optional<Meeting<Dim>> other_corner() const {
    for (std::size_t i = 0; i < planes_.size(); i += 2)
      for (std::size_t other = 0; other < planes_.size(); ++other) {
        if (other == i || other == i + 1) continue;
        Meeting<Dim> planes{i, i + 1};
        if constexpr (Dim == 3) planes[2] = other;
        const auto corner = meet(planes);
        if (corner && !outside_of(*corner)) return planes;
      }
    return std::nullopt;
  }

  static bool same_way(const Normals& a, const Normals& b) {
    if (dot(a, b).sign() <= 0) return false;
    for (std::size_t i = 0; i < Dim; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!(a[i] * b[j] == a[j] * b[i])) return false;
    return true;
  }

  std::vector<ExactPlane<Dim>> planes_;
};

}  // namespace

template <class Scalar, int Dim>
tl::expected<std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>, InputError>
exact_corners_of(const Frustum<Scalar, Dim>& frustum) {
  return CornerSearch<Scalar, Dim>(frustum).find();
}

template <class Scalar, int Dim>
tl::expected<FrustumCorners<Scalar, Dim>, InputError> corners_of(const Frustum<Scalar, Dim>& frustum) {
  const auto exact = exact_corners_of(frustum);
  if (!exact) return tl::unexpected(exact.error());
  FrustumCorners<Scalar, Dim> corners;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    for (int i = 0; i < Dim; ++i)
      corners[c][i] = static_cast<Scalar>(quotient((*exact)[c].coordinates[i], (*exact)[c].weight));
    if (!corners[c].allFinite())
      return tl::unexpected(InputError{.what = "a vertex is farther away than this program can represent"});
  }
  return corners;
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template tl::expected<std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>, InputError> exact_corners_of(               \
      const Frustum<Scalar, Dim>&);                                                                                    \
  template tl::expected<FrustumCorners<Scalar, Dim>, InputError> corners_of(const Frustum<Scalar, Dim>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug
