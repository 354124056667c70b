// Every algorithm by its name: what the command line, lessons and charts choose from.
// A new fitter is its own file and one row in the catalogue of its folder.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/any_step.hpp"
#include "fit/certify.hpp"
#include "fit/theory.hpp"
#include "geometry/point_set.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// A watched run: the result, every step with the counts as they stood then, and the proof.
struct Recording {
  Result result;
  std::vector<Recorder<Step3>::Entry> steps;
  OperationCounts counts{};
  Certificate certificate;
};

/// A watched run that keeps no steps, for traces too long for memory.
struct Watched {
  Result result;
  std::int64_t steps = 0;
  OperationCounts counts{};
  Certificate certificate;
};
/// Receives each step as it happens, with the counts so far.
using SeeStep = std::function<void(Step3&& step, const OperationCounts& counts)>;

struct Algorithm {
  std::string_view volume;  // of kVolumeNames
  std::string_view name;    // as scripts say it: "ritter_iterative"
  std::string_view title;   // as people say it: "Iterative Ritter"
  bool exact;               // whether it guarantees the smallest volume of its kind
  bool naive;               // as textbooks print it: rounding may cost it its digits
  bool loses_points;        // naive, and rounding may leave points outside its result
  bool plane, space;        // whether it takes 2-D points, 3-D points
  Index max_points;         // more are refused
  Index most_finished;  // with more, a limit of its own stops the run, which then has no time (max_points: no limit)
  std::string_view source;                             // author, title, year
  Theory theory;                                       // of its time
  std::span<const std::string_view> pseudocode;        // steps name its lines, counted from 0
  std::span<const std::string_view> plane_pseudocode;  // in 2-D, where that differs; empty otherwise

  /// The run without an observer, which is the one that is timed. points: at most max_points.
  Result (*fit)(const AnyPointSet& points, const Options& options);
  /// The same code with an observer. see: empty if only the result and the counts are wanted.
  Watched (*watch)(const AnyPointSet& points, const Options& options, const SeeStep& see);
  /// Runs it with an observer and keeps every step. room: an earlier recording whose memory is reused, because
  /// allocating megabytes for a long trace would take longer than the run.
  [[nodiscard]] Recording record(const AnyPointSet& points, const Options& options, Recording room = {}) const;
};

/// Sorted by volume, in kVolumeNames' order.
[[nodiscard]] std::span<const Algorithm> algorithms();
/// The algorithms for one volume; empty if there are none.
[[nodiscard]] std::span<const Algorithm> algorithms_of(std::string_view volume);

[[nodiscard]] inline std::span<const std::string_view> pseudocode_of(const Algorithm& algorithm, int dim) {
  return dim == 2 && !algorithm.plane_pseudocode.empty() ? algorithm.plane_pseudocode : algorithm.pseudocode;
}
[[nodiscard]] inline bool takes(const Algorithm& algorithm, int dim) {
  return dim == 2 ? algorithm.plane : algorithm.space;
}

/// Null where there is none of that volume and name.
[[nodiscard]] const Algorithm* find_algorithm(std::string_view volume, std::string_view name);

/// An algorithm that guarantees the smallest volume of its kind; null if none does. For spheres, the fastest of
/// three.
[[nodiscard]] const Algorithm* exact_algorithm(std::string_view volume);

/// Area (dim 2) or volume (dim 3).
[[nodiscard]] double measure_of(const Volume3& volume, int dim);

/// The size by which volumes are compared: a ball's radius; for any other kind, the area (dim 2) or volume (dim 3).
[[nodiscard]] double size_of(const Volume3& volume, int dim);

/// The fact's name, as traces and lessons say it: "ball_grown".
[[nodiscard]] std::string_view name_of(const Step3& step);

/// The names of all facts.
[[nodiscard]] std::span<const std::string_view> fact_names();

/// A hash over every number of every step, in order.
[[nodiscard]] std::uint64_t hash_of(std::span<const Recorder<Step3>::Entry> steps);

/// One step as one line of JSON, without a line feed: {"step":"ball_grown","line":3,"ball":{...},...}.
[[nodiscard]] std::string json_of(const Step3& step, int dim);

[[nodiscard]] int dim_of(const AnyPointSet& points);
[[nodiscard]] Index count_of(const AnyPointSet& points);
/// Point i in double and 3-D.
[[nodiscard]] Vector<double, 3> point_of(const AnyPointSet& points, Index i);

}  // namespace snug::fit
