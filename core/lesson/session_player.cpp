// The player: the place in the timeline, its gates and its marks.
#include <algorithm>
#include <cmath>

#include "lesson/costs.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

/// Which mark a step deserves, if any. first_ball: whether there was none before it.
std::optional<Mark::Kind> mark_of(const Step3& step, bool first_ball) {
  if (std::holds_alternative<FrameTaken>(step.fact)) return std::nullopt;  // all are alike
  if (std::holds_alternative<SupportReplaced>(step.fact)) return Mark::Kind::kReplaced;
  if (const auto* forced = std::get_if<BoundaryForced>(&step.fact); forced != nullptr && forced->depth == 1)
    return Mark::Kind::kReplaced;
  if (const auto* moved = std::get_if<MovedToFront>(&step.fact); moved != nullptr && moved->depth == 0)
    return Mark::Kind::kGrew;
  if (const auto* pass = std::get_if<PassJudged<double, 3>>(&step.fact); pass != nullptr && pass->better)
    return Mark::Kind::kBest;
  if (const auto* tried = std::get_if<CandidateTried<double, 3>>(&step.fact);
      tried != nullptr && tried->verdict == CandidateTried<double, 3>::Verdict::kKept)
    return Mark::Kind::kBest;
  if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&step.fact); axis != nullptr && axis->separates)
    return Mark::Kind::kBest;
  if (const auto* plane = std::get_if<query::PlaneTested<double, 3>>(&step.fact);
      plane != nullptr && plane->side == query::Culling::kOutside)
    return Mark::Kind::kBest;
  if (std::holds_alternative<query::Verdict<double, 3>>(step.fact) ||
      std::holds_alternative<query::Claimed>(step.fact) || std::holds_alternative<query::Classified>(step.fact))
    return Mark::Kind::kReplaced;
  if (const auto* tried = std::get_if<BoxTried<double, 3>>(&step.fact); tried != nullptr && tried->better)
    return Mark::Kind::kBest;
  if (const auto* found = std::get_if<RectangleFound<double, 3>>(&step.fact); found != nullptr && found->better)
    return Mark::Kind::kBest;
  if (first_ball || std::holds_alternative<BallGrown<double, 3>>(step.fact)) return Mark::Kind::kGrew;
  return std::nullopt;
}

std::vector<Mark> marks_of(Trace trace, const std::vector<Asked>& questions) {
  std::vector<Mark> marks;
  for (const Asked& asked : questions) marks.push_back({asked.step, Mark::Kind::kQuestion});
  bool has_ball = false;
  for (int i = 0; i < static_cast<int>(trace.size()); ++i) {
    const Step3& step = trace[i].step;
    if (const auto kind = mark_of(step, step.has_volume && !has_ball)) marks.push_back({i + 1, *kind});
    has_ball = step.has_volume;
  }
  std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.step < b.step; });
  return marks;
}

}  // namespace

/// Gates and marks of a new trace. at_end: whether the player stood at the old one's end.
void Session::trace_changed(bool at_end) {
  asked_.clear();
  if (lesson_.measures && has_own_points()) asked_ = asked_of_costs(lesson_);
  if (!lesson_.measures)
    asked_ = asked_on(lesson_, algorithm(0)->name, recording(0).steps, dim(), has_own_points() && off_.empty());
  marks_ = marks_of(recording(0).steps, lesson_.measures ? std::vector<Asked>() : asked_);
  step_ = at_end ? steps() : std::min(step_, steps());
  worked_.hash.reset();
  shown_outcome_ = -1;
  unpick();
}

const Recorder<Step3>::Entry* Session::current(int slot) const {
  const int step = step_of(slot);
  return step > 0 ? &recording(slot).steps[step - 1] : nullptr;
}

int Session::step_of(int slot) const {
  if (slot == 0) return step_;
  const auto all = static_cast<std::int64_t>(recording(slot).steps.size());
  if (step_ == steps()) return static_cast<int>(all);
  return static_cast<int>(step_ * all / steps());
}

std::vector<Index> Session::support(int slot) const { return support_after(recording(slot).steps, step_of(slot)); }

void Session::stand(int step) {
  if (step == step_ && !previewing_) return;
  step_ = step;
  previewing_ = false;
  unpick();
  ++revision_;
}

void Session::go(int step) {
  if (previewing_ && step == steps()) return;
  const bool begin = previewing_ && step > steps();
  const int from = previewing_ ? 0 : step_;
  int to = begin ? 1 : std::clamp(step, 0, steps());
  for (const Asked& asked : asked_)
    if (asked.step >= from && asked.step < to && open_question(asked)) to = asked.step;
  stand(to);
}

void Session::jump(int step) {
  if (previewing_ && step >= steps()) return;
  const int to = std::clamp(step, 0, steps());
  const int from = previewing_ ? 0 : step_;
  for (const Asked& asked : asked_) {
    if (asked.step < from || asked.step >= to || !open_question(asked)) continue;
    Outcome& outcome = outcome_for(asked.question->id);
    outcome = judge(asked, {}, recording(0).steps);
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
