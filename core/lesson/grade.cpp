#include "lesson/grade.hpp"

#include <cmath>

#include "fit/catalogue.hpp"
#include "lesson/figures.hpp"

namespace snug::lesson {
namespace {

std::string points_text(int n) { return std::to_string(n) + (n == 1 ? " point" : " points"); }

/// Rounded down, so that what is not reached does not look as if it were: "9.9 %".
std::string reached_text(double excess) {
  const std::string text = percent_text(std::floor(1000 * excess) / 1000);
  return text.front() == '+' ? text.substr(1) : text;
}

/// What is reached of a measure, and what is asked for.
std::string excess_sentence(const Task& task, const fit::Algorithm& algorithm, double excess) {
  const std::string whose = std::string(algorithm.title) + ": its ball is ";
  const std::string reached = whose + reached_text(excess) + " larger than the smallest";
  if (excess >= task.excess_at_least) return reached + ".";
  return reached + "; at least " + percent_text(task.excess_at_least).substr(1) + " is asked for.";
}

std::string support_sentence(const Task& task, int support) {
  const std::string held = points_text(support) + (support == 1 ? " holds" : " hold") + " the smallest ball";
  if (support == task.support_size) return held + ".";
  return held + "; it must be " + std::to_string(task.support_size) + ".";
}

}  // namespace

Grade grade(const Task& task, const AnyPointSet& points, std::uint64_t seed) {
  const fit::Algorithm& algorithm = *fit::find_algorithm("sphere", task.algorithm);
  const fit::Algorithm& smallest = *fit::find_algorithm("sphere", "welzl");
  Grade grade;
  grade.points = static_cast<int>(fit::size_of(points));
  if (grade.points > algorithm.max_points) {
    grade.says = std::string(algorithm.title) + " takes at most " + points_text(algorithm.max_points) + ".";
    return grade;
  }
  const fit::Result best = smallest.fit(points, {.seed = seed});
  grade.support = best.support.size();
  if (best.sphere.radius > 0) grade.excess = algorithm.fit(points, {.seed = seed}).sphere.radius / best.sphere.radius - 1;

  const bool count = grade.points == task.points;
  const bool large = task.excess_at_least <= 0 || grade.excess >= task.excess_at_least;
  const bool held = task.support_size == 0 || grade.support == task.support_size;
  grade.done = count && large && held;
  if (!count)
    grade.says = "There are " + points_text(grade.points) + "; the task is for " + std::to_string(task.points) + ". ";
  if (task.excess_at_least > 0) grade.says += excess_sentence(task, algorithm, grade.excess) + " ";
  if (task.support_size != 0) grade.says += support_sentence(task, grade.support) + " ";
  grade.says += grade.done ? "Done." : "";
  while (!grade.says.empty() && grade.says.back() == ' ') grade.says.pop_back();
  return grade;
}

}  // namespace snug::lesson
