// A lesson played by one who knows the answers: what a teacher checks a lesson with, and every test run.
#pragma once

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

/// The algorithms that the lesson offers, in its order, but for those that do not take as many points as there are.
[[nodiscard]] std::vector<std::string> playable(const Session& session);

struct Played {
  struct Algorithm {
    std::string name;
    int steps = 0;
    std::vector<Outcome> outcomes;  // of its questions, in the timeline's order
  };
  std::vector<Algorithm> algorithms;
  std::vector<std::string> not_asked;  // ids of questions whose step did not come on these points
  std::optional<Grade> grade;          // of the task's model answer

  /// Whether every question was asked and its model answer right, and the model answer does the task.
  [[nodiscard]] bool sound() const;
};

/// Plays each algorithm that is playable from the first step to the last, gives each question its model answer,
/// and has the task's model answer graded. The session is left with those points. There is no clock: a lesson with the
/// chart of costs is played by counted operations, and what is said of it speaks of them. Errors: of choose and load; a
/// player that does not move on.
[[nodiscard]] tl::expected<Played, InputError> play(Session& session);

}  // namespace snug::lesson
