#include "app/timeline_buttons.hpp"

#include <doctest/doctest.h>

#include "app/labels.hpp"

namespace snug::app {
namespace {

bool is_inside(const Rect& inner, const Rect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.width <= outer.x + outer.width &&
         inner.y + inner.height <= outer.y + outer.height;
}

}  // namespace

TEST_CASE("the speed stands beside the buttons and over none of them, however narrow the timeline") {
  int among_words = 0, in_row = 0;
  for (const bool fingers : {false, true})
    for (const float scale : {0.9f, 1.0f, 1.4f, 1.5f})
      for (float width = 300; width <= 1300; ++width)
        for (const bool on_side : {false, true}) {
          Look look;
          look.fingers = fingers, look.text_scale = scale;
          const Rect rect{371, 648, width, on_side ? 104 : timeline_height(look)};
          const TimelineButtons buttons = timeline_buttons(look, rect);
          CAPTURE(width);
          CAPTURE(scale);
          CAPTURE(fingers);
          CAPTURE(on_side);
          REQUIRE(is_inside(buttons.speed, rect));
          for (std::size_t i = 0; i < buttons.player.size(); ++i) {
            REQUIRE(is_inside(buttons.player[i], rect));
            REQUIRE_FALSE(overlap(buttons.player[i], buttons.speed));
            for (std::size_t k = 0; k < i; ++k) REQUIRE_FALSE(overlap(buttons.player[i], buttons.player[k]));
          }
          ++(buttons.speed_among_words ? among_words : in_row);
        }
  CHECK(among_words > 100);
  CHECK(in_row > 100);
}

}  // namespace snug::app
