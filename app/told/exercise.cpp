#include "app/told/exercise.hpp"

#include <array>

#include "app/timeline_map.hpp"
#include "app/told/json.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "number/fnv.hpp"

namespace snug::app::told {
namespace {

List<ExerciseRow> rows_of(const lesson::Sitting& sitting, const lesson::Session& session) {
  lesson::ProseFigures figures(session.conversation());
  List<ExerciseRow> rows;
  for (const lesson::Marked& marked : sitting.marked(session)) {
    const std::string prompt = plain_now(marked.asked->prompt, figures);
    rows.push_back({.id = marked.asked->question->id,
                    .short_ = std::to_string(rows.size() + 1) + ". " + std::string(lesson::short_prompt(prompt)),
                    .kind = state_word(marked.standing),
                    .hints = marked.hints,
                    .mark = marked.mark});
  }
  return rows;
}

/// None where decisions are made.
std::optional<Build> build_of(const lesson::Sitting& sitting, const lesson::Session& session) {
  const lesson::Exercise& exercise = sitting.exercise();
  if (!exercise.build) return std::nullopt;
  const int now = level_of(exercise, session), best = sitting.best() ? sitting.best()->level : 0;
  const std::string& prompt = exercise.stage.tasks.front().prompt;
  Build told{.heading = exercise.build->claim.empty() ? lesson::kBuildWord : lesson::kBreakWord,
             .prompt = prompt,
             .prompt_words = prompt_of(prompt),
             .claim = exercise.build->claim,
             .is_now = lesson::now_says(session),
             .adds = sitting.adds(),
             .can_go_back = best > now,
             .can_finish = best > 0};
  int level = 0;
  for (std::string& words : level_texts(exercise, session)) {
    ++level;
    told.levels.push_back({std::move(words), level <= now, level <= best});
  }
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (session.stage().may_move(i)) told.targets.push_back(session.stage().subject().name_of(i));
  return told;
}

}  // namespace

Exercise exercise_of(App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr) return {};
  const lesson::Session& session = *app.session();
  const lesson::Exercise& own = sitting->exercise();
  const bool over = sitting->finished(session), tells = sitting->tells_at_once();
  constexpr std::array<std::string_view, 3> kRuns{"", "own", "right"};  // by Looked
  ShownExercise told{.exercise = own.id,
                     .kind = own.kind(),
                     .lesson = own.lesson,
                     .seed = sitting->seed(),
                     .level = own.level,
                     .practises = sitting->practises(),
                     .leads_on = sitting->leads_on(session),
                     .build = build_of(*sitting, session),
                     .decision = sitting->at(session),
                     .decisions = sitting->of(),
                     .of = sitting->of(),
                     .told = session.conversation().outcome() != nullptr,
                     .tells_at_once = tells,
                     .count_known = count_known(own),
                     .finished = over,
                     .hints = sitting->hints(session),
                     .hint = sitting->hint_words(session),
                     .rule = sitting->rule_says(session),
                     .run = kRuns[static_cast<std::size_t>(sitting->looks_at(session))],
                     .compared = sitting->compared(session),
                     .first_difference = sitting->first_difference(session),
                     .can_take_back = !tells && !session.log().given().empty() && !over,
                     .rows = rows_of(*sitting, session)};
  if ((tells || over) && !told.practises) told.mark = sitting->mark(session);
  if (over) told.followed = sitting->rules_followed(session);
  return {std::move(told)};
}

std::optional<Attempt> attempt_of(App& app) {
  const lesson::Sitting* sitting = app.sitting();
  if (sitting == nullptr || sitting->practises()) return std::nullopt;
  const lesson::Attempt own = sitting->attempt(*app.session());
  Attempt told{.exercise = own.exercise,
               .hash = hex_of(own.hash),
               .seed = own.seed,
               .level = own.level,
               .hints = own.hints(),
               .mark = sitting->mark(*app.session()),
               .of = sitting->of(),
               .seconds = own.seconds()};
  for (const lesson::Made& made : own.made) told.decisions.push_back(text_of(made));
  return told;
}

std::string attempt_text(App& app) { return json_of(attempt_of(app)); }

}  // namespace snug::app::told
