// Reads an exercise's file: a lesson's, in which each question is a decision, or whose one task is built, and a table
// of its own.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "geometry/generate.hpp"
#include "lesson/exercise/exercise.hpp"
#include "lesson/names.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/subjects.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kMostDecisions = 100;
constexpr double kMostApart = 0.2;
constexpr std::int64_t kMostHarderPoints = 60;
constexpr std::size_t kMostSteps = 3;                       // to a bound
constexpr std::string_view kPreviousDecision = "decision";  // the value of "after"

/// The fewest and the most decisions of an instance.
std::pair<int, int> read_decisions(TomlTable& table) {
  const std::vector<double> range = table.numbers("decisions");
  const bool rises = range.size() == 2 && range[0] >= 1 && range[0] <= range[1] && range[1] <= kMostDecisions;
  if (!rises) table.wrong("decisions", "must be two numbers: the fewest, and the most, at most 100");
  return rises ? std::pair(static_cast<int>(range[0]), static_cast<int>(range[1])) : std::pair(1, 1);
}

Harder read_harder(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[exercise.harder]]", complaints);
  Harder harder;
  if (table.has("count")) harder.count = static_cast<int>(table.integer("count", 1, kMostHarderPoints));
  if (table.has("generate")) {
    harder.generate = table.text("generate");
    check_name(table, "generate", *harder.generate, generator_kinds());
  }
  if (table.has("apart")) {
    harder.apart = table.any_number("apart", 0);
    if (!(*harder.apart >= 0 && *harder.apart <= kMostApart)) table.wrong("apart", "must be from 0 to 0.2");
  }
  if (table.has("decisions")) harder.decisions = read_decisions(table);
  harder.ties = table.flag_or("ties", false);
  table.refuse_others();
  return harder;
}

void read_head(const toml::table& toml, Exercise& exercise, Complaints& complaints) {
  TomlTable table(toml, "[exercise]", complaints);
  exercise.lesson = table.text("lesson");
  if (exercise.build) {
    exercise.build->claim = table.text_or("claim", "");
    table.refuse_others();
    return;
  }
  const std::string told = table.text_or("told", "at once");
  check_name(table, "told", told, std::array<std::string_view, 2>{"at once", "at the end"});
  exercise.told_at_once = told != "at the end";
  exercise.apart = table.number("apart", kMostApart);
  std::tie(exercise.least, exercise.most) = read_decisions(table);
  for (const toml::table* one : table.tables("harder")) exercise.harder.push_back(read_harder(*one, complaints));
  table.refuse_others();
}

/// Reads what a question has in an exercise only, and takes it out, for the rest is read as a lesson's.
Decision read_decision(toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[question]]", complaints);
  Decision decision;
  decision.hint = table.text_or("hint", "");
  decision.least = static_cast<int>(table.integer_or("least", 0, kMostDecisions, 1));
  decision.most = static_cast<int>(table.integer_or("most", 1, kMostDecisions, kMostDecisions));
  decision.balanced = table.flag_or("balanced", false);
  decision.skip_ties = table.flag_or("skip_ties", false);
  if (decision.hint.empty()) complaints.add(table.place(), "[[question]] lacks the key \"hint\"");
  if (const toml::table* rules = table.table("rules"))
    for (const auto& [key, node] : *rules) {
      const auto* says = node.as_string();
      if (says == nullptr || says->get().empty()) table.wrong("rules", "must give each rule a text in quotes");
      else decision.rules.push_back({std::string(key.str()), says->get(), file_place(key.source())});
    }
  if (toml.contains("nth")) table.wrong("nth", "is not for exercises: a decision comes wherever the run has its step");
  decision.at_once = table.text_or("after", "") == kPreviousDecision;
  if (decision.at_once) toml.erase("after");
  for (const std::string_view key : {"hint", "least", "most", "rules", "nth", "skip_ties", "balanced"}) toml.erase(key);
  return decision;
}

/// The steps on the way to a requirement's bound.
std::vector<double> read_steps(toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[task.require]]", complaints);
  if (!table.has("steps")) return {};
  const std::vector<double> steps = table.numbers("steps");
  const bool rises = toml.contains("at_least");
  const double bound = table.any_number(rises ? "at_least" : "at_most", 0);
  const auto leads_on = [&](double one, double next) { return rises ? one < next : one > next; };
  bool sound = !steps.empty() && steps.size() <= kMostSteps && !toml.contains("goal") && !toml.contains("equals");
  for (std::size_t i = 0; i < steps.size(); ++i)
    sound = sound && leads_on(steps[i], i + 1 < steps.size() ? steps[i + 1] : bound);
  if (!sound) table.wrong("steps", "must be up to three numbers that lead to the bound, the easiest first");
  toml.erase("steps");
  return steps;
}

/// Reads what a task has in an exercise only, and takes it out.
Build read_build(toml::table& task, Complaints& complaints) {
  Build build;
  std::size_t most = 0;
  if (toml::array* due = task["require"].as_array())
    for (toml::node& one : *due)
      if (toml::table* table = one.as_table()) build.steps.push_back(read_steps(*table, complaints));
  for (const std::vector<double>& steps : build.steps) most = std::max(most, steps.size());
  for (const std::vector<double>& steps : build.steps)
    if (!steps.empty() && steps.size() != most)
      complaints.add(file_place(task), "each requirement with \"steps\" has as many of them");
  build.levels = static_cast<int>(most) + 1;
  if (!task.contains("model")) task.insert("model", std::string(kSearch));
  return build;
}

/// Checks that the step can be decided, and that there are such wrong rules.
void check_decision(const Question& question, const Decision& decision, const SubjectRow& subject,
                    Complaints& complaints) {
  std::vector<std::string_view> decided;
  const QuestionKind* kind = nullptr;
  for (const auto& [fact, one] : subject.question_kinds()) {
    if (fact != question.gate.fact || one->margin == nullptr) continue;
    decided.push_back(one->name);
    if (one->name == question.asks) kind = one;
  }
  if (const QuestionKind* general = general_question_kind(question.asks, subject);
      general != nullptr && general->margin != nullptr)
    kind = general;
  if (kind == nullptr)
    return complaints.add(question.place, "an exercise cannot ask " + question.asks + " of " + question.gate.fact +
                                              (decided.empty() ? "" : ", only " + one_of(decided)));
  std::vector<std::string_view> names;
  for (const WrongRule& rule : kind->rules) names.push_back(rule.name);
  for (const RuleWords& rule : decision.rules)
    if (!is_among(names, rule.name)) complaints.add(rule.place, "\"rules\" " + none_of_text(rule.name, names));
}

void read(toml::table& toml, std::string_view name, Exercise& exercise, Complaints& complaints) {
  if (toml::array* tasks = toml["task"].as_array(); tasks != nullptr && !tasks->empty()) {
    if (toml::table* task = tasks->front().as_table()) exercise.build = read_build(*task, complaints);
    if (tasks->size() > 1 || toml.contains("question"))
      complaints.add(file_place(*tasks), "an exercise has one [[task]], or questions");
  }
  if (const toml::table* own = toml["exercise"].as_table()) read_head(*own, exercise, complaints);
  else complaints.add({}, "the exercise lacks [exercise]");
  toml.erase("exercise");
  if (toml::array* questions = toml["question"].as_array())
    for (toml::node& one : *questions)
      if (toml::table* question = one.as_table()) exercise.decisions.push_back(read_decision(*question, complaints));
  if (exercise.decisions.empty() && !exercise.build)
    complaints.add({}, "the exercise has no [[question]], and no [[task]]");
  if (!toml.contains("covers")) toml.insert("covers", toml::array());
  std::optional<Lesson> stage = read_as_written(toml, name, complaints);
  if (!stage || complaints.count() > 0) return;
  exercise.stage = *std::move(stage);
  for (const Harder& harder : exercise.harder)
    if ((harder.count || harder.generate) && exercise.stage.points.generate.empty())
      complaints.add({}, "[[exercise.harder]] has \"count\" or \"generate\" only where [points] generates them");
  if (std::ssize(exercise.harder) > kMostLevels) complaints.add({}, "there are at most 9 [[exercise.harder]]");
  for (std::size_t i = 0; i < exercise.decisions.size(); ++i)
    check_decision(exercise.stage.questions[i], exercise.decisions[i], *exercise.stage.subject, complaints);
}

}  // namespace

std::string_view Exercise::kind() const {
  if (build) return build->claim.empty() ? "build" : "break_it";
  const auto all_ask = [&](auto... asks) {
    return std::all_of(stage.questions.begin(), stage.questions.end(),
                       [&](const Question& one) { return ((one.asks == asks) || ...); });
  };
  if (all_ask("number", "radius_b")) return "number";
  return all_ask("sequence", "tightest_order", "cheapest_order", "loose_box", "rebuilt_box", "climbed_box",
                 "rotated_box")
             ? "order"
             : "carry_out";
}

Exercise at_level(const Exercise& exercise, int level) {
  Exercise own = exercise;
  own.level = std::clamp(level, 0, static_cast<int>(exercise.harder.size()));
  for (int i = 0; i < own.level; ++i) {
    const Harder& harder = exercise.harder[i];
    if (harder.count) own.stage.points.count = *harder.count;
    if (harder.generate) own.stage.points.generate = *harder.generate;
    if (harder.apart) own.apart = *harder.apart;
    own.ties = own.ties || harder.ties;
    if (harder.decisions) std::tie(own.least, own.most) = *harder.decisions;
  }
  return own;
}

ExerciseDraft read_exercise(std::string_view text, std::string_view name) {
  Complaints complaints(name);
  ExerciseDraft draft;
  draft.exercise.id = id_of(name);
  draft.exercise.hash = hash_of_text(text);
  if (auto toml = parse_file(text, "an exercise", complaints)) read(*toml, name, draft.exercise, complaints);
  draft.mistakes = complaints.mistakes();
  return draft;
}

}  // namespace snug::lesson
