// The player: the place in the timeline, its gates and its marks.
#include <algorithm>

#include "geometry/sort.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

std::vector<Mark> marks_of(const Run& run, const std::vector<Asked>& questions) {
  std::vector<Mark> marks;
  for (const Asked& asked : questions)
    if (asked.step != Asked::kAnytime) marks.push_back({asked.step, Mark::Kind::kQuestion});
  for (int i = 0; i < run.steps(); ++i)
    if (const auto kind = run.mark(i)) marks.push_back({i + 1, *kind});
  sort_stably(marks, [](const Mark& a, const Mark& b) { return a.step < b.step; });
  return marks;
}

/// Where the marks end while something is to be decided: those to come would tell what is right.
int last_mark(const std::vector<Asked>& questions, int steps, auto is_open) {
  int last = steps;
  for (const Asked& asked : questions)
    if (asked.step != Asked::kAnytime && is_open(asked)) last = std::min(last, asked.step);
  return last;
}

}  // namespace

/// Computes the gates and marks of a new run. at_end: whether the player was at the old run's end.
void Session::run_changed(bool at_end) {
  const bool is_disturbed = now_->frames() != nullptr && now_->frames()->is_disturbed();
  asked_ = asked_on(*lesson_, name_in(*lesson_, *method(0)), *now_, run(0), is_own() && !is_disturbed);
  marks_ = marks_of(run(0), asked_);
  step_ = at_end ? steps() : std::min(step_, steps());
  hash_.reset();
  shown_outcome_ = -1;
  deciding_ = false;
  tried_.reset();
  unpick();
}

int Session::step_of(int slot) const {
  if (slot == 0) return step_;
  if (method(slot) == nullptr) return 0;
  const std::int64_t all = run(slot).steps();
  if (step_ == steps()) return static_cast<int>(all);
  return static_cast<int>(step_ * all / steps());
}

void Session::stand(int step) {
  if (step == step_ && !previewing_ && !fresh_) return;
  step_ = step;
  previewing_ = fresh_ = false;
  if (step >= shown_at_) deciding_ = false;
  if (!deciding_ && step != shown_at_) shown_outcome_ = -1;
  if (conduct_.decides) {
    const int last = last_mark(asked_, steps(), [&](const Asked& asked) { return is_open(*asked.question); });
    marks_ = marks_of(run(0), asked_);
    std::erase_if(marks_, [&](const Mark& mark) { return mark.step > last; });
  }
  unpick();
  ++revision_;
}

void Session::go(int step) {
  if (previewing_ && step == steps()) return;
  if (step != step_) acknowledge();
  if (deciding_) {  // a step on the way there; any other step ends it
    if (step > step_) return stand(std::min(step, shown_at_));
    deciding_ = false;
  }
  const bool begin = previewing_ && step > steps();
  const int from = previewing_ ? 0 : step_;
  int to = begin ? 1 : std::clamp(step, 0, steps());
  for (const Asked& asked : asked_)
    if (asked.step != Asked::kAnytime && asked.step >= from && asked.step < to && is_open(*asked.question))
      to = asked.step;
  stand(to);
}

void Session::forward() {
  if (!acknowledge()) go(step_ + 1);
}

void Session::jump(int step) {
  // A lesson that starts at its end is there already; who has answered something comes back to the end itself.
  if (previewing_ && step >= steps() && outcomes_.empty()) return;
  deciding_ = false;
  const int to = std::clamp(step, 0, steps());
  const int from = previewing_ ? 0 : step_;
  for (const Asked& asked : asked_) {
    if (asked.step == Asked::kAnytime || asked.step < from || asked.step >= to || !is_open(*asked.question)) continue;
    Outcome& outcome = outcome_for(asked.question->id);
    outcome = judged(asked, {});
    outcome.passed = true;
  }
  stand(to);
}

int Session::next_mark() const {
  for (const Mark& mark : marks_)
    if (mark.step > step_) return mark.step;
  return steps();
}

int Session::previous_mark() const {
  for (std::size_t i = marks_.size(); i-- > 0;)
    if (marks_[i].step < step_) return marks_[i].step;
  return 0;
}

}  // namespace snug::lesson
