#include "lesson/check_lesson.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

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

/// Checks the questions of one method on its run. A question must not come while another is still open, because
/// answering that one would skip it.
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

/// Checks that the methods shown from the start can take all the points.
void check_sizes(const Lesson& lesson, const Subject& own, const TomlTable& root, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (!own.suits(method) && (&name == &lesson.algorithms.front() || name == lesson.compare))
      complaints.add(root.line_of(lesson.subject->table), "too many points for " + std::string(method.title) +
                                                              ": at most " + std::to_string(method.max_points));
  }
}

/// The runs of the lesson's methods, each made when it is first needed.
class Runs {
 public:
  Runs(const Lesson& lesson, const Subject& own) : lesson_(lesson), own_(own) {}
  [[nodiscard]] const Subject& own() const { return own_; }
  /// Null if there are too many points for it.
  const Run* of(const std::string& algorithm) {
    const Method& method = *find_method(lesson_, algorithm);
    if (!own_.suits(method)) return nullptr;
    std::unique_ptr<Run>& run = runs_[algorithm];
    if (run == nullptr) run = own_.run(method, nullptr);
    return run.get();
  }

 private:
  const Lesson& lesson_;
  const Subject& own_;
  std::map<std::string, std::unique_ptr<Run>> runs_;
};

void check_runs(const Lesson& lesson, Runs& runs, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms)
    if (const Run* run = runs.of(name))
      check_questions(lesson, *find_method(lesson, name), runs.own(), *run, complaints);
}

void check_mark(const Lesson& lesson, const std::string& mark, int line, Runs& runs, Complaints& complaints) {
  if (!is_mark(runs.own(), mark))
    return complaints.add(line, "there is no mark " + mark + ": it is support, a step's name or a handle's");
  const auto lights_there = [&](const std::string& algorithm) {
    const Run* run = runs.of(algorithm);
    return run != nullptr && lights(*run, runs.own(), mark);
  };
  if (std::none_of(lesson.algorithms.begin(), lesson.algorithms.end(), lights_there))
    complaints.add(line, "the mark " + mark + " lights nothing at any step of the lesson's algorithms");
}

/// Checks that a link's step is one of the run that the section is about.
void check_step(const Lesson& lesson, const Section& section, const std::string& step, int line, Runs& runs,
                Complaints& complaints) {
  const Run* run = runs.of(section.algorithm.empty() ? lesson.algorithms.front() : section.algorithm);
  if (const int steps = run != nullptr ? run->steps() : 0; std::stoi(step) > steps)  // only digits, as checked before
    complaints.add(line, "there is no step " + step + ": the run has " + std::to_string(steps));
}

/// Checks the links that can only be checked on a run.
void check_links(const Lesson& lesson, const toml::table& toml, Runs& runs, Complaints& complaints) {
  const toml::array& tables = *toml["section"].as_array();  // tables: that was checked when they were read
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    for (const Paragraph& paragraph : lesson.sections[i].paragraphs)
      for (const Stretch& stretch : paragraph) {
        if (!stretch.link) continue;
        const auto& [kind, target] = *stretch.link;
        const int line = line_in_text(*tables[i].as_table(), "text", ':' + target + ')');
        if (kind == Link::Kind::kMark) check_mark(lesson, target, line, runs, complaints);
        if (kind == Link::Kind::kStep) check_step(lesson, lesson.sections[i], target, line, runs, complaints);
      }
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
  Runs runs(lesson, **own);
  check_links(lesson, toml, runs, complaints);
  if (lesson.subject->asks_of_steps) check_runs(lesson, runs, complaints);
  if (lesson.subject->check != nullptr) lesson.subject->check(lesson, toml, **own, complaints);
}

}  // namespace snug::lesson
