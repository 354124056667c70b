#include "query/overlap/obb_sat_exact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/sphere.hpp"
#include "geometry/tolerance.hpp"
#include "number/dyadic.hpp"
#include "query/overlap/box_of_numbers.hpp"
#include "query/overlap/exact_gap.hpp"

namespace snug::query {
namespace {

/// A pair of boxes in one kind of number.
template <class Number, int Dim>
class Pair {
 public:
  struct Along {
    Tuple<Number, Dim> axis;  // not unit
    Number offset, gap;       // times the axis's length
  };

  template <class Scalar>
  Pair(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) : a_(a), b_(b), offset_(b_.center - a_.center) {}

  [[nodiscard]] Along along(int place) const {
    const auto [kind, i, j] = axis_at<Dim>(place);
    const Tuple<Number, Dim> axis = this->axis(kind, i, j);
    const Number offset = dot(offset_, axis);
    return {axis, offset, magnitude(offset) - a_.radius(axis) - b_.radius(axis)};
  }

 private:
  [[nodiscard]] Tuple<Number, Dim> axis(AxisKind kind, std::size_t i, std::size_t j) const {
    if (kind == AxisKind::kFaceA) return a_.normal(i);
    if constexpr (Dim == 3)
      if (kind == AxisKind::kEdgeEdge) return cross(a_.axes[i], b_.axes[j]);
    return b_.normal(j);
  }

  BoxOf<Number, Dim> a_, b_;
  Tuple<Number, Dim> offset_;
};

template <int Dim>
Vector<double, Dim> approximate(const Tuple<Dyadic, Dim>& v) {
  Vector<double, Dim> result;
  for (int i = 0; i < Dim; ++i) result[i] = v[i].approximate();
  return result;
}

/// Scales a tiny axis up with its gap, for its length must not underflow. axis: not zero.
template <int Dim>
void make_measurable(typename Pair<Dyadic, Dim>::Along& along) {
  constexpr double kSmall = 0x1p-500, kLarge = 0x1p600;
  while (approximate<Dim>(along.axis).cwiseAbs().maxCoeff() < kSmall) {
    for (Dyadic& coordinate : along.axis) coordinate *= kLarge;
    along.gap *= kLarge;
  }
}

/// The axis and its gap in scene units. axis: not zero, though perhaps smaller than any double.
template <class Scalar, int Dim>
SatAxis<Scalar, Dim> separating_axis(int place, typename Pair<Dyadic, Dim>::Along along) {
  make_measurable<Dim>(along);
  const Vector<double, Dim> axis = approximate<Dim>(along.axis);
  const double length = scaled_norm<double, Dim>(axis);
  const double towards_b = along.offset.sign() < 0 ? -1 : 1;
  const auto [kind, i, j] = axis_at<Dim>(place);
  SatAxis<Scalar, Dim> result{kind, i, j, (axis * (towards_b / length)).template cast<Scalar>(), 0};
  const auto gap = static_cast<Scalar>(along.gap.approximate() / length);
  result.gap = std::max(gap, std::numeric_limits<Scalar>::denorm_min());
  return result;
}

template <int Dim>
void for_each_axis(AxisSet axes, auto&& visit) {
  for (int place = 0; place < kSatAxes<Dim>; ++place)
    if ((axes >> place & 1) != 0) visit(place);
}

/// Removes the axes from the set along which the projections certainly overlap, whatever double rounds.
template <class Scalar, int Dim>
AxisSet still_open(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, AxisSet axes) {
  const Pair<double, Dim> pair(a, b);
  const double size = (b.center.template cast<double>() - a.center.template cast<double>()).template lpNorm<1>() +
                      a.half_extents.template cast<double>().sum() + b.half_extents.template cast<double>().sum();
  const double error_bound = tolerance::kSatInDouble * size + std::numeric_limits<double>::min();
  AxisSet open = 0;
  for_each_axis<Dim>(axes, [&](int place) {
    if (!(pair.along(place).gap < -error_bound)) open |= AxisSet{1} << place;
  });
  return open;
}

}  // namespace

template <class Scalar, int Dim>
std::optional<SatAxis<Scalar, Dim>> separating_exactly(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                                                       AxisSet axes) {
  std::optional<SatAxis<Scalar, Dim>> best;
  const AxisSet open = still_open(a, b, axes);
  if (open == 0) return best;
  const Pair<Dyadic, Dim> pair(a, b);
  for_each_axis<Dim>(open, [&](int place) {
    const auto along = pair.along(place);
    if (along.gap.sign() <= 0) return;
    const auto axis = separating_axis<Scalar, Dim>(place, along);
    if (!best || axis.gap > best->gap) best = axis;
  });
  return best;
}

template <class Scalar, int Dim>
double exact_gap(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, int place) {
  auto along = Pair<Dyadic, Dim>(a, b).along(place);
  if (along.gap.sign() == 0) return 0;  // where the axis is zero as well
  make_measurable<Dim>(along);
  const double gap = along.gap.approximate() / scaled_norm<double, Dim>(approximate<Dim>(along.axis));
  return gap == 0 ? along.gap.sign() * std::numeric_limits<double>::denorm_min() : gap;
}

template <class Scalar, int Dim>
bool touch_exactly(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  const Pair<Dyadic, Dim> pair(a, b);
  bool touch = false;
  for (int place = 0; place < kSatAxes<Dim>; ++place) {
    const auto along = pair.along(place);
    const bool is_axis =
        std::any_of(along.axis.begin(), along.axis.end(), [](const Dyadic& x) { return x.sign() != 0; });
    if (along.gap.sign() > 0) return false;
    touch = touch || (is_axis && along.gap.sign() == 0);
  }
  return touch;
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template double exact_gap(const Obb<Scalar, Dim>&, const Obb<Scalar, Dim>&, int);                                    \
  template bool touch_exactly(const Obb<Scalar, Dim>&, const Obb<Scalar, Dim>&);                                       \
  template std::optional<SatAxis<Scalar, Dim>> separating_exactly(const Obb<Scalar, Dim>&, const Obb<Scalar, Dim>&,    \
                                                                  AxisSet);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::query
