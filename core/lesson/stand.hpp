// Goes to a place in a lesson that is named from outside, as for a picture: an algorithm, a step, a question.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"

namespace snug::lesson {

class Session;

struct Standpoint {
  static constexpr int kLastStep = -1;
  std::string situation;    // empty: the question's, or the one that is shown
  std::string algorithm;    // empty: the question's, or the one that is shown
  std::optional<int> step;  // or kLastStep; not together with a question, which has its own
  std::string question;     // its id; empty for none
  bool answered = false;    // whether its model answer is given and its outcome shown, or else it is open

  /// Whether no place is named.
  [[nodiscard]] bool empty() const { return situation.empty() && algorithm.empty() && !step && question.empty(); }
};

/// Errors: the lesson has no such situation, algorithm or question; the run has no such step; the question does not
/// come on what is on the stage.
[[nodiscard]] tl::expected<void, InputError> stand_at(Session& session, const Standpoint& at);

}  // namespace snug::lesson
