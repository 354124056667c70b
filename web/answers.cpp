// The questions, the answers and the task, for the page.
#include "lesson/progress.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"
#include "web/prose.hpp"
#include "web/values.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;

/// A chosen or tried answer: the numbers of choices (in the chosen order, if that is asked), and what could be typed
/// for it: a handle's name, several, or a number.
val answer_object(const lesson::Session& session, const lesson::Answer* answer) {
  if (answer == nullptr) return val::null();
  const auto name = [&](Index handle) { return session.stage().subject().name_of(handle); };
  std::string typed;
  if (const auto* one = std::get_if<lesson::OneHandle>(answer)) typed = name(one->handle);
  if (const auto* several = std::get_if<lesson::SeveralHandles>(answer))
    for (const Index handle : several->handles) typed += (typed.empty() ? "" : ", ") + name(handle);
  if (const auto* number = std::get_if<lesson::TypedNumber>(answer)) typed = lesson::plain_number(number->number);
  const auto* choice = std::get_if<lesson::OneChoice>(answer);
  val object = val::object();
  const auto chosen = choice != nullptr ? std::span(&choice->choice, 1) : lesson::choices_of(*answer);
  object.set("choices", array_of(chosen, [](int i) { return val(i); }));
  object.set("handle", typed.empty() ? val::null() : val(typed));
  return object;
}

/// A question's prompt, in plain words and as the page shows it.
void set_prompt(val& object, const lesson::Asked& asked, lesson::ProseFigures& figures) {
  object.set("prompt", plain_now(asked.prompt, figures));
  object.set("promptWords", prompt_array(asked.prompt));
}

val asked_object(const lesson::Asked* asked, const lesson::Session& session, lesson::ProseFigures& figures) {
  if (asked == nullptr) return val::null();
  val object = val::object();
  object.set("id", asked->question->id);
  set_prompt(object, *asked, figures);
  object.set("step", asked->step);
  object.set("choices", array_of(asked->choices, text));
  object.set("many", asked->many);
  object.set("ordered", asked->ordered);
  object.set("field", text(lesson::field_word(*asked)));
  object.set("onStage", asked->on_stage);
  object.set("place", lesson::place_text(*asked, session.conversation().questions()));
  object.set("how", lesson::how_to_answer(*asked));
  object.set("picked", answer_object(session, session.conversation().picked()));
  object.set("tried", answer_object(session, session.conversation().tried()));
  object.set("ready",
             session.conversation().picked() != nullptr && lesson::answers(*asked, *session.conversation().picked()));
  object.set("says", session.conversation().answer_says());
  return object;
}

std::string_view kind_of(const lesson::Outcome* outcome) { return kind_word(lesson::standing_of(outcome)); }

val outcome_object(const lesson::Outcome& outcome, lesson::ProseFigures& figures) {
  val object = val::object();
  object.set("kind", text(kind_of(&outcome)));
  object.set("tries", outcome.tries);
  object.set("question", outcome.question);
  object.set("on", static_cast<double>(outcome.on));
  object.set("fromStep", outcome.from_step);
  object.set("step", outcome.step);
  object.set("right", outcome.right);
  object.set("skipped", outcome.skipped);
  object.set("passed", outcome.passed);
  object.set("pending", outcome.pending);
  object.set("verdict", text(lesson::verdict_text(outcome)));
  object.set("predicted", outcome.predicted);
  object.set("happened", outcome.happened);
  object.set("says", outcome.says);
  object.set("because", plain_now(outcome.because, figures));
  object.set("becauseWords", prompt_array(outcome.because));
  return object;
}

/// The outcome that is shown, or about to be shown, with its question.
val told_object(const lesson::Session& session, const lesson::Outcome* outcome, lesson::ProseFigures& figures) {
  if (outcome == nullptr) return val::null();
  val object = outcome_object(*outcome, figures);
  const lesson::Asked* asked = session.conversation().question_of(*outcome);
  if (asked == nullptr) return object;
  set_prompt(object, *asked, figures);
  object.set("place", lesson::place_text(*asked, session.conversation().questions()));
  object.set("choices", array_of(asked->choices, text));
  object.set("ordered", asked->ordered);
  object.set("given", answer_object(session, &outcome->given));
  object.set("canWatch", session.conversation().can_watch_outcome());
  object.set("canShow", session.conversation().can_show_answer());
  object.set("shown", session.conversation().answer_shown());
  object.set("rightChoices",
             session.conversation().answer_shown() || asked->ordered
                 ? array_of(session.conversation().right_choices(), [](int choice) { return val(choice); })
                 : val::array());
  return object;
}

/// Every question of the run, in order, with its state.
val predictions(const lesson::Session& session, lesson::ProseFigures& figures) {
  return array_of(session.conversation().questions(), [&](const lesson::Asked& asked) {
    const lesson::Outcome* outcome = session.conversation().outcome_of(asked);
    val object = val::object();
    object.set("id", asked.question->id);
    const std::string prompt = plain_now(asked.prompt, figures);
    object.set("prompt", prompt);
    object.set("short", text(lesson::short_prompt(prompt)));
    object.set("kind", text(kind_of(outcome)));
    object.set("standing", text(lesson::standing_text(outcome)));
    return object;
  });
}

val tally_object(const lesson::Tally& tally) {
  val object = val::object();
  object.set("right", tally.right);
  object.set("second", tally.second);
  object.set("wrong", tally.wrong);
  object.set("skipped", tally.skipped);
  object.set("open", tally.open);
  return object;
}

val grade_object(const std::optional<lesson::Grade>& grade) {
  if (!grade) return val::null();
  val object = val::object();
  object.set("done", grade->done);
  object.set("points", grade->points);
  object.set("excess", grade->excess);
  object.set("says", grade->says);
  return object;
}

}  // namespace

std::string_view kind_word(lesson::Standing standing) {
  switch (standing) {
    case lesson::Standing::kRight: return "right";
    case lesson::Standing::kWrong: return "wrong";
    case lesson::Standing::kSkipped: return "skipped";
    case lesson::Standing::kOpen: break;
  }
  return "open";
}

val target_names(const lesson::Session& session) { return array_of(session.conversation().target_names(), text); }

void set_answers(val& object, const lesson::Session& session) {
  lesson::ProseFigures figures(session.conversation());
  object.set("asked", asked_object(session.conversation().asked(), session, figures));
  object.set("questions", static_cast<int>(session.conversation().questions().size()));
  object.set("outcome", told_object(session, session.conversation().outcome(), figures));
  object.set("deciding", told_object(session, session.conversation().deciding(), figures));
  object.set("predictions", predictions(session, figures));
  object.set("tally", tally_object(session.conversation().tally()));
  object.set("summary", session.conversation().at_summary());
  object.set("waiting", array_of(session.conversation().waiting(), [&](const lesson::Method* method) {
               return text(lesson::name_in(session.lesson(), *method));
             }));
  object.set("canPractise", session.conversation().can_practise());
  object.set("situationsWaiting", array_of(session.log().situations_waiting(session.stage().situation()), text));
  object.set("outcomes", array_of(session.log().outcomes(),
                                  [&](const lesson::Outcome& outcome) { return outcome_object(outcome, figures); }));
  object.set("score", session.conversation().score());
  object.set("grade", grade_object(session.grade()));
  val tasks = val::array();
  const std::size_t count =
      session.stage().conduct().builds ? 0 : session.lesson().tasks.size();  // as in lesson_object
  for (std::size_t i = 0; i < count; ++i) {
    val task = grade_object(session.grade(i));
    task.set("was", session.was_done(i));
    task.set("says", lesson::task_says(session, i));
    task.set("kept", session.can_solve_again(i));
    tasks.call<void>("push", task);
  }
  object.set("tasks", tasks);
  object.set("task", static_cast<int>(session.stage().task()));
  object.set("tasksDone", session.tasks_done());
  const lesson::Progress progress = lesson::progress_of(session);
  val far = val::object();
  far.set("begun", progress.begun);
  far.set("answered", progress.answered);
  far.set("done", progress.done);
  object.set("progress", far);
}

}  // namespace snug::web
