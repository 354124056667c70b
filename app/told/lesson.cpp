#include "app/told/lesson.hpp"

#include <utility>

#include "app/told/json.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::app::told {
namespace {

PointSet points_of(const lesson::Points& own) { return {own.generate, own.count, own.mesh, scalar_of(own.in_float)}; }

LessonAlgorithm algorithm_of(const lesson::Lesson& lesson, std::string_view name) {
  const lesson::Method* own = lesson::find_method(lesson, name);
  if (own == nullptr) return {.name = name, .title = std::string(name)};
  return {name, lesson::title_in(lesson, *own), own->source, own->max_points};
}

}  // namespace

Lesson lesson_of(const lesson::Session& session) {
  const lesson::Lesson& own = session.lesson();
  const lesson::Subject& subject = session.stage().subject();
  const lesson::Tools tools = subject.tools();
  Lesson told{points_of(own.points)};
  told.id = own.id, told.minutes = own.minutes, told.title = own.title, told.summary = own.summary;
  for (const lesson::Section& section : own.sections) {
    Section& one = told.sections.emplace_back(Section{section.title, section.situation, {}});
    for (const lesson::Block& block : section.blocks) one.blocks.push_back(block_of(block));
  }
  for (const std::string_view name : own.algorithms) told.algorithms.push_back(algorithm_of(own, name));
  told.step_word = own.subject->step_word, told.measures = own.subject->experiment != nullptr;
  told.tools = {tools.word, tools.title, tools.points};
  told.stage_says = subject.stage_says(), told.handle_words = subject.handle_words();
  if (!own.situations.empty())
    for (const std::string_view name : lesson::situation_names(own))
      told.situations.push_back({points_of(lesson::points_in(own, name)), name, lesson::situation_title(own, name)});
  told.dim = own.points.dim, told.seed = own.seed;
  told.meshes = own.meshes, told.generators = own.generators, told.compare = own.compare;
  for (std::size_t i = 0; i < session.tasks_listed(); ++i) {
    const lesson::Task& task = own.tasks[i];
    told.tasks.push_back({.heading = lesson::task_heading(i, own.tasks.size()),
                          .prompt = prompt_of(task.prompt),
                          .hint = prompt_of(task.hint),
                          .algorithm = task.algorithm,
                          .points = task.points,
                          .start = lesson::start_task_text(session, task)});
  }
  return told;
}

std::string lesson_text(const lesson::Session& session) { return json_of(lesson_of(session)); }

}  // namespace snug::app::told
