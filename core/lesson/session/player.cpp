#include "lesson/session/player.hpp"

#include <algorithm>

#include "geometry/sort.hpp"
#include "lesson/patience.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

Player::Player(const Lesson& lesson, Stage& stage)
    : lesson_(&lesson), stage_(&stage), left_(stage.places_.size()), grades_(lesson.tasks.size()) {
  use(0, find_method(lesson, lesson.algorithms.front()));
  if (!lesson.compare.empty()) use(1, find_method(lesson, lesson.compare));
}

/// Runs for the first time. Errors: no method of the lesson can take what stands on the stage.
Done Player::begin() {
  const Subject& subject = stage_->subject();
  if (method_for(0, subject) == nullptr) return tl::unexpected(InputError{.what = subject.refusal(*method(0))});
  make_room(subject);
  follow(false, nullptr);
  previewing_ = lesson_->start == Lesson::Start::kEnd;
  step_ = previewing_ ? steps() : 0;
  return {};
}

View Player::view(int slot) const {
  return {{Slot{slots_[0].method, slots_[0].run.get()}, Slot{slots_[1].method, slots_[1].run.get()}},
          slot,
          step_of(slot),
          stage_->dragging()};
}

void Player::use(int slot, const Method* method) {
  Used& own = slots_[slot];
  own = {method, nullptr, {}};
  if (method == nullptr) return;
  const auto pseudocode = pseudocode_of(*method, stage_->subject().dim());
  own.pseudocode.assign(pseudocode.begin(), pseudocode.end());
  for (const Pseudocode& words : lesson_->pseudocode)
    if (find_method(*lesson_, words.algorithm) == method) own.pseudocode.assign(words.lines.begin(), words.lines.end());
}

Done Player::choose(int slot, std::string_view name) {
  const bool clear = name.empty() && slot == 1;
  const Method* method = clear ? nullptr : find_method(*lesson_, name);
  if (method == nullptr && !clear)
    return tl::unexpected(InputError{.what = "there is no algorithm " + std::string(name)});
  const Subject& subject = stage_->subject();
  if (method != nullptr && !subject.suits(*method)) return tl::unexpected(InputError{.what = subject.refusal(*method)});
  if (method == this->method(slot)) return {};
  if (stage_->conduct().decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  const bool at_end = step_ == steps();
  use(slot, method);
  run_again(slot);
  ++revision_;
  if (slot != 0) return {};
  step_ = 0;
  run_changed(at_end);
  forget_grades();
  return {};
}

/// The main method gives way to the first of the lesson's that can take the next points.
const Method* Player::method_for(int slot, const Subject& next) const {
  const Method* own = slots_[slot].method;
  if (own == nullptr || next.suits(*own)) return own;
  if (slot == 0)
    for (const std::string& name : lesson_->algorithms)
      if (const Method* offered = find_method(*lesson_, name); next.suits(*offered)) return offered;
  return nullptr;
}

void Player::make_room(const Subject& next) {
  for (const int slot : {0, 1})
    if (const Method* const method = method_for(slot, next); method != slots_[slot].method) use(slot, method);
  if (next.origin().situation != stage_->situation()) left_[stage_->shown_] = {slots_[0].method, step_, previewing_};
}

void Player::run_again(int slot, Preparation* ready) {
  Used& own = slots_[slot];
  if (own.method == nullptr) return;
  const bool is_there = ready != nullptr && ready->method(slot) == own.method && ready->work.runs[slot] != nullptr;
  own.run = is_there ? std::move(ready->work.runs[slot]) : stage_->subject().run(*own.method, std::move(own.run));
}

void Player::follow(bool entered, Preparation* ready) {
  const bool at_end = slots_[0].run != nullptr && step_ == steps() && step_ > 0;
  rivals_.reset(), results_.clear();
  if (ready != nullptr) rivals_ = std::move(ready->work.rivals), results_ = std::move(ready->work.results);
  if (entered || !waits()) forget_grades();
  run_again(0, ready);
  run_again(1, ready);
  if (entered) enter(left_[stage_->shown_]);
  else run_changed(at_end);
  ++revision_;
}

/// The player stands where it stood, or if another method was chosen since then, where a lesson begins: before the
/// first step, where something is asked there that the end would tell.
void Player::enter(const Left& left) {
  const bool again = left.method == slots_[0].method;  // null before the first time
  const bool shows_end = lesson_->start == Lesson::Start::kEnd;
  previewing_ = again ? left.previewing : shows_end;
  fresh_ = false;  // somebody chose it
  step_ = again ? left.step : shows_end ? steps() : 0;
  const bool asks = run_changed(previewing_, true);
  if (!again && asks) previewing_ = false, step_ = 0;
}

/// at_end: whether the player was at the old run's end.
bool Player::run_changed(bool at_end, bool entered) {
  step_ = at_end ? steps() : std::min(step_, steps());
  hash_.reset();
  return questions_->follow(entered);
}

void Player::begin_task(const Task& task) {
  static_cast<void>(choose(0, task.algorithm));
  forget_grades();
  // A student who builds an example looks at results, and was asked nothing yet. Bodies are placed at their start.
  previewing_ = stage_->subject().frames() == nullptr;
  step_ = previewing_ ? steps() : 0;
  ++revision_;
}

void Player::rest() {
  if (stage_->subject().frames() != nullptr) forget_grades();
}

std::vector<Switch> Player::switches() const {
  const HasParts* const parts = stage_->subject().parts();
  return parts != nullptr ? parts->switches(view()) : std::vector<Switch>();
}

bool Player::toggle(const Switch& part) {
  const bool declares = part.optional && part.on && (step_ == 0 || !part.called);
  if (declares) return stage_->call_for(part.name, !part.called).has_value();
  HasParts* const parts = stage_->now_->parts();
  if (stage_->conduct().decides || parts == nullptr || !parts->turn(part.name, !part.on, view())) return false;
  results_.clear();
  run_again(0);
  run_again(1);
  run_changed(false);
  ++revision_;
  return true;
}

bool Player::push(Index i) {
  auto next = stage_->subject().clone();
  if (i < 0 || i >= next->size() || next->frames() == nullptr || !next->frames()->push(i, view())) return false;
  const int step = step_;
  if (!stage_->become(std::move(next))) return false;
  step_ = std::min(step, steps());  // the run may have become longer
  return true;
}

int Player::step_of(int slot) const {
  if (slot == 0) return step_;
  if (method(slot) == nullptr) return 0;
  const std::int64_t all = run(slot).steps();
  if (step_ == steps()) return static_cast<int>(all);
  return static_cast<int>(step_ * all / steps());
}

bool Player::set_step(int step) {
  if (step == step_ && !previewing_ && !fresh_) return false;
  step_ = step;
  previewing_ = fresh_ = false;
  ++revision_;
  return true;
}

void Player::mark(const std::vector<int>& questions, int last) {
  marks_.clear();
  for (const int step : questions) marks_.push_back({step, Mark::Kind::kQuestion});
  for (int i = 0; i < steps(); ++i)
    if (const auto kind = run(0).mark(i)) marks_.push_back({i + 1, *kind});
  sort_stably(marks_, [](const Mark& a, const Mark& b) { return a.step < b.step; });
  std::erase_if(marks_, [&](const Mark& mark) { return mark.step > last; });
}

int Player::next_mark() const {
  for (const Mark& mark : marks_)
    if (mark.step > step_) return mark.step;
  return steps();
}

int Player::previous_mark() const {
  for (std::size_t i = marks_.size(); i-- > 0;)
    if (marks_[i].step < step_) return marks_[i].step;
  return 0;
}

const fit::Volume3* Player::volume(int slot) const {
  return method(slot) != nullptr ? run(slot).volume(step_of(slot)) : nullptr;
}

std::vector<Index> Player::support(int slot) const {
  return method(slot) != nullptr ? run(slot).support(step_of(slot)) : std::vector<Index>{};
}

std::vector<Proof> Player::proofs(int slot) const {
  if (method(slot) == nullptr) return {};
  const WithDecimals wished(lesson_->view.decimals);
  return stage_->subject().proofs(view(slot));
}

bool Player::waits() const { return stage_->dragging() && stage_->subject().frames() != nullptr; }

const std::vector<Rival>& Player::rivals() const {
  if (!rivals_) rivals_ = stage_->subject().rivals(*lesson_, view());
  return *rivals_;
}

const std::vector<Figure>& Player::result(const Method& of) const {
  static const std::vector<Figure> kNotYet;
  if (waits()) return kNotYet;
  const auto [found, is_new] = results_.try_emplace(&of);
  const Subject& subject = stage_->subject();
  if (is_new && subject.suits(of)) found->second = subject.figures_at_end(of, view());
  return found->second;
}

const Grade& Player::judged(std::size_t task) const {
  if (!grades_[task]) grades_[task] = stage_->subject().grade(*lesson_, lesson_->tasks[task], view());
  return *grades_[task];
}

std::uint64_t Player::trace_hash() const {
  if (!hash_) hash_ = run(0).hash();
  return *hash_;
}

}  // namespace snug::lesson
