#include "check/check_lesson.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

#include "check/check_figures.hpp"
#include "check/check_stage.hpp"
#include "check/warn_answers.hpp"
#include "check/warn_figures.hpp"
#include "check/warn_lesson.hpp"
#include "fit/catalogue.hpp"
#include "lesson/ask.hpp"
#include "lesson/check_solution.hpp"
#include "lesson/grade.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"

namespace snug::check {
namespace {

/// Removes the questions for which holds(question) is false.
void keep_questions(Lesson& lesson, auto holds) {
  std::erase_if(lesson.questions, [&](const Question& question) { return !holds(question); });
}

/// The names of the steps that a run takes, each once, in the order in which they first occur.
std::vector<std::string_view> facts_of(const Run& run) {
  std::vector<std::string_view> facts;
  for (int i = 0; i < run.steps(); ++i)
    if (!is_among(facts, run.fact(i))) facts.push_back(run.fact(i));
  return facts;
}

/// What an answer in words can be: the choices, or the handles that can be tapped.
std::vector<std::string> sayable(const Asked& asked) {
  std::vector<std::string> names = asked.choices;
  if (!asked.on_stage) return names;
  for (const Index handle : asked.stage_points) names.push_back(asked.subject->name_of(handle));
  for (Index i = 0; asked.stage_points.empty() && i < asked.subject->size(); ++i)
    names.push_back(asked.subject->name_of(i));
  return names;
}

/// Checks that what the lesson says to wrong answers is about answers that can be given.
bool check_meanings(const Asked& asked, Complaints& complaints) {
  const std::size_t before = complaints.count();
  const std::vector<std::string> names = sayable(asked);
  for (const Meaning& meaning : asked.question->meanings) {
    if (can_be_said(asked, meaning.answer)) continue;
    const std::string_view meant = nearest(names, meaning.answer);
    complaints.add(meaning.place, "\"wrong\" speaks of an answer that cannot be given: " + meaning.answer +
                                      (asked.choices.empty() ? "" : "; the choices are " + one_of(asked.choices)) +
                                      (meant.empty() ? "" : "; did you mean " + std::string(meant) + "?"));
  }
  return complaints.count() == before;
}

/// Checks that a question's answer is true of the lesson's own run.
bool check_conditions(const Question& question, const Lesson& lesson, const std::string& algorithm,
                      const Subject& subject, const Run& run, Complaints& complaints) {
  const std::size_t before = complaints.count();
  const View view{{Slot{find_method(lesson, algorithm), &run}, Slot{}}, 0, run.steps()};
  for (const Requirement& due : question.conditions)
    if (const Judged judged = judge_requirement(due, lesson, algorithm, subject, view); !judged.met)
      complaints.add(due.place,
                     "does not hold on the lesson's own stage, so the question is never asked there: " + judged.says);
  return complaints.count() == before;
}

/// Checks the questions of one method on its run. A question must not come while another is still open, because
/// answering that one would skip it.
void check_questions(Lesson& lesson, const std::string& algorithm, const Subject& subject, const Run& run,
                     Complaints& complaints) {
  std::string why;
  const std::vector<std::string_view> fits = facts_of(run);
  keep_questions(lesson, [&](const Question& question) {
    if (question.gate.algorithm != algorithm) return true;
    if (!check_gate(question.gate, *lesson.subject, fits, complaints)) return false;
    if (!question.can_be_asked || question.gate.fact.empty()) return false;
    const auto asked = resolve(question, lesson, subject, run, why);
    const bool of_figure = why.starts_with("\"figure\" ");
    if (!asked) return complaints.add(of_figure ? question.figure_place : question.place, why), false;
    if (!comes_before(run, question.gate))
      return complaints.add(question.gate.after_place,
                            "\"after\" names a step that does not come before this one: " + question.gate.after),
             false;
    if (question.sound) warn_of_answer(*asked, run, complaints), warn_of_reasons(*asked, run, complaints);
    const bool meant = check_meanings(*asked, complaints);
    return check_conditions(question, lesson, algorithm, subject, run, complaints) && meant && question.sound;
  });
  const std::vector<Asked> asked = asked_on(lesson, algorithm, subject, run, true);
  const auto is_asked = [&](const Question& question) {
    return std::any_of(asked.begin(), asked.end(), [&](const Asked& one) { return one.question == &question; });
  };
  std::vector<std::string> passed_by;
  for (const Question& question : lesson.questions) {
    if (question.gate.algorithm != algorithm || is_asked(question)) continue;
    const int step = resolve(question, lesson, subject, run, why)->step;
    const auto open = std::find_if(asked.begin(), asked.end(),
                                   [&](const Asked& one) { return one.step <= step && step < one.until; });
    complaints.add(question.place, "the question comes while an earlier one is not decided yet" +
                                       (open == asked.end() ? ""
                                                            : ": \"" + open->question->id + "\", in line " +
                                                                  std::to_string(open->question->place.line)));
    passed_by.push_back(question.id);
  }
  keep_questions(lesson, [&](const Question& question) { return !is_among(passed_by, question.id); });
}

/// Checks that the methods shown from the start can take the points. place: that of the points. Subjects that check
/// their methods themselves say what else has to be said, and without points all of it.
void check_sizes(const Lesson& lesson, const Subject& own, const TomlTable& root, FilePlace place,
                 Complaints& complaints) {
  if (lesson.subject->check_first != nullptr && own.points() == nullptr) return;
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    const std::string refusal = own.refusal(method);
    const bool first = &name == &lesson.algorithms.front() || name == lesson.compare;
    if (!refusal.empty() && first) complaints.add(place, refusal);
    if (!refusal.empty() && first) return;
    if (!refusal.empty() && lesson.subject->check_first == nullptr)
      complaints.warn(root.place_of("algorithms"), refusal + ", and is not offered for these");
  }
}

/// The runs of the lesson's methods, each made when it is first needed.
class Runs {
 public:
  Runs(const Lesson& lesson, const Subject& own) : lesson_(lesson), own_(own) {}
  [[nodiscard]] const Subject& own() const { return own_; }
  /// Null if it cannot take these points.
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

void check_runs(Lesson& lesson, Runs& runs, Complaints& complaints) {
  for (const std::string& name : lesson.algorithms)
    if (const Run* run = runs.of(name)) check_questions(lesson, name, runs.own(), *run, complaints);
}

void check_tasks(const Lesson& lesson, const Subject& own, Complaints& complaints) {
  for (const Task& task : lesson.tasks) {
    const std::size_t before = complaints.count();
    if (own.points() != nullptr && fit::count_of(*own.points()) < task.points && lesson.subject->experiment == nullptr)
      complaints.add(task.place, "the task is for more points than the lesson has");
    for (const std::string& name : task.only)
      if (!handle_named(own, name))
        complaints.add(task.only_place,
                       "\"only\" names what is not there: " + name + meant_text(names_of_handles(own), name));
    const bool known = find_method(lesson, task.algorithm) != nullptr;
    if (complaints.count() > before || !task.can_be_solved || !known) continue;
    const auto check = lesson.subject->check_task;
    if (check != nullptr) check(lesson, task, own, complaints);
    else check_solution(lesson, task, own, complaints);
  }
}

/// A situation that opened, and its runs.
struct InSituation {
  Lesson lesson;  // as lesson_in says
  std::unique_ptr<Subject> own;
  Runs runs;
  InSituation(Lesson there, std::unique_ptr<Subject> subject)
      : lesson(std::move(there)), own(std::move(subject)), runs(lesson, *own) {}
  InSituation(const InSituation&) = delete;
  InSituation& operator=(const InSituation&) = delete;
};
using Situations = std::vector<std::unique_ptr<InSituation>>;

/// Where a situation's points, boxes or scene stand in the file.
FilePlace place_of_situation(const Lesson& lesson, std::string_view name, const TomlTable& root) {
  for (const Situation& situation : lesson.situations)
    if (situation.name == name) return situation.place;
  return root.place_of(lesson.subject->table);
}

/// Opens a situation without its sliders. Null, with a complaint, if that is impossible. mesh: null for none.
std::unique_ptr<Subject> opened(const Lesson& lesson, std::string_view name, FilePlace place, const io::PointFile* mesh,
                                Complaints& complaints) {
  const auto loaded = mesh != nullptr && !lesson.points.mesh.empty() ? std::optional(*mesh) : std::nullopt;
  auto own = lesson.subject->open(lesson, loaded, nullptr);
  if (!own) {
    std::vector<InputError> faults;
    if (lesson.subject->faults != nullptr) faults = lesson.subject->faults(lesson, loaded);
    if (faults.empty()) faults.push_back(own.error());
    for (const InputError& fault : faults)
      complaints.add(fault.position > 0 ? FilePlace(static_cast<int>(fault.position)) : place, fault.what);
    return nullptr;
  }
  Subject::Origin origin = (*own)->origin();
  origin.situation = name;
  (*own)->set_origin(std::move(origin));
  return *std::move(own);
}

/// Takes over what was found out about the sliders in a situation.
void take_over_sliders(Lesson& whole, const Lesson& there) {
  for (Slider& slider : whole.sliders)
    for (const Slider& own : there.sliders)
      if (own.place.line == slider.place.line && own.place.column == slider.place.column)
        slider.drives = own.drives, slider.sound = slider.sound && own.sound;
}

/// Opens a situation as it will stand on the stage, and checks that its algorithms take it. Null, with complaints, if
/// nothing can be run there. The lesson's view is checked on its own situation.
std::unique_ptr<InSituation> open_to_check(Lesson& whole, std::string_view name, const toml::table& toml,
                                           const TomlTable& root, const io::PointFile* mesh, Complaints& complaints) {
  const FilePlace place = place_of_situation(whole, name, root);
  Lesson lesson = lesson_in(whole, name);
  auto subject = opened(lesson, name, place, mesh, complaints);
  if (subject == nullptr) return nullptr;
  check_sizes(lesson, *subject, root, place, complaints);
  check_sliders(lesson, *subject, complaints);
  take_over_sliders(whole, lesson);
  std::erase_if(lesson.sliders, [](const Slider& slider) { return !slider.sound; });
  const std::size_t before = complaints.count();
  if (lesson.subject->check_first != nullptr) lesson.subject->check_first(lesson, *subject, complaints);
  const bool runs = complaints.count() == before;
  if (name == kOwnSituation) check_view(whole.view, toml, *subject, complaints);
  if (!runs) return nullptr;
  auto standing = with_sliders(lesson, std::move(subject), true);
  if (!standing) return complaints.add(place, standing.error().what), nullptr;
  return std::make_unique<InSituation>(std::move(lesson), std::move(standing->subject));
}

void check_mark(const Lesson& lesson, const std::string& mark, FilePlace place, Runs& runs, Complaints& complaints) {
  if (!is_mark(runs.own(), mark)) {
    std::vector<std::string> names = names_of_handles(runs.own());
    for (const std::string_view fact : lesson.subject->facts()) names.emplace_back(fact);
    names.emplace_back("support");
    const std::string_view meant = nearest(names, mark);
    return complaints.add(place, "there is no mark " + mark + ": a mark is support, a step's name or a handle's name" +
                                     (meant.empty() ? "" : "; did you mean " + std::string(meant) + "?"));
  }
  const auto lights_there = [&](const std::string& algorithm) {
    const Run* run = runs.of(algorithm);
    return run != nullptr && lights(*run, runs.own(), mark);
  };
  if (std::none_of(lesson.algorithms.begin(), lesson.algorithms.end(), lights_there))
    complaints.add(place, "the mark " + mark + " lights nothing at any step of the lesson's algorithms");
}

/// Checks that a link's step is one of the run that the section is about.
void check_step(const Lesson& lesson, const Section& section, const std::string& step, FilePlace place, Runs& runs,
                Complaints& complaints) {
  if (!is_step_number(step)) return;  // told when it was read
  const std::string& algorithm = section.algorithm.empty() ? lesson.algorithms.front() : section.algorithm;
  const Run* run = is_among(lesson.algorithms, algorithm) ? runs.of(algorithm) : nullptr;
  if (run != nullptr && std::stoi(step) > run->steps())  // only digits, as checked before
    complaints.add(place, "there is no step " + step + ": the run has " + std::to_string(run->steps()));
}

/// The situation of that name, the lesson's own for an empty one; null if it did not open.
InSituation* situation_named(std::string_view name, const Situations& situations) {
  for (const auto& one : situations)
    if (one->own->origin().situation == (name.empty() ? kOwnSituation : name)) return one.get();
  return nullptr;
}

/// Checks the links that can only be checked on a run.
void check_links(const Lesson& lesson, const toml::table& toml, const Situations& situations, Complaints& complaints) {
  const toml::array* tables = toml["section"].as_array();
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    for (const Stretch* stretch : stretches_of(lesson.sections[i])) {
      if (!stretch->link) continue;
      const auto& [kind, target] = *stretch->link;
      const FilePlace place = place_in_text(*tables->get(i)->as_table(), "text", stretch->at);
      InSituation* there = situation_named(lesson.sections[i].situation, situations);
      if (there == nullptr) continue;
      if (kind == Link::Kind::kMark) check_mark(lesson, target, place, there->runs, complaints);
      if (kind == Link::Kind::kStep) check_step(lesson, lesson.sections[i], target, place, there->runs, complaints);
    }
}

/// Checks the figures in braces, and warns of those that are typed.
void check_all_figures(const Lesson& lesson, const toml::table& toml, const Situations& situations,
                       Complaints& complaints) {
  std::vector<OpenSituation> open;
  for (const auto& one : situations)
    open.push_back({one->own->origin().situation, one->own.get(),
                    [&runs = one->runs](const std::string& algorithm) { return runs.of(algorithm); }});
  check_figures(lesson, toml, open, complaints);
  warn_of_figures(lesson, toml, open, complaints);
}

/// Checks on their runs what stands in the situations that opened.
void check_on_runs(Lesson& lesson, const toml::table& toml, const Situations& situations, Complaints& complaints) {
  check_links(lesson, toml, situations, complaints);
  check_all_figures(lesson, toml, situations, complaints);
  for (const auto& one : situations) {
    if (lesson.subject->experiment == nullptr) check_runs(one->lesson, one->runs, complaints);
    check_tasks(one->lesson, *one->own, complaints);
  }
}

/// Checks the steps that questions name where no run shows which fit: in situations that did not open, and of
/// algorithms that the lesson does not offer.
void check_gates_elsewhere(Lesson lesson, const Situations& situations, Complaints& complaints) {
  keep_questions(lesson, [&](const Question& question) {
    InSituation* there = situation_named(question.situation, situations);
    return there == nullptr || !is_among(lesson.algorithms, question.gate.algorithm);
  });
  check_gates(lesson, complaints);
}

/// Removes the questions that no situation kept.
void keep_asked(Lesson& lesson, const Situations& situations) {
  keep_questions(lesson, [&](const Question& question) {
    return std::any_of(situations.begin(), situations.end(), [&](const auto& one) {
      const auto& sound = one->lesson.questions;
      return std::any_of(sound.begin(), sound.end(), [&](const Question& kept) { return kept.id == question.id; });
    });
  });
}

/// Each situation that opens is run, and all that can be checked there is, in spite of mistakes elsewhere. Returns
/// whether the lesson can be shown.
bool check_run(Lesson& lesson, const toml::table& toml, const Stages& stages, const io::PointFile* mesh,
               Complaints& complaints) {
  const TomlTable root(toml, "the lesson", complaints);
  Situations situations;
  std::vector<const Subject*> subjects;
  bool all = stages.sound;
  for (const std::string_view name : situation_names(lesson)) {
    if (is_among(stages.unread, name)) continue;
    if (auto one = open_to_check(lesson, name, toml, root, mesh, complaints)) {
      subjects.push_back(one->own.get());
      situations.push_back(std::move(one));
    } else {
      all = false;
    }
  }
  warn_of_words(lesson, toml, subjects, complaints);
  for (const Question& question : lesson.questions)
    if (question.sound) warn_of_reasons(question, complaints);
  check_on_runs(lesson, toml, situations, complaints);
  check_gates_elsewhere(lesson, situations, complaints);
  keep_sound(lesson);
  if (all) keep_asked(lesson, situations);
  return all;
}

bool check_unrun(Lesson& lesson, const toml::table& toml, const Stages& stages, Complaints& complaints) {
  check_gates(lesson, complaints);
  warn_of_words(lesson, toml, {}, complaints);
  keep_sound(lesson);
  return stages.sound;
}

}  // namespace

Draft checked_draft(std::string_view text, std::string_view name, const io::PointFile* mesh) {
  Complaints complaints(name);
  Reading reading = read_file(text, name, complaints);
  bool draws = false;
  if (reading.stages) {
    Lesson& lesson = reading.lesson;
    const bool lacks_mesh = !lesson.points.mesh.empty() && mesh == nullptr;
    draws = lacks_mesh ? check_unrun(lesson, *reading.toml, *reading.stages, complaints)
                       : check_run(lesson, *reading.toml, *reading.stages, mesh, complaints);
  }
  return finished(std::move(reading), draws, complaints);
}

tl::expected<Lesson, InputError> checked_lesson(std::string_view text, std::string_view name) {
  Draft draft = checked_draft(text, name);
  if (!draft.mistakes.empty()) return tl::unexpected(draft.mistakes.front().error());
  return *std::move(draft.lesson);
}

}  // namespace snug::check
