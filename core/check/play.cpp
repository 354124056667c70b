#include "check/play.hpp"

#include <algorithm>

#include "check/warn_answers.hpp"
#include "lesson/playable.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::check {
namespace {

/// Answers the open question, or takes a step. false: it could do neither.
bool advance(Session& session, std::vector<Outcome>& outcomes, std::vector<Played::FalseKey>& false_keys) {
  const int step = session.player().step();
  if (const Asked* asked = session.conversation().asked()) {
    const std::string id = asked->question->id;
    if (auto is = contradiction(*asked, session.player().run(0)))
      false_keys.push_back({id, asked->choices[asked->question->answer], *std::move(is)});
    if (!session.conversation().give(model_answer(*asked, session.player().run(0)))) return false;
    for (const Outcome& outcome : session.log().outcomes())
      if (outcome.question == id) outcomes.push_back(outcome);
    while (session.conversation().acknowledge()) {
    }
    return true;
  }
  session.forward();
  return session.player().step() > step;
}

tl::expected<Played::Algorithm, InputError> play_algorithm(Session& session, const std::string& name,
                                                           std::vector<Played::FalseKey>& false_keys) {
  if (const auto chosen = session.player().choose(0, name); !chosen) return tl::unexpected(chosen.error());
  Played::Algorithm played{name, session.stage().situation(), session.player().steps(), {}};
  session.go(0);
  session.conversation().ask_predictions();
  // Every iteration answers a question or takes a step, so there are at most as many as both together.
  std::size_t turns = session.conversation().questions().size() + static_cast<std::size_t>(session.player().steps());
  while (session.player().step() < session.player().steps() || session.conversation().asked() != nullptr)
    if (turns-- == 0 || !advance(session, played.outcomes, false_keys))
      return tl::unexpected(InputError{.what = "the player does not get past step " +
                                               std::to_string(session.player().step()) + " of " + name});
  return played;
}

void find_not_asked(const Lesson& lesson, Played& played) {
  for (const Question& question : lesson.questions) {
    bool asked = false;
    for (const auto& algorithm : played.algorithms)
      for (const Outcome& outcome : algorithm.outcomes) asked = asked || outcome.question == question.id;
    if (!asked) played.not_asked.push_back(question.id);
  }
}

tl::expected<Grade, InputError> play_task(Session& session, std::size_t task) {
  const SubjectRow& subject = *session.lesson().subject;
  if (subject.play_task == nullptr) return session.solve_task(task, session.lesson().tasks[task].model);
  session.stage().start_task(task);
  return subject.play_task(session, session.lesson().tasks[task]);
}

}  // namespace

bool Played::sound() const {
  for (const Algorithm& algorithm : algorithms)
    for (const Outcome& outcome : algorithm.outcomes)
      if (!outcome.right) return false;
  return false_keys.empty() && not_asked.empty() &&
         std::all_of(grades.begin(), grades.end(), [](const Grade& it) { return it.done; });
}

tl::expected<Played, InputError> play(Session& session) {
  Played played;
  const SubjectRow& subject = *session.lesson().subject;
  session.forget_answers();
  for (const std::string_view situation : situation_names(session.lesson())) {
    if (const Done shown = session.stage().show_situation(situation); !shown) return tl::unexpected(shown.error());
    if (subject.experiment != nullptr) subject.experiment->perform(session);
    for (const std::string& name : playable(session)) {
      auto algorithm = play_algorithm(session, name, played.false_keys);
      if (!algorithm) return tl::unexpected(std::move(algorithm.error()));
      played.algorithms.push_back(std::move(*algorithm));
    }
  }
  if (const Done shown = session.stage().show_situation(kOwnSituation); !shown) return tl::unexpected(shown.error());
  find_not_asked(session.lesson(), played);
  for (std::size_t i = 0; i < session.lesson().tasks.size(); ++i) {
    auto grade = play_task(session, i);
    if (!grade) return tl::unexpected(std::move(grade.error()));
    played.grades.push_back(*std::move(grade));
  }
  return played;
}

}  // namespace snug::check
