// What was measured, as tables. Each row lists its fields by name once, for every writer and reader (report.hpp). A dot
// in a name is a level: "time_ns.median" is {"time_ns":{"median":...}} in JSON, and a column's name in CSV.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/vector.hpp"
#include "measure/timing.hpp"
#include "trace/observer.hpp"

namespace snug::cost {

/// What is needed to compare two results. All of it is passed in by who measures.
struct Provenance {
  std::string version;   // of the program
  std::string build;     // compiler and kind of build
  std::string platform;  // "native" or "WebAssembly"
  std::string processor;
  std::string points;  // what was measured on: a file's name, "cube:1000"
  std::string scalar;  // "double" or "float"
  int dim = 3;
  std::int64_t seed = 1;
  double clock_resolution_ns = 0;
  static void fields(auto& own, auto&& see) {
    see("version", own.version), see("build", own.build), see("platform", own.platform),
        see("processor", own.processor);
    see("points", own.points), see("scalar", own.scalar), see("dim", own.dim), see("seed", own.seed);
    see("clock_resolution_ns", own.clock_resolution_ns);
  }
};

/// A timing under a name, where "time_ns" is its first part.
void timing_fields(std::string_view prefix, auto& timing, auto&& see) {
  Timing::fields(
      timing, [&](std::string_view name, auto& value) { see(std::string(prefix).append(1, '.').append(name), value); });
}

/// An algorithm and what its accuracy costs.
struct CostRow {
  static constexpr std::string_view kTable = "costs";
  std::string volume, algorithm;
  Index points = 0;                // that it was measured on
  Index of = 0;                    // that there are: more, where one run on all of them would take too long
  std::optional<double> whole_ns;  // what such a run would take, by its growth; none where points == of
  Timing time;                     // of one fit
  OperationCounts operations{};    // of one watched run
  std::int64_t steps = 0;
  double size = 0;     // a ball's radius; of others the measure
  double measure = 0;  // volume (3-D) or area (2-D), scene units cubed or squared
  std::optional<double>
      tightness;  // size over that of the smallest of its kind; none where nobody can tell, or it is flat
  std::optional<double> over_hull;  // measure over that of the convex hull; none where that is flat or took too long
  double noise = 0;  // a measure that is no larger is nothing but rounding; of a run alone, no column of a table
  [[nodiscard]] bool is_flat() const { return measure <= noise; }
  std::int64_t bytes = 0;
  int overlap_pairs = 0, overlapping = 0;
  Timing overlap;                     // of one test with a copy
  std::optional<std::string> update;  // which update was timed; none where the volume has none
  Timing updated;                     // of one update after a turn; nothing timed where there is none
  bool contains = false, on_boundary = false;
  std::optional<bool> optimal;  // none where the algorithm claims nothing
  bool on_front = false;        // whether no other row undercuts it in time and measure (mark_front)
  static void fields(auto& own, auto&& see) {
    see("volume", own.volume), see("algorithm", own.algorithm), see("points", own.points), see("of", own.of);
    see("whole_ns", own.whole_ns);
    timing_fields("time_ns", own.time, see);
    for (std::size_t i = 0; i < kOperationNames.size(); ++i)
      see(std::string("operations.").append(kOperationNames[i]), own.operations[i]);
    see("steps", own.steps), see("size", own.size), see("measure", own.measure), see("tightness", own.tightness);
    see("over_hull", own.over_hull), see("bytes", own.bytes), see("overlap_pairs", own.overlap_pairs);
    see("overlapping", own.overlapping);
    timing_fields("overlap_ns", own.overlap, see);
    see("update", own.update);
    timing_fields("update_ns", own.updated, see);
    see("certificate.contains", own.contains), see("certificate.on_boundary", own.on_boundary);
    see("certificate.optimal", own.optimal), see("on_front", own.on_front);
  }
};

/// An algorithm's time on so many points. What is fitted through all of its times stands in each of its rows.
struct GrowthRow {
  static constexpr std::string_view kTable = "growth";
  std::string volume, algorithm;
  Index points = 0;
  Timing time;
  bool in_fit = false;                    // whether the exponent is fitted through it
  std::optional<double> exponent;         // of time as a power of points; none where there are too few times
  std::string theory;                     // "O(n log n)"
  std::optional<double> theory_exponent;  // of the theory's figures; none where points alone don't say
  bool tight = false;                     // whether the theory is no mere upper bound
  std::string stopped;                    // why there are no more points; empty where there are
  static void fields(auto& own, auto&& see) {
    see("volume", own.volume), see("algorithm", own.algorithm), see("points", own.points);
    timing_fields("time_ns", own.time, see);
    see("in_fit", own.in_fit), see("exponent", own.exponent), see("theory", own.theory);
    see("theory_exponent", own.theory_exponent), see("tight", own.tight), see("stopped", own.stopped);
  }
};

/// A body's volume at one angle of a full turn.
struct TurnRow {
  static constexpr std::string_view kTable = "turn";
  std::string volume, strategy;
  Index points = 0;
  double degrees = 0;
  std::optional<double> slack;  // by how much it is larger than the tightest of its kind; none where that is flat
  double measure = 0;
  bool contains = false;
  Timing updated;  // of one update, the median of the whole turn
  static void fields(auto& own, auto&& see) {
    see("volume", own.volume), see("strategy", own.strategy), see("points", own.points), see("degrees", own.degrees);
    see("slack", own.slack), see("measure", own.measure), see("contains", own.contains);
    timing_fields("update_ns", own.updated, see);
  }
};

/// What a lecture says, and what was measured.
struct ClaimRow {
  static constexpr std::string_view kTable = "claims";
  std::string claim;  // its name: "ritter_ten_per_cent"
  std::string lecture, slide;
  std::string says;                 // in our words
  std::string measured;             // in words, with the figures of this run
  double figure = 0;                // the one that decides
  std::string verdict = "unknown";  // or "holds", "typical" (but no bound), "false"
  static void fields(auto& own, auto&& see) {
    see("claim", own.claim), see("lecture", own.lecture), see("slide", own.slide), see("says", own.says);
    see("measured", own.measured), see("figure", own.figure), see("verdict", own.verdict);
  }
};

}  // namespace snug::cost
