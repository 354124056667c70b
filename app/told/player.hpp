// Where the player stands, and what the stage shows of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "app/told/words.hpp"

namespace snug::app::told {

/// A place on the canvas.
struct Rectangle {
  float x = 0, y = 0, width = 0, height = 0;
  SNUG_FIELDS(x, y, width, height);
};

/// What the prose lights on the stage, and the stage in the prose.
struct Lit {
  std::string_view mark;
  std::vector<std::string> handles;
  std::vector<std::string_view> words;
  SNUG_FIELDS(mark, handles, words);
};

/// What one who is new is asked to do next.
struct Invitation : Rectangle {
  using Base = Rectangle;
  std::string words;
  SNUG_FIELDS(words);
};

/// Where in the scene, how wide, how many times larger; and the panel's place.
struct CloseUp : Rectangle {
  using Base = Rectangle;
  std::vector<double> at;
  double size = 0, times = 1;
  SNUG_FIELDS(at, size, times);
};

/// What is being computed, and how much of it is done: 0 to 1.
struct Preparing {
  std::string says;
  double share = 0;
  SNUG_FIELDS(says, share);
};

struct Player {
  std::string_view lesson;
  int step = 0, steps = 0;
  std::optional<int> furthest;  // what people may see of the steps, if not all
  std::string caption;
  std::optional<int> section;
  Lit lit;
  std::optional<Invitation> invitation;
  std::optional<CloseUp> close_up;
  int invited = 0;
  bool playing = false;
  float speed = 1;
  bool previewing = false;
  std::optional<Preparing> preparing;
  SNUG_FIELDS(lesson, step, steps, furthest, caption, section, lit, invitation, close_up, invited, playing, speed,
              previewing, preparing);
};

struct Frames {
  long frames_drawn = 0;
  SNUG_FIELDS(frames_drawn);
};

[[nodiscard]] Player player_of(const App& app, const lesson::Session& session);
[[nodiscard]] std::optional<Preparing> preparing_of(const lesson::Session& session);

}  // namespace snug::app::told
