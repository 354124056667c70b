#include "web/view.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include "lesson/boxes.hpp"
#include "lesson/say.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "number/fnv.hpp"
#include "web/boxes.hpp"
#include "web/costs.hpp"

namespace snug::web {
namespace {

using emscripten::val;

val text(std::string_view words) { return val(std::string(words)); }

/// An array of make(item) for each item.
template <class Items, class Make>
val array_of(const Items& items, Make make) {
  val array = val::array();
  int i = 0;
  for (const auto& item : items) array.set(i++, make(item));
  return array;
}

val link_object(const lesson::Link& link) {
  constexpr std::array<const char*, 5> kKinds{"lesson", "mesh", "algorithm", "step", "mark"};
  val object = val::object();
  object.set("kind", kKinds[static_cast<std::size_t>(link.kind)]);
  object.set("target", link.target);
  return object;
}

val section_object(const lesson::Section& section) {
  val object = val::object();
  object.set("title", section.title);
  object.set("paragraphs", array_of(section.paragraphs, [](const lesson::Paragraph& paragraph) {
               return array_of(paragraph, [](const lesson::Stretch& stretch) {
                 val piece = val::object();
                 piece.set("text", stretch.text);
                 piece.set("strong", stretch.strong);
                 if (!stretch.tex.empty()) piece.set("tex", stretch.tex);
                 if (stretch.link) piece.set("link", link_object(*stretch.link));
                 return piece;
               });
             }));
  return object;
}

val algorithm_object(const lesson::Lesson& lesson, std::string_view name) {
  val object = val::object();
  const lesson::Method* algorithm = lesson::find_method(lesson, name);
  object.set("name", text(name));
  object.set("title", text(algorithm != nullptr ? algorithm->title : name));
  object.set("source", text(algorithm != nullptr ? algorithm->source : ""));
  object.set("maxPoints", algorithm != nullptr ? algorithm->max_points : 0);
  return object;
}

/// A chosen or tried answer: a handle's name, or the numbers of choices.
val answer_object(const lesson::Asked& asked, const lesson::Session& session, const lesson::Answer* answer) {
  if (answer == nullptr) return val::null();
  val object = val::object(), chosen = val::array();
  for (std::size_t i = 0; i < asked.choices.size(); ++i)
    if (lesson::is_picked(asked, *answer, static_cast<int>(i))) chosen.call<void>("push", static_cast<int>(i));
  object.set("choices", chosen);
  object.set("handle",
             answer->kind == lesson::Answer::Kind::kPoint ? val(session.name_of(answer->value)) : val::null());
  return object;
}

val asked_object(const lesson::Asked* asked, const lesson::Session& session) {
  if (asked == nullptr) return val::null();
  val object = val::object();
  object.set("id", asked->question->id);
  object.set("prompt", asked->prompt);
  object.set("step", asked->step);
  object.set("choices", array_of(asked->choices, text));
  object.set("many", asked->many);
  object.set("onStage", asked->on_stage);
  object.set("place", lesson::place_text(*asked, session.questions()));
  object.set("how", lesson::how_to_answer(*asked));
  object.set("picked", answer_object(*asked, session, session.picked()));
  object.set("tried", answer_object(*asked, session, session.tried()));
  object.set("says", session.answer_says());
  return object;
}

std::string_view kind_of(const lesson::Outcome* outcome) {
  switch (lesson::standing_of(outcome)) {
    case lesson::Standing::kRight: return "right";
    case lesson::Standing::kWrong: return "wrong";
    case lesson::Standing::kSkipped: return "skipped";
    case lesson::Standing::kOpen: break;
  }
  return "open";
}

val outcome_object(const lesson::Outcome& outcome) {
  val object = val::object();
  object.set("kind", text(kind_of(&outcome)));
  object.set("tries", outcome.tries);
  object.set("question", outcome.question);
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
  object.set("because", outcome.because);
  return object;
}

/// The outcome that is shown, or about to be shown, with its question.
val told_object(const lesson::Session& session, const lesson::Outcome* outcome) {
  if (outcome == nullptr) return val::null();
  val object = outcome_object(*outcome);
  const lesson::Asked* asked = session.question_of(*outcome);
  if (asked == nullptr) return object;
  object.set("prompt", asked->prompt);
  object.set("place", lesson::place_text(*asked, session.questions()));
  object.set("choices", array_of(asked->choices, text));
  object.set("given", answer_object(*asked, session, &outcome->given));
  object.set("canShow", session.can_show_answer());
  object.set("shown", session.answer_shown());
  object.set("rightChoices", session.answer_shown()
                                 ? array_of(session.right_choices(), [](int choice) { return val(choice); })
                                 : val::array());
  return object;
}

/// Every question of the run, in order, with its state.
val predictions(const lesson::Session& session) {
  return array_of(session.questions(), [&](const lesson::Asked& asked) {
    const lesson::Outcome* outcome = session.outcome_of(asked);
    val object = val::object();
    object.set("id", asked.question->id);
    object.set("prompt", asked.prompt);
    object.set("short", text(lesson::short_prompt(asked.prompt)));
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

/// The names of a subject's two boxes; null if it has none.
val box_words(const lesson::Subject& subject) {
  const lesson::BoxSubject* boxes = lesson::as_boxes(subject);
  if (boxes == nullptr) return val::null();
  return array_of(std::array{0, 1}, [&](int box) {
    const auto [heading, name, sizes] = boxes->words_of(box);
    val words = val::object();
    words.set("heading", text(heading));
    words.set("name", text(name));
    words.set("sizes", text(sizes));
    return words;
  });
}

void set_algorithms(val& object, const lesson::Session& session) {
  const lesson::Method* main = session.method(0);
  const lesson::Method* beside = session.method(1);
  object.set("algorithm", text(main->name));
  object.set("beside", beside != nullptr ? text(beside->name) : val::null());
  object.set("codeTitle", text(main->title));
  object.set("code", array_of(session.pseudocode(0), text));
  object.set("line", session.line());
  object.set("rivals", array_of(session.rivals(), [&](const lesson::Rival& rival) {
               val row = val::object();
               row.set("name", text(rival.method->name));
               row.set("title", text(rival.method->title));
               const bool hidden = session.hides_result(*rival.method);
               row.set("size", hidden ? val::null() : val(rival.size));
               row.set("excess", rival.excess && !hidden ? val(*rival.excess) : val::null());
               return row;
             }));
}

void set_figures(val& object, const lesson::Session& session) {
  val readout = val::object();
  const auto figures = session.figures();
  for (const auto& figure : figures)
    if (figure.known) readout.set(figure.key, figure.value);
  object.set("readout", readout);
  object.set("figures", array_of(figures, [](const lesson::Session::Figure& figure) {
               val row = val::object();
               row.set("key", figure.key);
               row.set("name", figure.name);
               row.set("text", figure.text);
               return row;
             }));
}

void set_points(val& object, const app::App& app, const lesson::Session& session) {
  object.set("boxes", boxes_object(session));
  object.set("size", session.size());
  object.set("dim", session.dim());
  object.set("edited", session.edited());
  object.set("source", session.source());
  object.set("seed", static_cast<double>(session.seed()));
  object.set("canUndo", session.can_undo());
  object.set("canRedo", session.can_redo());
  const Index selected = app.selected();
  const bool any = selected >= 0 && selected < session.size();
  object.set("selected", any ? val(selected) : val::null());
  object.set("selectedName", any ? val(session.name_of(selected)) : val::null());
  object.set("coordinates", any ? coordinates(session.point(selected), session.dim()) : val::null());
}

}  // namespace

val coordinates(const Vector<double, 3>& point, int dim) {
  return array_of(std::span(point.data(), static_cast<std::size_t>(dim)), [](double number) { return val(number); });
}

/// What the prose lights on the stage, and the stage in the prose.
static val lit_object(const app::App& app, const lesson::Session& session) {
  val object = val::object();
  object.set("mark", text(app.lit()));
  object.set("handles", array_of(lesson::marked_handles(session, app.lit()),
                                 [&](Index handle) { return val(session.name_of(handle)); }));
  object.set("words", array_of(app.marks_in_hand(), text));
  return object;
}

val lesson_object(const lesson::Session& session) {
  const lesson::Lesson& lesson = session.lesson();
  const lesson::Subject& subject = session.subject();
  val object = val::object();
  object.set("id", lesson.id);
  object.set("minutes", lesson.minutes);
  object.set("title", lesson.title);
  object.set("summary", lesson.summary);
  object.set("sections", array_of(lesson.sections, section_object));
  object.set("algorithms",
             array_of(lesson.algorithms, [&](std::string_view name) { return algorithm_object(lesson, name); }));
  object.set("stepWord", text(lesson.subject->step_word));
  object.set("asksOfSteps", lesson.subject->asks_of_steps);
  object.set("chart", text(lesson.subject->chart));
  object.set("toolsWord", text(subject.tools_word()));
  object.set("toolsTitle", text(subject.tools_title()));
  object.set("handleWords", array_of(subject.handle_words(), text));
  object.set("hasPoints", subject.points() != nullptr);
  object.set("boxes", box_words(subject));
  object.set("dim", lesson.points.dim);
  object.set("generate", lesson.points.generate);
  object.set("count", lesson.points.count);
  object.set("mesh", lesson.points.mesh);
  object.set("seed", static_cast<double>(lesson.seed));
  object.set("meshes", array_of(lesson.meshes, text));
  object.set("generators", array_of(lesson.generators, text));
  object.set("compare", lesson.compare);
  if (lesson.task) {
    val task = val::object();
    task.set("prompt", lesson.task->prompt);
    task.set("hint", lesson.task->hint);
    task.set("algorithm", lesson.task->algorithm);
    task.set("points", lesson.task->points);
    task.set("start", lesson::start_task_text(session));
    object.set("task", task);
  } else {
    object.set("task", val::null());
  }
  return object;
}

val target_names(const lesson::Session& session) { return array_of(session.target_names(), text); }

val words_object() {
  val object = val::object();
  object.set("predict", text(lesson::kPredictWord));
  object.set("answer", text(lesson::kAnswerWord));
  object.set("skip", text(lesson::kSkipWord));
  object.set("prediction", text(lesson::kPredictionWord));
  object.set("watch", text(lesson::kWatchWord));
  object.set("again", text(lesson::kPredictAgainWord));
  object.set("task", text(lesson::kTaskWord));
  object.set("hint", text(lesson::kHintWord));
  object.set("go_on", text(lesson::kContinueWord));
  object.set("show", text(lesson::kShowMeWord));
  object.set("summary", text(lesson::kSummaryWord));
  object.set("waiting", text(lesson::kWaitingWord));
  object.set("to_task", text(lesson::kToTaskWord));
  object.set("next_lesson", text(lesson::kNextLessonWord));
  object.set("close", text(lesson::kCloseWord));
  object.set("watching", text(lesson::kWatching));
  return object;
}

val view_object(app::App& app, const lesson::Session& session) {
  val object = val::object();
  object.set("lesson", session.lesson().id);
  object.set("step", session.step());
  object.set("steps", session.steps());
  object.set("caption", app.caption());
  const std::optional<int> section = lesson::section_at(session);
  object.set("section", section ? val(*section) : val::null());
  object.set("lit", lit_object(app, session));
  object.set("playing", app.playing());
  object.set("speed", app.speed());
  object.set("previewing", session.previewing());
  object.set("trace", text(hex_of(session.trace_hash())));
  object.set("asked", asked_object(session.asked(), session));
  object.set("questions", static_cast<int>(session.questions().size()));
  object.set("outcome", told_object(session, session.outcome()));
  object.set("deciding", told_object(session, session.deciding()));
  object.set("predictions", predictions(session));
  object.set("tally", tally_object(session.tally()));
  object.set("summary", session.at_summary());
  object.set("waiting", array_of(session.waiting(), [](const lesson::Method* method) { return text(method->name); }));
  object.set("outcomes", array_of(session.outcomes(), outcome_object));
  object.set("score", session.score());
  object.set("grade", grade_object(session.grade()));
  object.set("framesDrawn", static_cast<double>(app.frames_drawn()));
  object.set("costs", costs_object(app));
  set_algorithms(object, session);
  set_figures(object, session);
  set_points(object, app, session);
  if (const auto switches = session.switches(); !switches.empty())
    object.set("effects", array_of(switches, [](const lesson::Switch& one) {
                 val row = val::object();
                 row.set("effect", one.name);
                 row.set("on", one.on);
                 row.set("constructed", static_cast<double>(one.constructed));
                 row.set("run", static_cast<double>(one.run));
                 row.set("skipped", static_cast<double>(one.skipped));
                 row.set("microseconds", one.microseconds);
                 return row;
               }));
  return object;
}

}  // namespace snug::web
