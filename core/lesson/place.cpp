#include "lesson/place.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "geometry/generate.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kTaskSource = "task";

/// The points on the stage as a file would have them; none if the subject has no points.
std::optional<io::PointFile> file_of(const Subject& subject) {
  if (subject.points() == nullptr) return std::nullopt;
  io::PointFile file{subject.dim(), all_points(*subject.points()), {}};
  file.triangles.assign(subject.triangles().begin(), subject.triangles().end());
  return file;
}

/// What is picked one after the other to choose an answer; none for a number, which is typed.
std::vector<Answer> parts_of(const Asked& asked, const Answer& answer) {
  using Kind = Answer::Kind;
  if (answer.kind == Kind::kNumber) return {};
  std::vector<Answer> parts;
  for (const int one : answer.list) parts.push_back({answer.kind == Kind::kPoints ? Kind::kPoint : Kind::kChoice, one});
  if (!answer.list.empty()) return parts;
  if (!asked.many) return {answer};
  for (int i = 0; i < static_cast<int>(asked.choices.size()); ++i)
    if (is_picked(asked, answer, i)) parts.push_back({Kind::kChoice, i});
  return parts;
}

std::string typed(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", number);
  return text.data();
}

std::string name_of(const Session& session, int slot) {
  return session.method(slot) != nullptr ? name_in(session.lesson(), *session.method(slot)) : std::string();
}

}  // namespace

Place::Place(const Session& session)
    : lesson_(session.lesson().id), dim_(session.dim()), own_(session.own().rows()),
      scattered_(session.seed() != session.lesson().seed), origin_(session.subject().origin()),
      own_source_(session.own().origin().source), task_(session.task()), algorithm_(name_of(session, 0)),
      step_(session.step()), at_end_(session.step() > 0 && session.step() == session.steps()),
      previewing_(session.previewing()), outcomes_(session.outcomes()) {
  if (session.has_slid()) sliders_ = session.slider_values();
  if (session.edited()) rows_ = session.subject().rows();
  const bool generated = is_among(generator_kinds(), origin_.source);
  if (origin_.source != own_source_ && origin_.source != kTaskSource && !generated) file_ = file_of(session.subject());
  if (std::string beside = name_of(session, 1); beside != session.lesson().compare) beside_ = std::move(beside);
  if (const Outcome* told = session.outcome() != nullptr ? session.outcome() : session.deciding())
    told_ = told->question;
  if (const Answer* tried = session.tried()) tried_ = Try{session.asked()->question->id, *tried};
}

void Place::take(Session& session) const {
  if (session.lesson().id != lesson_) return;
  take_stage(session);
  take_methods(session);
  take_answers(session);
  take_step(session);
  if (!told_.empty()) session.review(told_);
  take_try(session);
}

/// What the stage was filled from, before it was edited by hand. What is refused is left out.
void Place::take_source(Session& session) const {
  if (origin_.source == kTaskSource) return session.start_task(task_);
  if (file_) return static_cast<void>(session.load(*file_, origin_.source));
  if (origin_.source != own_source_)
    return static_cast<void>(session.set_generator(origin_.source, origin_.generated, dim_, origin_.seed));
  if (scattered_) session.scatter(origin_.seed);
}

void Place::take_stage(Session& session) const {
  static_cast<void>(session.show_situation(origin_.situation));  // or the lesson's own, if that is gone
  const bool same = session.dim() == dim_ && session.own().rows() == own_;
  take_source(session);
  if (!sliders_.empty()) static_cast<void>(session.set_sliders(sliders_));  // unless there are others now
  if (same && !rows_.empty() && !file_) static_cast<void>(session.set_rows(rows_));
}

void Place::take_methods(Session& session) const {
  const auto& offered = session.lesson().algorithms;
  if (is_among(offered, algorithm_)) static_cast<void>(session.choose(0, algorithm_));
  if (beside_ && (beside_->empty() || is_among(offered, *beside_))) static_cast<void>(session.choose(1, *beside_));
}

void Place::take_answers(Session& session) const {
  std::vector<Outcome> outcomes;
  for (const Outcome& outcome : outcomes_) {
    const Asked* asked = session.question_of(outcome);
    if (asked == nullptr) outcomes.push_back(outcome);  // it may be one of another algorithm
    if (asked == nullptr || !answers(*asked, outcome.given)) continue;
    Outcome& again = outcomes.emplace_back(judge(*asked, outcome.given, session.run(0)));
    again.tries = outcome.tries, again.passed = outcome.passed;
  }
  session.take_up_answers(std::move(outcomes));
}

void Place::take_step(Session& session) const {
  if (previewing_) return;  // it stays where the lesson begins
  session.go(0);
  session.jump(at_end_ ? session.steps() : step_);
}

void Place::take_try(Session& session) const {
  const Asked* asked = session.asked();
  if (!tried_ || asked == nullptr || asked->question->id != tried_->question) return;
  if (!answers(*asked, tried_->answer)) return;
  if (tried_->answer.kind == Answer::Kind::kNumber) session.pick(std::string_view(typed(tried_->answer.number)));
  for (const Answer& part : parts_of(*asked, tried_->answer)) session.pick(part);
  session.commit();
}

}  // namespace snug::lesson
