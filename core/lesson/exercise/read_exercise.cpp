// Reads an exercise's file: a lesson's, in which each question is a decision, and a table of its own.
#include <algorithm>
#include <array>
#include <utility>

#include "lesson/exercise/exercise.hpp"
#include "lesson/names.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/subjects.hpp"
#include "lesson/toml_file.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kMostDecisions = 100;
constexpr double kMostApart = 0.2;
constexpr std::string_view kPreviousDecision = "decision";  // the value of "after"

std::uint64_t hash_of(std::string_view text) {
  Fnv1a hash;
  for (const char c : text) hash.add_bits(static_cast<unsigned char>(c));
  return hash.value();
}

void read_head(const toml::table& toml, Exercise& exercise, Complaints& complaints) {
  TomlTable table(toml, "[exercise]", complaints);
  exercise.lesson = table.text("lesson");
  const std::string told = table.text_or("told", "at once");
  check_name(table, "told", told, std::array<std::string_view, 2>{"at once", "at the end"});
  exercise.told_at_once = told != "at the end";
  exercise.apart = table.number("apart", kMostApart);
  const std::vector<double> range = table.numbers("decisions");
  const bool rises = range.size() == 2 && range[0] >= 1 && range[0] <= range[1] && range[1] <= kMostDecisions;
  if (!rises) table.wrong("decisions", "must be two numbers: the fewest, and the most, at most 100");
  else exercise.least = static_cast<int>(range[0]), exercise.most = static_cast<int>(range[1]);
  table.refuse_others();
}

/// Reads what a question has in an exercise only, and takes it out, for the rest is read as a lesson's.
Decision read_decision(toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[question]]", complaints);
  Decision decision;
  decision.hint = table.text_or("hint", "");
  decision.least = static_cast<int>(table.integer_or("least", 0, kMostDecisions, 1));
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
  for (const std::string_view key : {"hint", "least", "rules", "nth", "skip_ties", "balanced"}) toml.erase(key);
  return decision;
}

/// Checks that the step can be decided, and that there are such wrong rules.
void check_decision(const Question& question, const Decision& decision, const SubjectRow& subject,
                    Complaints& complaints) {
  std::vector<std::string_view> decided;
  const Asking* asking = nullptr;
  for (const auto& [fact, one] : subject.askings()) {
    if (fact != question.gate.fact || one->margin == nullptr) continue;
    decided.push_back(one->name);
    if (one->name == question.asks) asking = one;
  }
  if (const Asking* general = general_asking(question.asks, subject); general != nullptr && general->margin != nullptr)
    asking = general;
  if (asking == nullptr)
    return complaints.add(question.place, "an exercise cannot ask " + question.asks + " of " + question.gate.fact +
                                              (decided.empty() ? "" : ", only " + one_of(decided)));
  std::vector<std::string_view> names;
  for (const WrongRule& rule : asking->rules) names.push_back(rule.name);
  for (const RuleWords& rule : decision.rules)
    if (!is_among(names, rule.name)) complaints.add(rule.place, "\"rules\" " + none_of_text(rule.name, names));
}

void read(toml::table& toml, std::string_view name, Exercise& exercise, Complaints& complaints) {
  if (const toml::table* own = toml["exercise"].as_table()) read_head(*own, exercise, complaints);
  else complaints.add({}, "the exercise lacks [exercise]");
  toml.erase("exercise");
  if (toml::array* questions = toml["question"].as_array())
    for (toml::node& one : *questions)
      if (toml::table* question = one.as_table()) exercise.decisions.push_back(read_decision(*question, complaints));
  if (exercise.decisions.empty()) complaints.add({}, "the exercise has no [[question]]");
  if (!toml.contains("covers")) toml.insert("covers", toml::array());
  std::optional<Lesson> stage = read_as_written(toml, name, complaints);
  if (!stage || complaints.count() > 0) return;
  exercise.stage = *std::move(stage);
  for (std::size_t i = 0; i < exercise.decisions.size(); ++i)
    check_decision(exercise.stage.questions[i], exercise.decisions[i], *exercise.stage.subject, complaints);
}

}  // namespace

ExerciseDraft read_exercise(std::string_view text, std::string_view name) {
  Complaints complaints(name);
  ExerciseDraft draft;
  draft.exercise.id = id_of(name);
  draft.exercise.hash = hash_of(text);
  if (auto toml = parse_file(text, "an exercise", complaints)) read(*toml, name, draft.exercise, complaints);
  draft.mistakes = complaints.mistakes();
  return draft;
}

}  // namespace snug::lesson
