// Grades a task on a scene by the figures of its last frame.
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::lesson {
namespace {

std::string asked_for(const SceneTask::Requirement& due) {
  const std::string least = scene_bound_text(due.figure, due.at_least),
                    most = scene_bound_text(due.figure, due.at_most);
  if (due.at_least == due.at_most) return "it must be " + least;
  if (due.at_most == SceneTask::Requirement::kNoMost) return "it must be at least " + least;
  return due.at_least == 0 ? "it must be at most " + most : "it must be between " + least + " and " + most;
}

}  // namespace

Grade grade_scene(const Lesson& lesson, const SceneSet& scene, const AnyPointSet& points, std::uint64_t seed) {
  const Task& task = *lesson.task;
  Grade grade;
  grade.points = static_cast<int>(fit::size_of(points));
  const auto last = last_frame(scene, task.algorithm, points, seed);
  if (!last) return grade.says = last.error().what, grade;
  grade.done = grade.points == task.points;
  if (!grade.done)
    grade.says = "There are " + std::to_string(grade.points) + (scene.at_points() ? " bodies" : " points") +
                 "; the task is for " + std::to_string(task.points) + ". ";
  for (const SceneTask::Requirement& due : static_cast<const SceneTask&>(*task.terms).requirements) {
    const double value = figure_of(*last, due.figure);
    const bool met = value >= due.at_least && value <= due.at_most;
    grade.done = grade.done && met;
    grade.says += std::string(scene_figure_title(due.figure)) + ": " + scene_figure_text(due.figure, value) +
                  (met ? ". " : "; " + asked_for(due) + ". ");
  }
  if (grade.done) grade.says += "Done.";
  else grade.says.pop_back();
  return grade;
}

}  // namespace snug::lesson
