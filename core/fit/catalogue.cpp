#include "fit/catalogue.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "fit/aabb_center.hpp"
#include "fit/brute_force.hpp"
#include "fit/lift.hpp"
#include "fit/pca_sphere.hpp"
#include "fit/ritter.hpp"
#include "fit/ritter_iterative.hpp"
#include "fit/welzl.hpp"

namespace snug::fit {
namespace {

/// Counts, and hands each step on lifted where somebody wants to see it.
struct LiftingObserver {
  const SeeStep& see;
  Counter counter;
  template <class VolumeType, class... Facts>
  void operator()(const Step<VolumeType, Facts...>& step) {
    counter(step);
    if (see) see(lift(step), counter.counts);
  }
  void count(Operation operation, std::int64_t n) { counter.count(operation, n); }
};

template <class Held>
std::vector<Index> indices_of(const Held& support) {
  return {support.begin(), support.end()};
}

template <auto kFitter>
Result fit_any(const AnyPointSet& points, const Options& options) {
  return std::visit(
      [&](const auto& set) {
        Ignore ignore;
        const auto fit = kFitter(set.span(), options, ignore);
        return Result{lift(fit.volume), indices_of(fit.support)};
      },
      points);
}

template <auto kFitter, bool kExact>
Watched watch_any(const AnyPointSet& points, const Options& options, const SeeStep& see) {
  return std::visit(
      [&](const auto& set) {
        LiftingObserver observer{see, {}};
        const auto fit = kFitter(set.span(), options, observer);
        return Watched{{lift(fit.volume), indices_of(fit.support)},
                       observer.counter.steps,
                       observer.counter.counts,
                       certify(fit, set.span(), kExact)};
      },
      points);
}

template <auto kFitter, bool kExact>
Recording record_any(const AnyPointSet& points, const Options& options) {
  std::vector<Recorder<Step3>::Entry> entries;
  Watched watched = watch_any<kFitter, kExact>(
      points, options, [&](Step3&& step, const OperationCounts& counts) { entries.push_back({std::move(step), counts}); });
  return {watched.result, std::move(entries), watched.counts, watched.certificate};
}

constexpr Index kAny = std::numeric_limits<Index>::max();

template <auto kFitter, bool kExact>
constexpr Algorithm row(std::string_view name, std::string_view title, Index max_points, std::string_view source,
                        std::span<const std::string_view> pseudocode) {
  return {"sphere", name, title, kExact, max_points, source, pseudocode, &fit_any<kFitter>,
          &record_any<kFitter, kExact>, &watch_any<kFitter, kExact>};
}

constexpr auto kAabbCenter = [](auto p, const Options&, auto& o) { return aabb_center(p, o); };
constexpr auto kRitter = [](auto p, const Options&, auto& o) { return ritter(p, o); };
constexpr auto kRitterIterative = [](auto p, const Options& options, auto& o) { return ritter_iterative(p, options, o); };
constexpr auto kPca = [](auto p, const Options&, auto& o) { return pca_sphere(p, o); };
constexpr auto kWelzl = [](auto p, const Options& options, auto& o) { return welzl(p, options, o); };
constexpr auto kBruteForce = [](auto p, const Options&, auto& o) { return brute_force(p, o); };

constexpr std::array kAlgorithms{
    row<kAabbCenter, false>("aabb_center", "Box midpoint", kAny,
                            "C. Ericson, Real-Time Collision Detection, 2005", kAabbCenterPseudocode),
    row<kRitter, false>("ritter", "Ritter", kAny, "J. Ritter, An efficient bounding sphere, 1990", kRitterPseudocode),
    row<kRitterIterative, false>("ritter_iterative", "Iterative Ritter", kAny,
                                 "C. Ericson, Real-Time Collision Detection, 2005", kRitterIterativePseudocode),
    row<kPca, false>("pca", "PCA (Wu)", kAny, "X. Wu, A linear-time simple bounding volume algorithm, 1992",
                     kPcaSpherePseudocode),
    row<kWelzl, true>("welzl", "Welzl", kAny, "E. Welzl, Smallest enclosing disks (balls and ellipsoids), 1991",
                      kWelzlPseudocode),
    row<kBruteForce, true>("brute_force", "Brute force", kBruteForceLimit,
                           "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007", kBruteForcePseudocode),
};

}  // namespace

std::span<const Algorithm> algorithms() { return kAlgorithms; }

std::span<const Algorithm> algorithms_of(std::string_view volume) {
  const auto of_it = [&](const Algorithm& algorithm) { return algorithm.volume == volume; };
  const auto* first = std::find_if(kAlgorithms.begin(), kAlgorithms.end(), of_it);
  return {first, std::find_if_not(first, kAlgorithms.end(), of_it)};
}

const Algorithm* find_algorithm(std::string_view volume, std::string_view name) {
  for (const Algorithm& algorithm : algorithms_of(volume))
    if (algorithm.name == name) return &algorithm;
  return nullptr;
}

const Algorithm& exact_algorithm(std::string_view volume) {
  const auto all = algorithms_of(volume);
  return *std::find_if(all.begin(), all.end(), [](const Algorithm& algorithm) { return algorithm.exact; });
}

namespace {

/// Of a lifted volume of that dimension.
template <int Dim>
struct Measure {
  double operator()(const Sphere3& ball) const { return measure(Sphere<double, Dim>{ball.center.template head<Dim>(), ball.radius}); }
  double operator()(const Aabb<double, 3>& box) const { return (box.max - box.min).template head<Dim>().prod(); }
  double operator()(const Obb<double, 3>& box) const { return (2 * box.half_extents).template head<Dim>().prod(); }
  double operator()(const Capsule<double, 3>& capsule) const {
    return measure(Capsule<double, Dim>{capsule.a.template head<Dim>(), capsule.b.template head<Dim>(), capsule.radius});
  }
  double operator()(const Lozenge<double, 3>& lozenge) const {
    return measure(Lozenge<double, Dim>{lozenge.origin.template head<Dim>(),
                                        {lozenge.edges[0].template head<Dim>(), lozenge.edges[1].template head<Dim>()},
                                        lozenge.radius});
  }
  double operator()(const Kdop<double, 3>&) const { return 0; }
  double operator()(const ConvexHull<double, 3>&) const { return 0; }
};

}  // namespace

double measure_of(const Volume3& volume, int dim) {
  return dim == 2 ? std::visit(Measure<2>{}, volume) : std::visit(Measure<3>{}, volume);
}

double size_of(const Volume3& volume, int dim) {
  const auto* ball = std::get_if<Sphere3>(&volume);
  return ball != nullptr ? ball->radius : measure_of(volume, dim);
}

int dim_of(const AnyPointSet& points) {
  return std::visit([]<class Scalar, int Dim>(const PointSet<Scalar, Dim>&) { return Dim; }, points);
}

Index size_of(const AnyPointSet& points) {
  return std::visit([](const auto& set) { return set.size(); }, points);
}

Vector<double, 3> point_of(const AnyPointSet& points, Index i) {
  return std::visit([&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) { return lift<Scalar, Dim>(set[i]); }, points);
}

}  // namespace snug::fit
