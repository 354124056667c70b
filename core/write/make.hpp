// What the cases of several functions are made of: intervals in a relation, distances that are whole numbers, and
// scales.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/vector.hpp"
#include "write/function.hpp"

namespace snug::write {

using Vector3 = Vector<double, 3>;
using Point2 = Vector<double, 2>;

/// Scales and moves the cases of a kind by powers of two, so that nothing rounds in double. Far away, doubles can still
/// tell a few units apart, and floats cannot.
struct Scale {
  double factor = 1, offset = 0;
  double operator()(double value) const { return offset == 0 ? value * factor : value * factor + offset; }  // keeps -0
  Vector3 operator()(const Vector3& p) const { return {(*this)(p[0]), (*this)(p[1]), (*this)(p[2])}; }
  Point2 operator()(const Point2& p) const { return {(*this)(p[0]), (*this)(p[1])}; }
};
inline constexpr Scale kPlain{}, kTinyScale{.factor = 0x1p-60}, kFarScale{.offset = 0x1p33};
/// What almost touches is this far apart.
inline constexpr double kAlmost = 0x1p-20;

struct Interval {
  double low = 0, high = 0;
};
using Intervals = std::array<Interval, 2>;  // A's and B's

enum class Relation : std::uint8_t { kApart, kAlmost, kTouching, kCrossing, kWithin };

/// Two intervals with whole ends, in this relation, on either side of each other; of kWithin B is in A.
inline Intervals related(Cases& cases, Relation relation) {
  const double low = cases.whole(-12, 8), high = low + cases.whole(3, 10);
  Interval b;
  switch (relation) {
    case Relation::kApart: b.low = high + cases.whole(1, 6); break;
    case Relation::kAlmost: b.low = high + kAlmost; break;
    case Relation::kTouching: b.low = high; break;
    case Relation::kCrossing: b.low = high - cases.whole(1, static_cast<int>(high - low) - 1); break;
    case Relation::kWithin: b.low = low + cases.whole(0, 1); break;
  }
  b.high = relation == Relation::kWithin ? high - cases.whole(0, 1) : std::max(high, b.low) + cases.whole(1, 8);
  if (cases.coin()) return {Interval{low, high}, b};
  return {Interval{-high, -low}, Interval{-b.high, -b.low}};
}

/// A vector of whole numbers whose length is a whole number too: a row of the table, in any order and with any signs.
struct WholeVector {
  Vector3 vector;
  double length;
};
inline WholeVector whole_vector(Cases& cases) {
  constexpr std::array<std::array<double, 4>, 8> kQuadruples{{{1, 0, 0, 1},
                                                              {0, 3, 4, 5},
                                                              {1, 2, 2, 3},
                                                              {2, 3, 6, 7},
                                                              {1, 4, 8, 9},
                                                              {4, 4, 7, 9},
                                                              {2, 6, 9, 11},
                                                              {6, 6, 7, 11}}};
  const auto& [x, y, z, length] = kQuadruples[cases.random.below(kQuadruples.size())];
  std::array<double, 3> own{x, y, z};
  std::swap(own[0], own[cases.random.below(3)]);
  std::swap(own[1], own[1 + cases.random.below(2)]);
  for (double& one : own)
    if (cases.coin()) one = -one;
  return {Vector3(own[0], own[1], own[2]), length};
}

inline Vector3 whole_point(Cases& cases, int size) {
  const double x = cases.whole(-size, size), y = cases.whole(-size, size), z = cases.whole(-size, size);
  return {x, y, z};
}

inline Point2 whole_point2(Cases& cases, int size) {
  const double x = cases.whole(-size, size);
  return {x, cases.whole(-size, size)};
}

/// A direction and turn at random.
Matrix<double, 3> random_rotation(Cases& cases);

/// Whether an answer is an index below the count.
inline bool is_index(double value, std::size_t count) {
  return value >= 0 && value < static_cast<double>(count) && value == std::floor(value);
}

/// Appends to numbers.
inline void put(Numbers& to, double value) { to.push_back(value); }
inline void put(Numbers& to, const Point2& p) { to.insert(to.end(), p.data(), p.data() + 2); }
inline void put(Numbers& to, const Vector3& p) { to.insert(to.end(), p.data(), p.data() + 3); }
/// Appends the matrix row by row.
inline void put(Numbers& to, const Matrix<double, 3>& m) {
  for (int row = 0; row < 3; ++row) put(to, Vector3(m.row(row)));
}
template <class... Parts>
[[nodiscard]] Numbers numbers_of(const Parts&... parts) {
  Numbers all;
  (put(all, parts), ...);
  return all;
}

/// Takes numbers in their order.
class Take {
 public:
  explicit Take(const Numbers& numbers) : at_(numbers.data()) {}
  double number() { return *at_++; }
  Vector3 vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Point2 point() {
    const double x = number();
    return {x, number()};
  }
  Matrix<double, 3> rows() {
    Matrix<double, 3> m;
    for (int row = 0; row < 3; ++row) m.row(row) = vector();
    return m;
  }

 private:
  const double* at_;
};

/// How near an answer has to come, as a share of what it was computed from: a double has 1e-16 and loses some to a
/// few operations, a float has 6e-8.
inline constexpr double kNear = 1e-12;
/// What the last digits of a coordinate are worth, for one that lies far away.
inline constexpr double kLastDigits = 0x1p-50;
/// size: of the lengths that the number was computed from.
[[nodiscard]] inline bool is_near(double answer, double right, double size) {
  return std::abs(answer - right) <= kNear * size + kLastDigits * std::abs(right);
}
[[nodiscard]] inline bool are_near(const Numbers& answer, const Numbers& right, double size) {
  for (std::size_t i = 0; i < right.size(); ++i)
    if (!is_near(answer[i], right[i], size)) return false;
  return true;
}

}  // namespace snug::write
