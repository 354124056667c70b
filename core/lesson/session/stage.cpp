#include "lesson/session/stage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lesson/names.hpp"
#include "lesson/patience.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
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

/// More points than this follow a slider once the hand rests.
constexpr Index kMostInHand = 1000;

/// Whether sliders have the same values, except for rounding.
bool stand_alike(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kRounding = 1e-9;  // in parts of the value
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::abs(x - y) <= kRounding * std::max(std::abs(x), std::abs(y));
  });
}

}  // namespace

Stage::Stage(const Lesson& lesson, std::vector<Situated> situations, Log& log, Clock clock)
    : lesson_(&lesson), log_(&log), clock_(clock), places_(std::move(situations)), now_(own().clone()),
      slid_(opened().slid) {}
Stage::~Stage() = default;

/// Why the main method cannot take it.
tl::unexpected<InputError> Stage::refusal(const Subject& next) const {
  return tl::unexpected(InputError{.what = next.refusal(*runs_->method_for(0, *now_))});
}

/// Makes an edit, as one entry of undo. If it is refused, nothing changes.
Done Stage::edit(auto edit) {
  auto next = now_->clone();
  if (Done done = edit(*next); !done) return done;
  return become(std::move(next));
}

/// What an edit that brings something new leads to: the sliders begin again over it.
tl::expected<Snapshot, InputError> Stage::anew(auto edit) const {
  auto next = now_->clone();
  if (Done done = edit(*next); !done) return tl::unexpected(std::move(done.error()));
  return with_sliders(*lesson_, std::move(next), false);
}

Done Stage::become(tl::expected<Snapshot, InputError> next) {
  return next ? become(*std::move(next)) : tl::unexpected(std::move(next.error()));
}

/// Makes an edit that keeps to the task whatever it changes.
Done Stage::keeping_task(auto edit) {
  const bool started = task_started_;
  Done done = edit();
  if (done) (waiting_ != nullptr ? waiting_keeps_ : task_started_) = started;
  return done;
}

Done Stage::become(std::unique_ptr<Subject> next) {
  Slid slid = slid_;
  follow_edit(*lesson_, slid, *next);
  return become(Snapshot{std::move(next), std::move(slid)});
}

Done Stage::become(Snapshot next) {
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  if (runs_->method_for(0, *next.subject) == nullptr) return refusal(*next.subject);
  at_rest_.reset();
  static_cast<void>(end_drag());
  const bool keeps = keeps_to_task(*next.subject);
  if (conduct_.builds && (next.subject->dim() != now_->dim() || (!keeps && !only().empty())))
    return tl::unexpected(InputError{.what = only_text(lesson_->tasks[task_])});
  waiting_keeps_ = keeps;
  return prepare(std::move(next), Way::kEdit);
}

/// Computes what the next stage needs: all of it, or, where edits give way, only what is soon done. Edits of a few
/// points and what stood on the stage before are not estimated again.
Done Stage::prepare(Snapshot next, Way way) {
  constexpr double kSoon = 100e6;  // ns
  const Subject& subject = *next.subject;
  const bool known = way != Way::kEdit || clock_ == nullptr ||
                     (subject.size() <= now_->size() + 1 && subject.origin().source == now_->origin().source);
  if (!Preparation::may_take_long(subject) || (known && !gives_way_)) {
    waiting_.reset();
    take_over(way, std::move(next));
    return {};
  }
  const Preparation::Methods methods{runs_->method_for(0, subject), runs_->method_for(1, subject)};
  waiting_way_ = way;
  waiting_ = std::make_unique<Preparation>(*lesson_, std::move(next), methods, !known, clock_);
  return go_on(gives_way_ ? kSoon : std::numeric_limits<double>::infinity());
}

Done Stage::go_on(double ns) {
  if (waiting_ == nullptr) return {};
  const double begin = clock_ != nullptr ? clock_() : 0;
  const auto passed = [&] { return clock_ != nullptr ? clock_() - begin : 0; };
  do waiting_->go_on();
  while (!waiting_->done() && passed() + waiting_->next_takes() < ns);
  if (!waiting_->done()) return {};
  const std::unique_ptr<Preparation> ready = std::move(waiting_);
  if (ready->refused()) return tl::unexpected(*ready->refused());
  take_over(waiting_way_, std::move(ready->next), ready.get());
  return {};
}

void Stage::give_up() {
  waiting_.reset();
  ++revision_;
}

/// Puts the next thing on the stage, and what was there where undo or redo finds it.
void Stage::take_over(Way way, Snapshot next, Preparation* ready) {
  Snapshot before = exchange(std::move(next), ready);
  if (way == Way::kEdit) {
    remember(std::move(before));
    task_started_ = waiting_keeps_;
    return;
  }
  typing_ = false;
  (way == Way::kUndo ? past_ : future_).pop_back();
  (way == Way::kUndo ? future_ : past_).push_back(std::move(before));
}

bool Stage::keeps_to_task(const Subject& next) const {
  if (!task_started_ || next.origin().situation != situation() || next.size() != now_->size() || only().empty())
    return false;
  for (Index i = 0; i < now_->size(); ++i)
    if (!is_among(only(), now_->name_of(i)) && next.at(i) != now_->at(i)) return false;
  // What has no handle, such as a half extent, is among the numbers.
  const std::vector<NumberGroup> here = now_->numbers(), there = next.numbers();
  const auto same_row = [](const NumberRow& a, const NumberRow& b) { return a.values == b.values; };
  return std::equal(here.begin(), here.end(), there.begin(), there.end(), [&](const auto& a, const auto& b) {
    return is_among(only(), a.drive) ||
           std::equal(a.rows.begin(), a.rows.end(), b.rows.begin(), b.rows.end(), same_row);
  });
}

/// Replaces what stands on the stage, and returns it.
Snapshot Stage::exchange(Snapshot next, Preparation* ready) {
  const bool goes = next.subject->origin().situation != situation();
  runs_->make_room(*next.subject);
  if (goes) places_[shown_].left = snapshot();
  Snapshot before{std::exchange(now_, std::move(next.subject)), std::exchange(slid_, std::move(next.slid))};
  const auto is_here = [&](const Situated& place) { return place.own.subject->origin().situation == situation(); };
  if (goes) shown_ = static_cast<std::size_t>(std::find_if(places_.begin(), places_.end(), is_here) - places_.begin());
  runs_->follow(goes, ready);
  return before;
}

Done Stage::move(Index i, const Point3& to) {
  if (i < 0 || i >= now_->size()) return tl::unexpected(InputError{.what = "there is no point " + std::to_string(i)});
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  if (!may_move(i)) return tl::unexpected(InputError{.what = only_text(lesson_->tasks[task_])});
  if (!drag_.subject) return keeping_task([&] { return edit([&](Subject& next) { return next.move(i, to); }); });
  if (Done moved = now_->move(i, to); !moved) return moved;
  follow_edit(*lesson_, slid_, *now_);
  drag_moved_ = true;
  runs_->follow(false, nullptr);
  return {};
}

Done Stage::add(const Point3& at) {
  return edit([&](Subject& next) -> Done {
    if (next.with_points() == nullptr) return fixed_number();
    if (Done added = next.with_points()->add(at); !added) return added;
    const Method& main = *runs_->method_for(0, *now_);
    return next.suits(main) ? Done() : refusal(next);
  });
}

Done Stage::remove(Index i) {
  return edit([&](Subject& next) -> Done {
    return next.with_points() != nullptr ? next.with_points()->remove(i) : fixed_number();
  });
}

Done Stage::load(const io::PointFile& file, std::string_view name) {
  if (conduct_.decides || conduct_.builds)
    return tl::unexpected(InputError{.what = "in an exercise, points cannot be pasted or opened"});
  return become(anew([&](Subject& next) -> Done {
    return next.with_points() != nullptr ? next.with_points()->load(file, name) : no_points();
  }));
}

Done Stage::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed) {
  if (conduct_.builds) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  return become(anew([&](Subject& next) -> Done {
    HasPoints* const points = next.with_points();
    return points != nullptr ? points->set_generator(kind, count, dim, seed, own()) : no_points();
  }));
}

Done Stage::set_numbers(std::size_t group, std::size_t row, std::span<const double> values) {
  return edit([&](Subject& next) { return next.set_numbers(group, row, values); });
}

Done Stage::set_rows(const Rows& rows) {
  return edit([&](Subject& next) { return next.set_rows(rows); });
}

Done Stage::set_float(bool in_float) {
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
  return keeping_task([&] { return become(std::move(next)); });
}

Done Stage::call_for(std::string_view name, bool called) {
  return edit([&](Subject& next) -> Done {
    if (next.parts() != nullptr) return next.parts()->call_for(name, called);
    return tl::unexpected(InputError{.what = "nothing here can call for " + std::string(name)});
  });
}

Done Stage::set_file(std::string text) {
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

tl::expected<Snapshot, InputError> Stage::scattered(std::uint64_t seed) const {
  if (conduct_.builds) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  return anew([&](Subject& next) { return next.scatter(seed, own()), Done(); });
}

Done Stage::scatter(std::uint64_t seed) { return become(scattered(seed)); }

Done Stage::reset() {
  if (!conduct_.builds) return become(opened().clone());
  start_task(task_);
  return {};
}

void Stage::settle() {
  places_[shown_].own = snapshot();
  forget_undo();
}

void Stage::start_task(std::size_t task) {
  if (task >= lesson_->tasks.size()) return;
  const Task& own = lesson_->tasks[task];
  const AtOnce at_once(*this);
  static_cast<void>(show_situation(own.situation));
  static_cast<void>(edit([&](Subject& next) { return next.begin_task(*lesson_, own, this->own()), Done(); }));
  slid_.values = slid_.base_values = opened().slid.values;
  follow_edit(*lesson_, slid_, *now_);
  task_ = task;
  task_started_ = true;
  runs_->begin_task(own);
}

bool Stage::may_move(Index i) const {
  if (conduct_.decides) return false;
  if (!task_started_) return true;
  return only().empty() || is_among(only(), now_->name_of(i));
}

void Stage::remember(Snapshot before) {
  typing_ = false;
  future_.clear();
  if (types_on_) return;
  if (past_.size() == kMostUndo) past_.erase(past_.begin());
  past_.push_back(std::move(before));
}

void Stage::begin_drag() {
  static_cast<void>(end_drag());
  drag_ = snapshot();
}

Done Stage::end_drag() {
  Snapshot before = std::move(drag_);
  if (before.subject && drag_moved_) {
    remember(std::move(before));
    runs_->rest();
    ++revision_;
  }
  drag_moved_ = false;
  if (!at_rest_) return {};
  Snapshot next = *std::exchange(at_rest_, std::nullopt);
  return become(std::move(next));
}

void Stage::restore(Way way) {
  static_cast<void>(end_drag());
  std::vector<Snapshot>& from = way == Way::kUndo ? past_ : future_;
  // Every snapshot was accepted before, so the lesson's methods can take it.
  if (!from.empty()) static_cast<void>(prepare(from.back().clone(), way));
}

Done Stage::show_situation(std::string_view name) {
  if (name == situation()) return {};
  for (Situated& place : places_)
    if (place.own.subject->origin().situation == name)
      return become((place.left.subject != nullptr ? place.left : place.own).clone());
  return tl::unexpected(InputError{.what = "there is no situation " + std::string(name)});
}

std::vector<Stage::Situated> Stage::visited() const {
  std::vector<Situated> visited;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (i != shown_ && places_[i].left.subject != nullptr)
      visited.push_back({places_[i].own.clone(), places_[i].left.clone()});
  visited.push_back({opened().clone(), snapshot()});
  return visited;
}

std::vector<ShownSlider> Stage::sliders() const {
  const auto is_by_hand = [&](int slot) {
    const Method* const method = runs_->method_for(slot, *now_);
    return method != nullptr && method->by_hand;
  };
  const bool by_hand = is_by_hand(0) || is_by_hand(1);
  return shown_sliders(*lesson_, at_rest_ ? at_rest_->slid : slid_, *now_, by_hand);
}

Done Stage::slide(std::size_t slider, double value) {
  if (slider >= slid_.values.size() || !is_there(lesson_->sliders[slider], *now_))
    return tl::unexpected(InputError{.what = "there is no such slider"});
  if ((at_rest_ ? at_rest_->slid : slid_).values[slider] == value) return {};
  if (task_started_ && !only().empty() && !is_among(only(), lesson_->sliders[slider].drives))
    return tl::unexpected(InputError{.what = only_text(lesson_->tasks[task_])});
  std::vector<double> values = slid_.values;
  values[slider] = value;
  Done done = keeping_task([&] { return set_sliders(std::move(values)); });
  if (done) log_->add_moved(lesson_->sliders[slider]);
  return done;
}

Done Stage::slide_to_place(std::size_t slider, int place) {
  if (slider >= slid_.values.size() || !is_there(lesson_->sliders[slider], *now_)) return slide(slider, 0);
  const Slider& own = lesson_->sliders[slider];
  const std::optional<Drive> drive = drive_of(own, *now_);
  return drive ? slide(slider, value_at(own, *drive, place)) : Done{};
}

Done Stage::set_sliders(std::vector<double> values) {
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  if (values.size() != slid_.values.size()) return tl::unexpected(InputError{.what = "there are no such sliders"});
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]))
      return tl::unexpected(InputError{.what = "a slider's value must be a finite number"});
    if (values[i] == slid_.values[i]) continue;  // it may have been edited to beyond the slider's ends
    values[i] = std::clamp(values[i], lesson_->sliders[i].from, lesson_->sliders[i].to);
  }
  auto next = slid_to(*lesson_, snapshot(), std::move(values));
  if (!next) return tl::unexpected(std::move(next.error()));
  // Rows alone do not tell: a frustum's do not have how near its near plane is.
  const bool as_opened = stand_alike(next->slid.values, opened().slid.values) &&
                         next->subject->rows() == own().rows() && next->subject->in_float() == own().in_float();
  if (as_opened) next = opened().clone();
  if (!next->subject->suits(*runs_->method_for(0, *now_))) return refusal(*next->subject);
  if (!drag_.subject) return become(*std::move(next));
  at_rest_.reset();
  if (gives_way_ && next->subject->points() != nullptr && next->subject->size() > kMostInHand)
    return at_rest_ = *std::move(next), Done();
  static_cast<void>(exchange(*std::move(next)));
  drag_moved_ = true;
  return {};
}

}  // namespace snug::lesson
