// The exercise, for the page.
#include <algorithm>
#include <array>

#include "lesson/exercise/build.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/say.hpp"
#include "number/fnv.hpp"
#include "web/prose.hpp"
#include "web/values.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;

/// The handles that may be moved.
std::vector<std::string> movable_names(const lesson::Session& session) {
  std::vector<std::string> names;
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (session.stage().may_move(i)) names.push_back(session.stage().subject().name_of(i));
  return names;
}

val rows_of(const lesson::Sitting& sitting, const lesson::Session& session) {
  lesson::ProseFigures figures(session.conversation());
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

/// What is built; null where decisions are made.
val build_object(const lesson::Sitting& sitting, const lesson::Session& session) {
  const lesson::Exercise& exercise = sitting.exercise();
  if (!exercise.build) return val::null();
  const int now = level_of(exercise, session), best = sitting.best() ? sitting.best()->level : 0;
  val object = val::object();
  object.set("prompt", exercise.stage.tasks.front().prompt);
  object.set("promptWords", prompt_array(exercise.stage.tasks.front().prompt));
  object.set("heading", text(exercise.build->claim.empty() ? lesson::kBuildWord : lesson::kBreakWord));
  object.set("claim", exercise.build->claim);
  int level = 0;
  object.set("levels", array_of(level_texts(exercise, session), [&](const std::string& words) {
               val one = val::object();
               one.set("words", words);
               one.set("now", ++level <= now);
               one.set("best", level <= best);
               return one;
             }));
  object.set("isNow", lesson::now_says(session));
  object.set("targets", array_of(movable_names(session), text));
  object.set("adds", sitting.adds());
  object.set("canGoBack", best > now);
  object.set("canFinish", best > 0);
  return object;
}

}  // namespace

val exercise_object(app::App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr) return val::null();
  const lesson::Session& session = *app.session();
  const bool over = sitting->finished(session), tells = sitting->tells_at_once() || over;
  val object = val::object();
  object.set("exercise", sitting->exercise().id);
  object.set("kind", text(sitting->exercise().kind()));
  object.set("level", sitting->exercise().level);
  object.set("practises", sitting->practises());
  object.set("leadsOn", sitting->leads_on(session));
  object.set("build", build_object(*sitting, session));
  object.set("lesson", sitting->exercise().lesson);
  object.set("seed", static_cast<double>(sitting->seed()));
  object.set("decision", static_cast<int>(sitting->at(session)));
  object.set("decisions", sitting->of());
  object.set("mark", tells && !sitting->practises() ? val(sitting->mark(session)) : val::null());
  object.set("of", sitting->of());
  object.set("countKnown", sitting->exercise().least == sitting->exercise().most);
  object.set("told", session.conversation().outcome() != nullptr);
  object.set("tellsAtOnce", sitting->tells_at_once());
  object.set("finished", over);
  object.set("hints", array_of(sitting->hints(session), text));
  object.set("hint", sitting->hint_words(session));
  object.set("rule", sitting->rule_says(session));
  object.set("followed", over ? array_of(sitting->rules_followed(session), text) : val::array());
  constexpr std::array kRuns{"", "own", "right"};  // by Looked
  object.set("run", text(kRuns[static_cast<std::size_t>(sitting->looks_at(session))]));
  object.set("compared", sitting->compared(session));
  object.set("firstDifference", sitting->first_difference(session));
  object.set("canTakeBack", !sitting->tells_at_once() && !session.log().given().empty() && !over);
  object.set("rows", rows_of(*sitting, session));
  return object;
}

val attempt_object(app::App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr || sitting->practises()) return val::null();
  const lesson::Attempt attempt = sitting->attempt(*app.session());
  val object = val::object();
  object.set("exercise", attempt.exercise);
  object.set("hash", hex_of(attempt.hash));
  object.set("seed", static_cast<double>(attempt.seed));
  if (attempt.level > 0) object.set("level", attempt.level);
  object.set("decisions", array_of(attempt.made, [](const lesson::Made& made) { return text(text_of(made)); }));
  object.set("hints", attempt.hints());
  object.set("mark", sitting->mark(*app.session()));
  object.set("of", sitting->of());
  object.set("seconds", attempt.seconds());
  return object;
}

}  // namespace snug::web
