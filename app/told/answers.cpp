#include "app/told/answers.hpp"

#include <span>
#include <utility>

#include "lesson/progress.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app::told {
namespace {

std::optional<Answer> answer_of(const lesson::Session& session, const lesson::Answer* answer) {
  if (answer == nullptr) return std::nullopt;
  const auto name = [&](Index handle) { return session.stage().subject().name_of(handle); };
  Answer told;
  std::string typed;
  if (const auto* one = std::get_if<lesson::OneHandle>(answer)) typed = name(one->handle);
  if (const auto* several = std::get_if<lesson::SeveralHandles>(answer))
    for (const Index handle : several->handles) typed += (typed.empty() ? "" : ", ") + name(handle);
  if (const auto* number = std::get_if<lesson::TypedNumber>(answer)) typed = lesson::plain_number(number->number);
  const auto* choice = std::get_if<lesson::OneChoice>(answer);
  const auto chosen = choice != nullptr ? std::span(&choice->choice, 1) : lesson::choices_of(*answer);
  told.choices.assign(chosen.begin(), chosen.end());
  if (!typed.empty()) told.handle = std::move(typed);
  return told;
}

std::optional<Asked> asked_of(const lesson::Session& session, lesson::ProseFigures& figures) {
  const lesson::Conversation& now = session.conversation();
  const lesson::Asked* asked = now.asked();
  if (asked == nullptr) return std::nullopt;
  return Asked{.id = asked->question->id,
               .prompt = plain_now(asked->prompt, figures),
               .prompt_words = prompt_of(asked->prompt),
               .step = asked->step,
               .choices = asked->choices,
               .many = asked->many,
               .ordered = asked->ordered,
               .field = lesson::field_word(*asked),
               .on_stage = asked->on_stage,
               .place = lesson::place_text(*asked, now.questions()),
               .how = lesson::how_to_answer(*asked),
               .picked = answer_of(session, now.picked()),
               .tried = answer_of(session, now.tried()),
               .ready = now.picked() != nullptr && lesson::answers(*asked, *now.picked()),
               .says = now.answer_says()};
}

Outcome outcome_of(const lesson::Outcome& own, lesson::ProseFigures& figures) {
  return {.kind = state_word(lesson::answer_state_of(&own)),
          .tries = own.tries,
          .question = own.question,
          .on = own.on,
          .from_step = own.from_step,
          .step = own.step,
          .right = own.right,
          .skipped = own.skipped,
          .passed = own.passed,
          .pending = own.pending,
          .verdict = lesson::verdict_text(own),
          .predicted = own.predicted,
          .happened = own.happened,
          .says = own.says,
          .because = plain_now(own.because, figures),
          .because_words = prompt_of(own.because)};
}

std::optional<Told> told_of(const lesson::Session& session, const lesson::Outcome* outcome,
                            lesson::ProseFigures& figures) {
  if (outcome == nullptr) return std::nullopt;
  Told told{outcome_of(*outcome, figures)};
  const lesson::Conversation& now = session.conversation();
  const lesson::Asked* asked = now.question_of(*outcome);
  if (asked == nullptr) return told;
  told.prompt = plain_now(asked->prompt, figures);
  told.prompt_words = prompt_of(asked->prompt);
  told.place = lesson::place_text(*asked, now.questions());
  told.choices = asked->choices;
  told.ordered = asked->ordered;
  told.given = answer_of(session, &outcome->given);
  told.can_watch = now.can_watch_outcome();
  told.can_show = now.can_show_answer();
  told.shown = now.answer_shown();
  if (told.shown || told.ordered) told.right_choices = now.right_choices();
  return told;
}

Grade grade_of(const lesson::Grade& own) { return {own.done, own.points, own.excess, own.says}; }

}  // namespace

std::string_view state_word(lesson::AnswerState state) {
  switch (state) {
    case lesson::AnswerState::kRight: return "right";
    case lesson::AnswerState::kWrong: return "wrong";
    case lesson::AnswerState::kSkipped: return "skipped";
    case lesson::AnswerState::kOpen: break;
  }
  return "open";
}

Conversation conversation_of(const lesson::Session& session) {
  const lesson::Conversation& now = session.conversation();
  lesson::ProseFigures figures(now);
  return {.asked = asked_of(session, figures),
          .outcome = told_of(session, now.outcome(), figures),
          .deciding = told_of(session, now.deciding(), figures),
          .summary = now.at_summary()};
}

Log log_of(const lesson::Session& session) {
  const lesson::Conversation& now = session.conversation();
  lesson::ProseFigures figures(now);
  Log told{.questions = now.questions().size(),
           .can_practise = now.can_practise(),
           .situations_waiting = session.log().situations_waiting(session.stage().situation()),
           .score = now.score()};
  for (const lesson::Asked& asked : now.questions()) {
    const lesson::Outcome* outcome = now.outcome_of(asked);
    const std::string prompt = plain_now(asked.prompt, figures);
    told.predictions.push_back({.id = asked.question->id,
                                .prompt = prompt,
                                .short_ = std::string(lesson::short_prompt(prompt)),
                                .kind = state_word(lesson::answer_state_of(outcome)),
                                .standing = lesson::answer_state_text(outcome)});
  }
  const lesson::Tally tally = now.tally();
  told.tally = {tally.right, tally.second, tally.wrong, tally.skipped, tally.open};
  for (const lesson::Method* method : now.waiting()) told.waiting.push_back(lesson::name_in(session.lesson(), *method));
  for (const lesson::Outcome& outcome : session.log().outcomes()) told.outcomes.push_back(outcome_of(outcome, figures));
  const lesson::Progress progress = lesson::progress_of(session);
  told.progress = {progress.begun, progress.answered, progress.done};
  return told;
}

Tasks tasks_of(const lesson::Session& session) {
  Tasks told{.task = session.stage().task(), .tasks_done = session.tasks_done()};
  if (const auto grade = session.grade()) told.grade = grade_of(*grade);
  for (std::size_t i = 0; i < session.tasks_listed(); ++i) {
    TaskGrade task{grade_of(session.grade(i)), session.was_done(i), session.can_solve_again(i)};
    task.says = lesson::task_says(session, i);
    told.tasks.push_back(std::move(task));
  }
  return told;
}

}  // namespace snug::app::told
