// The tables of measurements. Each row lists its fields by name once, for every writer and reader (report.hpp). A dot
// in a name is a level: "time_ns.median" is {"time_ns":{"median":...}} in JSON, a column's name in CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/vector.hpp"
#include "measure/timing.hpp"
#include "trace/observer.hpp"

namespace snug::cost {

/// What is needed to compare two results. The caller passes all of it in.
struct Provenance {
  std::string version;   // the program's
  std::string build;     // the compiler and the kind of build
  std::string platform;  // "native" or "WebAssembly"
  std::string processor;
  std::string points;  // the points: a file's name, or "cube:1000"
  std::string scalar;  // "double" or "float"
  int dim = 3;
  std::int64_t seed = 1;
  double clock_resolution_ns = 0;
  void fields(auto&& see) {
    SNUG_SEE(see, version, build, platform, processor, points, scalar, dim, seed, clock_resolution_ns);
  }
};

/// The fields of a timing, with names such as "time_ns.median". prefix: "time_ns".
void timing_fields(std::string_view prefix, auto& timing, auto&& see) {
  timing.fields(
      [&](std::string_view name, auto& value) { see(std::string(prefix).append(1, '.').append(name), value); });
}

/// An algorithm and what its accuracy costs.
struct CostRow {
  static constexpr std::string_view kTable = "costs";
  std::string volume, algorithm;
  Index points = 0;  // how many it was measured on
  Index of = 0;      // how many there are: more than points, if one run on all of them would take too long
  std::optional<double> whole_ns;  // a run on all of them, extrapolated; none if points == of, or if a limit of the
                                   // algorithm's own would stop it
  Timing time;                     // of one fit
  OperationCounts operations{};    // of one watched run
  std::int64_t steps = 0;
  double size = 0;                  // a ball's radius; for any other volume its measure
  double measure = 0;               // volume (3-D) or area (2-D), scene units cubed or squared
  std::optional<double> tightness;  // size over that of the smallest of its kind; none if that is unknown or flat
  std::optional<double> over_hull;  // measure over the convex hull's; none if that is flat or took too long
  double noise = 0;                 // a measure no larger than this is only rounding; it is not a column of the table
  [[nodiscard]] bool is_flat() const { return measure <= noise; }
  std::int64_t bytes = 0;
  int overlap_pairs = 0, overlapping = 0;
  Timing overlap;                     // one test with a copy that is near: half of them overlap
  Timing scene_overlap;               // one test with a copy of a scene, most of which are apart
  std::optional<std::string> update;  // which update was timed; none if the volume has none
  Timing updated;                     // one update after a rotation; empty if there is none
  bool contains = false, on_boundary = false;
  std::optional<bool> optimal;  // none if the algorithm does not guarantee it
  bool on_front = false;        // whether no other row beats it in both time and measure (mark_front)
  void fields(auto&& see) {
    SNUG_SEE(see, volume, algorithm, points, of, whole_ns);
    timing_fields("time_ns", time, see);
    for (std::size_t i = 0; i < kOperationNames.size(); ++i)
      see(std::string("operations.").append(kOperationNames[i]), operations[i]);
    SNUG_SEE(see, steps, size, measure, tightness, over_hull, bytes, overlap_pairs, overlapping);
    timing_fields("overlap_ns", overlap, see);
    timing_fields("scene_overlap_ns", scene_overlap, see);
    SNUG_SEE(see, update);
    timing_fields("update_ns", updated, see);
    see("certificate.contains", contains);
    see("certificate.on_boundary", on_boundary);
    see("certificate.optimal", optimal);
    SNUG_SEE(see, on_front);
  }
};

/// An algorithm's time on a number of points. The exponent fitted through all of its times is in each of its rows.
struct GrowthRow {
  static constexpr std::string_view kTable = "growth";
  std::string volume, algorithm;
  Index points = 0;
  Timing time;
  bool in_fit = false;                    // whether the exponent is fitted through it
  std::optional<double> exponent;         // of n in the time; none if there are too few times
  std::string theory;                     // "O(n log n)"
  std::optional<double> theory_exponent;  // the theory's; none if it does not depend on n alone
  bool tight = false;                     // whether the theory is more than an upper bound
  std::string stopped;                    // why there are no more points; empty if there are more
  void fields(auto&& see) {
    SNUG_SEE(see, volume, algorithm, points);
    timing_fields("time_ns", time, see);
    SNUG_SEE(see, in_fit, exponent, theory, theory_exponent, tight, stopped);
  }
};

/// A body's volume at one angle of a full turn.
struct TurnRow {
  static constexpr std::string_view kTable = "turn";
  std::string volume, strategy;
  Index points = 0;
  double degrees = 0;
  std::optional<double> slack;  // how much larger it is than the tightest of its kind; none if that is flat
  double measure = 0;
  bool contains = false;
  Timing updated;  // one update: the median of the whole turn
  void fields(auto&& see) {
    SNUG_SEE(see, volume, strategy, points, degrees, slack, measure, contains);
    timing_fields("update_ns", updated, see);
  }
};

/// A volume's five criteria, and what it would cost in all under a load (load.hpp).
struct WhichRow {
  static constexpr std::string_view kTable = "which";
  std::string volume, algorithm;
  Index points = 0, of = 0;         // as of CostRow
  Timing test, build;               // one overlap test with a near copy; one fit
  std::optional<double> whole_ns;   // as of CostRow
  Timing update;                    // one update after a rotation
  std::optional<double> over_hull;  // looseness; none if the hull is flat
  std::int64_t bytes = 0;
  int pairs_apart = 0, passed = 0;  // pairs of bodies that are apart, and how many of them it does not reject
  double false_positives = 0;       // their share
  double bodies = 0, frames = 0, updates = 0, pairs = 0, hit_rate = 0;  // the load
  bool deforms = false;
  std::optional<double> total_build, total_updates, total_tests, total_false_positives,
      total;  // ns; none without a hull
  void fields(auto&& see) {
    SNUG_SEE(see, volume, algorithm, points, of);
    timing_fields("test_ns", test, see);
    SNUG_SEE(see, over_hull);
    timing_fields("build_ns", build, see);
    SNUG_SEE(see, whole_ns);
    timing_fields("update_ns", update, see);
    SNUG_SEE(see, bytes, pairs_apart, passed, false_positives);
    see("load.bodies", bodies);
    see("load.frames", frames);
    see("load.updates", updates);
    see("load.pairs", pairs);
    see("load.hit_rate", hit_rate);
    see("load.deforms", deforms);
    see("total_ns.build", total_build);
    see("total_ns.updates", total_updates);
    see("total_ns.tests", total_tests);
    see("total_ns.false_positives", total_false_positives);
    see("total_ns.total", total);
  }
};

/// A lecture's claim, and what was measured.
struct ClaimRow {
  static constexpr std::string_view kTable = "claims";
  std::string claim;  // its name: "ritter_ten_per_cent"
  std::string lecture, slide;
  std::string says;                 // in our words
  std::string measured;             // in words, with the figures of this run
  double figure = 0;                // the number that decides
  std::string verdict = "unknown";  // or "holds", "typical" (but not a bound), "false"
  void fields(auto&& see) { SNUG_SEE(see, claim, lecture, slide, says, measured, figure, verdict); }
};

}  // namespace snug::cost
