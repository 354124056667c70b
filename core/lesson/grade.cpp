#include "lesson/grade.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "fit/catalogue.hpp"
#include "lesson/figures.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

std::string points_text(int n) { return std::to_string(n) + (n == 1 ? " point" : " points"); }

/// As the inspector rounds it, without the sign: "9.9 %".
std::string plain_percent(double excess) {
  const std::string text = percent_text(excess);
  return text.front() == '+' ? text.substr(1) : text;
}

/// "9.96 %", rounded down: what is not reached does not look as if it were.
std::string closer_percent(double excess) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f %%", std::floor(10000 * excess) / 100);
  return text.data();
}

/// What is reached of a measure, and what is asked for.
std::string excess_sentence(const Task& task, const fit::Algorithm& algorithm, double excess, int dim) {
  const bool done = excess >= task.excess_at_least;
  const std::string asked_for = plain_percent(task.excess_at_least);
  std::string reached = plain_percent(excess);
  if (!done && reached == asked_for) reached = closer_percent(excess);
  reached = std::string(algorithm.title) + ": its " + std::string(volume_word(algorithm.volume, dim)) + " is " +
            reached + " larger than the smallest";
  return done ? reached + "." : reached + "; at least " + asked_for + " is asked for.";
}

std::string support_sentence(const Task& task, int support, int dim) {
  const std::string held =
      points_text(support) + (support == 1 ? " supports" : " support") + " the smallest " + ball_word(dim);
  if (support == task.support_size) return held + ".";
  return held + "; it must be " + std::to_string(task.support_size) + ".";
}

}  // namespace

Grade grade(const Task& task, const AnyPointSet& points, std::uint64_t seed) {
  const fit::Algorithm& algorithm = *fit::find_algorithm(task.volume, task.algorithm);
  const fit::Algorithm& smallest = *fit::exact_algorithm(task.volume);  // read_lesson refuses a task without one
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

  const bool count = grade.points == task.points;
  const bool large = task.excess_at_least <= 0 || grade.excess >= task.excess_at_least;
  const bool held = task.support_size == 0 || grade.support == task.support_size;
  grade.done = count && large && held;
  if (!count)
    grade.says = "There are " + points_text(grade.points) + "; the task is for " + std::to_string(task.points) + ". ";
  if (task.excess_at_least > 0) grade.says += excess_sentence(task, algorithm, grade.excess, dim) + " ";
  if (task.support_size != 0) grade.says += support_sentence(task, grade.support, dim) + " ";
  grade.says += grade.done ? "Done." : "";
  while (!grade.says.empty() && grade.says.back() == ' ') grade.says.pop_back();
  return grade;
}

}  // namespace snug::lesson
