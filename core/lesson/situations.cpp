#include "lesson/situations.hpp"

#include <algorithm>

#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

const Situation* find_situation(const Lesson& lesson, std::string_view name) {
  for (const Situation& situation : lesson.situations)
    if (situation.name == name) return &situation;
  return nullptr;
}

}  // namespace

std::vector<std::string_view> situation_names(const Lesson& lesson) {
  std::vector<std::string_view> names{kOwnSituation};
  for (const Situation& situation : lesson.situations) names.push_back(situation.name);
  return names;
}

const std::string& situation_title(const Lesson& lesson, std::string_view name) {
  const Situation* situation = find_situation(lesson, name);
  return situation != nullptr ? situation->title : lesson.own_title;
}

const Points& points_in(const Lesson& lesson, std::string_view name) {
  const Situation* situation = find_situation(lesson, name);
  return situation != nullptr ? situation->points : lesson.points;
}

Lesson lesson_in(const Lesson& lesson, std::string_view name) {
  Lesson there = lesson;
  there.situations.clear();
  if (const Situation* situation = find_situation(lesson, name))
    there.points = situation->points, there.tables = situation->tables;
  std::erase_if(there.questions, [&](const Question& question) { return question.situation != name; });
  std::erase_if(there.tasks, [&](const Task& task) { return task.situation != name; });
  std::erase_if(there.sliders, [&](const Slider& one) { return !one.situation.empty() && one.situation != name; });
  return there;
}

tl::expected<Snapshot, InputError> open_situation(const Lesson& lesson, std::string_view name,
                                                  const std::optional<io::PointFile>& mesh, Clock clock) {
  const Lesson there = lesson_in(lesson, name);
  auto subject = lesson.subject->open(there, there.points.mesh.empty() ? std::nullopt : mesh, clock);
  if (!subject) return tl::unexpected(std::move(subject.error()));
  Subject::Origin origin = (*subject)->origin();
  origin.situation = name;
  (*subject)->set_origin(std::move(origin));
  return with_sliders(lesson, *std::move(subject), true);
}

}  // namespace snug::lesson
