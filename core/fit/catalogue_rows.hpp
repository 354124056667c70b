// How a fitter becomes a row of the catalogue. For the catalogue's own files, one in each folder of volumes.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "fit/catalogue.hpp"
#include "fit/certify.hpp"
#include "fit/counters.hpp"
#include "fit/lift.hpp"

namespace snug::fit {

/// Counts operations, and passes each step on in double and 3-D if there is a callback.
struct LiftingObserver {
  const SeeStep& see;
  FullCounter counter{};
  template <class VolumeType, class... Facts>
  void operator()(const Step<VolumeType, Facts...>& step) {
    counter(step);
    if (!see) return;
    see(lift(step), counter.counts);
    counter.pass();
  }
  void count(Operation operation, std::int64_t n) { counter.count(operation, n); }
};

template <class Held>
std::vector<Index> indices_of(const Held& support) {
  return {support.begin(), support.end()};
}

/// Calls a function with the set's span.
template <class Returned, class Call>
Returned with_span(const AnyPointSet& points, Call call) {
  return std::visit([&](const auto& set) -> Returned { return call(set.span()); }, points);
}

template <auto kFitter>
Result fit_any(const AnyPointSet& points, const Options& options) {
  return with_span<Result>(points, [&](auto span) {
    Ignore ignore;
    const auto fit = kFitter(span, options, ignore);
    return Result{lift(fit.volume), indices_of(fit.support)};
  });
}

template <auto kFitter, bool kExact>
Watched watch_any(const AnyPointSet& points, const Options& options, const SeeStep& see) {
  return with_span<Watched>(points, [&](auto span) {
    LiftingObserver observer{see};
    const auto fit = kFitter(span, options, observer);
    observer.counter.take();
    return Watched{{lift(fit.volume), indices_of(fit.support)},
                   observer.counter.steps,
                   observer.counter.counts,
                   certify(fit, span, kExact)};
  });
}

inline constexpr Index kAny = std::numeric_limits<Index>::max();

/// The description of an algorithm, without its code.
struct About {
  std::string_view volume, name, title, source;
  Theory theory;
  std::span<const std::string_view> pseudocode;
  std::span<const std::string_view> plane_pseudocode = {};
  bool plane = true, space = true;
  Index max_points = kAny, most_finished = kAny;
  bool naive = false, loses_points = false;
};

/// kFitter: takes a PointSpan, Options and an observer. kExact: whether it guarantees the smallest.
template <auto kFitter, bool kExact = false>
constexpr Algorithm row(const About& about) {
  return {about.volume,      about.name,
          about.title,       kExact,
          about.naive,       about.loses_points,
          about.plane,       about.space,
          about.max_points,  std::min(about.max_points, about.most_finished),
          about.source,      about.theory,
          about.pseudocode,  about.plane_pseudocode,
          &fit_any<kFitter>, &watch_any<kFitter, kExact>};
}

// Sources that several rows name.
inline constexpr std::string_view kEricson = "C. Ericson, Real-Time Collision Detection, 2005";
inline constexpr std::string_view kRomanick = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";

}  // namespace snug::fit
