// Exercises in which the student builds an example: how much of what is asked stands on the stage, and the search that
// shows that all of it can be reached.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lesson/exercise/exercise.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

/// How many levels of the task the stage reaches, of Build::levels.
[[nodiscard]] int level_of(const Exercise& exercise, const Session& session);

/// What stands on the stage, of what is asked: "Excess over the optimum: 9.8 %; it must be at least 18 %."
[[nodiscard]] std::string now_says(const Session& session);

/// What each level asks for, the lowest first: "at least 5 %".
[[nodiscard]] std::vector<std::string> level_texts(const Exercise& exercise, const Session& session);

/// A stage that reaches all levels: the task's model, or one that a search finds from where the instance begins. None
/// if it finds none. The same on every machine.
[[nodiscard]] std::optional<Rows> find_model(const Exercise& exercise, const Session& instance);

}  // namespace snug::lesson
