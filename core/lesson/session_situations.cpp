// A session's situations and sliders.
#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/session.hpp"
#include "lesson/situations.hpp"

namespace snug::lesson {
namespace {

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

Done Session::show_situation(std::string_view name) {
  if (name == situation()) return {};
  for (Situated& place : places_)
    if (place.own.subject->origin().situation == name)
      return become((place.left.subject != nullptr ? place.left : place.own).clone());
  return tl::unexpected(InputError{.what = "there is no situation " + std::string(name)});
}

void Session::leave_situation() {
  Situated& place = places_[shown_];
  place.left = snapshot();
  place.method = slots_[0].method, place.step = step_, place.previewing = previewing_;
}

std::vector<Session::Visited> Session::visited() const {
  std::vector<Visited> visited;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (i != shown_ && places_[i].left.subject != nullptr)
      visited.push_back({places_[i].own.clone(), places_[i].left.clone()});
  visited.push_back({opened().clone(), snapshot()});
  return visited;
}

/// The player stands where it stood, or if another method was chosen since then, where a lesson begins: before the
/// first step, where something is asked there that the end would tell.
void Session::enter_situation() {
  const auto is_here = [&](const Situated& place) { return place.own.subject->origin().situation == situation(); };
  shown_ = static_cast<std::size_t>(std::find_if(places_.begin(), places_.end(), is_here) - places_.begin());
  const Situated& place = places_[shown_];
  rivals_.reset(), results_.clear();
  forget_grades();
  run_again(0);
  run_again(1);
  const bool again = place.method == slots_[0].method;  // null before the first time
  const bool shows_end = lesson_->start == Lesson::Start::kEnd;
  previewing_ = again ? place.previewing : shows_end;
  fresh_ = false;  // somebody chose it
  step_ = again ? place.step : shows_end ? steps() : 0;
  predicts_ = !lesson_->subject->predict_when_measuring;
  run_changed(previewing_);
  const auto waits = [&](const Asked& asked) { return asked.step == 0 && is_open(*asked.question); };
  if (!again && std::any_of(asked_.begin(), asked_.end(), waits)) previewing_ = false, step_ = 0;
  ++revision_;
}

std::vector<ShownSlider> Session::sliders() const {
  const bool by_hand =
      std::any_of(slots_.begin(), slots_.end(), [](const auto& slot) { return slot.method && slot.method->by_hand; });
  return shown_sliders(*lesson_, at_rest_ ? at_rest_->slid : slid_, *now_, by_hand);
}

Done Session::slide(std::size_t slider, double value) {
  if (slider >= slid_.values.size() || !is_there(lesson_->sliders[slider], *now_))
    return tl::unexpected(InputError{.what = "there is no such slider"});
  if (slid_.values[slider] == value) return {};
  if (task_started_) {
    const Task& task = lesson_->tasks[task_];
    if (!task.only.empty() && !is_among(task.only, lesson_->sliders[slider].drives))
      return tl::unexpected(InputError{.what = only_text(task)});
  }
  std::vector<double> values = slid_.values;
  values[slider] = value;
  const bool started = task_started_;
  Done done = set_sliders(std::move(values));
  keep_task(started);
  const std::string& drives = lesson_->sliders[slider].drives;
  if (done && lesson_->sliders[slider].must_move && !is_among(moved_, drives)) moved_.push_back(drives);
  return done;
}

std::vector<const Slider*> Session::sliders_to_move() const {
  std::vector<const Slider*> left;
  for (const Slider& slider : lesson_->sliders)
    if (slider.must_move && !is_among(moved_, slider.drives)) left.push_back(&slider);
  return left;
}

void Session::take_up_moved(std::vector<std::string> drives) { moved_ = std::move(drives); }

Done Session::slide_to_place(std::size_t slider, int place) {
  if (slider >= slid_.values.size() || !is_there(lesson_->sliders[slider], *now_)) return slide(slider, 0);
  const Slider& own = lesson_->sliders[slider];
  const std::optional<Drive> drive = drive_of(own, *now_);
  return drive ? slide(slider, value_at(own, *drive, place)) : Done{};
}

Done Session::set_sliders(std::vector<double> values) {
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
  if (!next->subject->suits(*slots_[0].method))
    return tl::unexpected(InputError{.what = next->subject->refusal(*slots_[0].method)});
  if (!drag_.subject) return become(*std::move(next));
  at_rest_.reset();
  if (gives_way_ && next->subject->points() != nullptr && next->subject->size() > kMostInHand)
    return at_rest_ = *std::move(next), Done();
  static_cast<void>(make_room_for(*next->subject));
  static_cast<void>(exchange(*std::move(next)));
  drag_moved_ = true;
  return {};
}

std::vector<std::string> Session::situations_waiting() const {
  std::vector<std::string> waiting;
  for (const std::string_view name : situation_names(*lesson_)) {
    const auto waits = [&](const Question& question) {
      return question.situation == name && std::none_of(outcomes_.begin(), outcomes_.end(), [&](const Outcome& one) {
               return one.question == question.id && !one.passed;  // on whatever points
             });
    };
    if (name != situation() && std::any_of(lesson_->questions.begin(), lesson_->questions.end(), waits))
      waiting.emplace_back(name);
  }
  return waiting;
}

}  // namespace snug::lesson
