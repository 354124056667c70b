// What the commands that measure have in common: the points, the progress bar, and the file that the table goes to.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>

#include "desktop/cli/command.hpp"
#include "desktop/cli/progress.hpp"
#include "measure/point_stock.hpp"
#include "measure/rows.hpp"

namespace snug::desktop {

struct PointsChoice {
  Reading reading;
  std::string generate, file;  // exactly one
  std::string scalar = "double";
  int dim = 0;
  std::uint64_t seed = 1;
};

/// Adds their options to a command.
void add_points(CLI::App& command, PointsChoice& choice);

struct MeasuredPoints {
  std::string name;  // "cube:1000", or the file's
  std::string kind;  // if generated; empty for a file
  AnyPointSet points;
};

/// Errors: none or both of --generate and FILE, those of either, and too many points.
[[nodiscard]] tl::expected<MeasuredPoints, InputError> points_of(const PointsChoice& choice);

/// Those of this program and machine.
[[nodiscard]] cost::Provenance provenance_of(const PointsChoice& choice, const MeasuredPoints& points);

/// Runs to the end, with a progress bar.
template <class Run>
void finish(Run& run) {
  constexpr int kParts = 1000;
  Progress bar("measuring", kParts);
  for (int shown = 0; !run.done();) {
    run.step();
    for (; shown < static_cast<int>(kParts * run.progress()); ++shown) bar.advance();
  }
}

/// Writes what measure returns to a file, or prints it if out is empty or "-". The file's ending says the format (csv,
/// json), which measure may read then; the file is created before the long work, so that an impossible one is reported
/// at once.
[[nodiscard]] CommandResult write_table(const std::string& out, bool& csv, bool& json,
                                        const std::function<tl::expected<Printed, InputError>()>& measure);

}  // namespace snug::desktop
