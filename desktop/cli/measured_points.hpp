// What the commands that measure have in common: the points, the progress bar, and the file that the table goes to.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/command.hpp"
#include "desktop/cli/cost_text.hpp"
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

/// Where a table goes, and its format: text if neither flag is set.
struct TableOutput {
  bool json = false, csv = false;
  std::string file;  // empty or "-": standard output
};

/// Adds its options to a command.
void add_output(CLI::App& command, TableOutput& output);

/// A table in its format.
template <class Row>
[[nodiscard]] std::string printed(const TableOutput& output, const cost::Provenance& provenance,
                                  const std::vector<Row>& rows) {
  const std::span<const Row> all(rows);
  if (output.json) return cost::json_of(provenance, all);
  if (output.csv) return cost::csv_of(provenance, all);
  return text_of(provenance, all);
}

/// Writes or prints what measure returns. measure receives the output with the format that the file's ending says. The
/// file is created before the long work, so that an impossible one is reported at once.
[[nodiscard]] CommandResult
write_table(TableOutput output, const std::function<tl::expected<Printed, InputError>(const TableOutput&)>& measure);

}  // namespace snug::desktop
