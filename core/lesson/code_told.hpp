// The pseudocode as it may be told now: while its lines are to be put in order, it would give the order away.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "lesson/session.hpp"

namespace snug::lesson {

struct CodeTold {
  std::span<const std::string_view> lines;
  int lit = -1;  // the line of the step just done; -1 for none
};

/// In an exercise it is told when everything that has an order is answered, elsewhere at any step but that of an open
/// question.
[[nodiscard]] inline CodeTold code_told(const Session& session) {
  static constexpr std::array<std::string_view, 1> kLater{"Shown once you have answered."};
  const Player& player = session.player();
  const Conversation& now = session.conversation();
  const bool decides = session.stage().conduct().decides;
  const bool hidden = std::any_of(now.questions().begin(), now.questions().end(), [&](const Asked& asked) {
    return asked.ordered && asked.step != Asked::kAnytime && (decides || asked.step == player.step()) &&
           now.is_open(*asked.question);
  });
  return hidden ? CodeTold{kLater} : CodeTold{player.pseudocode(0), player.line()};
}

}  // namespace snug::lesson
