#include "lesson/ask.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/tolerance.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using Kind = Answer::Kind;

bool contains(const auto& values, int value) { return std::find(values.begin(), values.end(), value) != values.end(); }

/// The index of the n-th step of that name that counts; the number of steps if there is none.
int find_fact(const Run& run, std::string_view name, int occurrence) {
  int i = 0;
  for (; i < run.steps(); ++i)
    if (run.fact(i) == name && run.counts(i) && --occurrence == 0) break;
  return i;
}

/// The place just after the last step with the gate's `after` name before a given step, or after the one that after_nth
/// counts; the given step itself if there is none.
int place_after(const Run& run, const Gate& gate, int before) {
  if (gate.after == Gate::kStart) return 0;
  if (gate.after_nth > 0) return std::min(find_fact(run, gate.after, gate.after_nth) + 1, before);
  for (int i = before; i-- > 0;)
    if (run.fact(i) == gate.after) return i + 1;
  return before;
}

const char* offer_points(Asked& asked, const Run& run) {
  if (run.handles(asked.fact).empty()) return "\"point\" cannot be asked of a step that names no point";
  asked.on_stage = true;
  asked.stage_points = run.candidates(asked.fact);
  return nullptr;
}

Truth point_truth(const Asked& asked, const Run& run) {
  Truth truth;
  truth.points = run.handles(asked.fact);
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + " " + run.predicate(asked.fact, truth.points.size() > 1) + ".";
  return truth;
}

const char* offer_choices(Asked& asked, const Run&) {
  for (const std::string& choice : asked.question->choices) asked.add_choice(in_words_of(asked.dim, choice));
  return nullptr;
}

/// The place right after the step that is asked about.
View view_after(const Asked& asked, const Run& run) {
  const Method* method = find_method(*asked.lesson, asked.question->gate.algorithm);
  return {{Slot{method, &run}, Slot{}}, 0, asked.until};
}

std::optional<Figure> figure_after(const Asked& asked, const Run& run) {
  for (Figure& figure : asked.subject->figures(view_after(asked, run)))
    if (figure.key == asked.question->figure && figure.known) return std::move(figure);
  return std::nullopt;
}

const char* offer_ranges(Asked& asked, const Run& run) {
  const auto figure = figure_after(asked, run);
  if (!figure) return "\"figure\" names none that there is after this step";
  for (std::string& range : range_texts(asked.question->bounds, figure->unit)) asked.add_choice(std::move(range));
  return nullptr;
}

Truth range_truth(const Asked& asked, const Run& run) {
  const Figure figure = *figure_after(asked, run);
  const std::vector<double>& bounds = asked.question->bounds;
  const auto range = std::lower_bound(bounds.begin(), bounds.end(), figure.value) - bounds.begin();
  return {{static_cast<int>(range)}, {}, figure.text, figure.name + ": " + figure.text + "."};
}

void read_figure(TomlTable& table, Question& question) {
  question.figure = table.text("figure");
  read_bounds(table, question);
}

const char* offer_methods(Asked& asked, const Run& run) {
  const std::vector<Rival> rivals = asked.subject->rivals(*asked.lesson, view_after(asked, run));
  if (rivals.size() < 2) return "\"tightest\" asks which of several algorithms is";
  for (const Rival& rival : rivals) asked.add_choice(std::string(rival.method->title));
  return nullptr;
}

/// Sizes that differ by rounding alone are equal, and all that have the least are right.
Truth tightest_truth(const Asked& asked, const Run& run) {
  const std::vector<Rival> rivals = asked.subject->rivals(*asked.lesson, view_after(asked, run));
  const auto smaller = [](const Rival& a, const Rival& b) { return a.size < b.size; };
  const double least = std::min_element(rivals.begin(), rivals.end(), smaller)->size;
  Truth truth;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    if (rivals[i].size > least * (1 + tolerance::kBoxProof)) continue;
    truth.choices.push_back(static_cast<int>(i));
    truth.happened += (truth.happened.empty() ? "" : ", ") + asked.choices[i];
  }
  const bool one = truth.choices.size() == 1;
  truth.sentence = truth.happened + (one ? " is the tightest: " : " are the tightest: ") + number_text(least) + ".";
  return truth;
}

constexpr Asking kPoint{"point", &offer_points, &point_truth}, kChoice{"choice", &offer_choices, &choice_truth},
    kFigure{.name = "figure", .offer = &offer_ranges, .truth = &range_truth, .read = &read_figure},
    kTightest{.name = "tightest", .offer = &offer_methods, .truth = &tightest_truth, .figure = kComparedFigure};

/// What the step's own fact can be asked comes first.
const Asking* find_asking(std::string_view name, const SubjectRow& row, const Run& run, int fact) {
  for (const Asking& asking : run.askings(fact))
    if (asking.name == name) return &asking;
  return general_asking(name, row);
}

/// What a tapped handle says, in the words of a choice that names several: "the y pair (P9)". A handle that belongs to
/// two choices counts as the right one.
std::string said_by_handle(const Asked& asked, const Truth& truth, Index handle) {
  const std::string* said = nullptr;
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    if (asked.choice_handles[i].size() < 2 || !contains(asked.choice_handles[i], handle)) continue;
    if (said == nullptr || contains(truth.choices, static_cast<int>(i))) said = &asked.choices[i];
  }
  const std::string name = asked.subject->name_of(handle);
  return said == nullptr ? name : *said + " (" + name + ")";
}

/// The names of the chosen choices, by their bits.
std::string names_of_bits(const Asked& asked, int bits) {
  std::string text;
  int left = __builtin_popcount(static_cast<unsigned>(bits));
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    if ((bits >> i & 1) == 0) continue;
    text += asked.choices[i];
    if (--left > 0) text += left == 1 ? " and " : ", ";
  }
  return text.empty() ? "none" : text;
}

bool is_right(const Asked& asked, const Answer& answer, const Truth& truth) {
  if (answer.kind == Kind::kPoint) return contains(truth.points, answer.value);
  if (answer.kind == Kind::kSkipped) return false;
  if (!asked.many) return contains(truth.choices, answer.value);
  int all = 0;
  for (const int choice : truth.choices) all |= 1 << choice;
  return answer.value == all;
}

/// A question that is asked before the first step.
Asked asked_anytime(const Question& question, const Lesson& lesson, const Subject& subject, const Run& run) {
  Asked asked;
  asked.lesson = &lesson;
  asked.question = &question;
  asked.subject = &subject;
  asked.dim = subject.dim();
  asked.step = asked.until = Asked::kAnytime;
  asked.asking = &kChoice;
  for (const auto& [fact, asking] : lesson.subject->askings())
    if (asking->name == question.asks) asked.asking = asking;
  put_words(asked, true);  // it is about the lesson's own points
  asked.asking->offer(asked, run);
  return asked;
}

}  // namespace

void Asked::add_choice(std::string text, std::vector<Index> handles) {
  choices.push_back(std::move(text));
  choice_handles.push_back(std::move(handles));
}

std::string Asked::names(std::span<const Index> handles) const {
  std::string text;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (i > 0) text += i + 1 == handles.size() ? " and " : ", ";
    text += subject->name_of(handles[i]);
  }
  return text;
}

std::string_view Asked::hidden_figure() const {
  return question->figure.empty() ? asking->figure : std::string_view(question->figure);
}

Truth choice_truth(const Asked& asked, const Run&) {
  const int right = asked.question->answer;
  const std::string& text = asked.choices[static_cast<std::size_t>(right)];
  return {{right}, {}, text, "The answer is “" + text + "”."};
}

std::optional<Asked> resolve(const Question& question, const Lesson& lesson, const Subject& subject, const Run& run,
                             std::string& why) {
  const SubjectRow& row = *lesson.subject;
  if (!row.asks_of_steps) return asked_anytime(question, lesson, subject, run);
  const Gate& gate = question.gate;
  Asked asked;
  asked.lesson = &lesson;
  asked.question = &question;
  asked.subject = &subject;
  asked.dim = subject.dim();
  put_words(asked, false);
  asked.fact = find_fact(run, gate.fact, gate.occurrence);
  if (asked.fact == run.steps()) {
    why = gate.algorithm + " does not take step " + gate.fact +
          (gate.occurrence > 1 ? " " + std::to_string(gate.occurrence) + " times" : "") + " on these points";
    return std::nullopt;
  }
  asked.asking = find_asking(question.asks, row, run, asked.fact);
  if (asked.asking == nullptr) {
    std::vector<std::string_view> facts;
    for (const auto& [fact, asking] : row.askings())
      if (asking->name == question.asks) facts.push_back(fact);
    why = "\"" + question.asks + "\" can only be asked of " + one_of(facts) + ", not of " + gate.fact;
    return std::nullopt;
  }
  asked.step = gate.after.empty() ? asked.fact : place_after(run, gate, asked.fact);
  asked.until = asked.asking->decided != nullptr ? asked.asking->decided(run, asked.fact) : asked.fact + 1;
  if (const char* refused = asked.asking->offer(asked, run)) {
    why = refused;
    return std::nullopt;
  }
  return asked;
}

std::vector<std::string_view> general_askings(const SubjectRow& subject) {
  if (!subject.asks_of_steps) return {kChoice.name};
  std::vector<std::string_view> names{kPoint.name, kChoice.name, kFigure.name};
  if (subject.compares) names.push_back(kTightest.name);
  return names;
}

const Asking* general_asking(std::string_view name, const SubjectRow& subject) {
  if (!is_among(general_askings(subject), name)) return nullptr;
  for (const Asking* asking : {&kPoint, &kChoice, &kFigure, &kTightest})
    if (asking->name == name) return asking;
  return nullptr;
}

void read_bounds(TomlTable& table, Question& question) {
  question.bounds = table.numbers("bounds");
  double last = -std::numeric_limits<double>::infinity();
  const auto rises = [&](double bound) {
    return bound > std::exchange(last, bound) && std::isfinite(bound);
  };  // no NaN does
  if (question.bounds.empty() || !std::all_of(question.bounds.begin(), question.bounds.end(), rises))
    table.wrong("bounds", "must be numbers that rise"), question.bounds = {0};
}

std::vector<std::string> range_texts(std::span<const double> bounds, std::string_view unit) {
  const bool measured = unit == "%" || unit.substr(0, 5) == "units" || unit == "times";
  const auto whole = [](double bound) { return bound == std::floor(bound); };
  const bool count = !measured && std::all_of(bounds.begin(), bounds.end(), whole);
  const std::string of(unit.empty() ? "" : " " + std::string(unit));
  const auto number = [&](double value) { return count ? count_text(std::llround(value)) : plain_number(value); };
  std::vector<std::string> texts{count && bounds.front() == 0 ? "none" : "at most " + number(bounds.front()) + of};
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double above = count ? bounds[i - 1] + 1 : bounds[i - 1];
    texts.push_back((above == bounds[i] ? "" : number(above) + " to ") + number(bounds[i]) + of);
  }
  texts.push_back("more than " + number(bounds.back()) + of);
  return texts;
}

void put_words(Asked& asked, bool own_run) {
  const Question& question = *asked.question;
  const auto words = [&](const std::string& here, const std::string& anywhere) {
    return in_words_of(asked.dim, own_run && !here.empty() ? here : anywhere);
  };
  asked.prompt = words(question.prompt_here, question.prompt);
  asked.because = words(question.because_here, question.because);
}

std::vector<Asked> asked_on(const Lesson& lesson, std::string_view method, const Subject& subject, const Run& run,
                            bool own_run) {
  std::vector<Asked> all;
  std::string why;
  for (const Question& question : lesson.questions) {
    if (lesson.subject->asks_of_steps && question.gate.algorithm != method) continue;
    if ((question.own_points || !lesson.subject->asks_of_steps) && !own_run) continue;
    auto asked = resolve(question, lesson, subject, run, why);
    if (!asked) continue;
    put_words(*asked, own_run);
    all.push_back(*std::move(asked));
  }
  if (!lesson.subject->asks_of_steps) return all;
  std::stable_sort(all.begin(), all.end(), [](const Asked& a, const Asked& b) { return a.step < b.step; });
  std::vector<Asked> apart;
  for (Asked& asked : all)
    if (apart.empty() || asked.step >= apart.back().until) apart.push_back(std::move(asked));
  return apart;
}

bool answers(const Asked& asked, const Answer& answer) {
  switch (answer.kind) {
    case Kind::kSkipped: return true;
    case Kind::kChoice: {
      const int choices = static_cast<int>(asked.choices.size());
      return answer.value >= 0 && answer.value < (asked.many ? 1 << choices : choices);
    }
    case Kind::kPoint:
      return asked.on_stage && answer.value >= 0 && answer.value < asked.subject->size() &&
             (asked.stage_points.empty() || contains(asked.stage_points, answer.value));
  }
  return false;
}

bool same_answer(const Asked& asked, const Answer& a, const Answer& b) {
  if (a.kind == b.kind) return a.value == b.value;
  if (a.kind == Kind::kSkipped || b.kind == Kind::kSkipped) return false;
  const Answer& choice = a.kind == Kind::kChoice ? a : b;
  const Answer& handle = a.kind == Kind::kChoice ? b : a;
  const auto at = static_cast<std::size_t>(choice.value);
  return at < asked.choice_handles.size() && asked.choice_handles[at].size() == 1 &&
         asked.choice_handles[at].front() == handle.value;
}

bool is_picked(const Asked& asked, const Answer& picked, int choice) {
  if (asked.many) return (picked.value >> choice & 1) != 0;
  return same_answer(asked, picked, {Kind::kChoice, choice});
}

bool has_second_try(const Asked& asked) {
  if (asked.step == Asked::kAnytime) return false;  // it is not decided yet
  if (asked.many) return true;
  if (!asked.choices.empty()) return asked.choices.size() > 2;
  return (asked.stage_points.empty() ? asked.subject->size() : static_cast<Index>(asked.stage_points.size())) > 2;
}

Standing standing_of(const Outcome* outcome) {
  if (outcome == nullptr || outcome->passed || outcome->pending) return Standing::kOpen;
  if (outcome->skipped) return Standing::kSkipped;
  return outcome->right ? Standing::kRight : Standing::kWrong;
}

Tally tally_of(std::span<const Asked> questions, std::span<const Outcome> outcomes) {
  Tally tally;
  for (const Asked& asked : questions) {
    const auto own = std::find_if(outcomes.begin(), outcomes.end(),
                                  [&](const Outcome& it) { return it.question == asked.question->id; });
    switch (standing_of(own == outcomes.end() ? nullptr : &*own)) {
      case Standing::kOpen: ++tally.open; break;
      case Standing::kRight: ++tally.right, tally.second += own->tries > 1; break;
      case Standing::kWrong: ++tally.wrong; break;
      case Standing::kSkipped: ++tally.skipped; break;
    }
  }
  return tally;
}

Outcome judge(const Asked& asked, const Answer& answer, const Run& run) {
  Truth truth = asked.asking->truth(asked, run);
  Outcome outcome;
  outcome.question = asked.question->id;
  outcome.given = answer;
  outcome.skipped = answer.kind == Kind::kSkipped;
  outcome.tries = outcome.skipped ? 0 : 1;
  outcome.pending = truth.pending;
  outcome.from_step = asked.step;
  outcome.step = asked.until;
  outcome.because = asked.because;
  if (answer.kind == Kind::kPoint) outcome.predicted = said_by_handle(asked, truth, answer.value);
  else if (answer.kind == Kind::kChoice)
    outcome.predicted =
        asked.many ? names_of_bits(asked, answer.value) : asked.choices[static_cast<std::size_t>(answer.value)];
  outcome.right = !truth.pending && is_right(asked, answer, truth);
  outcome.says = std::move(truth.sentence);
  if (!truth.pending) outcome.happened = std::move(truth.happened);
  return outcome;
}

Answer model_answer(const Asked& asked, const Run& run) {
  const Truth truth = asked.asking->truth(asked, run);
  if (asked.many) {
    int all = 0;
    for (const int choice : truth.choices) all |= 1 << choice;
    return {Kind::kChoice, all};
  }
  if (!truth.choices.empty()) return {Kind::kChoice, truth.choices.front()};
  return {Kind::kPoint, truth.points.empty() ? 0 : truth.points.front()};
}

}  // namespace snug::lesson
