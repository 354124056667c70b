#include "lesson/subjects/cloud/axes_by_hand.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/catalogue_rows.hpp"
#include "fit/kdop/kdop_by_hand.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/figures.hpp"
#include "lesson/rows.hpp"
#include "lesson/words.hpp"
#include "query/contain/contains_hull.hpp"

namespace snug::lesson {
namespace {

constexpr double kKnobBeyond = 1.25;  // times the distance of the farthest point from the centre
constexpr double kSameDirection = 1e-9;

template <int Dim>
std::vector<Vector<double, Dim>> axes_in(std::span<const Point3> axes) {
  std::vector<Vector<double, Dim>> own;
  for (const Point3& axis : axes) own.push_back(axis.head<Dim>());
  return own;
}

double enclosing(std::span<const Point3> axes, int dim) {
  return dim == 2 ? fit::enclosing<2>(axes_in<2>(axes)) : fit::enclosing<3>(axes_in<3>(axes));
}

/// Directions that may be added, all around: in the plane every 7.5 degrees, in space those of the 26-DOP.
std::vector<Point3> free_directions(int dim) {
  std::vector<Point3> all;
  constexpr int kSteps = 24;
  for (int i = 0; dim == 2 && i < kSteps; ++i) {
    const double angle = i * std::numbers::pi / kSteps;
    all.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  if (dim == 3)
    for (const auto& axis : kdop_axes<3>(26)) all.push_back(Point3(axis[0], axis[1], axis[2]).normalized());
  return all;
}

/// The candidate whose nearest neighbour among the axes is farthest away; the first of equal ones.
Point3 farthest_from(std::span<const Point3> axes, int dim) {
  Point3 best = Point3::UnitX();
  double least = 2;  // the largest |cosine| with any axis
  for (const Point3& candidate : free_directions(dim)) {
    double nearest = 0;
    for (const Point3& axis : axes) nearest = std::max(nearest, std::abs(candidate.dot(axis)));
    if (nearest < least - kSameDirection) least = nearest, best = candidate;
  }
  return best;
}

/// Calls with the points in double, and the axes in their dimension.
template <class Call>
auto with_axes(std::span<const Point3> axes, const AnyPointSet& points, Call call) {
  return std::visit(
      [&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) {
        const auto own = axes_in<Dim>(axes);
        const std::span<const Vector<double, Dim>> span(own);
        if constexpr (std::is_same_v<Scalar, double>) {
          return call(set.span(), span);
        } else {
          std::vector<Vector<double, Dim>> wide;
          for (const auto& p : set.span()) wide.push_back(p.template cast<double>());
          return call(PointSet<double, Dim>::make(std::move(wide))->span(), span);
        }
      },
      points);
}

/// Each point of the support set has to lie on a bound of a slab.
template <int Dim>
fit::Certificate certify(const fit::Fit<ConvexHull<double, Dim>>& fitted, PointSpan<double, Dim> points,
                         std::span<const Vector<double, Dim>> axes) {
  fit::Certificate certificate;
  for (const auto& p : points) {
    const double outside = query::outside_by(fitted.volume, p);
    certificate.outside += outside > 0 ? 1 : 0;
    certificate.max_outside = std::max(certificate.max_outside, outside);
  }
  certificate.contains = certificate.outside == 0;
  certificate.on_boundary = std::all_of(fitted.support.begin(), fitted.support.end(), [&](Index i) {
    return std::any_of(axes.begin(), axes.end(), [&](const auto& axis) {
      const fit::SlabFound found = fit::extremes_along<Dim>(axis, points);
      const double at = axis.dot(points[i]);
      return at == found.min || at == found.max;
    });
  });
  return certificate;
}

}  // namespace

void AxesByHand::begin(const AnyPointSet& points) {
  dim_ = fit::dim_of(points);
  axes_.clear();
  for (int i = 0; i < dim_; ++i) axes_.push_back(Point3::Unit(i));
  follow(points);
}

void AxesByHand::follow(const AnyPointSet& points) {
  if (fit::dim_of(points) != dim_) return begin(points);
  Point3 least = fit::point_of(points, 0), greatest = least;
  for (Index i = 1; i < fit::count_of(points); ++i) {
    least = least.cwiseMin(fit::point_of(points, i));
    greatest = greatest.cwiseMax(fit::point_of(points, i));
  }
  center_ = least + (greatest - least) / 2;
  double farthest = 0;
  for (Index i = 0; i < fit::count_of(points); ++i)
    farthest = std::max(farthest, (fit::point_of(points, i) - center_).norm());
  reach_ = farthest > 0 ? kKnobBeyond * farthest : 1;
}

Done AxesByHand::take(std::vector<Point3> axes) {
  if (static_cast<int>(axes.size()) > most(dim_))
    return tl::unexpected(InputError{.what = "there are at most " + std::to_string(most(dim_)) + " directions"});
  if (enclosing(axes, dim_) < fit::kLeastEnclosing)
    return tl::unexpected(InputError{.what = "slabs in these directions enclose nothing"});
  axes_ = std::move(axes);
  return {};
}

Done AxesByHand::move(Index i, const Point3& to) {
  Point3 way = to - center_;
  if (dim_ == 2) way[2] = 0;
  const double length = way.norm();
  if (!(length > 0) || !std::isfinite(length)) return tl::unexpected(InputError{.what = "a direction cannot be 0"});
  std::vector<Point3> axes = axes_;
  axes[i] = way / length;
  return take(std::move(axes));
}

Done AxesByHand::remove(Index i) {
  std::vector<Point3> axes = axes_;
  axes.erase(axes.begin() + i);
  return take(std::move(axes));
}

Done AxesByHand::resize(int count) {
  std::vector<Point3> axes = axes_;
  axes.resize(std::clamp(count, 0, size()));
  while (static_cast<int>(axes.size()) < std::min(count, most(dim_) + 1)) axes.push_back(farthest_from(axes, dim_));
  return take(std::move(axes));
}

std::vector<double> AxesByHand::row() const {
  RowWriter row(dim_);
  for (const Point3& axis : axes_) row(axis);
  return row.take();
}

Done AxesByHand::set_row(std::span<const double> numbers) {
  RowReader row(numbers, dim_);
  std::vector<Point3> axes(numbers.size() / static_cast<std::size_t>(dim_), Point3::Zero());
  for (Point3& axis : axes) {
    row(axis);
    const double length = axis.norm();
    if (!(length > 0) || !std::isfinite(length)) return tl::unexpected(InputError{.what = "a direction cannot be 0"});
    if (std::abs(length - 1) > kSameDirection) axis /= length;
  }
  if (!row.fits()) return tl::unexpected(InputError{.what = "these are not the numbers of directions"});
  return take(std::move(axes));
}

fit::Recording record_slabs(std::span<const Point3> axes, const AnyPointSet& points, fit::Recording room) {
  fit::Recording recording{.steps = std::move(room.steps)};
  recording.steps.clear();
  const fit::SeeStep keep = [&](fit::Step3&& step, const OperationCounts& counts) {
    recording.steps.push_back({std::move(step), counts});
  };
  with_axes(axes, points, [&]<int Dim>(PointSpan<double, Dim> span, std::span<const Vector<double, Dim>> own) {
    fit::LiftingObserver observer{keep};
    const auto fitted = fit::kdop_by_hand<Dim>(span, own, observer);
    observer.counter.take();
    recording.counts = observer.counter.counts;
    recording.result = {fit::lift(fitted.volume), fitted.support};
    recording.certificate = certify<Dim>(fitted, span, own);
  });
  return recording;
}

fit::Volume3 fit_slabs(std::span<const Point3> axes, const AnyPointSet& points) {
  return with_axes(axes, points, []<int Dim>(PointSpan<double, Dim> span, std::span<const Vector<double, Dim>> own) {
    return fit::Volume3(fit::lift(fit::kdop_by_hand<Dim>(span, own).volume));
  });
}

std::string direction_text(const Point3& axis, int dim) {
  const Point3 sizes = axis.cwiseAbs() / axis.cwiseAbs().maxCoeff();
  const bool plain = std::all_of(sizes.begin(), sizes.end(),
                                 [](double size) { return size < kSameDirection || size > 1 - kSameDirection; });
  if (plain) {
    Point3 signs = Point3::Zero();
    for (int i = 0; i < dim; ++i)
      if (sizes[i] > 0.5) signs[i] = axis[i] > 0 ? 1 : -1;
    if (signs[0] < 0 || (signs[0] == 0 && (signs[1] < 0 || (signs[1] == 0 && signs[2] < 0)))) signs = -signs;
    return axis_name(signs);
  }
  if (dim == 2) {
    double degrees = std::atan2(axis[1], axis[0]) * 180 / std::numbers::pi;
    if (degrees <= -90) degrees += 180;
    if (degrees > 90) degrees -= 180;
    return number_text(degrees, 3) + "°";
  }
  std::string text;
  for (int i = 0; i < 3; ++i) text += (i == 0 ? "(" : ", ") + number_text(axis[i], 2);
  return text + ")";
}

}  // namespace snug::lesson
