#include "lesson/reopening.hpp"

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
  const auto triangles = subject.with_points()->triangles();
  file.triangles.assign(triangles.begin(), triangles.end());
  return file;
}

/// What is picked one after the other to choose an answer; none for a number, which is typed.
std::vector<Answer> parts_of(const Answer& answer) {
  if (std::holds_alternative<OneHandle>(answer) || std::holds_alternative<OneChoice>(answer)) return {answer};
  std::vector<Answer> parts;
  for (const int choice : choices_of(answer)) parts.emplace_back(OneChoice{choice});
  if (const auto* several = std::get_if<SeveralHandles>(&answer))
    for (const Index handle : several->handles) parts.emplace_back(OneHandle{handle});
  return parts;
}

std::string typed(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.15g", number);
  return text.data();
}

std::string name_of(const Session& session, int slot) {
  return session.player().method(slot) != nullptr ? name_in(session.lesson(), *session.player().method(slot))
                                                  : std::string();
}

}  // namespace

Reopening::Stage Reopening::stage_of(const lesson::Stage::Situated& visited, const Lesson& lesson) {
  const Subject &own = *visited.own.subject, &now = *visited.left.subject;
  const Subject::Origin& origin = now.origin();
  Stage left{.dim = now.dim(),
             .own = own.rows(),
             .scattered = origin.seed != lesson.seed,
             .recast = now.in_float() != own.in_float(),
             .origin = origin,
             .own_source = own.origin().source};
  if (visited.left.slid.values != visited.own.slid.values) left.sliders = visited.left.slid.values;
  if (origin.edited) left.rows = now.rows(), left.text = now.file();
  const bool generated = is_among(generator_kinds(), origin.source);
  if (origin.source != left.own_source && origin.source != kTaskSource && !generated) left.file = file_of(now);
  return left;
}

Reopening::Reopening(const Session& session)
    : lesson_(session.lesson().id), task_(session.stage().task()), algorithm_(name_of(session, 0)),
      step_(session.player().step()),
      at_end_(session.player().step() > 0 && session.player().step() == session.player().steps()),
      previewing_(session.player().previewing()), outcomes_(session.log().outcomes()) {
  for (const lesson::Stage::Situated& visited : session.stage().visited())
    stages_.push_back(stage_of(visited, session.lesson()));
  if (std::string beside = name_of(session, 1); beside != session.lesson().compare) beside_ = std::move(beside);
  if (const Outcome* told = session.conversation().outcome() != nullptr ? session.conversation().outcome()
                                                                        : session.conversation().deciding())
    told_ = told->question;
  if (const Answer* tried = session.conversation().tried())
    tried_ = Try{session.conversation().asked()->question->id, *tried};
}

void Reopening::take(Session& session) const {
  if (session.lesson().id != lesson_) return;
  const AtOnce at_once(session.stage());  // each part is taken on what the last one left
  take_stage(session);
  take_methods(session);
  take_answers(session);
  take_step(session);
  if (!told_.empty()) session.conversation().review(told_);
  take_try(session);
}

/// What the stage was filled from, before it was edited by hand. What is refused is left out.
void Reopening::take_source(Session& session, const Stage& left) const {
  const Subject::Origin& origin = left.origin;
  if (origin.source == kTaskSource) return session.stage().start_task(task_);
  if (left.file) return static_cast<void>(session.stage().load(*left.file, origin.source));
  if (origin.source != left.own_source)
    return static_cast<void>(session.stage().set_generator(origin.source, origin.generated, left.dim, origin.seed));
  if (left.scattered) session.stage().scatter(origin.seed);
}

void Reopening::take_one(Session& session, const Stage& left) const {
  const bool same = session.stage().subject().dim() == left.dim && session.stage().own().rows() == left.own;
  take_source(session, left);
  if (left.recast) static_cast<void>(session.stage().set_float(left.origin.in_float));
  if (!left.sliders.empty())
    static_cast<void>(session.stage().set_sliders(left.sliders));  // unless there are others now
  if (same && !left.rows.empty() && !left.file) static_cast<void>(session.stage().set_rows(left.rows));
  if (const auto text = session.stage().subject().file(); text && left.text && text->own == left.text->own)
    for (const std::string& typed : {left.text->runs, left.text->typed})
      static_cast<void>(session.stage().set_file(typed));
}

/// The situations that are away come first. One that is gone is left out, but what is on the stage is then the lesson's
/// own.
void Reopening::take_stage(Session& session) const {
  for (const Stage& left : stages_) {
    const bool on_stage = &left == &stages_.back();
    if (!on_stage && !left.changed()) continue;
    if (session.stage().show_situation(left.origin.situation) || on_stage) take_one(session, left);
  }
}

void Reopening::take_methods(Session& session) const {
  const auto& offered = session.lesson().algorithms;
  if (is_among(offered, algorithm_)) static_cast<void>(session.player().choose(0, algorithm_));
  if (beside_ && (beside_->empty() || is_among(offered, *beside_)))
    static_cast<void>(session.player().choose(1, *beside_));
}

void Reopening::take_answers(Session& session) const {
  std::vector<Outcome> outcomes;
  for (const Outcome& outcome : outcomes_) {
    const Asked* asked = session.conversation().question_of(outcome);
    if (asked == nullptr) outcomes.push_back(outcome);  // it may be one of another algorithm
    if (asked == nullptr || !answers(*asked, as_asked(*asked, outcome.given))) continue;
    Outcome& again = outcomes.emplace_back(judge(*asked, outcome.given, session.player().run(0)));
    again.on = outcome.on, again.tries = outcome.tries, again.passed = outcome.passed;
  }
  session.take_up(std::move(outcomes));
}

void Reopening::take_step(Session& session) const {
  if (previewing_) return;  // it stays where the lesson begins
  session.go(0);
  session.jump(at_end_ ? session.player().steps() : step_);
}

void Reopening::take_try(Session& session) const {
  if (tried_ && session.conversation().to_predict() != nullptr) session.conversation().ask_predictions();
  const Asked* asked = session.conversation().asked();
  if (!tried_ || asked == nullptr || asked->question->id != tried_->question) return;
  if (!answers(*asked, tried_->answer)) return;
  if (const auto* number = std::get_if<TypedNumber>(&tried_->answer))
    session.conversation().pick(std::string_view(typed(number->number)));
  for (const Answer& part : parts_of(tried_->answer)) session.conversation().pick(part);
  session.conversation().commit();
}

}  // namespace snug::lesson
