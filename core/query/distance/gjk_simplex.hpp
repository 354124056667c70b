// Finds the point of a simplex nearest to the origin: a vertex, or a point on an edge, on a triangle or in a
// tetrahedron. Source: M. Montanari, N. Petrinic, E. Barbieri, "Improving the GJK algorithm for faster and more
// reliable distance queries between convex objects", 2017: the signs of areas and volumes tell which smaller simplex to
// try, and smaller ones are tried only if a sign rules out the larger.
#pragma once

#include <array>

#include "number/tuple.hpp"

namespace snug::query {

/// Some vertices of a simplex, and a point as their weighted mean.
template <class Real>
struct Nearest {
  int size = 0;
  std::array<int, 4> corners{};   // the first `size` are indices into the simplex
  std::array<Real, 4> weights{};  // > 0, of sum 1
  Tuple<Real, 3> point{};
  Real square{};  // its squared distance from the origin
};

template <class Real>
class Simplex {
 public:
  std::array<Tuple<Real, 3>, 4> corners{};
  int size = 0;

  [[nodiscard]] Nearest<Real> nearest_to_origin() const {
    switch (size) {
      case 1: return at_corner(0);
      case 2: return on_edge(0, 1);
      case 3: return on_triangle({0, 1, 2});
      default: return in_tetrahedron();
    }
  }

 private:
  [[nodiscard]] const Tuple<Real, 3>& at(int i) const { return corners[i]; }

  template <std::size_t n>
  [[nodiscard]] Nearest<Real> mean(const std::array<int, n>& places, const std::array<Real, n>& weights) const {
    Nearest<Real> mean;
    Real sum{};
    for (const Real& weight : weights) sum += weight;
    for (std::size_t i = 0; i < n; ++i) {
      mean.corners[i] = places[i];
      mean.weights[i] = weights[i] / sum;
      mean.point = mean.point + mean.weights[i] * at(places[i]);
    }
    mean.size = static_cast<int>(n);
    mean.square = dot(mean.point, mean.point);
    return mean;
  }

  [[nodiscard]] Nearest<Real> at_corner(int i) const { return mean<1>({i}, {Real(1)}); }

  /// The point a + t (b - a) is nearest to 0 where it is perpendicular to the edge:
  ///   (a + t (b - a)) . (b - a) = 0, so that t = -a . (b - a) / |b - a|^2 and 1 - t = b . (b - a) / |b - a|^2.
  /// Both numerators are the weights times the same square. Where one is not above 0, the other end is the nearest.
  [[nodiscard]] Nearest<Real> on_edge(int i, int j) const {
    const Tuple<Real, 3> edge = at(j) - at(i);
    const Real from_i = -dot(at(i), edge);
    const Real from_j = dot(at(j), edge);
    if (!(from_i > Real(0))) return at_corner(i);
    if (!(from_j > Real(0))) return at_corner(j);
    return mean<2>({i, j}, {from_j, from_i});
  }

  /// Let p be the foot of the perpendicular from 0 to the triangle's plane, and n = (b - a) x (c - a). The weight of a
  /// is the area of p, b, c over that of the triangle, with its sign:
  ///   n . ((b - p) x (c - p)) / |n|^2 = n . (b x c) / |n|^2,
  /// because p is parallel to n, and every product with it vanishes. So p itself is never computed. Where a weight is
  /// not above 0, p lies beyond the edge across from that vertex, and the nearest point lies on an edge.
  [[nodiscard]] Nearest<Real> on_triangle(const std::array<int, 3>& places) const {
    const Tuple<Real, 3>& a = at(places[0]);
    const Tuple<Real, 3>& b = at(places[1]);
    const Tuple<Real, 3>& c = at(places[2]);
    const Tuple<Real, 3> normal = cross(b - a, c - a);
    const std::array<Real, 3> areas{dot(normal, cross(b, c)), dot(normal, cross(c, a)), dot(normal, cross(a, b))};
    Nearest<Real> best;
    for (std::size_t i = 0; i < 3; ++i) {
      if (areas[i] > Real(0)) continue;
      take_nearer(best, on_edge(places[(i + 1) % 3], places[(i + 2) % 3]));
    }
    return best.size > 0 ? best : mean<3>(places, areas);
  }

  /// The weights that make 0 of the vertices are signed volumes, by Cramer's rule: that of a is det(b, c, d) over the
  /// tetrahedron's, that of b is -det(a, c, d), of c det(a, b, d) and of d -det(a, b, c). Two cross products serve all
  /// four. Their sum is six times the volume: if it is below 0, the vertices are the other way round. If all are above
  /// 0, the tetrahedron contains 0; otherwise the nearest point lies on a face across from a vertex whose weight is
  /// not.
  [[nodiscard]] Nearest<Real> in_tetrahedron() const {
    const Tuple<Real, 3> ab = cross(at(0), at(1));
    const Tuple<Real, 3> cd = cross(at(2), at(3));
    std::array<Real, 4> volumes{dot(at(1), cd), -dot(at(0), cd), dot(at(3), ab), -dot(at(2), ab)};
    if (volumes[0] + volumes[1] + volumes[2] + volumes[3] < Real(0))
      for (Real& volume : volumes) volume = -volume;
    Nearest<Real> best;
    for (int i = 0; i < 4; ++i) {
      if (volumes[i] > Real(0)) continue;
      take_nearer(best, on_triangle({(i + 1) % 4, (i + 2) % 4, (i + 3) % 4}));
    }
    return best.size > 0 ? best : mean<4>({0, 1, 2, 3}, volumes);
  }

  static void take_nearer(Nearest<Real>& best, const Nearest<Real>& other) {
    if (best.size == 0 || other.square < best.square) best = other;
  }
};

}  // namespace snug::query
