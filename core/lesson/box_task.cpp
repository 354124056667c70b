// Tasks on two boxes: goals, reached one after the other.
#include "lesson/boxes.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

void read_box_task(TomlTable& table, Lesson& lesson, Complaints& complaints, std::span<const std::string_view> names,
                   BoxPair (*read)(TomlTable& table, const BoxPair& like)) {
  auto terms = std::make_shared<BoxTask>();
  terms->goals = read_names(table, "goals", 1, names);
  for (const toml::table* model : table.tables("model")) {
    TomlTable own(*model, "[[task.model]]", complaints);
    terms->models.push_back(read(own, static_cast<const BoxTables&>(*lesson.tables).boxes));
    own.refuse_others();
  }
  if (terms->models.size() != terms->goals.size())
    complaints.add(table.place(), "[task] needs a [[task.model]] for each of its goals");
  lesson.task->terms = std::move(terms);
}

void check_box_task(const Lesson& lesson, const toml::table& toml, const Subject& own, const BoxGoals& goals,
                    Complaints& complaints) {
  if (!lesson.task) return;
  const TomlTable task(*toml.get_as<toml::table>("task"), "[task]", complaints);
  const auto& terms = static_cast<const BoxTask&>(*lesson.task->terms);
  for (std::size_t i = 0; i < terms.goals.size(); ++i) {
    if (goals.reaches(terms.goals[i], boxes_of(own)))
      complaints.add(task.place(), "the task is solved before the student begins");
    if (!goals.reaches(terms.goals[i], terms.models[i]))
      complaints.add(task.place_of("model"), "the model does not reach " + terms.goals[i]);
  }
}

tl::expected<Grade, InputError> play_box_task(Session& session) {
  session.start_task();
  Grade grade;
  for (const BoxPair& model : static_cast<const BoxTask&>(*session.lesson().task->terms).models) {
    if (const Done placed = set_boxes(session, model); !placed) return tl::unexpected(placed.error());
    grade = *session.grade();
  }
  return grade;
}

Grade grade_box_task(const Lesson& lesson, const BoxPair& pair, const BoxGoals& goals, std::vector<bool>& found) {
  const auto& terms = static_cast<const BoxTask&>(*lesson.task->terms);
  found.resize(terms.goals.size());
  Grade grade;
  grade.done = true;
  for (std::size_t i = 0; i < terms.goals.size(); ++i) {
    const bool now = goals.reaches(terms.goals[i], pair);
    found[i] = found[i] || now;
    grade.done = grade.done && found[i];
    grade.points += found[i] ? 1 : 0;
    grade.says += (grade.says.empty() ? "" : " ") + goals.sentence(terms.goals[i], pair, now, found[i]);
  }
  if (grade.done) grade.says += " Done.";
  return grade;
}

}  // namespace snug::lesson
