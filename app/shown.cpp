#include "app/shown.hpp"

namespace snug::app {
namespace {

/// The points that an answer means, of a question that is about points.
std::vector<Index> points_of(const lesson::Asked& asked, const lesson::Answer& answer) {
  if (answer.kind == lesson::Answer::Kind::kPoint) return {answer.value};
  const auto choice = static_cast<std::size_t>(answer.value);
  if (answer.kind == lesson::Answer::Kind::kSkipped || choice >= asked.choice_points.size()) return {};
  if (asked.question->asks == lesson::Question::Asks::kAxis)
    return {asked.stage_points[2 * choice], asked.stage_points[2 * choice + 1]};
  return asked.choice_points[choice] == kNoIndex ? std::vector<Index>{} : std::vector{asked.choice_points[choice]};
}

void show_outcome(Shown& shown, const lesson::Session& session) {
  const lesson::Outcome* outcome = session.outcome();
  if (outcome == nullptr || outcome->skipped) return;
  for (const lesson::Asked& asked : session.questions()) {
    if (asked.question->id != outcome->question) continue;
    const std::vector<Index> given = points_of(asked, outcome->given);
    if (!outcome->right) shown.guessed_wrong = given;
    // If several answers are right, the one that was given.
    shown.right = outcome->right && !given.empty()
                      ? given
                      : points_of(asked, lesson::model_answer(asked, session.recording(0).steps));
  }
}

}  // namespace

Shown shown_at(const lesson::Session& session, bool want_optimum) {
  Shown shown;
  if (const auto* rival = session.current(1); rival != nullptr && rival->step.has_volume)
    shown.rival = rival->step.volume;
  if (const auto* entry = session.current(0); entry != nullptr) {
    if (entry->step.has_volume) shown.volume = entry->step.volume;
    shown.support = session.support(0);
    shown.finished = session.step() == session.steps();
  }
  show_outcome(shown, session);
  // An exact method's result is the optimum: no second run says it better.
  if (shown.finished && session.algorithm(0)->exact) shown.optimum = shown.volume;
  else if (want_optimum || shown.finished)
    if (const fit::Recording* optimum = session.optimum()) shown.optimum = optimum->result.volume;
  return shown;
}

lesson::Trace steps_shown(const lesson::Session& session) {
  return lesson::Trace(session.recording(0).steps).first(session.step());
}

std::vector<Index> named_by(const fit::Step3& step, const lesson::Session& session) {
  return lesson::points_named(step, session.dim());
}

}  // namespace snug::app
