// The pseudocode as it may be told now: in an exercise that puts steps in order, it would give the order away.
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

[[nodiscard]] inline CodeTold code_told(const Session& session) {
  static constexpr std::array<std::string_view, 1> kLater{"Shown once you have answered."};
  const Player& player = session.player();
  const Conversation& now = session.conversation();
  const auto waits = [&](const Asked& asked) { return asked.ordered && now.is_open(*asked.question); };
  const bool hidden =
      session.stage().conduct().decides && std::any_of(now.questions().begin(), now.questions().end(), waits);
  return hidden ? CodeTold{kLater} : CodeTold{player.pseudocode(0), player.line()};
}

}  // namespace snug::lesson
