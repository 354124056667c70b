// The answers to the chart's questions and the grade of its task, from measured rows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "fit/catalogue.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cost/asks.hpp"
#include "lesson/subjects/cost/cost.hpp"
#include "measure/cost_run.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<double, 3> kTimes{10, 100, 1000};
constexpr std::array<std::string_view, 4> kTimesChoices{"up to 10 times", "10 to 100 times", "100 to 1,000 times",
                                                        "more than 1,000 times"};

std::string title_of(const cost::CostRow& row) {
  const fit::Algorithm* algorithm = fit::find_algorithm(row.volume, row.algorithm);
  return std::string(algorithm != nullptr ? algorithm->title : std::string_view(row.algorithm));
}
/// The same as the question's choices have it: with the volume, where the lesson has several.
std::string title_of(const Lesson& lesson, const cost::CostRow& row) {
  const Method* method = find_method(lesson, row.volume + '/' + row.algorithm);
  return method != nullptr ? title_in(lesson, *method) : title_of(row);
}

/// The time of one run on all points, measured or extrapolated; infinite where a limit would stop it.
double whole_time(const cost::CostRow& row) {
  const bool stopped = row.points < row.of && !row.whole_ns;
  return stopped ? std::numeric_limits<double>::infinity() : row.whole_ns.value_or(row.time.median);
}

/// Whether the row has operations instead of times, because nothing was timed (counted_costs).
bool is_counted(const cost::CostRow& row) { return row.time.repeats == 0; }

/// "12", "1.3", "4,700": a ratio with two digits.
std::string times_text(double ratio) {
  if (ratio >= 1000) {
    const double last = std::pow(10, std::floor(std::log10(ratio)) - 1);
    return count_text(static_cast<std::int64_t>(std::min(std::round(ratio / last) * last, 1e18)));
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), ratio < 10 ? "%.1f" : "%.0f", ratio);
  return text.data();
}

/// Says that a time was extrapolated from fewer points; empty if it was measured on all.
std::string foretold(const cost::CostRow& row) {
  if (!row.whole_ns) return "";
  return " A run on all points would have made you wait: it was timed on " + count_text(row.points) + " of the " +
         count_text(row.of) + " and extrapolated.";
}

/// Whether the machine was too busy to measure the time: on the chart such a mark is hollow.
bool is_unreliable(const cost::CostRow& row) { return !is_counted(row) && !row.time.trusted; }

Costs rows_of(const Asked& asked) {
  const auto* rows = static_cast<const CostSubject&>(*asked.subject).costs();
  return rows != nullptr ? Costs(*rows) : Costs();
}

Truth unknown(std::string why = {}) { return {.sentence = std::move(why), .pending = true}; }

const cost::CostRow* slowest_of(Costs rows) {
  return &*std::max_element(rows.begin(), rows.end(),
                            [](const auto& a, const auto& b) { return whole_time(a) < whole_time(b); });
}
const cost::CostRow* fastest_of(Costs rows) {
  return &*std::min_element(rows.begin(), rows.end(),
                            [](const auto& a, const auto& b) { return whole_time(a) < whole_time(b); });
}
double times_slower(Costs rows) { return whole_time(*slowest_of(rows)) / whole_time(*fastest_of(rows)); }

std::string slower_sentence(const Lesson& lesson, Costs rows) {
  const cost::CostRow &most = *slowest_of(rows), &least = *fastest_of(rows);
  return title_of(lesson, most) + " takes " + (most.whole_ns ? "about " : "") + times_text(times_slower(rows)) +
         " times as " + (is_counted(most) ? "many operations as " : "long as ") + title_of(lesson, least) + "." +
         foretold(most);
}

/// The titles of the rows with an unreliable time that could change the front. The slowest is slowest by far, but the
/// front depends on any two that are close.
std::vector<std::string> doubtful_titles(const Lesson& lesson, Costs rows) {
  std::vector<std::string> titles;
  for (const cost::CostRow& row : rows)
    if (row.points == row.of && is_unreliable(row)) titles.push_back(title_of(lesson, row));
  return titles;
}

bool of_same_points(const cost::CostRow& a, const cost::CostRow& b) { return a.points == b.points; }

bool are_mixed(Costs rows) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const cost::CostRow& row) { return row.volume != rows.front().volume; });
}

/// algorithm: "k8", of the first row's volume; or "kdop/k8".
const cost::CostRow* find_row(Costs rows, std::string_view algorithm) {
  const std::size_t slash = algorithm.find('/');
  const bool whole = slash != std::string_view::npos;
  if (rows.empty()) return nullptr;
  const std::string_view volume = whole ? algorithm.substr(0, slash) : std::string_view(rows.front().volume);
  const std::string_view name = whole ? algorithm.substr(slash + 1) : algorithm;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const cost::CostRow& row) {
    return row.algorithm == name && row.volume == volume;
  });
  return found == rows.end() ? nullptr : &*found;
}

/// How large a row's volume is, to be compared with another's: a sphere has a radius only beside other spheres.
double size_beside(const cost::CostRow& row, const cost::CostRow& other) {
  return row.volume == other.volume ? row.size : row.measure;
}

/// "12 % smaller than", "the same size as", "3.1 % larger than"
std::string smaller_text(double size, double than) {
  const double share = size / than - 1;
  const std::string text = without_plus(percent_text(share < 0 ? -share : share));
  return share == 0 ? "the same size as" : text + (share < 0 ? " smaller than" : " larger than");
}

}  // namespace

const char* offer_methods(Asked& asked, const Run&) {
  for (const Method* method : static_cast<const CostSubject&>(*asked.subject).methods())
    asked.add_choice(title_in(*asked.lesson, *method));
  return nullptr;
}

const char* offer_front(Asked& asked, const Run& run) {
  asked.many = true;
  return offer_methods(asked, run);
}

const char* offer_times(Asked& asked, const Run&) {
  for (const std::string_view choice : kTimesChoices) asked.add_choice(std::string(choice));
  return nullptr;
}

Truth front_truth(const Asked& asked, const Run&) {
  const Costs rows = rows_of(asked);
  if (rows.size() != asked.choices.size()) return unknown();
  if (const auto doubtful = doubtful_titles(*asked.lesson, rows); !doubtful.empty())
    return unknown(listed(doubtful, " and ") +
                   " could not be measured reliably, so the front is not decided: measure again.");
  Truth truth;
  const auto front = cost::pareto_front(rows);
  for (const std::size_t i : front) {
    truth.happened += (i == front.front() ? "" : i == front.back() ? " and " : ", ") + asked.choices[i];
    truth.choices.push_back(static_cast<int>(i));
  }
  truth.sentence = "On the front: " + truth.happened + ".";
  for (const cost::CostRow& row : rows)
    if (row.whole_ns)
      truth.sentence += " " + title_of(*asked.lesson, row) +
                        " was too slow here to measure on all points, and is left out of the front.";
  return truth;
}

Truth slowest_truth(const Asked& asked, const Run&) {
  const Costs rows = rows_of(asked);
  if (rows.size() != asked.choices.size()) return unknown();
  const cost::CostRow* slowest = slowest_of(rows);
  return {{static_cast<int>(slowest - rows.data())},
          {},
          title_of(*asked.lesson, *slowest),
          slower_sentence(*asked.lesson, rows)};
}

Truth times_truth(const Asked& asked, const Run&) {
  const Costs rows = rows_of(asked);
  if (rows.size() != static_cast<const CostSubject&>(*asked.subject).methods().size()) return unknown();
  const double ratio = times_slower(rows);
  const auto range = std::lower_bound(kTimes.begin(), kTimes.end(), ratio) - kTimes.begin();
  return {{static_cast<int>(range)}, {}, times_text(ratio) + " times", slower_sentence(*asked.lesson, rows)};
}

Truth measured_choice_truth(const Asked& asked, const Run& run) {
  return rows_of(asked).empty() ? unknown() : choice_truth(asked, run);
}

/// The fraction by which the volume must be smaller.
double tighter_by_of(const Task& task) { return task.conditions.empty() ? 0 : task.conditions.front().at_least / 100; }

std::string cheapest_of(const Task& task, Costs rows) {
  const double tighter_by = tighter_by_of(task);
  const cost::CostRow* const than = find_row(rows, task.algorithm);
  const bool known = than != nullptr && !than->is_flat();  // the sizes of a flat shape are only rounding
  const cost::CostRow* best = nullptr;
  for (const cost::CostRow& row : rows) {
    const bool smaller =
        known && of_same_points(row, *than) && size_beside(row, *than) <= (1 - tighter_by) * size_beside(*than, row);
    if (smaller && (best == nullptr || row.time.median < best->time.median)) best = &row;
  }
  if (best == nullptr) return {};
  return are_mixed(rows) ? best->volume + '/' + best->algorithm : best->algorithm;
}

Grade grade_costs(const Task& task, Costs rows, std::string_view chosen) {
  const double tighter_by = tighter_by_of(task);
  Grade grade;
  const cost::CostRow *const than = find_row(rows, task.algorithm), *const own = find_row(rows, chosen);
  if (than == nullptr || own == nullptr) return grade;
  grade.points = static_cast<int>(own->of);
  const std::string name = title_of(*than);
  const std::string asked_for = without_plus(percent_text(tighter_by));
  const std::string cheapest = cheapest_of(task, rows);
  if (cheapest.empty()) {
    grade.says = "On this shape nothing is " + asked_for + " smaller than " + name + ": take another shape.";
    return grade;
  }
  if (own == than) {
    grade.says = name + " is on the stage. Load one that is at least " + asked_for + " smaller, in the " +
                 (is_counted(*own) ? "fewest operations." : "least time.");
    return grade;
  }
  if (!of_same_points(*own, *than)) {
    grade.says = title_of(*own) + " was measured on fewer points: the two cannot be compared.";
    return grade;
  }
  const double own_size = size_beside(*own, *than), than_size = size_beside(*than, *own);
  const bool small_enough = own_size <= (1 - tighter_by) * than_size;
  const cost::CostRow& best = *find_row(rows, cheapest);
  const bool tied = small_enough && cost::faster(own->time, best.time, cost::kDoubtInRun) == cost::Faster::kTie;
  const bool is_cheapest = own == &best || tied;
  if (!is_cheapest && (is_unreliable(*own) || is_unreliable(best))) {
    grade.says = "The times of " + title_of(*own) + " and " + title_of(best) +
                 " cannot be compared, because one of them could not be measured reliably: measure again.";
    return grade;
  }
  grade.excess = own_size / than_size - 1;
  grade.done = is_cheapest;
  grade.says = title_of(*own) + ": " + smaller_text(own_size, than_size) + " " + name + ", in " +
               times_text(own->time.median / than->time.median) + " times the " +
               (is_counted(*own) ? "operations." : "time.");
  if (grade.done) grade.says += " Done.";
  else if (small_enough) grade.says += is_counted(*own) ? " Another does it in fewer." : " Another does it in less.";
  else grade.says += " It should be at least " + asked_for + " smaller.";
  return grade;
}

std::vector<cost::CostRow> counted_costs(const Lesson& lesson, const AnyPointSet& points) {
  std::vector<cost::CostRow> rows;
  const int dim = fit::dim_of(points);
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    const fit::Algorithm& algorithm = *fit::find_algorithm(method.volume, method.name);
    if (fit::count_of(points) > algorithm.max_points) continue;
    const fit::Watched run = algorithm.watch(points, {.seed = lesson.seed}, {});
    cost::CostRow row;
    row.volume = algorithm.volume, row.algorithm = algorithm.name;
    row.points = row.of = fit::count_of(points);
    row.time.median = static_cast<double>(std::accumulate(run.counts.begin(), run.counts.end(), std::int64_t{1}));
    row.noise = cost::rounding_of(points).noise(dim);
    row.size = fit::size_of(run.result.volume, dim), row.measure = fit::measure_of(run.result.volume, dim);
    rows.push_back(std::move(row));
  }
  cost::mark_front(rows);
  return rows;
}

}  // namespace snug::lesson
