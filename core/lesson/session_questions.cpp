// The questions of a session and the answers given.
#include <algorithm>

#include "lesson/costs.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

bool Session::open_question(const Asked& asked) const {
  for (const Outcome& outcome : outcomes_)
    if (outcome.question == asked.question->id) return outcome.passed;
  return true;
}

const Asked* Session::asked() const {
  if (lesson_.measures) {
    for (const Asked& asked : asked_)
      if (open_question(asked)) return &asked;
    return nullptr;
  }
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
  if (lesson_.measures) {
    if (question == nullptr || !answers_of_costs(*question, answer)) return false;
    outcome_for(question->question->id) = predicted(*question, answer);
    decide_costs();
    ++revision_;
    return true;
  }
  if (question == nullptr || !answers(*question, answer, size())) return false;
  Outcome& outcome = outcome_for(question->question->id);
  outcome = judge(*question, answer, recording(0).steps);
  shown_outcome_ = static_cast<int>(&outcome - outcomes_.data());
  shown_at_ = question->until;
  stand(question->until);
  return true;
}

const Outcome* Session::outcome() const {
  if (lesson_.measures || shown_outcome_ < 0 || previewing_ || step_ != shown_at_) return nullptr;
  return &outcomes_[shown_outcome_];
}

bool Session::has_own_points() const {
  return !edited() && seed() == lesson_.seed && now_.source == own_.source && now_.generated == own_.generated;
}

void Session::measured(std::vector<cost::CostRow> rows) {
  worked_.costs = std::move(rows);
  worked_.grade.reset();
  decide_costs();
  ++revision_;
}

/// What was predicted of the lesson's own points. A later measurement decides it anew.
void Session::decide_costs() {
  if (costs() == nullptr || costs()->size() != lesson_.algorithms.size()) return;
  for (const Asked& asked : asked_)
    for (Outcome& outcome : outcomes_)
      if (outcome.question == asked.question->id) decide(asked, *costs(), outcome);
}

Grade Session::grade_of_costs() const {
  Grade grade;
  grade.points = static_cast<int>(size());
  if (has_own_points()) grade.says = "This is the lesson's own shape: scatter another, or open a file of your own.";
  else if (costs() == nullptr) grade.says = "Measure this shape.";
  else return grade_costs(*lesson_.task, *costs(), algorithm(0)->name);
  return grade;
}

void Session::take_up_answers(std::vector<Outcome> outcomes) {
  std::erase_if(outcomes, [&](const Outcome& outcome) {
    return std::none_of(lesson_.questions.begin(), lesson_.questions.end(),
                        [&](const Question& question) { return question.id == outcome.question; });
  });
  outcomes_ = std::move(outcomes);
  shown_outcome_ = -1;
  ++revision_;
}

void Session::forget_answers() {
  outcomes_.clear();
  shown_outcome_ = -1;
  ++revision_;
}

}  // namespace snug::lesson
