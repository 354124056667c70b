#include "fit/catalogue.hpp"

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
  template <class Scalar, int Dim>
  void operator()(const SphereStep<Scalar, Dim>& step) {
    counter(step);
    if (see) see(lift(step), counter.counts);
  }
  void count(Operation operation, std::int64_t n) { counter.count(operation, n); }
};

template <auto kFitter>
Result fit_any(const AnyPointSet& points, const Options& options) {
  return std::visit(
      [&](const auto& set) {
        Ignore ignore;
        const auto fit = kFitter(set.span(), options, ignore);
        return Result{lift(fit.volume), fit.support};
      },
      points);
}

template <auto kFitter, bool kExact>
Watched watch_any(const AnyPointSet& points, const Options& options, const SeeStep& see) {
  return std::visit(
      [&](const auto& set) {
        LiftingObserver observer{see, {}};
        const auto fit = kFitter(set.span(), options, observer);
        return Watched{{lift(fit.volume), fit.support},
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

const Algorithm* find_algorithm(std::string_view volume, std::string_view name) {
  for (const Algorithm& algorithm : kAlgorithms)
    if (algorithm.volume == volume && algorithm.name == name) return &algorithm;
  return nullptr;
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
