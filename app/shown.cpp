#include "app/shown.hpp"

namespace snug::app {
namespace {

/// The handles that an answer means, if the question is about handles.
std::vector<Index> handles_of(const lesson::Asked& asked, const lesson::Answer& answer) {
  if (answer.kind == lesson::Answer::Kind::kPoint) return {answer.value};
  if (answer.kind == lesson::Answer::Kind::kPoints) return {answer.list.begin(), answer.list.end()};
  std::vector<Index> handles;
  if (answer.kind != lesson::Answer::Kind::kChoice) return handles;
  for (std::size_t i = 0; i < asked.choice_handles.size(); ++i)
    if (lesson::is_picked(asked, answer, static_cast<int>(i)))
      handles.insert(handles.end(), asked.choice_handles[i].begin(), asked.choice_handles[i].end());
  return handles;
}

void show_outcome(Shown& shown, const lesson::Session& session) {
  if (const lesson::Answer* tried = session.tried()) shown.guessed_wrong = handles_of(*session.asked(), *tried);
  const lesson::Outcome* outcome = session.outcome();
  if (outcome == nullptr || outcome->skipped) return;
  for (const lesson::Asked& asked : session.questions()) {
    if (asked.question->id != outcome->question) continue;
    const std::vector<Index> given = handles_of(asked, outcome->given);
    if (!outcome->right) shown.guessed_wrong = given;
    // If several answers are right, marks the one that was given; after a wrong one, marks the right one on request.
    if (outcome->right && !given.empty()) shown.right = given;
    else if (outcome->right || session.answer_shown())
      shown.right = handles_of(asked, lesson::model_answer(asked, session.run(0)));
  }
}

}  // namespace

Shown shown_at(const lesson::Session& session) {
  Shown shown;
  const fit::Volume3* rival = session.method(1) != session.method(0) ? session.volume(1) : nullptr;
  if (rival != nullptr) shown.rival = *rival;
  if (session.step() > 0) {
    if (const fit::Volume3* own = session.volume(0)) shown.volume = *own;
    shown.support = session.support(0);
    shown.finished = session.step() == session.steps();
  }
  show_outcome(shown, session);
  // An exact method's result is the optimum, so no second run is needed.
  if (shown.finished && session.method(0)->exact) shown.optimum = shown.volume;
  return shown;
}

std::vector<Index> named_now(const lesson::Session& session) {
  return session.step() > 0 ? session.run(0).handles(session.step() - 1) : std::vector<Index>();
}

}  // namespace snug::app
