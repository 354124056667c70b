#include "query/cull/frustum_sat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/tolerance.hpp"
#include "number/dyadic.hpp"
#include "number/power_of_two.hpp"
#include "query/overlap/box_of_numbers.hpp"

namespace snug::query {
namespace {

template <std::size_t Dim>
double size_of_all(const std::array<double, Dim>& v) {
  double sum = 0;
  for (const double x : v) sum += std::abs(x);
  return sum;
}

/// An axis, and the size of the products that are summed for it.
template <class Number, int Dim>
struct Axis {
  Tuple<Number, Dim> direction;
  double size = 0;  // for rounded numbers only
};

/// If an error bound is below this, no sum in it came near to the largest double.
constexpr double kSoundErrorBound = tolerance::kFrustumGap * (std::numeric_limits<double>::max() / 64);

constexpr int kPairsOfSides = 12;  // in space: pairs of a frustum's planes that meet in an edge
template <int Dim>
constexpr int kAxes = 3 * Dim + (Dim == 3 ? 3 * kPairsOfSides : 0);

/// The two planes that meet in an edge: two that are not opposite.
std::array<std::size_t, 2> planes_of_edge(std::size_t edge) {
  const std::size_t pair = edge / 4;  // which pair of opposite planes is left out
  const std::size_t i = pair == 0 ? 1 : 0, j = pair == 2 ? 1 : 2;
  return {2 * i + (edge & 1), 2 * j + (edge >> 1 & 1)};
}

/// The axis with an index: the frustum's normals, the box's normals, then cross products of the box's and the frustum's
/// edges. normal(i): that of plane i, of any length.
template <class Number, int Dim>
Axis<Number, Dim> cross_axis_at(const auto& normal, const BoxOf<Number, Dim>& box, int place) {
  Axis<Number, Dim> axis;
  [[maybe_unused]] const auto sized = [&](double size) {
    if constexpr (std::is_same_v<Number, double>) axis.size = size;
  };
  const auto own_size = [&] {
    if constexpr (std::is_same_v<Number, double>) axis.size = size_of_all(axis.direction);
  };
  if (place < 2 * Dim) {
    axis.direction = normal(place);
    own_size();
  } else if (place < 3 * Dim) {
    axis.direction = box.normal(place - 2 * Dim);
    own_size();
    if (Dim == 3) axis.size += 4;  // for the products of unit axes
  } else if constexpr (Dim == 3) {
    const std::size_t rest = place - 9;
    const auto [i, j] = planes_of_edge(rest % kPairsOfSides);
    const auto n = normal(i), m = normal(j);
    axis.direction = cross(box.axes[rest / kPairsOfSides], cross(n, m));
    if constexpr (std::is_same_v<Number, double>) sized(size_of_all(n) * size_of_all(m) * 2);
  }
  return axis;
}

/// Whether the axis separates the frustum's vertices from the box.
template <int Dim>
bool separates_exactly(const Tuple<Dyadic, Dim>& axis, const BoxOf<Dyadic, Dim>& box,
                       const std::array<ExactPoint<Dim>, kFrustumCorners<Dim>>& corners) {
  if (std::all_of(axis.begin(), axis.end(), [](const Dyadic& x) { return x.sign() == 0; })) return false;
  const Span<Dyadic> span = box.along(axis);
  bool all_above = true, all_below = true;
  for (const auto& [coordinates, weight] : corners) {
    const Dyadic value = dot(coordinates, axis);
    all_above = all_above && span.high * weight < value;
    all_below = all_below && value < span.low * weight;
    if (!all_above && !all_below) return false;
  }
  return true;
}

}  // namespace

template <class Scalar, int Dim>
tl::expected<FrustumSat<Scalar, Dim>, InputError> FrustumSat<Scalar, Dim>::make(const Frustum<Scalar, Dim>& frustum) {
  auto exact = exact_corners_of(frustum);
  if (!exact) return tl::unexpected(exact.error());
  return FrustumSat(frustum, std::move(*exact));
}

template <class Scalar, int Dim>
FrustumSat<Scalar, Dim>::FrustumSat(const Frustum<Scalar, Dim>& frustum, ExactCorners exact)
    : frustum_(frustum), exact_(std::move(exact)) {
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const Vector<double, Dim> normal = frustum.planes()[i].normal.template cast<double>();
    normals_[i] = normal * to_unit_size(normal.cwiseAbs().maxCoeff());
  }
  for (std::size_t c = 0; c < exact_.size(); ++c) {
    for (int i = 0; i < Dim; ++i) corners_[c][i] = quotient(exact_[c].coordinates[i], exact_[c].weight);
    size_ = corners_[c].allFinite() ? std::max(size_, corners_[c].cwiseAbs().maxCoeff())
                                    : std::numeric_limits<double>::infinity();
  }
}

template <class Scalar, int Dim>
bool FrustumSat<Scalar, Dim>::overlaps_any(const auto& given) const {
  const BoxOf<double, Dim> box(given);
  const double size = size_ + static_cast<double>(magnitude_of(given));
  const auto rounded = [&](std::size_t plane) { return tuple_of<double, Dim>(normals_[plane]); };
  std::array<int, kAxes<Dim>> open;
  std::size_t count = 0;
  for (int place = 0; place < kAxes<Dim>; ++place) {
    const auto axis = cross_axis_at<double, Dim>(rounded, box, place);
    const Span<double> span = box.along(axis.direction);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const auto& corner : corners_) {
      double value = 0;
      for (int i = 0; i < Dim; ++i) value += corner[i] * axis.direction[i];
      low = std::min(low, value);
      high = std::max(high, value);
    }
    const double gap = std::max(low - span.high, span.low - high);
    const double error_bound = tolerance::kFrustumGap * axis.size * size + std::numeric_limits<double>::min();
    const bool sound = error_bound < kSoundErrorBound;
    if (sound && gap > error_bound) return false;
    if (!sound || !(gap < -error_bound)) open[count++] = place;
  }
  if (count == 0) return true;
  const BoxOf<Dyadic, Dim> exact(given);
  const auto whole = [&](std::size_t plane) { return tuple_of<Dyadic, Dim>(frustum_.planes()[plane].normal); };
  return std::none_of(open.begin(), open.begin() + count, [&](int place) {
    return separates_exactly<Dim>(cross_axis_at<Dyadic, Dim>(whole, exact, place).direction, exact, exact_);
  });
}

template <class Scalar, int Dim>
bool FrustumSat<Scalar, Dim>::overlaps(const Obb<Scalar, Dim>& box) const {
  return overlaps_any(box);
}
template <class Scalar, int Dim>
bool FrustumSat<Scalar, Dim>::overlaps(const Aabb<Scalar, Dim>& box) const {
  return overlaps_any(box);
}

template class FrustumSat<float, 2>;
template class FrustumSat<float, 3>;
template class FrustumSat<double, 2>;
template class FrustumSat<double, 3>;

}  // namespace snug::query
