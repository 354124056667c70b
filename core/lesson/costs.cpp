#include "lesson/costs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>

#include "lesson/box_tests.hpp"
#include "lesson/figures.hpp"
#include "lesson/methods.hpp"
#include "lesson/words.hpp"
#include "measure/cost_run.hpp"

namespace snug::lesson {
namespace {

using Asks = Question::Asks;
using Kind = Answer::Kind;

constexpr std::array<double, 3> kTimes{10, 100, 1000};
constexpr std::array<std::string_view, 4> kTimesChoices{"up to 10 times", "10 to 100 times", "100 to 1,000 times",
                                                        "more than 1,000 times"};

std::string title_of(const cost::CostRow& row) {
  const fit::Algorithm* algorithm = find_method(row.volume, row.algorithm);
  return std::string(algorithm != nullptr ? algorithm->title : std::string_view(row.algorithm));
}

/// One run on all points, measured or foreseen.
double whole_time(const cost::CostRow& row) { return row.whole_ns.value_or(row.time.median); }

/// Whether operations stand in the place of times: nothing was timed (counted_costs).
bool is_counted(const cost::CostRow& row) { return row.time.repeats == 0; }

/// "12", "1.3", "4,700": what is counted in times needs no third digit.
std::string times_text(double ratio) {
  if (ratio >= 1000) {
    const double last = std::pow(10, std::floor(std::log10(ratio)) - 1);
    std::string text = std::to_string(static_cast<std::int64_t>(std::min(std::round(ratio / last) * last, 1e18)));
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
    return text;
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), ratio < 10 ? "%.1f" : "%.0f", ratio);
  return text.data();
}

/// The chosen of many, by their bits.
std::string names_of(const std::vector<std::string>& choices, int bits) {
  std::string text;
  int left = __builtin_popcount(static_cast<unsigned>(bits));
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if ((bits >> i & 1) == 0) continue;
    text += choices[i];
    if (--left > 0) text += left == 1 ? " and " : ", ";
  }
  return text.empty() ? "none" : text;
}

/// That a time was not taken of all points, but worked out; nothing where it was.
std::string foretold(const cost::CostRow& row) {
  if (!row.whole_ns) return "";
  return " A run on all points would have made you wait: it was timed on " + std::to_string(row.points) + " of the " +
         std::to_string(row.of) + ", and the rest is extrapolated.";
}

/// Whether the machine was too busy to tell how long it takes: on the chart such a mark is hollow.
bool measured_badly(const cost::CostRow& row) { return !is_counted(row) && !row.time.trusted; }

struct Truth {
  int value = 0;
  std::string happened, sentence;
};

Truth front_truth(const Asked& asked, Costs rows) {
  Truth truth;
  for (const std::size_t i : cost::pareto_front(rows)) truth.value |= 1 << i;
  truth.happened = names_of(asked.choices, truth.value);
  truth.sentence = "On the front: " + truth.happened + ".";
  for (const cost::CostRow& row : rows)
    if (row.whole_ns) truth.sentence += " " + title_of(row) + " was too slow here for all points, and is left out.";
  return truth;
}

Truth time_truth(const Asked& asked, Costs rows) {
  const auto faster = [](const cost::CostRow& a, const cost::CostRow& b) { return whole_time(a) < whole_time(b); };
  const auto [least, most] = std::minmax_element(rows.begin(), rows.end(), faster);
  const double ratio = whole_time(*most) / whole_time(*least);
  const std::string sentence = title_of(*most) + " takes " + (most->whole_ns ? "about " : "") + times_text(ratio) +
                               " times as " + (is_counted(*most) ? "many operations as " : "long as ") +
                               title_of(*least) + "." + foretold(*most);
  if (asked.question->asks == Asks::kSlowest) return {static_cast<int>(most - rows.begin()), title_of(*most), sentence};
  const auto range = std::lower_bound(kTimes.begin(), kTimes.end(), ratio) - kTimes.begin();
  return {static_cast<int>(range), times_text(ratio) + " times", sentence};
}

Truth truth_of(const Asked& asked, Costs rows) {
  if (asked.question->asks == Asks::kOnFront) return front_truth(asked, rows);
  if (asked.question->asks != Asks::kChoice) return time_truth(asked, rows);
  const std::string& right = asked.choices[static_cast<std::size_t>(asked.question->answer)];
  return {asked.question->answer, right, "The answer is “" + right + "”."};
}

/// A row that the answer rests on and that was measured badly; null where there is none. Whoever is slowest is so by
/// far, but the front is decided by any two that are close.
const cost::CostRow* doubtful_row(const Asked& asked, Costs rows) {
  if (asked.question->asks != Asks::kOnFront) return nullptr;
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [](const cost::CostRow& row) { return row.points == row.of && measured_badly(row); });
  return found == rows.end() ? nullptr : &*found;
}

bool of_same_points(const cost::CostRow& a, const cost::CostRow& b) { return a.points == b.points; }

const cost::CostRow* find_row(Costs rows, std::string_view algorithm) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const cost::CostRow& row) { return row.algorithm == algorithm; });
  return found == rows.end() ? nullptr : &*found;
}

/// "12 % smaller than", "of the size of", "3.1 % larger than"
std::string smaller_text(double size, double than) {
  const double share = size / than - 1;
  std::string text = percent_text(share < 0 ? -share : share);
  if (text.front() == '+') text.erase(0, 1);
  return share == 0 ? "of the size of" : text + (share < 0 ? " smaller than" : " larger than");
}

}  // namespace

std::vector<Asked> asked_of_costs(const Lesson& lesson) {
  std::vector<Asked> all;
  for (const Question& question : lesson.questions) {
    Asked asked;
    asked.question = &question;
    asked.dim = lesson.points.dim;
    put_words(asked, true);  // they are of the lesson's own points
    asked.step = asked.until = -1;
    asked.many = question.asks == Asks::kOnFront;
    if (question.asks == Asks::kTimesSlower) asked.choices.assign(kTimesChoices.begin(), kTimesChoices.end());
    else if (question.asks == Asks::kChoice) asked.choices = question.choices;
    else
      for (const std::string& name : lesson.algorithms)
        asked.choices.emplace_back(find_method(lesson.volume, name)->title);
    asked.choice_points.assign(asked.choices.size(), kNoIndex);
    all.push_back(std::move(asked));
  }
  return all;
}

bool answers_of_costs(const Asked& asked, const Answer& answer) {
  const int most = asked.many ? 1 << asked.choices.size() : static_cast<int>(asked.choices.size());
  return answer.kind == Kind::kSkipped || (answer.kind == Kind::kChoice && answer.value >= 0 && answer.value < most);
}

Outcome predicted(const Asked& asked, const Answer& answer) {
  Outcome outcome;
  outcome.question = asked.question->id;
  outcome.given = answer;
  outcome.from_step = outcome.step = -1;
  outcome.pending = true;
  outcome.skipped = answer.kind == Kind::kSkipped;
  outcome.because = asked.because;
  if (!outcome.skipped)
    outcome.predicted =
        asked.many ? names_of(asked.choices, answer.value) : asked.choices[static_cast<std::size_t>(answer.value)];
  return outcome;
}

void decide(const Asked& asked, Costs rows, Outcome& outcome) {
  outcome = predicted(asked, outcome.given);
  if (const cost::CostRow* const row = doubtful_row(asked, rows)) {
    outcome.says += " " + title_of(*row) + " was measured badly, so the front is not decided: measure again.";
    return;
  }
  Truth truth = truth_of(asked, rows);
  outcome.pending = false;
  outcome.right = !outcome.skipped && outcome.given.value == truth.value;
  outcome.says = std::move(truth.sentence);
  outcome.happened = std::move(truth.happened);
}

Answer model_answer(const Asked& asked, Costs rows) { return {Kind::kChoice, truth_of(asked, rows).value}; }

std::string_view cheapest_of(const Task& task, Costs rows) {
  const cost::CostRow* const than = find_row(rows, task.algorithm);
  const bool known = than != nullptr && !than->is_flat();  // of a flat shape sizes are nothing but rounding
  const cost::CostRow* best = nullptr;
  for (const cost::CostRow& row : rows) {
    const bool smaller = known && of_same_points(row, *than) && row.size <= (1 - task.tighter_by) * than->size;
    if (smaller && (best == nullptr || row.time.median < best->time.median)) best = &row;
  }
  return best != nullptr ? std::string_view(best->algorithm) : std::string_view();
}

Grade grade_costs(const Task& task, Costs rows, std::string_view chosen) {
  Grade grade;
  const cost::CostRow *const than = find_row(rows, task.algorithm), *const own = find_row(rows, chosen);
  if (than == nullptr || own == nullptr) return grade;
  grade.points = static_cast<int>(own->of);
  const std::string name = title_of(*than);
  std::string asked_for = percent_text(task.tighter_by);
  asked_for.erase(0, asked_for.front() == '+' ? 1 : 0);
  const std::string_view cheapest = cheapest_of(task, rows);
  if (cheapest.empty()) {
    grade.says = "On this shape nothing is " + asked_for + " smaller than " + name + ": take another shape.";
    return grade;
  }
  if (own == than) {
    grade.says = name + " stands on the stage. Load one that is at least " + asked_for + " smaller, for the " +
                 (is_counted(*own) ? "fewest operations." : "least time.");
    return grade;
  }
  if (!of_same_points(*own, *than)) {
    grade.says = title_of(*own) + " was measured on fewer points: the two cannot be compared.";
    return grade;
  }
  if (chosen != cheapest && (measured_badly(*own) || measured_badly(*find_row(rows, cheapest)))) {
    grade.says = "The times of " + title_of(*own) + " and " + title_of(*find_row(rows, cheapest)) +
                 " cannot be compared, for one of them was measured badly: measure again.";
    return grade;
  }
  grade.excess = own->size / than->size - 1;
  grade.done = chosen == cheapest;
  grade.says = title_of(*own) + ": " + smaller_text(own->size, than->size) + " " + name + ", for " +
               times_text(own->time.median / than->time.median) + " times its " +
               (is_counted(*own) ? "operations." : "time.");
  if (grade.done) grade.says += " Done.";
  else if (own->size <= (1 - task.tighter_by) * than->size) grade.says += " Another does it for less.";
  else grade.says += " It should be at least " + asked_for + " smaller.";
  return grade;
}

std::vector<cost::CostRow> counted_costs(const Lesson& lesson, const AnyPointSet& points) {
  std::vector<cost::CostRow> rows;
  const int dim = fit::dim_of(points);
  for (const std::string& name : lesson.algorithms) {
    const fit::Algorithm& algorithm = *find_method(lesson.volume, name);
    if (fit::size_of(points) > algorithm.max_points) continue;
    const fit::Watched run = algorithm.watch(points, {.seed = lesson.seed}, {});
    cost::CostRow row;
    row.volume = algorithm.volume, row.algorithm = algorithm.name;
    row.points = row.of = fit::size_of(points);
    row.time.median = static_cast<double>(std::accumulate(run.counts.begin(), run.counts.end(), std::int64_t{1}));
    row.noise = cost::rounding_of(points).noise(dim);
    row.size = fit::size_of(run.result.volume, dim), row.measure = fit::measure_of(run.result.volume, dim);
    rows.push_back(std::move(row));
  }
  cost::mark_front(rows);
  return rows;
}

}  // namespace snug::lesson
