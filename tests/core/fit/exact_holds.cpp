#include "core/fit/exact_holds.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "core/exact.hpp"
#include "core/exact_hull.hpp"

namespace snug::exact {
namespace {

template <int Dim>
using Place = std::array<Rational, Dim>;

template <int Dim>
Place<Dim> exactly(const Vector<double, Dim>& v) {
  Place<Dim> place;
  for (std::size_t i = 0; i < Dim; ++i) place[i] = v[static_cast<int>(i)];
  return place;
}
template <std::size_t N>
std::array<Rational, N> plus(std::array<Rational, N> a, const std::array<Rational, N>& b, const Rational& times = 1) {
  for (std::size_t i = 0; i < N; ++i) a[i] += times * b[i];
  return a;
}
template <std::size_t N>
Rational dot(const std::array<Rational, N>& a, const std::array<Rational, N>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < N; ++i) sum += a[i] * b[i];
  return sum;
}

/// The least squared distance of point from origin + s e + t f, 0 <= s, t <= 1: over the inside, the sides and the
/// corners.
template <std::size_t N>
Rational squared_distance(const std::array<Rational, N>& point, const std::array<Rational, N>& origin,
                          const std::array<Rational, N>& e, const std::array<Rational, N>& f) {
  const auto p = plus(point, origin, -1);
  const auto at = [&](const Rational& s, const Rational& t) {
    const auto rest = plus(plus(p, e, -s), f, -t);
    return dot(rest, rest);
  };
  Rational least = std::min({at(0, 0), at(0, 1), at(1, 0), at(1, 1)});
  const Rational ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), pe = dot(p, e), pf = dot(p, f);
  const auto consider = [&](const Rational& s, const Rational& t) {
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, at(s, t));
  };
  for (const int end : {0, 1}) {
    if (ee != 0) consider((pe - end * ef) / ee, end);
    if (ff != 0) consider(end, (pf - end * ef) / ff);
  }
  const Rational determinant = ee * ff - ef * ef;
  if (determinant != 0) consider((pe * ff - pf * ef) / determinant, (pf * ee - pe * ef) / determinant);
  return least;
}

bool within(const Rational& square, const Rational& radius) { return radius >= 0 && square <= radius * radius; }

template <int Dim>
bool holds_one(const Sphere<double, Dim>& outer, const Sphere<double, Dim>& inner) {
  return within(exact::squared_distance<double, Dim>(outer.center, inner.center),
                Rational(outer.radius) - Rational(inner.radius));
}

template <int Dim>
bool holds_one(const Aabb<double, Dim>& outer, const Aabb<double, Dim>& inner) {
  return (outer.min.array() <= inner.min.array()).all() && (outer.max.array() >= inner.max.array()).all();
}

/// x with x . axis_i = along_i for all i, by Cramer's rule.
template <int Dim>
Place<Dim> solve(const Matrix<double, Dim>& axes, const Place<Dim>& along) {
  const auto determinant = [](const std::array<Place<Dim>, Dim>& rows) -> Rational {
    if constexpr (Dim == 2) return rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
    else {
      Rational sum = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        sum += rows[0][i] * (rows[1][j] * rows[2][k] - rows[1][k] * rows[2][j]);
      }
      return sum;
    }
  };
  std::array<Place<Dim>, Dim> rows;
  for (std::size_t i = 0; i < Dim; ++i) rows[i] = exactly<Dim>(axes.col(static_cast<int>(i)));
  const Rational whole = determinant(rows);
  Place<Dim> x;
  for (std::size_t column = 0; column < Dim; ++column) {
    auto replaced = rows;
    for (std::size_t i = 0; i < Dim; ++i) replaced[i][column] = along[i];
    x[column] = determinant(replaced) / whole;
  }
  return x;
}

/// Whether both are read as slabs or both as what their edges span.
template <int Dim>
bool holds_one(const Obb<double, Dim>& outer, const Obb<double, Dim>& inner) {
  const auto between = plus(exactly<Dim>(inner.center), exactly<Dim>(outer.center), -1);
  const Matrix<double, Dim> rows = outer.axes.transpose();
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    Place<Dim> along, of_edges = between;
    for (std::size_t i = 0; i < Dim; ++i) {
      along[i] = Rational(inner.half_extents[static_cast<int>(i)]) * ((corner >> i & 1) == 0 ? -1 : 1);
      of_edges = plus(of_edges, exactly<Dim>(inner.axes.col(static_cast<int>(i))), along[i]);
    }
    const auto of_slabs = plus(between, solve<Dim>(inner.axes, along));
    const auto shares = solve<Dim>(rows, of_edges);
    for (int i = 0; i < Dim; ++i) {
      const Rational half = outer.half_extents[i], reach = dot(of_slabs, exactly<Dim>(outer.axes.col(i)));
      if (abs(reach) > half || abs(shares[i]) > half) return false;
    }
  }
  return true;
}

template <int Dim>
bool holds_one(const Capsule<double, Dim>& outer, const Capsule<double, Dim>& inner) {
  const auto a = exactly<Dim>(outer.a), edge = plus(exactly<Dim>(outer.b), a, -1);
  const Rational left = Rational(outer.radius) - Rational(inner.radius);
  return within(squared_distance(exactly<Dim>(inner.a), a, edge, Place<Dim>{}), left) &&
         within(squared_distance(exactly<Dim>(inner.b), a, edge, Place<Dim>{}), left);
}

template <int Dim>
bool holds_one(const Lozenge<double, Dim>& outer, const Lozenge<double, Dim>& inner) {
  const Rational left = Rational(outer.radius) - Rational(inner.radius);
  for (const int s : {0, 1})
    for (const int t : {0, 1}) {
      const auto corner =
          plus(plus(exactly<Dim>(inner.origin), exactly<Dim>(inner.edges[0]), s), exactly<Dim>(inner.edges[1]), t);
      if (!within(squared_distance(corner, exactly<Dim>(outer.origin), exactly<Dim>(outer.edges[0]),
                                   exactly<Dim>(outer.edges[1])),
                  left))
        return false;
    }
  return true;
}

template <int Dim>
bool holds_one(const Kdop<double, Dim>& outer, const Kdop<double, Dim>& inner) {
  const auto axes = kdop_axes<Dim>(outer.k), inner_axes = kdop_axes<Dim>(inner.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto found = std::find(inner_axes.begin(), inner_axes.end(), axes[i]);
    if (found == inner_axes.end()) return false;
    const auto j = static_cast<std::size_t>(found - inner_axes.begin());
    if (inner.min[j] < outer.min[i] || inner.max[j] > outer.max[i]) return false;
  }
  return true;
}

template <int Dim>
bool holds_one(const ConvexHull<double, Dim>& outer, const ConvexHull<double, Dim>& inner) {
  return std::all_of(inner.vertices.begin(), inner.vertices.end(),
                     [&](const auto& v) { return in_hull(v, outer.vertices); });
}

template <class Scalar, int Dim>
Volume<double, Dim> wider(const Sphere<Scalar, Dim>& v) {
  return Sphere<double, Dim>{v.center.template cast<double>(), static_cast<double>(v.radius)};
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const Aabb<Scalar, Dim>& v) {
  return Aabb<double, Dim>{v.min.template cast<double>(), v.max.template cast<double>()};
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const Obb<Scalar, Dim>& v) {
  return Obb<double, Dim>{v.center.template cast<double>(), v.axes.template cast<double>(),
                          v.half_extents.template cast<double>()};
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const Capsule<Scalar, Dim>& v) {
  return Capsule<double, Dim>{v.a.template cast<double>(), v.b.template cast<double>(), static_cast<double>(v.radius)};
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const Lozenge<Scalar, Dim>& v) {
  return Lozenge<double, Dim>{v.origin.template cast<double>(),
                              {v.edges[0].template cast<double>(), v.edges[1].template cast<double>()},
                              static_cast<double>(v.radius)};
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const Kdop<Scalar, Dim>& v) {
  Kdop<double, Dim> kdop{.k = v.k};
  std::copy(v.min.begin(), v.min.end(), kdop.min.begin());
  std::copy(v.max.begin(), v.max.end(), kdop.max.begin());
  return kdop;
}
template <class Scalar, int Dim>
Volume<double, Dim> wider(const ConvexHull<Scalar, Dim>& v) {
  ConvexHull<double, Dim> hull;
  for (const auto& vertex : v.vertices) hull.vertices.push_back(vertex.template cast<double>());
  hull.indices = v.indices, hull.facets = v.facets, hull.affine_dim = v.affine_dim;
  return hull;
}

}  // namespace

template <int Dim>
bool holds(const Volume<double, Dim>& outer, const Volume<double, Dim>& inner) {
  return std::visit(
      [&]<class Kind>(const Kind& o) {
        const auto* i = std::get_if<Kind>(&inner);
        return i != nullptr && holds_one<Dim>(o, *i);
      },
      outer);
}
template <class Scalar, int Dim>
Volume<double, Dim> in_double(const Volume<Scalar, Dim>& volume) {
  return std::visit([](const auto& v) { return wider(v); }, volume);
}

template bool holds<2>(const Volume<double, 2>&, const Volume<double, 2>&);
template bool holds<3>(const Volume<double, 3>&, const Volume<double, 3>&);
template Volume<double, 2> in_double(const Volume<float, 2>&);
template Volume<double, 3> in_double(const Volume<float, 3>&);
template Volume<double, 2> in_double(const Volume<double, 2>&);
template Volume<double, 3> in_double(const Volume<double, 3>&);

}  // namespace snug::exact
