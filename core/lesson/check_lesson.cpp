#include "lesson/check_lesson.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "lesson/ask.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/costs.hpp"
#include "lesson/grade.hpp"
#include "lesson/methods.hpp"
#include "lesson/own_points.hpp"
#include "lesson/scene_runs.hpp"

namespace snug::lesson {
namespace {

bool offers(const Lesson& lesson, std::string_view algorithm) {
  return std::find(lesson.algorithms.begin(), lesson.algorithms.end(), algorithm) != lesson.algorithms.end();
}

void check_ids(const Lesson& lesson, Complaints& complaints) {
  for (auto question = lesson.questions.begin(); question != lesson.questions.end(); ++question) {
    const auto same = [&](const Question& other) { return other.id == question->id; };
    if (std::any_of(lesson.questions.begin(), question, same))
      complaints.add(question->line, "there is another question with the id " + question->id);
    if (!lesson.measures && !offers(lesson, question->gate.algorithm))
      complaints.add(question->line, "the lesson does not offer the algorithm " + question->gate.algorithm);
  }
}

/// The questions of one algorithm on its trace. A question must not stand where another is still open, for answering
/// that one would pass it by.
void check_questions(const Lesson& lesson, const fit::Algorithm& algorithm, const fit::Recording& recording, int dim,
                     Complaints& complaints) {
  std::string why;
  for (const Question& question : lesson.questions)
    if (question.gate.algorithm == algorithm.name && !resolve(question, lesson.volume, recording.steps, dim, why))
      complaints.add(question.line, why);
  const std::vector<Asked> asked = asked_on(lesson, algorithm.name, recording.steps, dim, true);
  for (const Question& question : lesson.questions) {
    const auto is_it = [&](const Asked& one) { return one.question == &question; };
    if (question.gate.algorithm == algorithm.name && std::none_of(asked.begin(), asked.end(), is_it))
      complaints.add(question.line, "the question stands where another one is not decided yet");
  }
}

/// Two boxes: every test is run on them, and every goal is reached by its model but not at the start.
void check_boxes(const Lesson& lesson, const toml::table& toml, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms) {
    const fit::Algorithm& test = *find_method(lesson.volume, name);
    check_questions(lesson, test, record(test, *lesson.boxes), lesson.boxes->dim, complaints);
  }
  if (!lesson.task) return;
  const TomlTable task(*toml.get_as<toml::table>("task"), "[task]", complaints);
  for (std::size_t i = 0; i < lesson.task->goals.size(); ++i) {
    if (reaches(lesson.task->goals[i], *lesson.boxes))
      complaints.add(task.line(), "the task is solved before the student begins");
    if (!reaches(lesson.task->goals[i], lesson.task->models[i]))
      complaints.add(task.line_of("model"), "the model does not reach " + lesson.task->goals[i]);
  }
}

/// A scene: every method is run on it, and the model does the task, which the beginning does not.
void complain_of_points(const TomlTable& root, const fit::Algorithm& algorithm, Complaints& complaints) {
  complaints.add(root.line_of("points"), "too many points for " + std::string(algorithm.title) + ": at most " +
                                             std::to_string(algorithm.max_points));
}

void check_scene(const Lesson& lesson, const toml::table& toml, const AnyPointSet& points, Complaints& complaints) {
  const TomlTable root(toml, "the lesson", complaints);
  const TomlTable own(*toml.get_as<toml::table>("scene"), "[scene]", complaints);
  if (lesson.scene->is_too_long(fit::size_of(points))) return complaints.add(own.line_of("frames"), too_long_text());
  const fit::Algorithm& first = *find_method(kScene, lesson.algorithms.front());
  if (fit::size_of(points) > first.max_points) return complain_of_points(root, first, complaints);
  for (const std::string& name : lesson.algorithms) {
    if (const auto kept = check_pairs(*lesson.scene, name, points, lesson.seed); !kept)
      return complaints.add(static_cast<int>(kept.error().position), kept.error().what);
    const auto run = run_scene(*lesson.scene, name, points, lesson.seed);
    if (!run)
      return complaints.add(run.error().position > 0 ? static_cast<int>(run.error().position) : root.line_of("scene"),
                            run.error().what);
    check_questions(lesson, *find_method(kScene, name), run->recording, fit::dim_of(points), complaints);
  }
  if (!lesson.task) return;
  const TomlTable task(*toml.get_as<toml::table>("task"), "[task]", complaints);
  const auto graded = [&](const AnyPointSet& on) { return grade_scene(*lesson.task, *lesson.scene, on, lesson.seed); };
  if (fit::size_of(points) < lesson.task->points)
    complaints.add(task.line(), "the task is for more points than the lesson has");
  if (!offers(lesson, lesson.task->algorithm))
    complaints.add(task.line(), "the lesson does not offer the algorithm " + lesson.task->algorithm);
  if (graded(start_of_task(lesson, points)).done)
    complaints.add(task.line(), "the task is solved before the student begins");
  const auto model = to_set(lesson.task->model, fit::dim_of(points));
  if (!model) return complaints.add(task.line_of("model"), model.error().what);
  if (lesson.scene->is_too_long(fit::size_of(*model))) return complaints.add(task.line_of("model"), too_long_text());
  if (const auto kept = check_pairs(*lesson.scene, lesson.task->algorithm, *model, lesson.seed); !kept)
    return complaints.add(task.line_of("model"), kept.error().what);
  if (const Grade grade = graded(*model); !grade.done)
    complaints.add(task.line_of("model"), "the model does not solve the task: " + grade.says);
}

void check_task(const Lesson& lesson, const AnyPointSet& points, int line, int model_line, Complaints& complaints) {
  const Task& task = *lesson.task;
  if (fit::size_of(points) < task.points) complaints.add(line, "the task is for more points than the lesson has");
  if (!offers(lesson, task.algorithm))
    complaints.add(line, "the lesson does not offer the algorithm " + task.algorithm);
  if (grade(task, start_of_task(lesson, points), lesson.seed).done)
    complaints.add(line, "the task is solved before the student begins");
  const auto model = to_set(task.model, fit::dim_of(points));
  if (!model) return complaints.add(model_line, model.error().what);
  const Grade graded = grade(task, *model, lesson.seed);
  if (!graded.done) complaints.add(model_line, "the model does not solve the task: " + graded.says);
}

/// The chart: on the model's points something is as much smaller as the task asks. What takes the least time to be so
/// is for the student's machine to say.
void check_costs(const Lesson& lesson, const toml::table& toml, Complaints& complaints) {
  if (!lesson.task) return;
  const TomlTable task(*toml.get_as<toml::table>("task"), "[task]", complaints);
  if (!offers(lesson, lesson.task->algorithm))
    return complaints.add(task.line(), "the lesson does not offer the algorithm " + lesson.task->algorithm);
  const auto model = to_set(lesson.task->model, lesson.points.dim);
  if (!model) return complaints.add(task.line_of("model"), model.error().what);
  if (cheapest_of(*lesson.task, counted_costs(lesson, *model)).empty())
    complaints.add(task.line_of("model"), "on the model no algorithm is as much smaller as the task asks");
}

}  // namespace

void check_lesson(const Lesson& lesson, const toml::table& toml, Complaints& complaints) {
  const TomlTable root(toml, "the lesson", complaints);
  check_ids(lesson, complaints);
  if (!lesson.compare.empty() && !offers(lesson, lesson.compare))
    complaints.add(root.line_of("compare"), "the lesson does not offer the algorithm " + lesson.compare);
  if (lesson.measures && !complaints.first()) return check_costs(lesson, toml, complaints);
  if (!lesson.points.mesh.empty() || complaints.first()) return;
  if (lesson.boxes) return check_boxes(lesson, toml, complaints);

  const auto points = own_points(lesson, lesson.seed, std::nullopt);
  if (!points) return complaints.add(root.line_of("points"), points.error().what);
  if (lesson.scene) return check_scene(lesson, toml, *points, complaints);
  for (const std::string& name : lesson.algorithms) {
    const fit::Algorithm& algorithm = *fit::find_algorithm(lesson.volume, name);
    if (fit::size_of(*points) <= algorithm.max_points)
      check_questions(lesson, algorithm, algorithm.record(*points, {.seed = lesson.seed}), fit::dim_of(*points),
                      complaints);
    else if (&name == &lesson.algorithms.front() || name == lesson.compare)
      complain_of_points(root, algorithm, complaints);
  }
  if (!lesson.task) return;
  const toml::table& task = *toml.get_as<toml::table>("task");
  const TomlTable task_table(task, "[task]", complaints);
  check_task(lesson, *points, task_table.line(), task_table.line_of("model"), complaints);
}

}  // namespace snug::lesson
