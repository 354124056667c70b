// Where the timeline's buttons stand: the player's five in a row, and the speed.
#pragma once

#include <array>

#include "app/app.hpp"
#include "app/look.hpp"

namespace snug::app {

struct TimelineButtons {
  std::array<Rect, 5> player;  // to the start, back, step, play, to the end
  Rect speed;                  // at the end of their row, or beside the step number if it has no room there
  float left = 0, width = 0;   // of the track
  float track = 0;             // its middle
  float words = 0;             // the middle of the line of words under it
  bool low = false;            // a phone on its side and a lecture on a low screen have no such line
  bool speed_among_words = false;
};

/// rect: the timeline's.
[[nodiscard]] TimelineButtons timeline_buttons(const Look& look, const Rect& rect);

/// The height that the timeline needs.
[[nodiscard]] float timeline_height(const Look& look);
/// And the least that buttons for a mouse need, without the line of words.
[[nodiscard]] float low_timeline_height(const Look& look);

}  // namespace snug::app
