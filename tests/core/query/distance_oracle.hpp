// Distances of points, segments and parallelograms in 300 bits, by trying every pair of features: the oracle of what
// query/distance/distance.hpp does in one scalar.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::test {

using Big =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

struct BigVector {
  Big x, y, z;
  friend BigVector operator+(const BigVector& a, const BigVector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend BigVector operator-(const BigVector& a, const BigVector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend BigVector operator*(const Big& s, const BigVector& a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline Big dot(const BigVector& a, const BigVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline BigVector cross(const BigVector& a, const BigVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar, int Dim>
BigVector big(const Vector<Scalar, Dim>& v) {
  return {Big(v[0]), Big(v[1]), Dim == 3 ? Big(v[Dim - 1]) : Big(0)};
}

/// All of corner + s edges[0] + t edges[1], 0 <= s, t <= 1: a point where both edges are zero, a segment where one is.
struct BigPatch {
  BigVector corner;
  std::array<BigVector, 2> edges;
};

namespace oracle {

inline bool in_unit(const Big& t) { return t >= 0 && t <= 1; }

inline Big point_segment(const BigVector& p, const BigVector& start, const BigVector& edge) {
  const Big square = dot(edge, edge);
  Big t = square == 0 ? Big(0) : dot(p - start, edge) / square;
  t = t < 0 ? Big(0) : t > 1 ? Big(1) : t;
  const BigVector d = start + t * edge - p;
  return dot(d, d);
}

/// The squared distance of two lines where it is between their segments, else of an end from the other segment.
inline Big segment_segment(const BigVector& p, const BigVector& e, const BigVector& q, const BigVector& f) {
  Big best = std::min(std::min(point_segment(p, q, f), point_segment(p + e, q, f)),
                      std::min(point_segment(q, p, e), point_segment(q + f, p, e)));
  const BigVector normal = cross(e, f);
  const Big square = dot(normal, normal);
  if (square == 0) return best;
  const Big s = dot(cross(q - p, f), normal) / square;
  const Big t = dot(cross(q - p, e), normal) / square;
  if (!in_unit(s) || !in_unit(t)) return best;
  const Big height = dot(q - p, normal);
  return std::min(best, Big(height * height / square));
}

/// Where a point's foot on the patch's plane is, in parts of its edges, and whether that is on it.
inline bool foot_is_on(const BigPatch& patch, const BigVector& normal, const BigVector& p) {
  const Big square = dot(normal, normal);
  return in_unit(dot(cross(p - patch.corner, patch.edges[1]), normal) / square) &&
         in_unit(dot(cross(patch.edges[0], p - patch.corner), normal) / square);
}

inline std::vector<std::array<BigVector, 2>> boundary(const BigPatch& patch) {
  const auto& [e, f] = patch.edges;
  return {{patch.corner, e}, {patch.corner + f, e}, {patch.corner, f}, {patch.corner + e, f}};
}

/// The least over the ends of one patch's edges, and where the edges pass through, from the inside of the other.
inline Big boundary_inside(const BigPatch& from, const BigPatch& patch, Big best) {
  const BigVector normal = cross(patch.edges[0], patch.edges[1]);
  const Big square = dot(normal, normal);
  if (square == 0) return best;
  const auto height_of = [&](const BigVector& p) { return dot(p - patch.corner, normal); };
  for (const auto& [start, edge] : boundary(from)) {
    for (const BigVector& end : {start, start + edge})
      if (foot_is_on(patch, normal, end)) best = std::min(best, Big(height_of(end) * height_of(end) / square));
    const Big height = height_of(start);
    const Big climb = dot(edge, normal);
    if (climb == 0 || !in_unit(-height / climb)) continue;
    if (foot_is_on(patch, normal, start - (height / climb) * edge)) return 0;
  }
  return best;
}

}  // namespace oracle

/// The distance of two patches.
inline Big distance(const BigPatch& a, const BigPatch& b) {
  Big best = dot(a.corner - b.corner, a.corner - b.corner);
  for (const auto& [p, e] : oracle::boundary(a))
    for (const auto& [q, f] : oracle::boundary(b)) best = std::min(best, oracle::segment_segment(p, e, q, f));
  best = oracle::boundary_inside(a, b, oracle::boundary_inside(b, a, best));
  return sqrt(best);
}

}  // namespace snug::test
