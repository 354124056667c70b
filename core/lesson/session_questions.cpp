// The questions of a session and the answers given.
#include "lesson/session.hpp"

namespace snug::lesson {

bool Session::open_question(const Asked& asked) const {
  for (const Outcome& outcome : outcomes_)
    if (outcome.question == asked.question->id) return outcome.passed;
  return true;
}

const Asked* Session::asked() const {
  if (previewing_) return nullptr;
  for (const Asked& asked : asked_)
    if (asked.step == step_ && open_question(asked)) return &asked;
  return nullptr;
}

Outcome& Session::outcome_for(const std::string& id) {
  for (Outcome& outcome : outcomes_)
    if (outcome.question == id) return outcome;
  return outcomes_.emplace_back();
}

bool Session::answer(const Answer& answer) {
  const Asked* question = asked();
  if (question == nullptr || !answers(*question, answer, size())) return false;
  Outcome& outcome = outcome_for(question->question->id);
  outcome = judge(*question, answer, recording(0).steps);
  shown_outcome_ = static_cast<int>(&outcome - outcomes_.data());
  shown_at_ = question->until;
  stand(question->until);
  return true;
}

const Outcome* Session::outcome() const {
  if (shown_outcome_ < 0 || previewing_ || step_ != shown_at_) return nullptr;
  return &outcomes_[static_cast<std::size_t>(shown_outcome_)];
}

void Session::forget_answers() {
  outcomes_.clear();
  shown_outcome_ = -1;
  ++revision_;
}

}  // namespace snug::lesson
