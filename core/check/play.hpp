// Plays a lesson with the right answers: teachers check a lesson this way, and so do the tests.
#pragma once

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::check {

using namespace lesson;

struct Played {
  struct Algorithm {
    std::string name;
    std::string situation;
    int steps = 0;
    std::vector<Outcome> outcomes;  // one for each question, in the timeline's order
  };
  /// A fixed answer that the run contradicts.
  struct FalseKey {
    std::string question, answer, is;
  };
  std::vector<Algorithm> algorithms;
  std::vector<FalseKey> false_keys;
  std::vector<std::string> not_asked;  // ids of questions whose step did not come on these points
  std::vector<Grade> grades;           // those of the tasks' models

  /// Whether every question was asked and its model answer was right, which no run contradicts if it is fixed, and each
  /// model solves its task.
  [[nodiscard]] bool sound() const;
};

/// Plays in each situation each playable algorithm from the first step to the last, gives each question its model
/// answer, and grades the tasks' models. The session is left with the last of them. There is no clock: a lesson with
/// the cost chart is played by counted operations, and its sentences mention them. Errors: those of choose and load; a
/// player that does not move on.
[[nodiscard]] tl::expected<Played, InputError> play(Session& session);

}  // namespace snug::check
