#include "fit/obb/obb_from_axes.hpp"

#include <cmath>
#include <limits>

#include "fit/sphere/extremes.hpp"
#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"
#include "number/outward.hpp"
#include "number/power_of_two.hpp"
#include "query/contain/contains.hpp"

namespace snug::fit {
namespace {

/// The least and greatest projections onto each axis, measured from an origin.
template <int Dim>
struct Reach {
  Vector<double, Dim> least = Vector<double, Dim>::Constant(std::numeric_limits<double>::infinity());
  Vector<double, Dim> greatest = -least;

  void add(const Vector<double, Dim>& along) {
    for (int i = 0; i < Dim; ++i) {
      least[i] = std::min(least[i], along[i]);
      greatest[i] = std::max(greatest[i], along[i]);
    }
  }
};

/// A half extent that grows until the slab contains every point given to it, exactly.
template <class Scalar, int Dim>
class Slab {
 public:
  /// size: the points' largest distance from the centre, within a factor of 8.
  Slab(const Vector<Scalar, Dim>& center, const Vector<Scalar, Dim>& axis, double size)
      : center_(center), axis_(axis), exponent_(exponent_of(size)) {}

  [[nodiscard]] Scalar half_extent() const { return half_; }

  void hold(const Vector<Scalar, Dim>& point) {
    const DoubleDouble reach = scaled_reach(point);
    for (;;) {
      const double beyond = (reach - DoubleDouble(std::ldexp(static_cast<double>(half_), -exponent_))).value();
      if (beyond < -tolerance::kWideProjection) return;
      const bool in_doubt = beyond <= tolerance::kWideProjection;
      if (in_doubt && exact_questions_ > 0) {
        --exact_questions_;
        if (query::side_of_slab<Scalar, Dim>(point, center_, axis_, half_) <= 0) return;
      }
      const double to = reach.value() + (in_doubt ? 2 * tolerance::kWideProjection : 0);
      half_ = std::max(std::nextafter(half_, std::numeric_limits<Scalar>::max()),
                       static_cast<Scalar>(std::ldexp(to, exponent_)));
    }
  }

 private:
  /// |(point - centre) . axis|, scaled by a power of two to about 1.
  [[nodiscard]] DoubleDouble scaled_reach(const Vector<Scalar, Dim>& point) const {
    DoubleDouble sum;
    for (int i = 0; i < Dim; ++i) {
      const double p = std::ldexp(static_cast<double>(point[i]), -exponent_);
      const double c = std::ldexp(static_cast<double>(center_[i]), -exponent_);
      sum += DoubleDouble::sum(p, -c) * DoubleDouble(static_cast<double>(axis_[i]));
    }
    return sum < DoubleDouble(0) ? -sum : sum;
  }

  Vector<Scalar, Dim> center_, axis_;
  int exponent_;
  Scalar half_ = 0;
  int exact_questions_ = 4096;  // after so many, the error bound, far below an ulp, widens the half extent
};

template <class Scalar, int Dim>
class Around {
 public:
  Around(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points)
      : points_(points), origin_(points[0].template cast<double>()), turn_(axes.template cast<double>().transpose()) {
    found_.box.axes = axes;
  }

  BoxOnAxes<Scalar, Dim> box() {
    reach_of_blocks();
    const Vector<double, Dim> middle = all_.least + (all_.greatest - all_.least) / 2;
    found_.box.center = (origin_ + turn_.transpose() * middle).template cast<Scalar>();
    for (int axis = 0; axis < Dim; ++axis) widen(axis);
    return std::move(found_);
  }

 private:
  static constexpr Index kBlock = 1024;

  [[nodiscard]] Vector<double, Dim> along(Index i) const {
    return turn_ * Vector<double, Dim>(points_[i].template cast<double>() - origin_);
  }

  template <class Visit>
  void for_block(std::size_t block, Visit&& visit) const {
    const Index begin = static_cast<Index>(block) * kBlock;
    const Index end = begin + std::min(points_.size() - begin, kBlock);
    for (Index i = begin; i < end; ++i) visit(i);
  }

  void reach_of_blocks() {
    blocks_.resize(static_cast<std::size_t>((points_.size() - 1) / kBlock) + 1);
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      Reach<Dim> reach;
      for_block(block, [&](Index i) { reach.add(along(i)); });
      blocks_[block] = reach;
      all_.add(reach.least);
      all_.add(reach.greatest);
    }
    size_ = (all_.greatest - all_.least).sum();
  }

  void widen(int axis) {
    const Vector<double, Dim> to_center = found_.box.center.template cast<double>() - origin_;
    const double middle = turn_.row(axis).dot(to_center);
    const double most = std::max(all_.greatest[axis] - middle, middle - all_.least[axis]);
    // Twice the error bound of the projections.
    const double error_bound =
        tolerance::kExtremeProjection * (size_ + to_center.norm()) + 16 * std::numeric_limits<double>::denorm_min();
    const auto near = [&](double projection) { return std::abs(projection - middle) >= most - error_bound; };

    Slab<Scalar, Dim> slab(found_.box.center, found_.box.axes.col(axis), std::max(size_, to_center.norm()));
    Index least = kNoIndex, greatest = kNoIndex;
    for (std::size_t block = 0; block < blocks_.size(); ++block) {
      const double low = blocks_[block].least[axis], high = blocks_[block].greatest[axis];
      const bool has_end =
          (least == kNoIndex && low == all_.least[axis]) || (greatest == kNoIndex && high == all_.greatest[axis]);
      if (!has_end && !near(low) && !near(high)) continue;
      for_block(block, [&](Index i) {
        const double projection = along(i)[axis];
        if (least == kNoIndex && projection == all_.least[axis]) least = i;
        if (greatest == kNoIndex && projection == all_.greatest[axis]) greatest = i;
        if (near(projection)) slab.hold(points_[i]);
      });
    }
    found_.box.half_extents[axis] = slab.half_extent();
    found_.least.push_back(least);
    found_.greatest.push_back(greatest);
  }

  PointSpan<Scalar, Dim> points_;
  Vector<double, Dim> origin_;
  Matrix<double, Dim> turn_;  // rotates a direction into the box's frame
  std::vector<Reach<Dim>> blocks_;
  Reach<Dim> all_;
  double size_ = 0;
  BoxOnAxes<Scalar, Dim> found_;
};

/// Coordinates are their own projections, so the faces are known exactly, and no point needs a second look.
template <class Scalar, int Dim>
BoxOnAxes<Scalar, Dim> box_along_coordinates(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points) {
  Ignore ignore;
  const ExtremesFound<Scalar, Dim> ends = extreme_points(points, ignore);
  BoxOnAxes<Scalar, Dim> found;
  found.box.axes = axes;
  for (int axis = 0; axis < Dim; ++axis) {
    int along = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&along);
    Index least = ends.least[along], greatest = ends.greatest[along];
    const Scalar low = points[least][along], high = points[greatest][along];
    const auto middle = static_cast<Scalar>((static_cast<double>(low) + static_cast<double>(high)) / 2);
    found.box.center[along] = middle;
    found.box.half_extents[axis] = std::max(sum_up<Scalar>(high, -middle), sum_up<Scalar>(middle, -low));
    if (axes(along, axis) < 0) std::swap(least, greatest);
    found.least.push_back(least);
    found.greatest.push_back(greatest);
  }
  return found;
}

}  // namespace

template <class Scalar, int Dim>
BoxOnAxes<Scalar, Dim> obb_from_axes(const Matrix<Scalar, Dim>& axes, PointSpan<Scalar, Dim> points) {
  if (along_coordinates<Scalar, Dim>(axes)) return box_along_coordinates<Scalar, Dim>(axes, points);
  return Around<Scalar, Dim>(axes, points).box();
}

template BoxOnAxes<float, 2> obb_from_axes(const Matrix<float, 2>&, PointSpan<float, 2>);
template BoxOnAxes<float, 3> obb_from_axes(const Matrix<float, 3>&, PointSpan<float, 3>);
template BoxOnAxes<double, 2> obb_from_axes(const Matrix<double, 2>&, PointSpan<double, 2>);
template BoxOnAxes<double, 3> obb_from_axes(const Matrix<double, 3>&, PointSpan<double, 3>);

}  // namespace snug::fit
