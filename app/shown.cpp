#include "app/shown.hpp"

namespace snug::app {
namespace {

/// The handles that an answer means, if the question is about handles.
std::vector<Index> handles_of(const lesson::Asked& asked, const lesson::Answer& answer) {
  if (const auto* one = std::get_if<lesson::OneHandle>(&answer)) return {one->handle};
  if (const auto* several = std::get_if<lesson::SeveralHandles>(&answer)) return several->handles;
  std::vector<Index> handles;
  if (std::holds_alternative<lesson::ChoicesInOrder>(answer)) return handles;
  for (std::size_t i = 0; i < asked.choice_handles.size(); ++i)
    if (lesson::is_picked(asked, answer, static_cast<int>(i)))
      handles.insert(handles.end(), asked.choice_handles[i].begin(), asked.choice_handles[i].end());
  return handles;
}

void show_outcome(Shown& shown, const lesson::Session& session) {
  if (const lesson::Answer* tried = session.conversation().tried())
    shown.guessed_wrong = handles_of(*session.conversation().asked(), *tried);
  const lesson::Outcome* outcome = session.conversation().outcome();
  if (outcome == nullptr || outcome->skipped) return;
  for (const lesson::Asked& asked : session.conversation().questions()) {
    if (asked.question->id != outcome->question) continue;
    const std::vector<Index> given = handles_of(asked, outcome->given);
    if (!outcome->right) shown.guessed_wrong = given;
    // If several answers are right, marks the one that was given; after a wrong one, marks the right one on request.
    if (outcome->right && !given.empty()) shown.right = given;
    else if (outcome->right || session.conversation().answer_shown())
      shown.right = handles_of(asked, lesson::model_answer(asked, session.player().run(0)));
  }
}

}  // namespace

Shown shown_at(const lesson::Session& session) {
  Shown shown;
  const fit::Volume3* rival =
      session.player().method(1) != session.player().method(0) ? session.player().volume(1) : nullptr;
  if (rival != nullptr) shown.rival = *rival;
  if (session.player().step() > 0) {
    if (const fit::Volume3* own = session.player().volume(0)) shown.volume = *own;
    shown.support = session.player().support(0);
    shown.finished = session.player().step() == session.player().steps();
  }
  show_outcome(shown, session);
  // An exact method's result is the optimum, so no second run is needed.
  if (shown.finished && session.player().method(0)->exact) shown.optimum = shown.volume;
  return shown;
}

std::vector<Index> named_now(const lesson::Session& session) {
  return session.player().step() > 0 ? session.player().run(0).handles(session.player().step() - 1)
                                     : std::vector<Index>();
}

}  // namespace snug::app
