// "Make it fail" or "construct it", graded on the points as they stand.
#include <array>
#include <cmath>
#include <cstdio>

#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

std::string points_text(int n) { return count_text(n) + (n == 1 ? " point" : " points"); }

/// Rounded as in the inspector, without the sign: "9.9 %".
std::string plain_percent(double excess) {
  const std::string text = percent_text(excess);
  return text.front() == '+' ? text.substr(1) : text;
}

/// "9.96 %", rounded down, so that a value below the goal does not look as if it had reached it.
std::string closer_percent(double excess) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f %%", std::floor(10000 * excess) / 100);
  return text.data();
}

/// The sentence about the excess: what is reached, and what is required.
std::string excess_sentence(const CloudTask& task, const fit::Algorithm& algorithm, double excess, int dim) {
  const bool done = excess >= task.excess_at_least;
  const std::string asked_for = plain_percent(task.excess_at_least);
  std::string reached = plain_percent(excess);
  if (!done && reached == asked_for) reached = closer_percent(excess);
  reached = std::string(algorithm.title) + ": its " + std::string(volume_word(algorithm.volume, dim)) + " is " +
            reached + " larger than the smallest";
  return done ? reached + "." : reached + "; it must be at least " + asked_for + ".";
}

std::string support_sentence(const CloudTask& task, int support, int dim) {
  const std::string held =
      points_text(support) + (support == 1 ? " supports" : " support") + " the smallest " + ball_word(dim);
  if (support == task.support_size) return held + ".";
  return held + "; it must be " + std::to_string(task.support_size) + ".";
}

}  // namespace

void read_cloud_task(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto terms = std::make_shared<CloudTask>();
  Task& task = *lesson.task;
  task.points = static_cast<int>(table.integer("points", 1, 1000));
  const Method* method = find_method(lesson, task.algorithm);
  if (method != nullptr && fit::exact_algorithm(method->volume) == nullptr)
    complaints.add(table.place(),
                   "[task] cannot be graded: no algorithm finds the smallest " + std::string(method->volume));
  if (!table.has("excess_at_least") && !table.has("support_size"))
    complaints.add(table.place(), "[task] needs \"excess_at_least\" or \"support_size\"");
  if (table.has("excess_at_least")) terms->excess_at_least = table.number("excess_at_least", 1);
  if (table.has("support_size"))
    terms->support_size = static_cast<int>(table.integer("support_size", 1, lesson.points.dim + 1));
  task.model = table.points("model", lesson.points.dim);
  task.terms = std::move(terms);
}

void check_cloud_task(const Lesson& lesson, const toml::table& toml, const Subject& own, Complaints& complaints) {
  if (!lesson.task) return;
  const TomlTable task(*toml.get_as<toml::table>("task"), "[task]", complaints);
  const std::size_t before = complaints.count();
  const auto model = check_point_task(lesson, *own.points(), task, complaints);
  if (grade_points(lesson, start_of_task(lesson, *own.points()), lesson.seed).done)
    complaints.add(task.place(), "the task is solved before the student begins");
  if (!model || complaints.count() > before) return;
  const Grade graded = grade_points(lesson, *model, lesson.seed);
  if (!graded.done) complaints.add(task.place_of("model"), "the model does not solve the task: " + graded.says);
}

Grade grade_points(const Lesson& lesson, const AnyPointSet& points, std::uint64_t seed) {
  const auto& task = static_cast<const CloudTask&>(*lesson.task->terms);
  const fit::Algorithm& algorithm = algorithm_of(*find_method(lesson, lesson.task->algorithm));
  const fit::Algorithm& smallest = *fit::exact_algorithm(algorithm.volume);  // read_lesson refuses a task without one
  const int dim = fit::dim_of(points);
  Grade grade;
  grade.points = static_cast<int>(fit::size_of(points));
  for (const fit::Algorithm* run : {&algorithm, &smallest}) {
    if (grade.points <= run->max_points) continue;
    grade.says = std::string(run->title) + " takes at most " + points_text(run->max_points) + ".";
    return grade;
  }
  const fit::Result best = smallest.fit(points, {.seed = seed});
  grade.support = static_cast<int>(best.support.size());
  const double own = fit::size_of(algorithm.fit(points, {.seed = seed}).volume, dim);
  grade.excess = excess_of(own, fit::size_of(best.volume, dim)).value_or(0);

  const bool count = grade.points == lesson.task->points;
  const bool large = task.excess_at_least <= 0 || grade.excess >= task.excess_at_least;
  const bool held = task.support_size == 0 || grade.support == task.support_size;
  grade.done = count && large && held;
  if (!count)
    grade.says =
        "There are " + points_text(grade.points) + "; the task is for " + std::to_string(lesson.task->points) + ". ";
  if (task.excess_at_least > 0) grade.says += excess_sentence(task, algorithm, grade.excess, dim) + " ";
  if (task.support_size != 0) grade.says += support_sentence(task, grade.support, dim) + " ";
  grade.says += grade.done ? "Done." : "";
  while (!grade.says.empty() && grade.says.back() == ' ') grade.says.pop_back();
  return grade;
}

}  // namespace snug::lesson
