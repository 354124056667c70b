// The timeline: track, marks, gates, thumb, and the buttons of the player.
#pragma once

#include <optional>
#include <string_view>

#include "app/subject.hpp"

namespace snug::app {

struct PlayerView {
  bool playing = false;
  float speed = 1;
  std::optional<int> furthest;  // see furthest_to_show
};

/// What the user asked for: a command's name, or empty; a speed, or 0. And where two of its buttons stand.
struct PlayerWish {
  std::string_view command;
  float speed = 0;
  Rect step = {}, play = {};
};

/// The speeds that can be chosen, slowest first.
inline constexpr std::array kSpeeds{0.25f, 0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f, 32.0f};

/// What the button says that takes a step: where the end is shown before the player was used, a step begins anew.
[[nodiscard]] std::string_view step_words(const lesson::Session& session);

/// Draws into a rectangle of the current pane. Scrubbing moves the session directly.
[[nodiscard]] PlayerWish draw_timeline(const Look& look, lesson::Session& session, const SubjectView& view,
                                       const Rect& rect, const PlayerView& player);

}  // namespace snug::app
