#include "desktop/cli/cost_text.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <optional>
#include <vector>

#include "measure/growth.hpp"
#include "measure/turn_run.hpp"

namespace snug::desktop {
namespace {

template <class... Values>
std::string said(const char* format, Values... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

/// A time with three digits and a suitable unit.
std::string time_text(double ns) {
  constexpr double kYear = 365.25 * 24 * 3600 * 1e9;
  if (ns < 999.5) return said("%.3g ns", ns);
  if (ns < 999.5e3) return said("%.3g us", ns / 1e3);
  if (ns < 999.5e6) return said("%.3g ms", ns / 1e6);
  if (ns < 1e14) return said("%.3g s", ns / 1e9);
  return said("%.2g years", ns / kYear);
}

/// A time, marked if this machine could not measure it well.
std::string time_text(const cost::Timing& timing) {
  if (timing.repeats == 0) return "-";
  return time_text(timing.median) + (timing.trusted ? "" : " ?");
}
std::string spread_text(const cost::Timing& timing) {
  return timing.spread ? said("%.0f %%", 100 * *timing.spread) : "-";
}
std::string ratio_text(const std::optional<double>& ratio, const char* format) {
  return ratio ? said(format, *ratio) : "-";
}

/// Columns as wide as their content: the first two left-aligned, figures right-aligned, the last as it is.
class Columns {
 public:
  explicit Columns(std::vector<std::string> header) { add(std::move(header)); }
  void add(std::vector<std::string> line) { lines_.push_back(std::move(line)); }

  [[nodiscard]] std::string text() const {
    std::vector<std::size_t> widths(lines_[0].size());
    for (const auto& line : lines_)
      for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const auto& line : lines_) {
      std::string row;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const std::string blanks(widths[i] - line[i].size(), ' ');
        row += i == 0 ? "" : "  ";
        row += i < 2 || i + 1 == line.size() ? line[i] + blanks : blanks + line[i];
      }
      text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> lines_;
};

std::string head_of(const cost::Provenance& p) {
  return p.points +
         said(", %d-D, %s, seed %lld; %s, ", p.dim, p.scalar.c_str(), static_cast<long long>(p.seed),
              p.platform.c_str()) +
         p.build + (p.processor.empty() ? "" : ", " + p.processor) +
         said("; the clock's step is %s\n\n", time_text(p.clock_resolution_ns).c_str());
}

constexpr const char* kDoubt =
    "? could not be measured reliably: the times spread over more than a third of their median, or there is only one\n";

std::string note_of(const cost::CostRow& row) {
  std::string note = row.on_front ? "* front" : "";
  if (row.points < row.of)
    note +=
        said("%son %d of %d points%s", note.empty() ? "" : ", ", static_cast<int>(row.points), static_cast<int>(row.of),
             row.whole_ns ? (": all would take about " + time_text(*row.whole_ns)).c_str()
                          : ": on more, a limit of its own stops it");
  if (!row.contains) note += note.empty() ? "does not contain all points" : ", does not contain all points";
  return note;
}

std::string growth_note(const cost::GrowthRow& last) {
  std::string note = last.exponent ? "" : std::string(cost::kTooFewToTell);
  if (!last.stopped.empty()) note += (note.empty() ? "stopped: " : "; stopped: ") + last.stopped;
  return note;
}

const cost::CostRow* find_row(const cost::Table<cost::CostRow>& table, const cost::CostRow& like) {
  const auto found = std::find_if(table.rows.begin(), table.rows.end(), [&](const cost::CostRow& row) {
    return row.volume == like.volume && row.algorithm == like.algorithm && row.points == like.points;
  });
  return found == table.rows.end() ? nullptr : &*found;
}

/// The rows of each algorithm or strategy, which are consecutive.
template <class Row, class Same>
std::vector<std::span<const Row>> groups_of(std::span<const Row> rows, Same same) {
  std::vector<std::span<const Row>> groups;
  for (std::size_t first = 0; first < rows.size();) {
    std::size_t end = first;
    while (end < rows.size() && same(rows[end], rows[first])) ++end;
    groups.push_back(rows.subspan(first, end - first));
    first = end;
  }
  return groups;
}

}  // namespace

std::string text_of(const cost::Provenance& provenance, std::span<const cost::CostRow> rows,
                    const cost::Table<cost::CostRow>* then) {
  std::vector<std::string> header{"volume", "algorithm", "time", "spread"};
  if (then != nullptr) header.insert(header.end(), {"then", "now/then"});
  header.insert(header.end(),
                {"operations", "exact", "size/least", "volume/hull", "bytes", "near", "scene", "update", ""});
  if (provenance.dim == 2) *(header.end() - 6) = "area/hull";
  Columns columns(header);
  bool doubt = false;
  for (const cost::CostRow& row : rows) {
    std::vector<std::string> line{row.volume, row.algorithm, time_text(row.time), spread_text(row.time)};
    if (then != nullptr) {
      const cost::CostRow* const old = find_row(*then, row);
      line.push_back(old == nullptr ? "-" : time_text(old->time));
      line.push_back(old == nullptr || !(old->time.median > 0) ? "-"
                                                               : said("%.2f", row.time.median / old->time.median));
    }
    const std::int64_t exact = row.operations[static_cast<std::size_t>(Operation::kExactDecisions)];
    const std::int64_t others = std::accumulate(row.operations.begin(), row.operations.end(), -exact);
    line.insert(line.end(), {said("%lld", static_cast<long long>(others)), said("%lld", static_cast<long long>(exact)),
                             ratio_text(row.tightness, "%.4f"), ratio_text(row.over_hull, "%.3f"),
                             said("%lld", static_cast<long long>(row.bytes)), time_text(row.overlap),
                             time_text(row.scene_overlap), time_text(row.updated), note_of(row)});
    columns.add(std::move(line));
    for (const cost::Timing* timing : {&row.time, &row.overlap, &row.scene_overlap, &row.updated})
      doubt = doubt || (timing->repeats > 0 && !timing->trusted);
  }
  std::string text = head_of(provenance) + columns.text() +
                     "\n* no other is both faster and tighter\n"
                     "near, scene: one overlap test of two, near contact and as they lie in a scene\n";
  if (doubt) text += kDoubt;
  if (then != nullptr) text += "then: " + head_of(then->provenance);
  return text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::GrowthRow> rows) {
  Columns columns({"volume", "algorithm", "points", "time", "power", "theory's", "theory", ""});
  const auto same = [](const cost::GrowthRow& a, const cost::GrowthRow& b) {
    return a.volume == b.volume && a.algorithm == b.algorithm;
  };
  bool doubt = false;
  for (const auto group : groups_of(rows, same)) {
    const cost::GrowthRow& last = group.back();
    const std::string theirs =
        last.theory_exponent ? said(last.tight ? "%.2f" : "<= %.2f", *last.theory_exponent) : "-";
    columns.add({last.volume, last.algorithm, said("%d", static_cast<int>(last.points)), time_text(last.time),
                 ratio_text(last.exponent, "%.2f"), theirs, last.theory, growth_note(last)});
    for (const cost::GrowthRow& row : group) doubt = doubt || !row.time.trusted;
  }
  std::string text = head_of(provenance) + columns.text() +
                     "\nThe power is that of n by which the time grows, fitted to the last decade and a half of n; CSV "
                     "has every time.\n"
                     "<= marks an upper bound on the operations; memory access may add to the time.\n";
  return doubt ? text + kDoubt : text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::TurnRow> rows) {
  Columns columns({"volume", "update", "time", "least looseness", "mean", "most", ""});
  const auto same = [](const cost::TurnRow& a, const cost::TurnRow& b) {
    return a.volume == b.volume && a.strategy == b.strategy;
  };
  for (const auto group : groups_of(rows, same)) {
    const auto range = cost::slack_range(group);
    const bool holds = std::all_of(group.begin(), group.end(), [](const cost::TurnRow& row) { return row.contains; });
    const auto per_cent = [&](double cost::SlackRange::*slack) {
      return range ? said("%.1f %%", 100 * (*range).*slack) : "-";
    };
    columns.add({group[0].volume, group[0].strategy, time_text(group[0].updated), per_cent(&cost::SlackRange::least),
                 per_cent(&cost::SlackRange::mean), per_cent(&cost::SlackRange::most),
                 holds ? "" : "does not contain all points"});
  }
  return head_of(provenance) + columns.text() +
         "\nHow much larger the volume is than the tightest of its kind, over one full turn of the body; an oriented "
         "box\n"
         "is compared with the box that rotates with the body.\n";
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::ClaimRow> rows) {
  std::string text = head_of(provenance);
  for (const cost::ClaimRow& row : rows) {
    const std::string verdict = row.verdict == "typical" ? "typical, not a bound"
                                : row.verdict == "false" ? "false here"
                                                         : row.verdict;
    text += row.says + "\n  " + row.lecture + ": " + row.slide + "\n  " + verdict + ": " + row.measured + "\n\n";
  }
  return text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::TrialRow> rows) {
  std::string text = head_of(provenance);
  for (const cost::TrialClaim& claim : cost::trial_claims()) {
    const cost::TrialTally tally = cost::tally_trials(claim.name, rows);
    if (tally.clouds == 0) continue;
    text += std::string(claim.says) + "\n  " + std::string(claim.lecture) + ": " + std::string(claim.slide) + "\n  " +
            std::string(claim.value) + "; claimed: " + std::string(claim.claimed) + "\n  " +
            std::string(tally.verdict()) + ": holds on " + std::to_string(tally.held) + " of " +
            std::to_string(tally.clouds) + " clouds\n";
    if (tally.worst)
      text += "  worst: " + said("%.4g", tally.worst->value) + ", on " + tally.worst->kind + ':' +
              std::to_string(tally.worst->points) + " with seed " + std::to_string(tally.worst->seed) + '\n';
    text += '\n';
  }
  return text;
}

}  // namespace snug::desktop
