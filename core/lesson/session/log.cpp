#include "lesson/session/log.hpp"

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/situations.hpp"

namespace snug::lesson {

Log::Log(const Lesson& lesson, Clock clock)
    : lesson_(&lesson), clock_(clock), opened_at_(clock != nullptr ? clock() : 0), done_(lesson.tasks.size()) {}

double Log::seconds() const { return clock_ != nullptr ? (clock_() - opened_at_) * 1e-9 : 0; }

const Outcome* Log::outcome_of(std::string_view question, std::uint64_t on) const {
  const auto found = std::find_if(outcomes_.begin(), outcomes_.end(),
                                  [&](const Outcome& one) { return one.question == question && one.on == on; });
  return found == outcomes_.end() ? nullptr : &*found;
}

std::vector<std::string> Log::situations_waiting(std::string_view besides) const {
  std::vector<std::string> waiting;
  for (const std::string_view name : situation_names(*lesson_)) {
    const auto waits = [&](const Question& question) {
      return question.situation == name && std::none_of(outcomes_.begin(), outcomes_.end(), [&](const Outcome& one) {
               return one.question == question.id && !one.passed;
             });
    };
    if (name != besides && std::any_of(lesson_->questions.begin(), lesson_->questions.end(), waits))
      waiting.emplace_back(name);
  }
  return waiting;
}

std::size_t Log::first_to_do() const {
  return static_cast<std::size_t>(std::find(done_.begin(), done_.end(), std::nullopt) - done_.begin());
}

std::vector<const Slider*> Log::to_move() const {
  std::vector<const Slider*> left;
  for (const Slider& slider : lesson_->sliders)
    if (slider.must_move && !is_among(moved_, slider.drives)) left.push_back(&slider);
  return left;
}

std::size_t Log::add(Outcome outcome) {
  const Outcome* const earlier = outcome_of(outcome.question, outcome.on);
  const std::size_t at = earlier != nullptr ? static_cast<std::size_t>(earlier - outcomes_.data()) : outcomes_.size();
  if (earlier == nullptr) outcomes_.emplace_back();
  outcomes_[at] = std::move(outcome);
  return at;
}

void Log::add(std::string_view question, const Answer& answer, bool right) {
  given_.push_back({std::string(question), answer, right, seconds()});
}

void Log::take_back() {
  std::erase_if(outcomes_, [&](const Outcome& outcome) { return outcome.question == given_.back().question; });
  given_.pop_back();
}

void Log::add_done(std::size_t task, const Subject& by) {
  constexpr std::size_t kMostLetters = 8000;  // as a device keeps it
  if (done_[task]) return;
  std::string word = packed_rows(by.rows());
  done_[task] = word.size() <= kMostLetters ? std::move(word) : std::string();
}

void Log::add_moved(const Slider& slider) {
  if (slider.must_move && !is_among(moved_, slider.drives)) moved_.push_back(slider.drives);
}

void Log::take_up(std::vector<Outcome> outcomes) {
  std::erase_if(outcomes, [&](const Outcome& outcome) {
    return std::none_of(lesson_->questions.begin(), lesson_->questions.end(),
                        [&](const Question& question) { return question.id == outcome.question; });
  });
  outcomes_ = std::move(outcomes);
}

void Log::take_as_asked(const Asked& asked) {
  for (Outcome& outcome : outcomes_)
    if (outcome.question == asked.question->id) outcome.given = as_asked(asked, std::move(outcome.given));
}

void Log::take_up(const std::vector<DoneTask>& tasks, std::vector<std::string> moved) {
  moved_ = std::move(moved);
  for (const auto& [task, by] : tasks)
    if (task >= 0 && task < std::ssize(done_)) done_[task] = by;
}

void Log::forget_answers() { outcomes_.clear(), given_.clear(), moved_.clear(); }

}  // namespace snug::lesson
