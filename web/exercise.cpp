// The exercise, for the page.
#include <algorithm>

#include "lesson/exercise/sitting.hpp"
#include "lesson/say.hpp"
#include "number/fnv.hpp"
#include "web/prose.hpp"
#include "web/values.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;

val rows_of(const lesson::Sitting& sitting, const lesson::Session& session) {
  lesson::ProseFigures figures(session);
  int number = 0;
  return array_of(sitting.marked(session), [&](const lesson::Marked& marked) {
    val row = val::object();
    row.set("id", marked.asked->question->id);
    const std::string prompt = plain_now(marked.asked->prompt, figures);
    row.set("short", std::to_string(++number) + ". " + std::string(lesson::short_prompt(prompt)));
    row.set("kind", text(kind_word(marked.standing)));
    row.set("hints", marked.hints);
    row.set("mark", marked.mark);
    return row;
  });
}

}  // namespace

val exercise_object(app::App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr) return val::null();
  const lesson::Session& session = *app.session();
  const bool over = sitting->finished(session), tells = sitting->exercise().told_at_once || over;
  val object = val::object();
  object.set("exercise", sitting->exercise().id);
  object.set("lesson", sitting->exercise().lesson);
  object.set("seed", static_cast<double>(sitting->seed()));
  object.set("decision", static_cast<int>(sitting->at(session)));
  object.set("decisions", sitting->of());
  object.set("mark", tells ? val(sitting->mark(session)) : val::null());
  object.set("of", sitting->of());
  object.set("countKnown", sitting->exercise().least == sitting->exercise().most);
  object.set("told", session.outcome() != nullptr);
  object.set("tellsAtOnce", sitting->exercise().told_at_once);
  object.set("finished", over);
  object.set("hints", array_of(sitting->hints(session), text));
  object.set("nextPrice", sitting->next_price(session));
  object.set("rule", sitting->rule_says(session));
  object.set("followed", over ? array_of(sitting->rules_followed(session), text) : val::array());
  object.set("canTakeBack", !sitting->exercise().told_at_once && !session.given().empty() && !over);
  object.set("rows", rows_of(*sitting, session));
  return object;
}

val attempt_object(app::App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr) return val::null();
  const lesson::Attempt attempt = sitting->attempt(*app.session());
  val object = val::object();
  object.set("exercise", attempt.exercise);
  object.set("hash", hex_of(attempt.hash));
  object.set("seed", static_cast<double>(attempt.seed));
  object.set("decisions", array_of(attempt.made, [](const lesson::Made& made) { return text(text_of(made)); }));
  object.set("hints", attempt.hints());
  object.set("mark", sitting->mark(*app.session()));
  object.set("of", sitting->of());
  object.set("seconds", attempt.seconds());
  return object;
}

}  // namespace snug::web
