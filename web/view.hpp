// Turns a lesson and its session into plain JavaScript objects, for the page's HTML and for window.snug.
#pragma once

#include <emscripten/val.h>

#include <string_view>

#include "app/app.hpp"
#include "lesson/session.hpp"

namespace snug::web {

/// What stays constant while the lesson is open: {id, title, sections, task, algorithms, tools, stageSays …}.
emscripten::val lesson_object(const lesson::Session& session);

/// What changes: {step, steps, caption, algorithms, code, rivals, readout, selected, numbers, cover, effects …}, and
/// set_answers.
emscripten::val view_object(app::App& app, const lesson::Session& session);

/// "right", "wrong", "skipped", "open".
std::string_view kind_word(lesson::Standing standing);

/// The names of the handles that can be the answer to the open question.
emscripten::val target_names(const lesson::Session& session);

/// The headings and buttons that page and window share (lesson/say.hpp).
emscripten::val words_object();

/// The exercise that is open, for the page and for window.snug.exercise(); null while a lesson is.
emscripten::val exercise_object(app::App& app);
/// Its attempt, as a result file has it, without the student.
emscripten::val attempt_object(app::App& app);

/// Adds to an object: {asked, outcome, deciding, predictions, tally, outcomes, grade …}.
void set_answers(emscripten::val& object, const lesson::Session& session);

}  // namespace snug::web
