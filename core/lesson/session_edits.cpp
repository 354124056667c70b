// A session's edits, and undo.
#include <algorithm>
#include <limits>

#include "lesson/names.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/patience.hpp"
#include "lesson/say.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

Done fixed_number() {
  return tl::unexpected(InputError{.what = "in this lesson nothing is added to the stage, and nothing removed"});
}
Done no_points() {
  return tl::unexpected(InputError{.what = "this lesson takes no point file, and scatters no points"});
}

constexpr std::size_t kMostUndo = 200;  // for the bunny, 10 MB

}  // namespace

/// Makes an edit, as one entry of undo. If it is refused, nothing changes.
template <class Edit>
Done Session::edit(Edit edit) {
  auto next = now_->clone();
  if (Done done = edit(*next); !done) return done;
  return become(std::move(next));
}

/// The same for an edit that brings something new, over which the sliders begin again.
template <class Edit>
Done Session::edit_anew(Edit edit) {
  auto next = now_->clone();
  if (Done done = edit(*next); !done) return done;
  auto begun = with_sliders(*lesson_, std::move(next), false);
  if (!begun) return tl::unexpected(std::move(begun.error()));
  return become(*std::move(begun));
}

Done Session::become(std::unique_ptr<Subject> next) {
  Slid slid = slid_;
  follow_edit(*lesson_, slid, *next);
  return become(Snapshot{std::move(next), std::move(slid)});
}

Done Session::become(Snapshot next) {
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  if (method_for(0, *next.subject) == nullptr)
    return tl::unexpected(InputError{.what = next.subject->refusal(*slots_[0].method)});
  at_rest_.reset();
  static_cast<void>(end_drag());
  const bool keeps = keeps_to_task(*next.subject);
  if (conduct_.builds && (next.subject->dim() != dim() || (!keeps && !lesson_->tasks[task_].only.empty())))
    return tl::unexpected(InputError{.what = only_text(lesson_->tasks[task_])});
  waiting_keeps_ = keeps;
  return prepare(std::move(next), Way::kEdit);
}

/// Computes what the next stage needs: all of it, or, where edits give way, only what is soon done. Edits of a few
/// points and what stood on the stage before are not estimated again.
Done Session::prepare(Snapshot next, Way way) {
  constexpr double kSoon = 100e6;  // ns
  const Subject& subject = *next.subject;
  const bool known = way != Way::kEdit || clock_ == nullptr ||
                     (subject.size() <= size() + 1 && subject.origin().source == now_->origin().source);
  if (!Preparation::may_take_long(subject) || (known && !gives_way_)) {
    waiting_.reset();
    take_over(way, std::move(next));
    return {};
  }
  const Preparation::Methods methods{method_for(0, subject), method_for(1, subject)};
  waiting_way_ = way;
  waiting_ = std::make_unique<Preparation>(*lesson_, std::move(next), methods, !known, clock_);
  return go_on(gives_way_ ? kSoon : std::numeric_limits<double>::infinity());
}

Done Session::go_on(double ns) {
  if (waiting_ == nullptr) return {};
  const double begin = clock_ != nullptr ? clock_() : 0;
  const auto passed = [&] { return clock_ != nullptr ? clock_() - begin : 0; };
  do waiting_->go_on();
  while (!waiting_->done() && passed() + waiting_->next_takes() < ns);
  if (!waiting_->done()) return {};
  std::unique_ptr<Preparation> ready = std::move(waiting_);
  if (ready->refused()) return tl::unexpected(*ready->refused());
  put_on_stage(std::move(ready));
  return {};
}

void Session::give_up() {
  waiting_.reset();
  ++revision_;
}

void Session::put_on_stage(std::unique_ptr<Preparation> ready) {
  ready_ = std::move(ready);
  take_over(waiting_way_, std::move(ready_->next));
  rivals_ = std::move(ready_->work.rivals);
  results_ = std::move(ready_->work.results);
  ready_.reset();
}

/// Puts the next thing on the stage, and what was there where undo or redo finds it.
void Session::take_over(Way way, Snapshot next) {
  static_cast<void>(make_room_for(*next.subject));  // there is a method that can take it
  Snapshot before = exchange(std::move(next));
  if (way == Way::kEdit) {
    remember(std::move(before));
    task_started_ = waiting_keeps_;
    return;
  }
  typing_ = false;
  (way == Way::kUndo ? past_ : future_).pop_back();
  (way == Way::kUndo ? future_ : past_).push_back(std::move(before));
}

bool Session::keeps_to_task(const Subject& next) const {
  if (!task_started_ || next.origin().situation != situation() || next.size() != size()) return false;
  const std::vector<std::string>& only = lesson_->tasks[task_].only;
  if (only.empty()) return false;
  for (Index i = 0; i < size(); ++i)
    if (!is_among(only, name_of(i)) && next.at(i) != point(i)) return false;
  // What has no handle, such as a half extent, is among the numbers.
  const std::vector<NumberGroup> here = now_->numbers(), there = next.numbers();
  const auto same_row = [](const NumberRow& a, const NumberRow& b) { return a.values == b.values; };
  return std::equal(here.begin(), here.end(), there.begin(), there.end(), [&](const auto& a, const auto& b) {
    return is_among(only, a.drive) || std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), same_row);
  });
}

/// Replaces what stands on the stage, and returns it.
Snapshot Session::exchange(Snapshot next) {
  const bool goes = next.subject->origin().situation != situation();
  if (goes) leave_situation();
  Snapshot before{std::exchange(now_, std::move(next.subject)), std::exchange(slid_, std::move(next.slid))};
  if (goes) enter_situation();
  else subject_changed();
  return before;
}

Done Session::move(Index i, const Point3& to) {
  if (i < 0 || i >= size()) return tl::unexpected(InputError{.what = "there is no point " + std::to_string(i)});
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  if (!may_move(i)) return tl::unexpected(InputError{.what = only_text(lesson_->tasks[task_])});
  if (!drag_.subject) {
    const bool started = task_started_;
    Done moved = edit([&](Subject& next) { return next.move(i, to); });
    keep_task(started);
    return moved;
  }
  if (Done moved = now_->move(i, to); !moved) return moved;
  follow_edit(*lesson_, slid_, *now_);
  drag_moved_ = true;
  subject_changed();
  return {};
}

Done Session::add(const Point3& at) {
  return edit([&](Subject& next) -> Done {
    if (next.with_points() == nullptr) return fixed_number();
    if (Done added = next.with_points()->add(at); !added) return added;
    if (!next.suits(*slots_[0].method)) return tl::unexpected(InputError{.what = next.refusal(*slots_[0].method)});
    return {};
  });
}

Done Session::remove(Index i) {
  return edit([&](Subject& next) -> Done {
    return next.with_points() != nullptr ? next.with_points()->remove(i) : fixed_number();
  });
}

Done Session::load(const io::PointFile& file, std::string_view name) {
  if (conduct_.builds) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  return edit_anew([&](Subject& next) -> Done {
    return next.with_points() != nullptr ? next.with_points()->load(file, name) : no_points();
  });
}

Done Session::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed) {
  if (conduct_.builds) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  return edit_anew([&](Subject& next) -> Done {
    HasPoints* const points = next.with_points();
    return points != nullptr ? points->set_generator(kind, count, dim, seed, own()) : no_points();
  });
}

Done Session::set_numbers(std::size_t group, std::size_t row, std::span<const double> values) {
  return edit([&](Subject& next) { return next.set_numbers(group, row, values); });
}

Done Session::set_rows(const Rows& rows) {
  return edit([&](Subject& next) { return next.set_rows(rows); });
}

Done Session::set_float(bool in_float) {
  if (in_float == now_->in_float()) return {};
  if (conduct_.builds) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  Snapshot next = snapshot();
  HasScalar* const scalar = next.subject->scalar();
  if (scalar == nullptr) return tl::unexpected(InputError{.what = "this lesson is computed in double alone"});
  if (next.slid.base != nullptr) {  // from which the sliders' next move begins
    auto base = next.slid.base->clone();
    if (Done set = base->scalar()->set_float(in_float); !set) return set;
    next.slid.base = std::move(base);
  }
  if (Done set = scalar->set_float(in_float); !set) return set;
  const bool started = task_started_;
  Done done = become(std::move(next));
  keep_task(started);
  return done;
}

Done Session::call_for(std::string_view name, bool called) {
  return edit([&](Subject& next) -> Done {
    if (next.parts() != nullptr) return next.parts()->call_for(name, called);
    return tl::unexpected(InputError{.what = "nothing here can call for " + std::string(name)});
  });
}

bool Session::can_toggle(const Switch& part) const { return step() > 0 || !part.on || part.optional; }

bool Session::toggle(const Switch& part) {
  const bool declares = part.optional && part.on && (step() == 0 || !part.called);
  return declares ? call_for(part.name, !part.called).has_value() : turn(part.name, !part.on);
}

bool Session::push(Index i) {
  auto next = now_->clone();
  if (i < 0 || i >= size() || next->frames() == nullptr || !next->frames()->push(i, view())) return false;
  const int step = step_;
  if (!become(std::move(next))) return false;
  step_ = std::min(step, steps());  // the run may have become longer
  return true;
}

Done Session::set_file(std::string text) {
  if (const auto file = now_->file(); file && file->typed == text) return {};
  types_on_ = typing_;
  const AtOnce at_once(*this);
  Done set = edit([&](Subject& next) -> Done {
    if (next.text() != nullptr) return next.text()->set_file(std::move(text));
    return tl::unexpected(InputError{.what = "nothing here is made from a text"});
  });
  types_on_ = false;
  if (set) typing_ = true;
  return set;
}

void Session::scatter(std::uint64_t seed) {
  if (conduct_.builds) return;
  static_cast<void>(edit_anew([&](Subject& next) { return next.scatter(seed, own()), Done(); }));
}

void Session::reset() {
  if (conduct_.builds) start_task(task_);
  else static_cast<void>(become(opened().clone()));
}

void Session::settle() {
  places_[shown_].own = snapshot();
  past_.clear(), future_.clear();
}

void Session::start_task(std::size_t task) {
  if (task >= lesson_->tasks.size()) return;
  const Task& own = lesson_->tasks[task];
  const AtOnce at_once(*this);
  static_cast<void>(show_situation(own.situation));
  static_cast<void>(edit([&](Subject& next) { return next.begin_task(*lesson_, own, this->own()), Done(); }));
  slid_.values = slid_.base_values = opened().slid.values;
  follow_edit(*lesson_, slid_, *now_);
  static_cast<void>(choose(0, own.algorithm));
  task_ = task;
  task_started_ = true;
  forget_grades();
  // A student who builds an example looks at results, and was asked nothing yet. Bodies are placed at their start.
  previewing_ = now_->frames() == nullptr;
  step_ = previewing_ ? steps() : 0;
  ++revision_;
}

tl::expected<Grade, InputError> Session::place_answer(std::size_t task, const Rows& answer) {
  start_task(task);
  if (Done made = set_rows(answer); !made) return tl::unexpected(std::move(made.error()));
  task_started_ = true;
  grades_[task].reset();
  return grade(task);
}

tl::expected<Grade, InputError> Session::solve_task(std::size_t task) {
  return place_answer(task, lesson_->tasks[task].model);
}

tl::expected<Grade, InputError> Session::solve_again(std::size_t task) {
  const auto rows = can_solve_again(task) ? unpacked_rows(*done_[task]) : std::nullopt;
  return rows ? place_answer(task, *rows) : grade(task);
}

bool Session::may_move(Index i) const {
  if (conduct_.decides) return false;
  if (!task_started_) return true;
  const std::vector<std::string>& only = lesson_->tasks[task_].only;
  return only.empty() || is_among(only, name_of(i));
}

bool Session::is_own() const { return now_->origin() == own().origin(); }

void Session::remember(Snapshot before) {
  typing_ = false;
  future_.clear();
  if (types_on_) return;
  if (past_.size() == kMostUndo) past_.erase(past_.begin());
  past_.push_back(std::move(before));
}

void Session::begin_drag() {
  static_cast<void>(end_drag());
  drag_ = snapshot();
}

Done Session::end_drag() {
  Snapshot before = std::move(drag_);
  if (before.subject && drag_moved_) {
    remember(std::move(before));
    if (now_->frames() != nullptr) forget_grades();
    ++revision_;
  }
  drag_moved_ = false;
  if (!at_rest_) return {};
  Snapshot next = *std::exchange(at_rest_, std::nullopt);
  return become(std::move(next));
}

void Session::restore(Way way) {
  static_cast<void>(end_drag());
  std::vector<Snapshot>& from = way == Way::kUndo ? past_ : future_;
  // Every snapshot was accepted before, so the lesson's methods can take it.
  if (!from.empty()) static_cast<void>(prepare(from.back().clone(), way));
}

void Session::undo() { restore(Way::kUndo); }
void Session::redo() { restore(Way::kRedo); }

}  // namespace snug::lesson
