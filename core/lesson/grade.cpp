#include "lesson/grade.hpp"

#include <cmath>

#include "fit/catalogue.hpp"
#include "lesson/ask.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kPointsFigure = "points";  // how many there are, of whatever stands on the stage
constexpr double kInfinite = std::numeric_limits<double>::infinity(), kNone = std::numeric_limits<double>::quiet_NaN();

std::string due_text(const Requirement& due, const Figure& figure) {
  const std::string& unit = figure.unit;
  const std::string must = figure.key == kPointsFigure ? "there must be " : "it must be ";
  if (due.at_least == due.at_most && due.at_least >= 0 && due.at_least < static_cast<double>(figure.names.size()))
    return must + std::string(figure.names[static_cast<std::size_t>(due.at_least)]);
  if (due.at_least == due.at_most) return must + bound_text(due.at_least, unit);
  if (due.at_most == kInfinite) return must + "at least " + bound_text(due.at_least, unit);
  if (due.at_least == -kInfinite) return must + "at most " + bound_text(due.at_most, unit);
  return must + "from " + bound_text(due.at_least, unit) + " to " + bound_text(due.at_most, unit);
}

/// A value that misses its bound, with enough digits not to look as if it had reached it.
std::string missed_text(const Figure& figure, double bound) {
  const std::string text = without_plus(figure.text);
  if (typed_number(text, figure.unit) != bound) return text;
  return number_texts_apart(figure.value, bound).first + (figure.unit.empty() ? "" : " " + figure.unit);
}

/// How much larger an algorithm's result is than that of another.
std::optional<Figure> excess_over(const Requirement& due, const Method& method, const Lesson& lesson,
                                  const Subject& subject, const View& view) {
  const Method& other = *find_method(lesson, due.over);
  const bool by_measure = method.volume != other.volume;
  const auto size = [&](const Method& of) { return subject.result_size(of, by_measure, view); };
  const std::optional<double> own = size(method), than = size(other);
  if (!own || !than) return std::nullopt;
  const auto excess = excess_of(*own, *than);
  if (!excess) return std::nullopt;
  return Figure{"Excess over " + title_in(lesson, other), "excess", percent_text(*excess), 100 * *excess, "%"};
}

std::optional<Figure> figure_of(const Requirement& due, const Method& method, const Lesson& lesson,
                                const Subject& subject, const View& view) {
  if (!due.over.empty()) return excess_over(due, method, lesson, subject, view);
  if (due.figure == kPointsFigure && subject.points() != nullptr) {
    const auto count = static_cast<double>(fit::count_of(*subject.points()));
    return Figure{"Points", std::string(kPointsFigure), bound_text(count, "points"), count, "points"};
  }
  for (Figure& figure : subject.results(method, view))
    if (figure.key == due.figure) return std::move(figure);
  return std::nullopt;
}

std::string no_figure_text(const Requirement& due, const Method& method, const Subject& subject, const View& view) {
  std::vector<std::string> keys;
  for (const Figure& figure : subject.results(method, view)) keys.push_back(figure.key);
  return "\"figure\" " + (keys.empty() ? "is not there: it has none" : none_of_text(due.figure, keys));
}

void read_bounds_of(TomlTable& table, Requirement& requirement) {
  if (table.has("equals")) {
    requirement.at_least = requirement.at_most = table.any_number("equals", 0);
  } else if (table.has("at_least") || table.has("at_most")) {
    requirement.at_least = table.any_number("at_least", requirement.at_least);
    requirement.at_most = table.any_number("at_most", requirement.at_most);
  } else {
    table.lack("at_least", "[[require]] needs \"at_least\", \"at_most\" or \"equals\"");
  }
  if (!(requirement.at_least <= requirement.at_most))
    table.wrong(table.has("at_most") ? "at_most" : "at_least", "leaves no number between its bounds");
}

/// Reads the lesson's name of an algorithm, of those that the subject has.
std::string read_method(TomlTable& table, std::string_view key, const Lesson& lesson) {
  const std::string name = table.text_or(key, "");
  if (name.empty()) return name;
  if (const Method* method = find_method(lesson, name)) return name_in(lesson, *method);
  const std::string own = lesson.volume + "/";  // which may be left out
  check_name(table, key, name.starts_with(own) ? name.substr(own.size()) : name, lesson.algorithms);
  return {};
}

Requirement read_requirement(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[require]]", complaints);
  Requirement requirement;
  requirement.place = table.place_of(table.has("goal") ? "goal" : "figure");
  const auto goals = lesson.subject->goals;
  if (table.has("goal")) {
    for (const std::string_view key : {"figure", "algorithm", "over", "at_least", "at_most", "equals"}) {
      if (table.has(key)) table.wrong("goal", "stands alone, and here stands \"" + std::string(key) + "\" as well");
      table.allow(key);
    }
    requirement.goal = table.text("goal");
    if (goals.empty()) table.wrong("goal", "is none: such a lesson has figures alone");
    else check_name(table, "goal", requirement.goal, goals);
  } else {
    requirement.figure = table.text("figure");
    requirement.algorithm = read_method(table, "algorithm", lesson);
    requirement.over = read_method(table, "over", lesson);
    if (!requirement.over.empty() && requirement.figure != "excess") table.wrong("over", "is for the figure excess");
    read_bounds_of(table, requirement);
  }
  table.refuse_others();
  return requirement;
}

}  // namespace

std::string bound_text(double bound, const std::string& unit) {
  if (unit.empty()) return plain_number(bound);
  const bool one = bound == 1 && unit.ends_with('s');
  return plain_number(bound) + " " + (one ? unit.substr(0, unit.size() - 1) : unit);
}

std::vector<Requirement> read_requirements(TomlTable& table, const Lesson& lesson, Complaints& complaints) {
  std::vector<Requirement> all;
  for (const toml::table* one : table.tables("require")) {
    const std::size_t before = complaints.count();
    Requirement requirement = read_requirement(*one, lesson, complaints);
    if (complaints.count() == before) all.push_back(std::move(requirement));
  }
  return all;
}

Judged judge_requirement(const Requirement& due, const Lesson& lesson, std::string_view algorithm,
                         const Subject& subject, const View& view) {
  if (const HasGoals* const goals = subject.goals(); !due.goal.empty() && goals != nullptr)
    return {goals->reaches(due.goal), 0, {}, goals->goal_says(due.goal)};
  const Method& method = *find_method(lesson, due.algorithm.empty() ? algorithm : std::string_view(due.algorithm));
  if (const std::string refusal = subject.refusal(method); !refusal.empty())
    return {false, kNone, {}, refusal + ".", false};
  const auto figure = figure_of(due, method, lesson, subject, view);
  if (!figure)
    return {false, kNone, {}, title_in(lesson, method) + ": " + no_figure_text(due, method, subject, view), false};
  std::string says = figure->name;
  if (!due.algorithm.empty() && due.algorithm != algorithm) says += " (" + title_in(lesson, method) + ")";
  if (!figure->known) return {false, kNone, {}, says + ": none now; " + due_text(due, *figure) + "."};
  const bool low = figure->value<due.at_least, high = figure->value> due.at_most;
  if (!low && !high) return {true, figure->value, figure->unit, says + ": " + without_plus(figure->text) + "."};
  says += ": " + missed_text(*figure, low ? due.at_least : due.at_most) + "; " + due_text(due, *figure) + ".";
  return {false, figure->value, figure->unit, says};
}

Grade grade_by_requirements(const Lesson& lesson, const Task& task, const Subject& subject, const View& view) {
  Grade grade;
  grade.done = true;
  if (subject.points() != nullptr) {
    grade.points = static_cast<int>(fit::count_of(*subject.points()));
    grade.done = task.points == 0 || grade.points == task.points;
    const auto words = subject.handle_words();
    if (!grade.done)
      grade.says = "There " + std::string(grade.points == 1 ? "is " : "are ") + std::to_string(grade.points) + " " +
                   std::string(words[grade.points == 1 ? 0 : 1]) + "; the task is for " + std::to_string(task.points) +
                   ".";
  }
  if (!grade.done) return grade;
  for (const Requirement& due : task.conditions) {
    const Judged judged = judge_requirement(due, lesson, task.algorithm, subject, view);
    grade.done = grade.done && judged.met;
    if (due.figure == "excess") grade.excess = judged.value / 100;
    grade.says += (grade.says.empty() ? "" : " ") + judged.says;
  }
  if (grade.done) grade.says += " Done.";
  return grade;
}

}  // namespace snug::lesson
