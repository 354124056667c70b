#include "lesson/ask.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/sort.hpp"
#include "io/text.hpp"
#include "lesson/decide.hpp"
#include "lesson/grade.hpp"
#include "lesson/names.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kOf = "{of}";

bool contains(const auto& values, Index value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

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

/// What the step's own fact can be asked comes first.
const QuestionKind* find_question_kind(std::string_view name, const SubjectRow& row, const Run& run, int fact) {
  for (const QuestionKind& kind : run.question_kinds(fact))
    if (kind.name == name) return &kind;
  return general_question_kind(name, row);
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

/// "x, y and z"; "none".
std::string names_of(const Asked& asked, const SeveralChoices& several) {
  std::string text;
  std::size_t left = several.choices.size();
  for (const int choice : several.choices) {
    text += asked.choices[choice];
    if (--left > 0) text += left == 1 ? " and " : ", ";
  }
  return text.empty() ? "none" : text;
}

/// Whether a list has the same entries as another, in any order.
template <class Entry>
bool same_set(std::vector<Entry> a, std::vector<Entry> b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

/// Whether these are the right handles. At least one of each tied group must be given.
bool are_right(const std::vector<Index>& given, const Truth& truth) {
  if (truth.tied.empty()) return same_set(given, truth.points);
  const auto is_given = [&](Index handle) { return contains(given, handle); };
  return std::all_of(given.begin(), given.end(), [&](Index one) { return contains(truth.points, one); }) &&
         std::all_of(truth.tied.begin(), truth.tied.end(),
                     [&](const auto& tied) { return std::any_of(tied.begin(), tied.end(), is_given); });
}

bool is_right(const Answer& answer, const Truth& truth) {
  const auto before = [&](int a, int b) { return truth.ranks[a] < truth.ranks[b]; };
  return std::visit(
      ByKind{
          [](const Skipped&) { return false; },
          [&](const OneHandle& one) { return contains(truth.points, one.handle); },
          [&](const SeveralHandles& several) { return are_right(several.handles, truth); },
          [&](const OneChoice& one) { return contains(truth.choices, one.choice); },
          [&](const SeveralChoices& several) { return same_set(several.choices, truth.choices); },
          [&](const ChoicesInOrder& all) { return std::is_sorted(all.choices.begin(), all.choices.end(), before); },
          [&](const TypedNumber& typed) { return std::abs(typed.number - truth.number) <= truth.tolerance; },
      },
      answer);
}

/// What an answer says, in words.
std::string said_by(const Asked& asked, const Answer& answer, const Truth& truth) {
  return std::visit(ByKind{
                        [](const Skipped&) { return std::string(); },
                        [&](const OneHandle& one) { return said_by_handle(asked, truth, one.handle); },
                        [&](const SeveralHandles& several) { return asked.names(several.handles); },
                        [&](const OneChoice& one) { return asked.choices[one.choice]; },
                        [&](const SeveralChoices& several) { return names_of(asked, several); },
                        [&](const ChoicesInOrder& all) { return choice_words(asked, all.choices); },
                        [&](const TypedNumber& typed) { return with_unit(typed.number, asked.unit); },
                    },
                    answer);
}

/// Whether a question's answer is true of this run.
bool conditions_hold(const Question& question, const Lesson& lesson, std::string_view method, const Subject& subject,
                     const Run& run) {
  const View view{{Slot{find_method(lesson, method), &run}, Slot{}}, 0, run.steps()};
  const auto holds = [&](const Requirement& due) { return judge_requirement(due, lesson, method, subject, view).met; };
  return std::all_of(question.conditions.begin(), question.conditions.end(), holds);
}

/// A question that is asked before the first step.
Asked asked_anytime(const Question& question, const Lesson& lesson, const Subject& subject, const Run& run) {
  Asked asked;
  asked.lesson = &lesson;
  asked.question = &question;
  asked.subject = &subject;
  asked.dim = subject.dim();
  asked.step = asked.until = Asked::kAnytime;
  asked.kind = general_question_kind("choice", *lesson.subject);
  for (const auto& [fact, kind] : lesson.subject->question_kinds())
    if (kind->name == question.asks) asked.kind = kind;
  put_words(asked, true);  // it is about the lesson's own points
  asked.kind->offer(asked, run);
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
  return question->figure.empty() ? kind->figure : std::string_view(question->figure);
}

bool comes_before(const Run& run, const Gate& gate) {
  if (gate.after.empty() || gate.after == Gate::kStart) return true;
  const int due = find_fact(run, gate.fact, gate.occurrence);
  if (gate.after_nth > 0) return find_fact(run, gate.after, gate.after_nth) < due;
  for (int i = 0; i < due; ++i)
    if (run.fact(i) == gate.after) return true;
  return false;
}

std::optional<Asked> resolve(const Question& question, const Lesson& lesson, const Subject& subject, const Run& run,
                             std::string& why) {
  if (question.predicts) return asked_anytime(question, lesson, subject, run);
  const SubjectRow& row = *lesson.subject;
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
  if (run.is_rounding(asked.fact)) {
    why = "on these points, step " + gate.fact + " happens only by rounding";
    return std::nullopt;
  }
  asked.kind = find_question_kind(question.asks, row, run, asked.fact);
  if (asked.kind == nullptr) {
    std::vector<std::string_view> facts;
    for (const auto& [fact, kind] : row.question_kinds())
      if (kind->name == question.asks) facts.push_back(fact);
    why = "\"" + question.asks + "\" can only be asked of " + one_of(facts) + ", not of " + gate.fact;
    return std::nullopt;
  }
  asked.step = gate.after.empty() ? asked.fact : place_after(run, gate, asked.fact);
  asked.until = asked.kind->decided != nullptr ? asked.kind->decided(run, asked.fact) : asked.fact + 1;
  if (const char* refused = asked.kind->offer(asked, run)) {
    why = refused == kNoFigureAfter ? no_figure_after(asked, run) : refused;
    return std::nullopt;
  }
  return asked;
}

void put_words(Asked& asked, bool own_run) {
  const Question& question = *asked.question;
  asked.own_run = own_run;
  const auto words = [&](const std::string& here, const std::string& anywhere) {
    std::string text = in_words_of(asked.dim, own_run && !here.empty() ? here : anywhere);
    if (const std::size_t at = text.find(kOf); at != std::string::npos) text.replace(at, kOf.size(), asked.of);
    return text;
  };
  asked.prompt = words(question.prompt_here, question.prompt);
  asked.because = words(question.because_here, question.because);
}

std::vector<Asked> asked_on(const Lesson& lesson, std::string_view method, const Subject& subject, const Run& run,
                            bool own_run) {
  std::vector<Asked> all;
  std::string why;
  for (const Question& question : lesson.questions) {
    if (question.situation != subject.origin().situation) continue;
    if (!question.predicts && question.gate.algorithm != method) continue;
    if ((question.holds == Holds::kHere || question.predicts) && !own_run) continue;
    if (!conditions_hold(question, lesson, method, subject, run)) continue;
    auto asked = resolve(question, lesson, subject, run, why);
    if (!asked) continue;
    put_words(*asked, own_run);
    all.push_back(*std::move(asked));
  }
  sort_stably(all, [](const Asked& a, const Asked& b) { return a.step < b.step; });
  // Questions at one place are asked one after the other, before the first is decided.
  std::vector<Asked> apart;
  int until = 0;
  for (Asked& asked : all) {
    if (!apart.empty() && asked.step < until && asked.step != apart.back().step) continue;
    until = std::max(until, asked.until);
    apart.push_back(std::move(asked));
  }
  return apart;
}

Answer as_asked(const Asked& asked, Answer answer) {
  const auto* one = std::get_if<OneChoice>(&answer);
  return asked.many && one != nullptr && one->choice >= 0 ? Answer(choices_of_bits(one->choice)) : answer;
}

bool answers(const Asked& asked, const Answer& answer) {
  const auto is_target = [&](Index handle) {
    return handle >= 0 && handle < asked.subject->size() &&
           (asked.stage_points.empty() || contains(asked.stage_points, handle));
  };
  const auto is_choice = [&](int i) { return i >= 0 && i < std::ssize(asked.choices); };
  const auto is_set_of = [](auto all, auto is_one) {
    std::sort(all.begin(), all.end());
    return std::all_of(all.begin(), all.end(), is_one) && std::adjacent_find(all.begin(), all.end()) == all.end();
  };
  return std::visit(
      ByKind{
          [](const Skipped&) { return true; },
          [&](const OneHandle& one) { return asked.on_stage && !asked.many && is_target(one.handle); },
          [&](const SeveralHandles& several) {
            return asked.on_stage && asked.many && !several.handles.empty() && is_set_of(several.handles, is_target);
          },
          [&](const OneChoice& one) { return !asked.ordered && !asked.many && is_choice(one.choice); },
          [&](const SeveralChoices& several) { return asked.many && is_set_of(several.choices, is_choice); },
          [&](const ChoicesInOrder& all) {
            return asked.ordered && all.choices.size() == asked.choices.size() && is_set_of(all.choices, is_choice);
          },
          [&](const TypedNumber& typed) { return asked.number && std::isfinite(typed.number); },
      },
      answer);
}

bool same_answer(const Asked& asked, const Answer& a, const Answer& b) {
  if (a.index() == b.index()) return a == b;
  const auto names = [&](const Answer& one, const Answer& other) {
    const auto* choice = std::get_if<OneChoice>(&one);
    const auto* handle = std::get_if<OneHandle>(&other);
    if (choice == nullptr || handle == nullptr || choice->choice >= std::ssize(asked.choice_handles)) return false;
    const std::vector<Index>& named = asked.choice_handles[choice->choice];
    return named.size() == 1 && named.front() == handle->handle;
  };
  return names(a, b) || names(b, a);
}

bool is_picked(const Asked& asked, const Answer& picked, int choice) {
  return same_answer(asked, picked, OneChoice{choice}) || contains(choices_of(picked), choice);
}

int place_in_order(const Answer& picked, int choice) {
  const auto* all = std::get_if<ChoicesInOrder>(&picked);
  if (all == nullptr) return 0;
  const auto at = std::find(all->choices.begin(), all->choices.end(), choice);
  return at == all->choices.end() ? 0 : static_cast<int>(at - all->choices.begin()) + 1;
}

bool names_handle(const Answer& picked, Index handle) {
  if (const auto* several = std::get_if<SeveralHandles>(&picked)) return contains(several->handles, handle);
  const auto* one = std::get_if<OneHandle>(&picked);
  return one != nullptr && one->handle == handle;
}

bool can_be_said(const Asked& asked, std::string_view answer) {
  if (asked.number) return typed_number(answer, asked.unit).has_value();
  if (asked.ordered) return false;  // only all of the choices can
  if (is_among(asked.choices, in_words_of(asked.dim, std::string(answer)))) return true;
  return asked.on_stage && handle_named(*asked.subject, answer).has_value();
}

/// Which way the right answer lies from a wrong one, where the lesson has no words for it.
static std::string way_to(const Asked& asked, const Answer& answer, const Truth& truth) {
  if (truth.pending) return {};
  if (is_right(answer, truth)) return {};
  if (const auto* typed = std::get_if<TypedNumber>(&answer))
    return typed->number < truth.number ? "That is too little." : "That is too much.";
  const auto* one = std::get_if<OneChoice>(&answer);
  if (one == nullptr || truth.choices.empty()) return {};
  return std::string(one->choice < truth.choices.front() ? asked.kind->before : asked.kind->after);
}

std::string meaning_of(const Asked& asked, const Answer& answer, const Truth& truth) {
  const auto choice_of = [&](const std::string& what) {
    const auto choice = std::find(asked.choices.begin(), asked.choices.end(), in_words_of(asked.dim, what));
    return static_cast<int>(choice - asked.choices.begin());
  };
  const auto handles_of = [&](int at) {
    return at < std::ssize(asked.choices) ? std::span<const Index>(asked.choice_handles[at]) : std::span<const Index>();
  };
  const auto is_given = [&](const std::string& what) {
    if (const auto* typed = std::get_if<TypedNumber>(&answer)) {
      const auto number = typed_number(what, asked.unit);
      return number && std::abs(*number - typed->number) <= truth.tolerance;
    }
    const int at = choice_of(what);
    const bool is_choice = at < std::ssize(asked.choices);
    const auto* tapped = std::get_if<OneHandle>(&answer);
    const bool is_tapped = tapped != nullptr && contains(handles_of(at), tapped->handle);
    if (is_tapped || (is_choice && is_picked(asked, answer, at))) return !contains(truth.choices, at);
    const auto handle = handle_named(*asked.subject, what);
    return handle && names_handle(answer, *handle) && !contains(truth.points, *handle);
  };
  // Words about handles, which a choice may name as well, are about where those stand: "P4 is far from the origin".
  const auto is_said = [&](const Meaning& meaning) {
    return asked.own_run || asked.number ||
           (handles_of(choice_of(meaning.answer)).empty() && !handle_named(*asked.subject, meaning.answer));
  };
  for (const Meaning& meaning : asked.question->meanings)
    if (!is_skipped(answer) && is_said(meaning) && is_given(meaning.answer))
      return in_words_of(asked.dim, meaning.says);
  return way_to(asked, answer, truth);
}

std::optional<double> typed_number(std::string_view text, std::string_view unit) {
  text = io::trim(text);
  if (!unit.empty() && text.ends_with(unit)) text = io::trim(text.substr(0, text.size() - unit.size()));
  constexpr std::string_view kMinus = "−";
  std::string plain;
  if (text.starts_with(kMinus)) plain = "-", text.remove_prefix(kMinus.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != ',') {
      plain += text[i];
      continue;
    }
    // A comma groups thousands, "1,839". "2,5" is no number: to some it is two and a half.
    const std::string_view three = text.substr(i + 1, 3), rest = text.substr(std::min(i + 4, text.size()));
    const bool digits = three.size() == 3 && three.find_first_not_of("0123456789") == std::string_view::npos;
    if (i == 0 || !digits || (!rest.empty() && rest.front() != ',' && rest.front() != '.')) return std::nullopt;
  }
  const auto value = io::parse_number(plain);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

bool has_second_try(const Asked& asked) {
  if (asked.step == Asked::kAnytime) return false;  // it is not decided yet
  if (asked.many || asked.ordered || asked.number) return true;
  if (!asked.choices.empty()) return asked.choices.size() > 2;
  return (asked.stage_points.empty() ? asked.subject->size() : static_cast<Index>(asked.stage_points.size())) > 2;
}

AnswerState answer_state_of(const Outcome* outcome) {
  if (outcome == nullptr || outcome->passed || outcome->pending) return AnswerState::kOpen;
  if (outcome->skipped) return AnswerState::kSkipped;
  return outcome->right ? AnswerState::kRight : AnswerState::kWrong;
}

void add_to(Tally& tally, const Outcome* outcome) {
  switch (answer_state_of(outcome)) {
    case AnswerState::kOpen: ++tally.open; break;
    case AnswerState::kRight: ++tally.right, tally.second += outcome->tries > 1; break;
    case AnswerState::kWrong: ++tally.wrong; break;
    case AnswerState::kSkipped: ++tally.skipped; break;
  }
}

Outcome judge(const Asked& asked, const Answer& given, const Run& run) {
  const Answer answer = as_asked(asked, given);
  const WithDecimals wished(asked.lesson->view.decimals);
  Truth truth = asked.kind->truth(asked, run);
  Outcome outcome;
  outcome.question = asked.question->id;
  outcome.given = answer;
  outcome.skipped = is_skipped(answer);
  outcome.tries = outcome.skipped ? 0 : 1;
  outcome.pending = truth.pending;
  outcome.from_step = asked.step;
  outcome.step = asked.until;
  outcome.because = asked.because;
  outcome.predicted = said_by(asked, answer, truth);
  outcome.right = !truth.pending && is_right(answer, truth);
  if (const std::string meaning = outcome.right ? std::string() : meaning_of(asked, answer, truth); !meaning.empty())
    outcome.because = meaning + " " + outcome.because;
  outcome.says = std::move(truth.sentence);
  if (!truth.pending) outcome.happened = std::move(truth.happened);
  return outcome;
}

bool has_tie(const Asked& asked, const Run& run) {
  const Truth truth = asked.kind->truth(asked, run);
  if (asked.many) return !truth.tied.empty();
  if (!truth.choices.empty()) return truth.choices.size() > 1 && truth.choices.size() < asked.choices.size();
  return truth.points.size() > 1 && truth.points.size() != asked.stage_points.size();
}

Answer model_answer(const Asked& asked, const Run& run) {
  const Truth truth = asked.kind->truth(asked, run);
  if (asked.many && asked.on_stage) {
    std::vector<Index> all = truth.points;
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return SeveralHandles{std::move(all)};
  }
  if (asked.many) {
    std::vector<int> all = truth.choices;
    std::sort(all.begin(), all.end());
    return SeveralChoices{std::move(all)};
  }
  // Less than a millionth of the tolerance is rounding, and is reported as 0.
  const bool nothing = std::abs(truth.number) < 1e-6 * truth.tolerance;
  if (asked.number) return TypedNumber{nothing ? 0 : truth.number};
  if (asked.ordered) return ChoicesInOrder{truth.choices};
  if (!truth.choices.empty()) return OneChoice{truth.choices.front()};
  return OneHandle{truth.points.empty() ? 0 : truth.points.front()};
}

}  // namespace snug::lesson
