// Answers as a text that a device keeps until the next visit, in the page's storage or in the window's state file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

/// What was answered in a lesson, and which of its tasks were done, by what.
struct KeptAnswers {
  std::vector<Outcome> outcomes;
  std::vector<DoneTask> tasks;
  std::vector<std::string> moved = {};  // the sliders that the lesson is about which were moved, by what they drive
};

/// Those of a session.
[[nodiscard]] KeptAnswers answers_of(const Session& session);
/// Takes them over in another session of the lesson.
void take_up(Session& session, const KeptAnswers& answers);

/// The answers as TOML. Pending ones stay pending: the next measurement decides them.
[[nodiscard]] std::string kept_text(const KeptAnswers& answers);

/// Reads what kept_text wrote. Returns none if the text is damaged.
[[nodiscard]] KeptAnswers kept_answers_of(std::string_view kept);

}  // namespace snug::lesson
