#include "check/warn_answers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>

#include "geometry/sort.hpp"
#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"

namespace snug::check {
namespace {

/// What the run says of a question with fixed choices.
struct Told {
  std::vector<int> right;  // the choices
  std::string says;        // the answer: "P7"
  std::string asks;        // what works it out: "point"
};

bool speaks_of(const Asked& asked, std::string_view words) {
  return io::lower_case(asked.question->prompt).find(io::lower_case(words)) != std::string::npos;
}

/// Where the choices are handles: those that the step is about.
std::optional<Told> told_by_handles(const Asked& asked, const Run& run) {
  const std::vector<Index> about = run.handles(asked.fact);
  Told told{{}, asked.names(about), about.size() > 1 ? "points" : "point"};
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const auto handle = handle_named(*asked.subject, asked.choices[i]);
    if (!handle) return std::nullopt;
    if (std::find(about.begin(), about.end(), *handle) != about.end()) told.right.push_back(static_cast<int>(i));
  }
  if (told.right.empty()) return std::nullopt;  // they are about something else
  return told;
}

/// What a choice may call an algorithm: by its title, by its name, or by its volume, where no other is of that.
bool names_method(std::string_view choice, const Lesson& lesson, const Method& method) {
  std::string said = io::lower_case(choice);
  if (said.starts_with("the ")) said.erase(0, 4);
  const std::string volume(method.volume), name(method.name);
  const auto is_of_volume = [&](const std::string& algorithm) {
    return find_method(lesson, algorithm)->volume == method.volume;
  };
  const bool alone = std::count_if(lesson.algorithms.begin(), lesson.algorithms.end(), is_of_volume) == 1;
  return said == io::lower_case(title_in(lesson, method)) || said == io::lower_case(method.title) || said == name ||
         said == volume + '/' + name || (alone && (said == volume || (said == "k-dop" && volume == "kdop")));
}

bool speaks_of_any(const Asked& asked, auto words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view one) { return speaks_of(asked, one); });
}

/// Where the choices are algorithms: the tightest or the cheapest of them.
std::optional<Told> told_by_methods(const Asked& asked, const Run& run) {
  constexpr std::array<std::string_view, 5> kTight{"tight", "smallest", "wins", "fits best", "best fit"};
  constexpr std::array<std::string_view, 2> kCheap{"cheap", "fewest operations"};
  if (!asked.lesson->subject->compares) return std::nullopt;
  const bool tight = speaks_of_any(asked, kTight);
  if (tight == speaks_of_any(asked, kCheap)) return std::nullopt;
  const QuestionKind& kind = *general_question_kind(tight ? "tightest" : "cheapest", *asked.lesson->subject);
  Asked worked = asked;
  worked.choices.clear();
  if (kind.offer(worked, run) != nullptr) return std::nullopt;
  const Truth truth = kind.truth(worked, run);
  Told told{{}, truth.happened, std::string(kind.name)};
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const Method* meant = nullptr;
    for (const std::string& name : asked.lesson->algorithms)
      if (const Method* one = find_method(*asked.lesson, name); names_method(asked.choices[i], *asked.lesson, *one))
        meant = one;
    if (meant == nullptr) return std::nullopt;
    const auto own = std::find(worked.choices.begin(), worked.choices.end(), title_in(*asked.lesson, *meant));
    if (own == worked.choices.end()) return std::nullopt;
    const int choice = static_cast<int>(own - worked.choices.begin());
    if (std::find(truth.choices.begin(), truth.choices.end(), choice) != truth.choices.end())
      told.right.push_back(static_cast<int>(i));
  }
  return told;
}

std::vector<std::string> in_alphabet(std::vector<std::string> words) {
  for (std::string& word : words) word = io::lower_case(word);
  sort_stably(words);
  return words;
}

/// Whether a prompt asks what the step is asked by that name: "separates" in "Does this axis separate them?", and not
/// in "Does any axis separate them?", which is about more than the step.
bool asks_the_same(const Asked& asked, std::string_view kind) {
  constexpr std::array<std::string_view, 7> kOther{" any", " some", "not ", "n't", "always", "ever ", " would"};
  const std::string_view stem = kind.substr(0, kind.size() - (kind.ends_with('s') ? 1 : 0));
  return speaks_of(asked, stem) && !speaks_of_any(asked, kOther);
}

/// Where the choices are those of something that the step can be asked: "inside", "intersecting", "outside".
std::optional<Told> told_by_step(const Asked& asked, const Run& run) {
  constexpr std::array<std::string_view, 5> kBeyond{"really", "truly", "should", "would", "in truth"};
  if (speaks_of_any(asked, kBeyond)) return std::nullopt;  // a wrong test's own verdict is not what is asked
  const std::vector<std::string> own = in_alphabet(asked.choices);
  const bool yes_no = own == std::vector<std::string>{"no", "yes"};
  for (const QuestionKind& kind : run.question_kinds(asked.fact)) {
    if (kind.read != nullptr || (yes_no && !asks_the_same(asked, kind.name))) continue;
    Asked worked = asked;
    worked.choices.clear(), worked.choice_handles.clear();
    if (kind.offer(worked, run) != nullptr || worked.many || in_alphabet(worked.choices) != own) continue;
    const Truth truth = kind.truth(worked, run);
    Told told{{}, truth.happened, std::string(kind.name)};
    for (const int right : truth.choices)
      for (std::size_t i = 0; i < asked.choices.size(); ++i)
        if (io::lower_case(asked.choices[i]) == io::lower_case(worked.choices[right]))
          told.right.push_back(static_cast<int>(i));
    return told;
  }
  return std::nullopt;
}

/// Half of a number's last digit, as it is written: 0.005 for "1.25".
double rounding_of(std::string_view number) {
  const std::size_t point = number.find('.');
  std::size_t decimals = 0;
  if (point != std::string_view::npos)
    while (point + 1 + decimals < number.size() &&
           std::isdigit(static_cast<unsigned char>(number[point + 1 + decimals])) != 0)
      ++decimals;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
}

/// The numbers that a choice means: "2.05 units", or a range, "at most 10 %", "10 to 40 %", "more than 40 %".
std::optional<std::array<double, 2>> range_of(std::string_view choice, std::string_view unit) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  constexpr std::array<std::string_view, 5> kBelow{"at most ", "less than ", "below ", "under ", "up to "};
  constexpr std::array<std::string_view, 4> kAbove{"at least ", "more than ", "above ", "over "};
  using Range = std::array<double, 2>;
  const std::string lower = io::lower_case(choice);
  const std::string_view said = lower;
  const auto number_behind = [&](const auto& words) -> std::optional<double> {
    for (const std::string_view word : words)
      if (said.starts_with(word)) return typed_number(said.substr(word.size()), unit);
    return std::nullopt;
  };
  if (const auto most = number_behind(kBelow)) return Range{-kInfinite, *most};
  if (const auto least = number_behind(kAbove)) return Range{*least, kInfinite};
  if (const std::size_t to = said.find(" to "); to != std::string_view::npos) {
    const auto least = typed_number(said.substr(0, to), unit), most = typed_number(said.substr(to + 4), unit);
    if (least && most) return Range{*least, *most};
  }
  const auto value = typed_number(choice, unit);
  if (!value) return std::nullopt;
  return Range{*value - rounding_of(choice), *value + rounding_of(choice)};
}

/// Where the choices are numbers or ranges: those of the figure that the prompt names, by its key only if they have its
/// unit.
std::optional<Told> told_by_figure(const Asked& asked, const Run& run) {
  const View view{{Slot{find_method(*asked.lesson, asked.question->gate.algorithm), &run}, Slot{}}, 0, asked.until};
  for (const Figure& figure : asked.subject->figures(view)) {
    const auto has_unit = [&](const std::string& choice) { return choice.ends_with(figure.unit); };
    const bool by_key = !figure.unit.empty() && speaks_of(asked, figure.key) &&
                        std::all_of(asked.choices.begin(), asked.choices.end(), has_unit);
    if (!figure.known || (!by_key && !speaks_of(asked, figure.name))) continue;
    Told told{{}, figure.text, "figure"};
    for (std::size_t i = 0; i < asked.choices.size(); ++i) {
      const auto range = range_of(asked.choices[i], figure.unit);
      if (!range) return std::nullopt;
      if ((*range)[0] <= figure.value && figure.value <= (*range)[1]) told.right.push_back(static_cast<int>(i));
    }
    return told;
  }
  return std::nullopt;
}

/// What the run says of a fixed answer; none where it cannot tell.
std::optional<Told> told_of(const Asked& asked, const Run& run) {
  if (asked.question->asks != "choice" || asked.step == Asked::kAnytime) return std::nullopt;
  std::optional<Told> told = told_by_handles(asked, run);
  if (!told) told = told_by_methods(asked, run);
  if (!told) told = told_by_step(asked, run);
  if (!told) told = told_by_figure(asked, run);
  return told;
}

bool is_false(const Asked& asked, const Told& told) {
  return std::find(told.right.begin(), told.right.end(), asked.question->answer) == told.right.end();
}

/// A wrong answer, or one wrong part of an answer of several.
struct Wrong {
  std::string says;
  bool told;  // whether the lesson or the program has words for it
};

/// Where more are wrong than kMostTold, kLeastTold of them need a reason: those that the usual mistakes lead to.
constexpr std::size_t kMostTold = 8, kLeastTold = 2;

/// Where handles answer, a choice is another name of one or of several.
std::vector<Wrong> wrong_answers(Asked asked, const Run& run) {
  asked.own_run = true;
  const Truth truth = asked.kind->truth(asked, run);
  std::vector<Wrong> wrong;
  const auto see = [&](const auto& right, int one, std::string says, const Answer& answer) {
    if (std::find(right.begin(), right.end(), one) == right.end())
      wrong.push_back({std::move(says), !meaning_of(asked, answer, truth).empty()});
  };
  for (int i = 0; i < static_cast<int>(asked.choices.size()); ++i)
    see(truth.choices, i, asked.choices[i], asked.many ? Answer(SeveralChoices{{i}}) : OneChoice{i});
  if (!asked.choices.empty()) return wrong;
  const auto see_handle = [&](Index i) {
    see(truth.points, i, asked.subject->name_of(i), asked.many ? Answer(SeveralHandles{{i}}) : OneHandle{i});
  };
  for (const Index i : asked.stage_points) see_handle(i);
  for (Index i = 0; asked.stage_points.empty() && i < asked.subject->size(); ++i) see_handle(i);
  return wrong;
}

}  // namespace

std::optional<std::string> contradiction(const Asked& asked, const Run& run) {
  const std::optional<Told> told = told_of(asked, run);
  return told && is_false(asked, *told) ? std::optional(told->says) : std::nullopt;
}

void warn_of_answer(const Asked& asked, const Run& run, Complaints& complaints) {
  const std::optional<Told> told = told_of(asked, run);
  if (!told) return;
  const std::string better = "; asks = \"" + told->asks + "\" works it out from the run";
  const std::string& answer = asked.choices[asked.question->answer];
  if (is_false(asked, *told))
    complaints.warn(asked.question->place,
                    "the run contradicts the answer \"" + answer + "\": it is " + told->says + better);
  else if (asked.question->holds == Holds::kAlways && asked.question->conditions.empty())
    complaints.warn(asked.question->place, "the answer \"" + answer +
                                               "\" is true only of the lesson's own stage, and needs holds = \"here\"" +
                                               better);
}

void warn_of_reasons(const Question& question, Complaints& complaints) {
  if (question.asks != "choice") return;
  std::vector<std::string> without;
  for (std::size_t i = 0; i < question.choices.size(); ++i) {
    const auto speaks = [&](const Meaning& meaning) { return meaning.answer == question.choices[i]; };
    if (static_cast<int>(i) != question.answer &&
        std::none_of(question.meanings.begin(), question.meanings.end(), speaks))
      without.push_back('"' + question.choices[i] + '"');
  }
  if (!without.empty()) complaints.warn(question.place, "\"wrong\" has no reason for " + listed(without, ", "));
}

void warn_of_reasons(const Asked& asked, const Run& run, Complaints& complaints) {
  if (asked.question->asks == "choice" || asked.ordered || asked.number || !has_second_try(asked)) return;
  const std::vector<Wrong> wrong = wrong_answers(asked, run);
  std::vector<std::string> without;
  for (const Wrong& one : wrong)
    if (!one.told) without.push_back('"' + one.says + '"');
  const std::size_t told = wrong.size() - without.size();
  if (without.empty() || (wrong.size() > kMostTold && told >= kLeastTold)) return;
  const std::string of_many = wrong.size() <= kMostTold ? "" : told == 0 ? "two of " : "one more of ";
  complaints.warn(asked.question->place, "\"wrong\" has no reason for " + of_many + listed(without, ", "));
}

}  // namespace snug::check
