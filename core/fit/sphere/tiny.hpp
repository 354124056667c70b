// Tiny points, whose squared lengths would lose digits to underflow, are fitted a power of two times as large: that
// changes no digit. What the catalogue's rows of spheres do around their fitters; the rows of other volumes square no
// lengths, or scale by themselves.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "fit/catalogue_rows.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {

/// No coordinate of tiny points is this large. Down to it, the squares of their least differences are normal numbers.
template <class Scalar>
inline constexpr Scalar kTiny = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p-300) : static_cast<Scalar>(0x1p-30);

/// Takes the smallest subnormal number to where its square is a normal one, and no tiny coordinate beyond kLargest.
template <class Scalar>
inline constexpr Scalar kEnlarged = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p800) : static_cast<Scalar>(0x1p90);

/// The points so many times as large if they are tiny, none if they are not: mostly the first coordinate tells.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<PointSet<Scalar, Dim>> enlarged(PointSpan<Scalar, Dim> points) {
  bool all_zero = true;
  for (const auto& p : points) {
    const Scalar largest = p.cwiseAbs().maxCoeff();
    if (largest >= kTiny<Scalar>) return std::nullopt;
    all_zero = all_zero && largest == 0;
  }
  if (all_zero) return std::nullopt;
  std::vector<Vector<Scalar, Dim>> larger;
  for (const auto& p : points) larger.push_back(p * kEnlarged<Scalar>);
  return *PointSet<Scalar, Dim>::make(std::move(larger));
}

/// The ball around the points as they are. Among subnormal numbers its centre is rounded, and its radius then reaches
/// the farthest point from there. larger: the enlarged points.
template <class Scalar, int Dim>
[[nodiscard]] Sphere<Scalar, Dim> reduced(const Sphere<Scalar, Dim>& ball, PointSpan<Scalar, Dim> larger) {
  constexpr Scalar kFactor = kEnlarged<Scalar>;
  Sphere<Scalar, Dim> result{ball.center / kFactor, ball.radius / kFactor};
  const Vector<Scalar, Dim> center = result.center * kFactor;
  Scalar radius = ball.radius;
  if (center != ball.center) radius = enclosing_radius(center, larger, farthest_points(center, larger));
  result.radius = radius / kFactor;
  if (result.radius * kFactor < radius)
    result.radius = std::nextafter(result.radius, std::numeric_limits<Scalar>::infinity());
  return result;
}

/// A step's volume and its fact, in the points' own units. unit: the inverse of the factor.
inline void reduce(double& length, double unit) { length *= unit; }
inline void reduce(Vector<double, 3>& v, double unit) { v *= unit; }
inline void reduce(Sphere3& ball, double unit) { ball.center *= unit, ball.radius *= unit; }
template <class Other>
void reduce(Other&, double) {}  // an index, a count, a choice
inline void reduce(CovarianceFound<double, 3>& fact, double unit) {
  fact.mean *= unit, fact.covariance *= unit, fact.covariance *= unit;
}
inline void reduce(AxesFound<double, 3>& fact, double unit) {
  fact.mean *= unit, fact.variances *= unit, fact.variances *= unit;
}
template <class Fact>
requires requires(Fact& fact) {
  Fact::tie(fact);
} &&(!std::is_same_v<Fact, Sphere3>)void reduce(Fact& fact, double unit) {
  std::apply([&](auto&... fields) { (reduce(fields, unit), ...); }, Fact::tie(fact));
}

inline void reduce(Step3& step, double unit) {
  if (Sphere3* const ball = std::get_if<Sphere3>(&step.volume)) reduce(*ball, unit);
  std::visit([&](auto& fact) { reduce(fact, unit); }, step.fact);
}

template <auto kFitter>
Result fit_sphere(const AnyPointSet& points, const Options& options) {
  return with_span<Result>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) {
    const auto larger = enlarged(span);
    if (!larger) return fit_any<kFitter>(points, options);
    Ignore ignore;
    const auto fit = kFitter(larger->span(), options, ignore);
    return Result{lift(reduced(fit.volume, larger->span())), indices_of(fit.support)};
  });
}

template <auto kFitter, bool kExact>
Watched watch_sphere(const AnyPointSet& points, const Options& options, const SeeStep& see) {
  return with_span<Watched>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) {
    const auto larger = enlarged(span);
    if (!larger) return watch_any<kFitter, kExact>(points, options, see);
    const double unit = 1 / static_cast<double>(kEnlarged<Scalar>);
    SeeStep see_reduced;
    if (see)
      see_reduced = [&](Step3&& step, const OperationCounts& counts) {
        reduce(step, unit);
        see(std::move(step), counts);
      };
    Watched watched = watch_any<kFitter, kExact>(AnyPointSet(*larger), options, see_reduced);
    const auto ball = converted<Scalar, Dim>(ball_of(watched.result));
    const Sphere<Scalar, Dim> own = reduced(ball, larger->span());
    watched.result.volume = lift(own);
    // The proof is that of the enlarged points, whose numbers are the same; what rounding left outside is not.
    const Certificate rounded = certify(Fit<Sphere<Scalar, Dim>>{own, {}}, span, false);
    watched.certificate.contains = rounded.contains, watched.certificate.outside = rounded.outside;
    watched.certificate.max_outside = rounded.max_outside;
    watched.certificate.lower_bound *= unit;
    return watched;
  });
}

/// A row whose fitter takes points of any size.
template <auto kFitter, bool kExact = false>
constexpr Algorithm sphere_row(const About& about) {
  Algorithm algorithm = row<kFitter, kExact>(about);
  algorithm.fit = &fit_sphere<kFitter>;
  algorithm.watch = &watch_sphere<kFitter, kExact>;
  return algorithm;
}

}  // namespace snug::fit
