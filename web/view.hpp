// Turns a lesson and its session into plain JavaScript objects, for the page's HTML and for window.snug.
#pragma once

#include <emscripten/val.h>

#include "app/app.hpp"
#include "lesson/session.hpp"

namespace snug::web {

/// What stays constant while the lesson is open: {id, group, title, dim, sections, task, algorithms, points …}.
emscripten::val lesson_object(const lesson::Session& session);

/// What changes: {step, steps, caption, asked, outcome, grade, algorithms, code, rivals, readout, selected …}.
emscripten::val view_object(app::App& app, const lesson::Session& session);

/// The names of the handles that can be the answer to the open question.
emscripten::val target_names(const lesson::Session& session);

/// The headings and buttons that page and window share (lesson/say.hpp).
emscripten::val words_object();

/// [x, y] or [x, y, z].
emscripten::val coordinates(const Vector<double, 3>& point, int dim);

}  // namespace snug::web
