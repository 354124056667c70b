// The tables that many machines measured for a lab sheet, side by side.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "desktop/cli/sheet_files.hpp"

namespace snug::desktop {

/// One time that one machine measured.
struct MachineTime {
  std::string file, student, version, build, platform, processor, date;
  std::string table, points, volume, algorithm;
  std::string what;                // what was timed: "fit", "test"
  std::optional<std::int64_t> of;  // how many points there are
  double median_ns = 0;
  std::optional<double> spread;  // between the quartiles, over the median
  bool trusted = false;
  std::optional<double> over_hull;
  int bytes = 0;
  /// What can be compared: the same thing, timed on the same points. Two files of one name may be two meshes.
  [[nodiscard]] std::string group() const {
    return table + '\n' + points + '\n' + (of ? std::to_string(*of) : "") + '\n' + what;
  }
};

/// The times of a table that one student measured.
[[nodiscard]] std::vector<MachineTime> times_of(const std::string& file, const std::string& student,
                                                const MeasuredTable& measured);

/// Where an axis of times has its ticks: at powers of ten, or where not two of them are in reach, at round numbers; at
/// the least time where all are the same. least, most: above zero.
[[nodiscard]] std::vector<double> ticks_between(double least, double most);

/// A text for people. It has a chart for each thing that was timed, with a line for each algorithm and a mark for each
/// measurement.
[[nodiscard]] std::string machines_text(const std::vector<MachineTime>& times, bool color);
/// The same as a picture.
[[nodiscard]] std::string machines_svg(const std::vector<MachineTime>& times);
/// One row a time, with the names of the columns.
[[nodiscard]] std::vector<std::vector<std::string>> machines_table(const std::vector<MachineTime>& times);
/// The same as JSON Lines.
[[nodiscard]] std::string machines_json(const std::vector<MachineTime>& times);

}  // namespace snug::desktop
