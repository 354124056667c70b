#include "fit/sphere/tiny.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "fit/sphere/certify_sphere.hpp"
#include "geometry/point_set.hpp"

namespace snug::fit {
namespace {

/// All coordinates of tiny points are below this. From here on, the squares of the least differences of coordinates are
/// normal numbers.
template <class Scalar>
constexpr Scalar kTiny = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p-300) : static_cast<Scalar>(0x1p-30);

/// The factor for tiny points: the square of the smallest subnormal number becomes a normal one, and no tiny coordinate
/// exceeds kLargest.
template <class Scalar>
constexpr Scalar kEnlarged = sizeof(Scalar) == 8 ? static_cast<Scalar>(0x1p800) : static_cast<Scalar>(0x1p90);

/// The points, enlarged, if they are tiny; none otherwise, which mostly the first coordinate tells.
template <class Scalar, int Dim>
std::optional<PointSet<Scalar, Dim>> enlarged(PointSpan<Scalar, Dim> points) {
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
Sphere<Scalar, Dim> reduced(const Sphere<Scalar, Dim>& ball, PointSpan<Scalar, Dim> larger) {
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

// ---- what a step tells, in the points' own units. unit: the inverse of the factor.

void reduce(double& length, double unit) { length *= unit; }
void reduce(Vector<double, 3>& v, double unit) { v *= unit; }
void reduce(Sphere3& ball, double unit) {
  ball.center *= unit;
  ball.radius *= unit;
}
void reduce(CovarianceFound<double, 3>& fact, double unit) {
  fact.mean *= unit;
  fact.covariance *= unit;
  fact.covariance *= unit;
}
void reduce(AxesFound<double, 3>& fact, double unit) {
  fact.mean *= unit;
  fact.variances *= unit;
  fact.variances *= unit;
}
template <class Other>
void reduce(Other&, double) {}  // an index, a count, a choice

template <class Fact>
requires requires(Fact& fact) { Fact::tie(fact); }
void reduce_fields(Fact& fact, double unit) {
  std::apply([&](auto&... fields) { (reduce(fields, unit), ...); }, Fact::tie(fact));
}
void reduce_fields(CovarianceFound<double, 3>& fact, double unit) { reduce(fact, unit); }
void reduce_fields(AxesFound<double, 3>& fact, double unit) { reduce(fact, unit); }

/// Only what a sphere's fitter tells.
template <class... Facts>
void reduce_fact(Fact3& any, double unit, const std::variant<Facts...>*) {
  const auto try_one = [&](auto* fact) {
    if (fact != nullptr) reduce_fields(*fact, unit);
  };
  (try_one(std::get_if<Facts>(&any)), ...);
}

void reduce(Step3& step, double unit) {
  if (auto* const ball = std::get_if<Sphere3>(&step.volume)) reduce(*ball, unit);
  reduce_fact(step.fact, unit, static_cast<const SphereStep<double, 3>::Fact*>(nullptr));
}

/// Puts the ball of the enlarged points back, and says what rounding left outside.
template <class Scalar, int Dim>
Fit<Sphere<Scalar, Dim>> put_back(Result& result, PointSpan<Scalar, Dim> larger) {
  const Sphere<Scalar, Dim> own = reduced(converted<Scalar, Dim>(ball_of(result)), larger);
  result.volume = lift(own);
  return {own, {}};
}

}  // namespace

Result fit_of_any_size(const AnyPointSet& points, const Options& options, decltype(Algorithm::fit) fit) {
  return with_span<Result>(points, [&](auto span) {
    const auto larger = enlarged(span);
    if (!larger) return fit(points, options);
    Result result = fit(*larger, options);
    static_cast<void>(put_back(result, larger->span()));
    return result;
  });
}

Watched watch_of_any_size(const AnyPointSet& points, const Options& options, const SeeStep& see,
                          decltype(Algorithm::watch) watch) {
  return with_span<Watched>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) {
    const auto larger = enlarged(span);
    if (!larger) return watch(points, options, see);
    const double unit = 1 / static_cast<double>(kEnlarged<Scalar>);
    SeeStep see_reduced;
    if (see)
      see_reduced = [&](Step3&& step, const OperationCounts& counts) {
        reduce(step, unit);
        see(std::move(step), counts);
      };
    Watched watched = watch(*larger, options, see_reduced);
    // The proof is that of the enlarged points, whose numbers are the same; what rounding left outside is not.
    const Certificate rounded = certify(put_back(watched.result, larger->span()), span, false);
    watched.certificate.contains = rounded.contains;
    watched.certificate.outside = rounded.outside;
    watched.certificate.max_outside = rounded.max_outside;
    watched.certificate.lower_bound *= unit;
    return watched;
  });
}

}  // namespace snug::fit
