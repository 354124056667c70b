// A point set checks its input: it has at least one point and every coordinate is finite, so that fitters cannot fail.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"

namespace snug {

template <class Scalar, int Dim>
class PointSet;

/// A view of a PointSet: n >= 1 finite points, in scene units. Only a PointSet makes one.
template <class Scalar, int Dim>
class PointSpan {
 public:
  using Point = Vector<Scalar, Dim>;

  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }
  [[nodiscard]] const Point& operator[](Index i) const { return points_[i]; }
  [[nodiscard]] const Point* begin() const { return points_.data(); }
  [[nodiscard]] const Point* end() const { return points_.data() + points_.size(); }

 private:
  friend class PointSet<Scalar, Dim>;
  explicit PointSpan(std::span<const Point> points) : points_(points) {}
  std::span<const Point> points_;
};

template <class Scalar, int Dim>
class PointSet {
 public:
  using Point = Vector<Scalar, Dim>;

  /// The largest coordinate allowed, in absolute value: beyond it a squared distance in 3-D could overflow.
  static constexpr Scalar kLargest = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p508) : static_cast<Scalar>(0x1p60);

  /// Errors: no points; more than 2^31 - 1; a coordinate that is not finite or above kLargest (the error says which).
  static tl::expected<PointSet, InputError> make(std::vector<Point> points) {
    if (points.empty()) return tl::unexpected(InputError{.what = "there are no points"});
    if (points.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max()))
      return tl::unexpected(InputError{.what = "there are more than 2147483647 points"});
    for (std::size_t i = 0; i < points.size(); ++i)
      if (auto error = refuse(points[i], static_cast<Index>(i))) return tl::unexpected(std::move(*error));
    return PointSet(std::move(points));
  }

  [[nodiscard]] PointSpan<Scalar, Dim> span() const { return PointSpan<Scalar, Dim>(points_); }
  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }
  [[nodiscard]] const Point& operator[](Index i) const { return points_[i]; }

  /// Moves point i. Errors: those of make; the set is then unchanged. i: in range.
  tl::expected<void, InputError> move(Index i, const Point& to) {
    if (auto error = refuse(to, i)) return tl::unexpected(std::move(*error));
    points_[i] = to;
    return {};
  }

 private:
  explicit PointSet(std::vector<Point> points) : points_(std::move(points)) {}

  static std::optional<InputError> refuse(const Point& point, Index i) {
    constexpr const char* kTooLarge = sizeof(Scalar) == 8 ? " is larger than this program can take (8.3e152)"
                                                          : " is larger than this program can take (1.1e18)";
    for (int axis = 0; axis < Dim; ++axis) {
      const char* wrong = nullptr;
      if (!std::isfinite(point[axis])) wrong = " is not finite";
      else if (std::abs(point[axis]) > kLargest) wrong = kTooLarge;
      if (wrong != nullptr)
        return InputError{.what = std::string("coordinate ") + "xyz"[axis] + " of point " + std::to_string(i) + wrong};
    }
    return std::nullopt;
  }

  std::vector<Point> points_;
};

/// A point set whose scalar and dimension are known only at run time.
using AnyPointSet = std::variant<PointSet<double, 2>, PointSet<double, 3>, PointSet<float, 2>, PointSet<float, 3>>;

}  // namespace snug
