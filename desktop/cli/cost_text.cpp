#include "desktop/cli/cost_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "desktop/cli/words.hpp"
#include "measure/cost_run.hpp"
#include "measure/growth.hpp"
#include "measure/turn_run.hpp"

namespace snug::desktop {
namespace {

template <class... Values>
std::string said(const char* format, Values... values) {
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace

std::string time_text(double ns) {
  constexpr double kDay = 24 * 3600 * 1e9, kYear = 365.25 * kDay;
  if (ns < 999.5) return said("%.3g ns", ns);
  if (ns < 999.5e3) return said("%.3g µs", ns / 1e3);
  if (ns < 999.5e6) return said("%.3g ms", ns / 1e6);
  if (ns < 1e14) return said("%.3g s", ns / 1e9);
  if (ns < kYear) return said("%.3g days", ns / kDay);
  return said("%.2g years", ns / kYear);
}

namespace {

/// A column's unit of time, for all of its rows.
struct TimeUnit {
  const char* name;
  double ns;
  /// A time in this unit, with three digits; marked if this machine could not measure it well.
  [[nodiscard]] std::string text(const cost::Timing& timing) const {
    return timing.repeats == 0 ? "-" : text(timing.median) + (timing.trusted ? "" : " ?");
  }
  [[nodiscard]] std::string text(double time) const { return said(time / ns < 999.5 ? "%.3g" : "%.0f", time / ns); }
};

/// The largest unit in which the shortest time is at least a tenth.
TimeUnit unit_for(double shortest) {
  constexpr std::array<TimeUnit, 4> kUnits{{{"s", 1e9}, {"ms", 1e6}, {"µs", 1e3}, {"ns", 1}}};
  const auto* const found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const TimeUnit& unit) { return shortest >= unit.ns / 10; });
  return shortest <= 0 || found == kUnits.end() || std::isinf(shortest) ? kUnits.back() : *found;
}

/// The unit for the shortest of these times.
template <class Row>
TimeUnit unit_of(std::span<const Row> rows, cost::Timing Row::*timing) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Row& row : rows)
    if ((row.*timing).repeats > 0) shortest = std::min(shortest, (row.*timing).median);
  return unit_for(shortest);
}
std::string header_of(const char* what, const TimeUnit& unit) { return std::string(what) + " " + unit.name; }

std::string ratio_text(const std::optional<double>& ratio, const char* format) {
  return ratio ? said(format, *ratio) : "-";
}

/// "1 volume", "2 volumes"
std::string many(double n, const char* noun) { return said(n == 1 ? "%.10g %s" : "%.10g %ss", n, noun); }

constexpr std::size_t kWidest = 100;

/// The text in lines of at most kWidest characters, where its blanks allow it, each after the indent.
std::string wrapped(const std::string& text, const std::string& indent = "") {
  std::string lines = indent;
  std::size_t line = 0;  // without the indent
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, end - from);
    if (line > 0 && indent.size() + line + 1 + word.size() > kWidest) lines += '\n' + indent, line = 0;
    if (line > 0) lines += ' ', ++line;
    lines += word, line += word.size();
    from = end + 1;
  }
  return lines;
}

/// Notes under a table: a row has their letters.
class Notes {
 public:
  /// The letter of a note: "a", "b"; equal notes have one.
  std::string letter(const std::string& note) {
    const auto found = std::find(notes_.begin(), notes_.end(), note);
    const auto i = static_cast<std::size_t>(found - notes_.begin());
    if (found == notes_.end()) notes_.push_back(note);
    return name_of(i);
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (std::size_t i = 0; i < notes_.size(); ++i) text += name_of(i) + "  " + notes_[i] + '\n';
    return text;
  }

 private:
  static std::string name_of(std::size_t i) {
    return i < 26 ? std::string(1, static_cast<char>('a' + i)) : std::to_string(i + 1);
  }
  std::vector<std::string> notes_;
};

/// Columns as wide as their content: the first two left-aligned, figures right-aligned, the last as it is.
class Columns {
 public:
  explicit Columns(std::vector<std::string> header) { add(std::move(header)); }
  void add(std::vector<std::string> line) { lines_.push_back(std::move(line)); }

  [[nodiscard]] std::string text() const {
    std::vector<std::size_t> widths(lines_[0].size());
    for (const auto& line : lines_)
      for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], letters_of(line[i]));
    std::string text;
    for (const auto& line : lines_) {
      std::string row;
      for (std::size_t i = 0; i < line.size(); ++i) {
        row += i == 0 ? "" : "  ";
        row += padded(line[i], widths[i], i >= 2 && i + 1 < line.size());
      }
      text += row.substr(0, row.find_last_not_of(' ') + 1) + '\n';
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> lines_;
};

std::string head_of(const cost::Provenance& p, const char* before = "") {
  return wrapped(before + p.points +
                 said(", %d-D, %s, seed %lld; %s, ", p.dim, p.scalar.c_str(), static_cast<long long>(p.seed),
                      p.platform.c_str()) +
                 p.build + (p.processor.empty() ? "" : ", " + p.processor) +
                 said("; the clock's step is %s", time_text(p.clock_resolution_ns).c_str())) +
         "\n\n";
}

constexpr const char* kDoubt = "? could not be measured reliably: its rounds disagree, or there is only one\n";

/// The marks of a row: on the front, tied there, and the letters of its notes.
std::string marks_of(std::span<const cost::CostRow> rows, const cost::CostRow& row, Notes& notes) {
  std::string marks = cost::is_tied(rows, row) ? "=" : row.on_front ? "*" : "";
  const auto add = [&](const std::string& note) { marks += (marks.empty() ? "" : " ") + notes.letter(note); };
  if (row.points < row.of)
    add(said("on %d of %d points%s", static_cast<int>(row.points), static_cast<int>(row.of),
             row.whole_ns ? (": all would take about " + time_text(*row.whole_ns)).c_str()
                          : ": on more, a limit of its own stops it"));
  if (!row.contains) add("does not contain all points");
  return marks;
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

/// How a time compares with an earlier one: "0.52 faster".
std::string against_text(const cost::Timing& now, const cost::Timing& then) {
  if (!(then.median > 0)) return "-";
  const cost::Faster faster = cost::faster(now, then, cost::kDoubtBetweenRuns);
  return said("%.2f", now.median / then.median) + (faster == cost::Faster::kTie     ? " within noise"
                                                   : faster == cost::Faster::kFirst ? " faster"
                                                                                    : " slower");
}

}  // namespace

std::string text_of(const cost::Provenance& provenance, std::span<const cost::CostRow> rows,
                    const cost::Table<cost::CostRow>* then) {
  constexpr std::array kTimes{&cost::CostRow::time, &cost::CostRow::overlap, &cost::CostRow::scene_overlap,
                              &cost::CostRow::updated};
  constexpr std::array kNames{"time", "near", "scene", "update"};
  std::array<TimeUnit, 4> units{};
  for (std::size_t i = 0; i < kTimes.size(); ++i) units[i] = unit_of(rows, kTimes[i]);
  std::vector<std::string> header{"volume", "algorithm", header_of(kNames[0], units[0])};
  if (then != nullptr) header.insert(header.end(), {"then", "now/then"});
  else header.insert(header.end(), {"ops"});
  header.insert(header.end(), {"/least", "/hull", "bytes"});
  const std::size_t times = then != nullptr ? 1 : kTimes.size();  // beside an earlier result there is room for one
  for (std::size_t i = 1; i < times; ++i) header.push_back(header_of(kNames[i], units[i]));
  header.emplace_back();
  Columns columns(header);
  Notes notes;
  bool doubt = false, tied = false;
  for (const cost::CostRow& row : rows) {
    std::vector<std::string> line{row.volume, row.algorithm, units[0].text(row.time)};
    if (then != nullptr) {
      const cost::CostRow* const old = find_row(*then, row);
      line.push_back(old == nullptr ? "-" : units[0].text(old->time));
      line.push_back(old == nullptr ? "-" : against_text(row.time, old->time));
    } else {
      const std::int64_t all = std::accumulate(row.operations.begin(), row.operations.end(), std::int64_t{0});
      line.push_back(said("%lld", static_cast<long long>(all)));
    }
    line.insert(line.end(), {ratio_text(row.tightness, "%.4f"), ratio_text(row.over_hull, "%.3f"),
                             said("%lld", static_cast<long long>(row.bytes))});
    for (std::size_t i = 1; i < times; ++i) line.push_back(units[i].text(row.*kTimes[i]));
    line.push_back(marks_of(rows, row, notes));
    columns.add(std::move(line));
    tied = tied || cost::is_tied(rows, row);
    for (std::size_t i = 0; i < times; ++i)
      doubt = doubt || ((row.*kTimes[i]).repeats > 0 && !(row.*kTimes[i]).trusted);
  }
  std::string text =
      head_of(provenance) + columns.text() +
      (times == 1 ? "\ntime: of one fit\n"
                  : "\ntime: of one fit; near, scene: of one overlap test, near contact and as volumes "
                    "lie in a scene\nops: operations counted in one fit, exact decisions among them\n") +
      "/least: size over that of the smallest of its kind; /hull: " + (provenance.dim == 2 ? "area" : "volume") +
      " over the hull's\n"
      "* no other is both faster and tighter\n";
  if (tied) text += "= the same, but with another that neither time nor size tells apart\n";
  if (doubt) text += kDoubt;
  text += notes.text();
  if (then != nullptr) text += head_of(then->provenance, "then: ");
  return text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::GrowthRow> rows) {
  const TimeUnit unit = unit_of(rows, &cost::GrowthRow::time);
  Columns columns({"volume", "algorithm", "points", header_of("time", unit), "power", "theory's", "theory", ""});
  const auto same = [](const cost::GrowthRow& a, const cost::GrowthRow& b) {
    return a.volume == b.volume && a.algorithm == b.algorithm;
  };
  bool doubt = false;
  Notes notes;
  for (const auto group : groups_of(rows, same)) {
    const cost::GrowthRow& last = group.back();
    const std::string theirs =
        last.theory_exponent ? said(last.tight ? "%.2f" : "<= %.2f", *last.theory_exponent) : "-";
    const std::string note = growth_note(last);
    columns.add({last.volume, last.algorithm, said("%d", static_cast<int>(last.points)), unit.text(last.time),
                 ratio_text(last.exponent, "%.2f"), theirs, last.theory, note.empty() ? "" : notes.letter(note)});
    for (const cost::GrowthRow& row : group) doubt = doubt || !row.time.trusted;
  }
  std::string text =
      head_of(provenance) + columns.text() +
      "\nThe power is that of n by which the time grows, fitted to the last decade and a half of n;\n"
      "CSV has every time. <= marks an upper bound on the operations; memory access may add to the time.\n";
  if (doubt) text += kDoubt;
  return text + notes.text();
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::TurnRow> rows) {
  const TimeUnit unit = unit_of(rows, &cost::TurnRow::updated);
  Columns columns({"volume", "update", header_of("time", unit), "least looseness", "mean", "most", ""});
  const auto same = [](const cost::TurnRow& a, const cost::TurnRow& b) {
    return a.volume == b.volume && a.strategy == b.strategy;
  };
  for (const auto group : groups_of(rows, same)) {
    const auto range = cost::slack_range(group);
    const bool holds = std::all_of(group.begin(), group.end(), [](const cost::TurnRow& row) { return row.contains; });
    const auto per_cent = [&](double cost::SlackRange::*slack) {
      return range ? said("%.1f %%", 100 * (*range).*slack) : "-";
    };
    columns.add({group[0].volume, group[0].strategy, unit.text(group[0].updated), per_cent(&cost::SlackRange::least),
                 per_cent(&cost::SlackRange::mean), per_cent(&cost::SlackRange::most),
                 holds ? "" : "does not contain all points"});
  }
  return head_of(provenance) + columns.text() +
         "\nHow much larger the volume is than the tightest of its kind, over one full turn of the body; an\n"
         "oriented box is compared with the box that rotates with the body.\n";
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::ClaimRow> rows) {
  std::string text = head_of(provenance);
  for (const cost::ClaimRow& row : rows) {
    const std::string verdict = row.verdict == "typical" ? "typical, not a bound"
                                : row.verdict == "false" ? "false here"
                                                         : row.verdict;
    text += wrapped(row.says) + '\n' + wrapped(row.lecture + ": " + row.slide, "  ") + '\n' +
            wrapped(verdict + ": " + row.measured, "  ") + "\n\n";
  }
  return text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::WhichRow> rows) {
  using Row = cost::WhichRow;
  constexpr std::array kTimes{&Row::test, &Row::build, &Row::update};
  std::array<TimeUnit, 3> units{};
  for (std::size_t i = 0; i < kTimes.size(); ++i) units[i] = unit_of(rows, kTimes[i]);
  const auto least = std::min_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.total.value_or(HUGE_VAL) < b.total.value_or(HUGE_VAL);
  });
  const TimeUnit whole = unit_for(rows.empty() ? 0 : least->total.value_or(0));
  Columns columns({"volume", "algorithm", header_of("test", units[0]), "/hull", header_of("build", units[1]),
                   header_of("update", units[2]), "bytes", "false pos.", header_of("T", whole), "f.p./T"});
  bool doubt = false;
  for (const Row& row : rows) {
    std::vector<std::string> line{row.volume,
                                  row.algorithm,
                                  units[0].text(row.test),
                                  ratio_text(row.over_hull, "%.3f"),
                                  units[1].text(row.build),
                                  units[2].text(row.update),
                                  said("%lld", static_cast<long long>(row.bytes)),
                                  said("%.1f %%", 100 * row.false_positives)};
    line.push_back(row.total ? whole.text(*row.total) + (&row == &*least ? " *" : "  ") : "-");
    line.push_back(row.total && *row.total > 0 ? said("%.0f %%", 100 * *row.total_false_positives / *row.total) : "-");
    columns.add(std::move(line));
    for (const auto timing : kTimes) doubt = doubt || ((row.*timing).repeats > 0 && !(row.*timing).trusted);
  }
  std::string text = head_of(provenance) + columns.text();
  if (rows.empty()) return text;
  const Row& load = rows.front();
  text +=
      "\ntest: of one overlap test near contact; /hull: " + std::string(provenance.dim == 2 ? "area" : "volume") +
      " over the hull's\nfalse pos.: of pairs near each other that are apart, those it does not reject;\nf.p./T: their "
      "share of T\n" +
      wrapped(said("T: what %s, and in each of %s %s and %s, %.3g %% of them of bodies that overlap, cost in all; "
                   "* the least",
                   many(load.bodies, "volume").c_str(), many(load.frames, "frame").c_str(),
                   many(load.updates, load.deforms ? "new fit" : "update").c_str(), many(load.pairs, "test").c_str(),
                   100 * load.hit_rate)) +
      '\n';
  return doubt ? text + kDoubt : text;
}

std::string text_of(const cost::Provenance& provenance, std::span<const cost::TrialRow> rows) {
  std::string text = head_of(provenance);
  for (const cost::Claim* claim : cost::tried_claims()) {
    const cost::TrialTally tally = cost::tally_trials(claim->name, rows);
    if (tally.clouds == 0) continue;
    text += wrapped(std::string(claim->says)) + '\n' +
            wrapped(std::string(claim->lecture) + ": " + std::string(claim->slide), "  ") + '\n' +
            wrapped(std::string(claim->value) + "; claimed: " + std::string(claim->claimed), "  ") + "\n  " +
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
