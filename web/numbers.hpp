// A subject's number fields, for the page to read and write.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "lesson/session.hpp"

namespace snug::web {

/// [{heading, name, rows: [{words, unit, turn, names, values}]}]: see lesson::NumberGroup.
[[nodiscard]] emscripten::val numbers_object(const lesson::Session& session);

/// Sets a row of numbers. Returns an error as a sentence, or "".
[[nodiscard]] std::string take_numbers(lesson::Session& session, int group, int row, const emscripten::val& values);

}  // namespace snug::web
