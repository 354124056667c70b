#include "core/query/exact_planes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/exact.hpp"
#include "number/double_double.hpp"

namespace snug::exact {
namespace {

using query::Culling;

struct PlaneInDouble {
  double normal[3]{};
  double d = 0;
};
template <class Scalar, int Dim>
PlaneInDouble in_double(const Plane<Scalar, Dim>& plane) {
  PlaneInDouble result;
  for (int i = 0; i < Dim; ++i) result.normal[i] = static_cast<double>(plane.normal[i]);
  result.d = static_cast<double>(plane.d);
  return result;
}

template <class Number>
struct Ends {
  Number least, most;
};

/// normal . p + d over the segments' sum; each segment's own end is chosen by comparing products.
template <class Number>
Ends<Number> ends_of(const PlaneInDouble& plane, const SumOfSegments& volume) {
  const auto dot = [&](const double* v) {
    Number sum(0);
    for (int i = 0; i < 3; ++i)
      if (plane.normal[i] != 0 && v[i] != 0) sum = sum + Number(plane.normal[i]) * Number(v[i]);
    return sum;
  };
  const Number middle = dot(volume.center) + Number(plane.d);
  Ends<Number> ends{middle, middle};
  for (int s = 0; s < volume.count; ++s) {
    const auto& segment = volume.segments[s];
    const Number along = dot(segment.direction);
    const Number a = along * Number(segment.least), b = along * Number(segment.most);
    ends.least = ends.least + (a < b ? a : b);
    ends.most = ends.most + (a < b ? b : a);
  }
  return ends;
}

/// The sum of the sizes of all products.
double size_of(const PlaneInDouble& plane, const SumOfSegments& volume) {
  const auto dot = [&](const double* v) {
    return std::abs(plane.normal[0] * v[0]) + std::abs(plane.normal[1] * v[1]) + std::abs(plane.normal[2] * v[2]);
  };
  double size = dot(volume.center) + std::abs(plane.d);
  for (int s = 0; s < volume.count; ++s)
    size += dot(volume.segments[s].direction) *
            std::max(std::abs(volume.segments[s].least), std::abs(volume.segments[s].most));
  const double normal = std::abs(plane.normal[0]) + std::abs(plane.normal[1]) + std::abs(plane.normal[2]);
  return size + normal * volume.radius;
}

template <class Number>
Number square_of_radius(const PlaneInDouble& plane, double radius) {
  Number square(0);
  for (const double x : plane.normal) square = square + Number(x) * Number(x);
  return square * Number(radius) * Number(radius);
}

int sign(const Rational& x) { return x < 0 ? -1 : x > 0 ? 1 : 0; }
/// 2: not certain.
int sign(const DoubleDouble& x, double doubt) { return x.high > doubt ? 1 : x.high < -doubt ? -1 : 2; }

/// The sign of value - radius |normal|.
int sign_less(const Rational& value, const Rational& square) {
  if (value <= 0) return square > 0 ? -1 : sign(value);
  return sign(value * value - square);
}
int sign_less(const DoubleDouble& value, const DoubleDouble& square, double size) {
  const int own = sign(value, 0x1p-90 * size);
  if (own != 1) return own == -1 ? -1 : 2;
  return sign(value * value - square, 0x1p-90 * size * size);
}

std::optional<Culling> side(int least, int most) {
  if (least == 1) return Culling::kOutside;
  if (least == 2 || most == 2) return std::nullopt;
  return most == 1 ? Culling::kIntersecting : Culling::kInside;
}

std::optional<Culling> in_double(const PlaneInDouble& plane, const SumOfSegments& volume, double size) {
  const double doubt = 0x1p-46 * size;
  const auto ends = ends_of<double>(plane, volume);
  const double radius =
      volume.radius * std::sqrt(plane.normal[0] * plane.normal[0] + plane.normal[1] * plane.normal[1] +
                                plane.normal[2] * plane.normal[2]);
  const auto certain = [&](double value) { return value > doubt ? 1 : value < -doubt ? -1 : 2; };
  return side(certain(ends.least - radius), certain(ends.most + radius));
}

std::optional<Culling> in_106_bits(const PlaneInDouble& plane, const SumOfSegments& volume, double size) {
  if (!(size < 0x1p400 && size > 0x1p-400)) return std::nullopt;
  const auto ends = ends_of<DoubleDouble>(plane, volume);
  if (volume.radius == 0) return side(sign(ends.least, 0x1p-90 * size), sign(ends.most, 0x1p-90 * size));
  const auto square = square_of_radius<DoubleDouble>(plane, volume.radius);
  const int most = sign_less(-ends.most, square, size);
  return side(sign_less(ends.least, square, size), most == 2 ? 2 : -most);
}

Culling in_rationals(const PlaneInDouble& plane, const SumOfSegments& volume) {
  const auto ends = ends_of<Rational>(plane, volume);
  const auto square = square_of_radius<Rational>(plane, volume.radius);
  return *side(sign_less(ends.least, square), -sign_less(-ends.most, square));
}

template <class Scalar, int Dim>
Culling of_all_planes(const Frustum<Scalar, Dim>& frustum, const auto& side_of) {
  Culling all = Culling::kInside;
  for (const auto& plane : frustum.planes()) all = std::max(all, side_of(in_double(plane)));
  return all;
}

template <class Scalar, int Dim>
void set(double* to, const Vector<Scalar, Dim>& from) {
  for (int i = 0; i < Dim; ++i) to[i] = static_cast<double>(from[i]);
}

}  // namespace

template <class Scalar, int Dim>
SumOfSegments sum_of(const Vector<Scalar, Dim>& point) {
  SumOfSegments sum;
  set<Scalar, Dim>(sum.center, point);
  return sum;
}
template <class Scalar, int Dim>
SumOfSegments sum_of(const Sphere<Scalar, Dim>& sphere) {
  SumOfSegments sum = sum_of<Scalar, Dim>(sphere.center);
  sum.radius = static_cast<double>(sphere.radius);
  return sum;
}
template <class Scalar, int Dim>
SumOfSegments sum_of(const Aabb<Scalar, Dim>& box) {
  SumOfSegments sum;
  sum.count = Dim;
  for (int i = 0; i < Dim; ++i) {
    sum.segments[i].direction[i] = 1;
    sum.segments[i].least = static_cast<double>(box.min[i]), sum.segments[i].most = static_cast<double>(box.max[i]);
  }
  return sum;
}
template <class Scalar, int Dim>
SumOfSegments sum_of(const Obb<Scalar, Dim>& box) {
  SumOfSegments sum = sum_of<Scalar, Dim>(box.center);
  sum.count = Dim;
  for (int i = 0; i < Dim; ++i) {
    set<Scalar, Dim>(sum.segments[i].direction, box.axes.col(i));
    sum.segments[i].most = static_cast<double>(box.half_extents[i]);
    sum.segments[i].least = -sum.segments[i].most;
  }
  return sum;
}
template <class Scalar, int Dim>
SumOfSegments sum_of(const AabbCenterExtents<Scalar, Dim>& box) {
  return sum_of(Obb<Scalar, Dim>{box.center, Matrix<Scalar, Dim>::Identity(), box.half_extents});
}
template <class Scalar, int Dim>
SumOfSegments sum_of(const Lozenge<Scalar, Dim>& lozenge) {
  SumOfSegments sum = sum_of<Scalar, Dim>(lozenge.origin);
  sum.count = 2;
  for (std::size_t i = 0; i < 2; ++i) {
    set<Scalar, Dim>(sum.segments[i].direction, lozenge.edges[i]);
    sum.segments[i].most = 1;
  }
  sum.radius = static_cast<double>(lozenge.radius);
  return sum;
}

template <class Scalar, int Dim>
Culling classify(const Frustum<Scalar, Dim>& frustum, const SumOfSegments& volume, bool rationals) {
  return of_all_planes(frustum, [&](const PlaneInDouble& plane) {
    if (rationals) return in_rationals(plane, volume);
    const double size = size_of(plane, volume);
    if (const auto certain = in_double(plane, volume, size)) return *certain;
    if (const auto certain = in_106_bits(plane, volume, size)) return *certain;
    return in_rationals(plane, volume);
  });
}

template <class Scalar, int Dim>
Culling classify(const Frustum<Scalar, Dim>& frustum, const Capsule<Scalar, Dim>& capsule) {
  return of_all_planes(frustum, [&](const PlaneInDouble& plane) {
    const Culling a = in_rationals(plane, sum_of(Sphere<Scalar, Dim>{capsule.a, capsule.radius}));
    const Culling b = in_rationals(plane, sum_of(Sphere<Scalar, Dim>{capsule.b, capsule.radius}));
    return a == b ? a : Culling::kIntersecting;
  });
}

template <class Scalar, int Dim>
Culling classify(const Frustum<Scalar, Dim>& frustum, const std::vector<Vector<Scalar, Dim>>& points) {
  return of_all_planes(frustum, [&](const PlaneInDouble& plane) {
    std::size_t outside = 0;
    for (const auto& point : points) outside += in_rationals(plane, sum_of<Scalar, Dim>(point)) == Culling::kOutside;
    return outside == points.size() ? Culling::kOutside : outside == 0 ? Culling::kInside : Culling::kIntersecting;
  });
}

namespace {

using Rationals = std::vector<Rational>;

/// The point where as many planes meet as there are coordinates: Gauss elimination of rows (normal, right side).
std::optional<Rationals> meet(std::vector<Rationals> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while (pivot < n && rows[pivot][k] == 0) ++pivot;
    if (pivot == n) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const Rational factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Rationals point(n);
  for (std::size_t i = 0; i < n; ++i) point[i] = rows[i][n] / rows[i][i];
  return point;
}

template <class Scalar, int Dim>
std::vector<Rationals> vertices_of(const Kdop<Scalar, Dim>& kdop) {
  const auto axes = kdop_axes<Dim>(kdop.k);
  std::vector<Rationals> vertices;
  const auto bound = [&](std::size_t at, bool max) {
    return Rational(static_cast<double>(max ? kdop.max[at] : kdop.min[at]));
  };
  const auto holds = [&](const Rationals& point) {
    for (std::size_t a = 0; a < axes.size(); ++a) {
      Rational along = 0;
      for (std::size_t i = 0; i < Dim; ++i) along += axes[a][i] * point[i];
      if (along < bound(a, false) || along > bound(a, true)) return false;
    }
    return true;
  };
  std::vector<Rationals> rows;
  const auto choose = [&](const auto& self, std::size_t first) -> void {
    if (rows.size() == Dim) {
      const auto point = meet(rows);
      if (point && holds(*point)) vertices.push_back(*point);
      return;
    }
    for (std::size_t a = first; a < axes.size(); ++a)
      for (const bool max : {false, true}) {
        Rationals row(axes[a].begin(), axes[a].end());
        row.push_back(bound(a, max));
        rows.push_back(row);
        self(self, a + 1);
        rows.pop_back();
      }
  };
  choose(choose, 0);
  return vertices;
}

}  // namespace

template <class Scalar, int Dim>
Culling classify(const Frustum<Scalar, Dim>& frustum, const Kdop<Scalar, Dim>& kdop) {
  const auto vertices = vertices_of(kdop);
  return of_all_planes(frustum, [&](const PlaneInDouble& plane) {
    std::size_t outside = 0;
    for (const auto& vertex : vertices) {
      Rational value = plane.d;
      for (std::size_t i = 0; i < Dim; ++i) value += Rational(plane.normal[i]) * vertex[i];
      outside += value > 0;
    }
    return outside == vertices.size() ? Culling::kOutside : outside == 0 ? Culling::kInside : Culling::kIntersecting;
  });
}

template <class Scalar, int Dim>
bool overlap(const Frustum<Scalar, Dim>& frustum, const Obb<Scalar, Dim>& box) {
  // Unknown: how far to go along each axis, within the half extents. Rows: coefficients . unknown <= last.
  std::vector<Rationals> rows;
  for (int k = 0; k < Dim; ++k)
    for (const int sign : {-1, 1}) {
      Rationals row(Dim + 1, 0);
      row[k] = sign;
      row[Dim] = static_cast<double>(box.half_extents[k]);
      rows.push_back(row);
    }
  for (const auto& given : frustum.planes()) {
    const auto plane = in_double(given);
    Rationals row(Dim + 1, 0);
    row[Dim] = -Rational(plane.d);
    for (int i = 0; i < Dim; ++i) {
      row[Dim] -= Rational(plane.normal[i]) * Rational(static_cast<double>(box.center[i]));
      for (int k = 0; k < Dim; ++k) row[k] += Rational(plane.normal[i]) * Rational(static_cast<double>(box.axes(i, k)));
    }
    rows.push_back(row);
  }
  for (std::size_t k = 0; k < Dim; ++k) {
    std::vector<Rationals> next;
    for (const auto& a : rows) {
      if (a[k] == 0) next.push_back(a);
      if (a[k] <= 0) continue;
      for (const auto& b : rows) {
        if (b[k] >= 0) continue;
        Rationals sum(Dim + 1);
        for (std::size_t j = 0; j <= Dim; ++j) sum[j] = a[j] / a[k] - b[j] / b[k];
        next.push_back(sum);
      }
    }
    rows = next;
  }
  return std::all_of(rows.begin(), rows.end(), [](const Rationals& row) { return row[Dim] >= 0; });
}

#define SNUG_SUM(Scalar, Dim, Shape) template SumOfSegments sum_of(const Shape<Scalar, Dim>&);
#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  SNUG_SUM(Scalar, Dim, Vector)                                                                                        \
  SNUG_SUM(Scalar, Dim, Sphere)                                                                                        \
  SNUG_SUM(Scalar, Dim, Aabb)                                                                                          \
  SNUG_SUM(Scalar, Dim, AabbCenterExtents)                                                                             \
  SNUG_SUM(Scalar, Dim, Obb)                                                                                           \
  SNUG_SUM(Scalar, Dim, Lozenge)                                                                                       \
  template Culling classify(const Frustum<Scalar, Dim>&, const SumOfSegments&, bool);                                  \
  template Culling classify(const Frustum<Scalar, Dim>&, const Capsule<Scalar, Dim>&);                                 \
  template Culling classify(const Frustum<Scalar, Dim>&, const std::vector<Vector<Scalar, Dim>>&);                     \
  template Culling classify(const Frustum<Scalar, Dim>&, const Kdop<Scalar, Dim>&);                                    \
  template bool overlap(const Frustum<Scalar, Dim>&, const Obb<Scalar, Dim>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE
#undef SNUG_SUM

}  // namespace snug::exact
