#include "desktop/cli/machines.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "desktop/cli/cost_text.hpp"
#include "desktop/cli/words.hpp"
#include "io/text.hpp"
#include "lesson/figures.hpp"

namespace snug::desktop {
namespace {

constexpr int kCells = 44;  // of the text's chart

/// The times that a table of a kind has, and what each is of.
std::vector<std::pair<const char*, const char*>> timed_in(const std::string& table) {
  if (table == "which") return {{"build_ns", "fit"}, {"test_ns", "test"}};
  return {{"time_ns", "fit"}};
}

std::optional<std::int64_t> count_at(const Json& json, const char* key) {
  const auto number = number_at(json, key);
  return number && *number >= 0 && *number < 1e15 ? std::optional(static_cast<std::int64_t>(*number)) : std::nullopt;
}

/// An algorithm's times in all files, the shortest first.
struct Line {
  std::string name;
  std::vector<double> times;
  [[nodiscard]] double median() const { return times[times.size() / 2]; }
};

/// What is compared with one another: a chart.
struct Group {
  std::string title;
  std::vector<Line> lines;  // the fastest first
  std::size_t machines = 0, files = 0;
  int untrusted = 0;
  double least = 0, most = 0;
  /// Where a time stands, from 0 to 1.
  [[nodiscard]] double place(double ns) const {
    return most > least ? std::log(ns / least) / std::log(most / least) : 0.5;
  }
};

std::vector<Group> charts_of(const std::vector<MachineTime>& times) {
  std::vector<std::string> order;
  std::map<std::string, std::map<std::string, Line>> lines;
  std::map<std::string, Group> groups;
  std::map<std::string, std::set<std::string>> machines, files;
  for (const MachineTime& one : times) {
    Group& group = groups[one.group()];
    if (group.title.empty()) {
      order.push_back(one.group());
      group.title = (one.what == "fit" ? "One fit, " : "One overlap test, ") + one.points +
                    (one.of ? ", " + lesson::count_text(*one.of) + (*one.of == 1 ? " point" : " points") : "");
      group.least = group.most = one.median_ns;
    }
    Line& line = lines[one.group()][one.volume + '/' + one.algorithm];
    line.name = one.volume + '/' + one.algorithm;
    line.times.push_back(one.median_ns);
    group.least = std::min(group.least, one.median_ns), group.most = std::max(group.most, one.median_ns);
    group.untrusted += one.trusted ? 0 : 1;
    machines[one.group()].insert(one.processor);
    files[one.group()].insert(one.file);
  }
  std::vector<Group> all;
  for (const std::string& key : order) {
    Group group = std::move(groups[key]);
    for (auto& [name, line] : lines[key]) {
      std::sort(line.times.begin(), line.times.end());
      group.lines.push_back(std::move(line));
    }
    std::stable_sort(group.lines.begin(), group.lines.end(),
                     [](const Line& a, const Line& b) { return a.median() < b.median(); });
    group.machines = machines[key].size(), group.files = files[key].size();
    all.push_back(std::move(group));
  }
  return all;
}

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// "One fit, teapot (2 machines, 40 files)"
std::string head_of(const Group& group) {
  return group.title + " (" + count_of(group.machines, "machine", "machines") + ", " +
         count_of(group.files, "file", "files") + ')';
}

/// Marks of measurements in cells: one, some, many; the median is a line.
std::string strip(const Group& group, const Line& line) {
  const auto cell = [&](double ns) { return static_cast<std::size_t>(std::lround(group.place(ns) * (kCells - 1))); };
  std::vector<int> counts(kCells);
  for (const double ns : line.times) ++counts[cell(ns)];
  std::string text(kCells, ' ');
  for (std::size_t i = 0; i < text.size(); ++i)
    text[i] = counts[i] == 0 ? ' ' : counts[i] == 1 ? '.' : counts[i] < 5 ? 'o' : 'O';
  text[cell(line.median())] = '|';
  return text;
}

/// "Intel Xeon, native, GNU 12.2.0: 3 files" for each that was measured on.
std::vector<std::string> machines_of(const std::vector<MachineTime>& times) {
  std::vector<std::string> order;
  std::map<std::string, std::set<std::string>> files;
  for (const MachineTime& one : times) {
    const std::string machine =
        (one.processor.empty() ? "unknown processor" : one.processor) + ", " + one.platform + ", " + one.build;
    if (files[machine].empty()) order.push_back(machine);
    files[machine].insert(one.file);
  }
  for (std::string& machine : order) machine += ": " + count_of(files[machine].size(), "file", "files");
  return order;
}

std::string untrusted_text(int count) {
  return count == 0 ? std::string()
                    : count_of(static_cast<std::size_t>(count), "time was", "times were") +
                          " not measured well: the rounds disagree, or there is only one.";
}

}  // namespace

std::vector<double> ticks_between(double least, double most) {
  constexpr std::size_t kFewest = 2;
  constexpr double kSame = 1.01;  // nearer times would have the same label
  if (!(most > least * kSame)) return {least};
  std::vector<double> ticks;
  for (double tick = std::pow(10, std::ceil(std::log10(least))); tick <= most; tick *= 10) ticks.push_back(tick);
  for (double power = std::pow(10, std::ceil(std::log10(most))); ticks.size() < kFewest; power /= 10)
    for (const double step : {5 * power, 2 * power, power}) {
      if (ticks.size() >= kFewest) break;
      ticks.clear();
      for (double k = std::ceil(least / step); k * step <= most; ++k) ticks.push_back(k * step);
    }
  return ticks;
}

std::vector<MachineTime> times_of(const std::string& file, const std::string& student, const MeasuredTable& measured) {
  std::vector<MachineTime> times;
  const Json& table = measured.table;
  const Json& provenance = table["provenance"];
  MachineTime one{.file = file, .student = student};
  one.version = text_at(provenance, "version"), one.build = text_at(provenance, "build");
  one.platform = text_at(provenance, "platform"), one.processor = text_at(provenance, "processor");
  one.date = measured.date, one.table = text_at(table, "table"), one.points = text_at(provenance, "points");
  for (const Json& row : table["rows"])
    for (const auto& [key, what] : timed_in(one.table)) {
      const auto time = row.find(key);
      if (time == row.end()) continue;
      const auto median = number_at(*time, "median");
      if (!median || !(*median > 0) || !std::isfinite(*median)) continue;
      one.volume = text_at(row, "volume"), one.algorithm = text_at(row, "algorithm"), one.what = what;
      one.of = count_at(row, "of");
      one.median_ns = *median, one.spread = number_at(*time, "spread");
      one.trusted = time->value("trusted", Json()) == true;
      one.over_hull = number_at(row, "over_hull");
      one.bytes = static_cast<int>(std::clamp(number_at(row, "bytes").value_or(0), 0.0, 1e9));
      times.push_back(one);
    }
  return times;
}

std::string machines_text(const std::vector<MachineTime>& times, bool color) {
  std::string text;
  const std::string bold = color ? "\x1b[1m" : "", plain = color ? "\x1b[0m" : "";
  for (const Group& group : charts_of(times)) {
    text += bold + head_of(group) + plain + '\n';
    std::size_t width = 0;
    for (const Line& line : group.lines) width = std::max(width, letters_of(line.name));
    text += "  " + std::string(width, ' ') + "   fastest    median   slowest  " +
            padded(time_text(group.least), kCells / 2) + padded(time_text(group.most), kCells - kCells / 2, true) +
            '\n';
    for (const Line& line : group.lines)
      text += "  " + padded(line.name, width) + padded(time_text(line.times.front()), 10, true) +
              padded(time_text(line.median()), 10, true) + padded(time_text(line.times.back()), 10, true) + "  " +
              strip(group, line) + '\n';
    if (const std::string note = untrusted_text(group.untrusted); !note.empty()) text += "  " + note + '\n';
    text += '\n';
  }
  text += "The time grows from left to right on a logarithmic axis: . is one measurement, o up to four, O more, | "
          "their median.\n";
  for (const std::string& machine : machines_of(times)) text += "  " + machine + '\n';
  return text;
}

std::string machines_svg(const std::vector<MachineTime>& times) {
  constexpr double kAcross = 860, kLeft = 190, kRight = 830, kRow = 24, kTitle = 56, kAxis = 30;
  const auto n = [](double value) { return io::shortest_text(std::round(value * 10) / 10); };
  const auto words = [&](double x, double y, const std::string& says, const char* more = "") {
    return "<text x=\"" + n(x) + "\" y=\"" + n(y) + "\" " + more + '>' + xml_text(says) + "</text>\n";
  };
  std::string body;
  double y = 0;
  for (const Group& group : charts_of(times)) {
    const double top = y + kTitle, bottom = top + kRow * static_cast<double>(group.lines.size());
    const auto x_of = [&](double ns) { return kLeft + group.place(ns) * (kRight - kLeft); };
    body += words(16, y + 34, head_of(group), "class=\"title\"");
    for (const double tick : ticks_between(group.least, group.most)) {
      body += "<path class=\"grid\" d=\"M" + n(x_of(tick)) + ' ' + n(top) + 'V' + n(bottom) + "\"/>\n";
      body += words(x_of(tick), bottom + 18, time_text(tick), "class=\"small\" text-anchor=\"middle\"");
    }
    for (std::size_t i = 0; i < group.lines.size(); ++i) {
      const Line& line = group.lines[i];
      const double middle = top + kRow * (static_cast<double>(i) + 0.5);
      body += words(kLeft - 14, middle + 4, line.name, "text-anchor=\"end\"");
      for (const double ns : line.times)
        body += "<circle cx=\"" + n(x_of(ns)) + "\" cy=\"" + n(middle) + "\" r=\"4\"/>\n";
      body += "<path class=\"median\" d=\"M" + n(x_of(line.median())) + ' ' + n(middle - 9) + "v18\"/>\n";
    }
    y = bottom + kAxis;
    if (const std::string note = untrusted_text(group.untrusted); !note.empty())
      body += words(16, y + 4, note, "class=\"small\""), y += 20;
  }
  y += 26;
  for (const std::string& machine : machines_of(times)) body += words(16, y, machine, "class=\"small\""), y += 18;
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + n(kAcross) + ' ' + n(y + 8) + "\" width=\"" +
         n(kAcross) + "\" height=\"" + n(y + 8) +
         "\" role=\"img\">\n<title>Times of many machines: a mark is a measurement, a bar their median</title>\n"
         "<style>text{font:14px Inter,sans-serif;fill:#1B2230}.title{font-weight:600;font-size:16px}"
         ".small{font-size:12px;fill:#5F6878}circle{fill:#0A5FBF;fill-opacity:.45}.grid{stroke:#E3DED3}"
         ".median{stroke:#C8430A;stroke-width:2.5}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#FFFFFF\"/>\n" +
         body + "</svg>\n";
}

std::vector<std::vector<std::string>> machines_table(const std::vector<MachineTime>& times) {
  std::vector<std::vector<std::string>> table{{"file", "student", "processor", "platform", "build", "version", "date",
                                               "table", "points", "volume", "algorithm", "what", "median_ns", "spread",
                                               "trusted", "over_hull", "bytes", "of"}};
  const auto number = [](const std::optional<double>& value) {
    return value ? io::shortest_text(*value) : std::string();
  };
  for (const MachineTime& one : times)
    table.push_back({one.file, one.student, one.processor, one.platform, one.build, one.version, one.date, one.table,
                     one.points, one.volume, one.algorithm, one.what, number(one.median_ns), number(one.spread),
                     one.trusted ? "true" : "false", number(one.over_hull), std::to_string(one.bytes),
                     one.of ? std::to_string(*one.of) : ""});
  return table;
}

std::string machines_json(const std::vector<MachineTime>& times) {
  std::string text;
  for (const MachineTime& one : times)
    text += line_of({{"file", one.file},
                     {"student", one.student},
                     {"processor", one.processor},
                     {"platform", one.platform},
                     {"build", one.build},
                     {"version", one.version},
                     {"date", one.date},
                     {"table", one.table},
                     {"points", one.points},
                     {"volume", one.volume},
                     {"algorithm", one.algorithm},
                     {"what", one.what},
                     {"median_ns", one.median_ns},
                     {"spread", one.spread ? Json(*one.spread) : Json()},
                     {"trusted", one.trusted},
                     {"over_hull", one.over_hull ? Json(*one.over_hull) : Json()},
                     {"bytes", one.bytes},
                     {"of", one.of ? Json(*one.of) : Json()}});
  return text;
}

}  // namespace snug::desktop
