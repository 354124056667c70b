#include "lesson/check_lesson.hpp"

#include <algorithm>

#include "lesson/ask.hpp"
#include "lesson/names.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_line.hpp"

namespace snug::lesson {
namespace {

void check_ids(const Lesson& lesson, Complaints& complaints) {
  for (auto question = lesson.questions.begin(); question != lesson.questions.end(); ++question) {
    const auto same = [&](const Question& other) { return other.id == question->id; };
    if (std::any_of(lesson.questions.begin(), question, same))
      complaints.add(question->line, "there is another question with the id " + question->id);
    if (lesson.subject->asks_of_steps && !is_among(lesson.algorithms, question->gate.algorithm))
      complaints.add(question->line, "the lesson does not offer the algorithm " + question->gate.algorithm);
  }
}

/// The questions of one method on its run. A question must not stand where another is still open, for answering that
/// one would pass it by.
void check_questions(const Lesson& lesson, const Method& method, const Subject& subject, const Run& run,
                     Complaints& complaints) {
  std::string why;
  for (const Question& question : lesson.questions)
    if (question.gate.algorithm == method.name && !resolve(question, *lesson.subject, subject, run, why))
      complaints.add(question.line, why);
  const std::vector<Asked> asked = asked_on(lesson, method.name, subject, run, true);
  for (const Question& question : lesson.questions) {
    const auto is_it = [&](const Asked& one) { return one.question == &question; };
    if (question.gate.algorithm == method.name && std::none_of(asked.begin(), asked.end(), is_it))
      complaints.add(question.line, "the question stands where another one is not decided yet");
  }
}

/// What is shown from the start takes as many points as there are.
void check_sizes(const Lesson& lesson, const Subject& own, const TomlTable& root, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (!own.suits(method) && (&name == &lesson.algorithms.front() || name == lesson.compare))
      complaints.add(root.line_of(lesson.subject->table), "too many points for " + std::string(method.title) +
                                                              ": at most " + std::to_string(method.max_points));
  }
}

void check_runs(const Lesson& lesson, const Subject& own, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms)
    if (const Method& method = *find_method(lesson, name); own.suits(method))
      check_questions(lesson, method, own, *own.run(method, nullptr), complaints);
}

/// The steps of the run that a section speaks of.
int steps_of(const Lesson& lesson, const Section& section, const Subject& own) {
  const std::string& name = section.algorithm.empty() ? lesson.algorithms.front() : section.algorithm;
  const Method& method = *find_method(lesson, name);
  return own.suits(method) ? own.run(method, nullptr)->steps() : 0;
}

void check_link(const Lesson& lesson, const Section& section, const toml::table& table, const Link& link,
                const Subject& own, Complaints& complaints) {
  const int line = line_in_text(table, "text", ':' + link.target + ')');
  if (link.kind == Link::Kind::kMark && !is_mark(own, link.target))
    complaints.add(line, "there is no mark " + link.target + ": it is support, a step's name or a handle's");
  if (link.kind != Link::Kind::kStep) return;
  if (const int steps = steps_of(lesson, section, own); std::stoi(link.target) > steps)  // digits, as it was read
    complaints.add(line, "there is no step " + link.target + ": the run has " + std::to_string(steps));
}

/// Links that only a run can tell from mistakes.
void check_links(const Lesson& lesson, const toml::table& toml, const Subject& own, Complaints& complaints) {
  const toml::array& tables = *toml["section"].as_array();  // as they were read
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    for (const Paragraph& paragraph : lesson.sections[i].paragraphs)
      for (const Stretch& stretch : paragraph)
        if (stretch.link) check_link(lesson, lesson.sections[i], *tables[i].as_table(), *stretch.link, own, complaints);
}

}  // namespace

void check_lesson(const Lesson& lesson, const toml::table& toml, Complaints& complaints) {
  const TomlTable root(toml, "the lesson", complaints);
  check_ids(lesson, complaints);
  if (!lesson.compare.empty() && !is_among(lesson.algorithms, lesson.compare))
    complaints.add(root.line_of("compare"), "the lesson does not offer the algorithm " + lesson.compare);
  if (!lesson.points.mesh.empty() || complaints.first()) return;
  const auto own = lesson.subject->open(lesson, std::nullopt, nullptr);
  if (!own) {
    const int line = static_cast<int>(own.error().position);
    return complaints.add(line > 0 ? line : root.line_of(lesson.subject->table), own.error().what);
  }
  check_sizes(lesson, **own, root, complaints);
  if (!complaints.first() && lesson.subject->check_first != nullptr)
    lesson.subject->check_first(lesson, **own, complaints);
  if (complaints.first()) return;
  check_links(lesson, toml, **own, complaints);
  if (lesson.subject->asks_of_steps) check_runs(lesson, **own, complaints);
  if (lesson.subject->check != nullptr) lesson.subject->check(lesson, toml, **own, complaints);
}

}  // namespace snug::lesson
