#include "app/timeline_buttons.hpp"

namespace snug::app {
namespace {

constexpr float kMargin = 28, kFingerMargin = 20;  // of the track
constexpr float kEdge = 8;                         // of the row of buttons
constexpr float kButtonGap = 6;

struct RowSizes {
  float height, small, wide;
  [[nodiscard]] float width() const { return 3 * small + 2 * wide + 4 * kButtonGap; }
};

RowSizes row_sizes(const Look& look, float width, bool low) {
  if (!look.fingers && width >= look.px(372) + 4 * kButtonGap) return {look.px(36), look.px(44), look.px(120)};
  // Buttons for the thumb, over the whole width: two small, two large, one small.
  const float unit = (width - 4 * kButtonGap) / 7.4f;
  return {!look.fingers ? look.px(36) : low ? 44.0f : 52.0f, unit, unit * 2.2f};
}

}  // namespace

float timeline_height(const Look& look) { return look.fingers ? 110 + look.px(48) : 60 + look.px(76); }

float low_timeline_height(const Look& look) { return 56 + look.px(36); }

TimelineButtons timeline_buttons(const Look& look, const Rect& rect) {
  TimelineButtons buttons;
  const float margin = look.fingers ? kFingerMargin : kMargin;
  buttons.left = rect.x + margin, buttons.width = rect.width - 2 * margin;
  buttons.low = rect.height < timeline_height(look) - 20;
  buttons.track = rect.y + (buttons.low ? 30 : 36);
  buttons.words = rect.y + 36 + look.px(30);

  const float speed_width = look.px(48), speed_height = look.fingers ? 40 : look.px(32);
  const float room = buttons.low ? rect.width - speed_width - 4 : rect.width;
  const RowSizes row = row_sizes(look, room - 2 * kEdge, buttons.low);
  const float top = rect.y + rect.height - (buttons.low ? 8 : 14) - row.height;
  float x = rect.x + (room - row.width()) / 2;
  for (std::size_t i = 0; i < buttons.player.size(); ++i) {
    const float width = i == 2 || i == 3 ? row.wide : row.small;
    buttons.player[i] = {x, top, width, row.height};
    x += width + kButtonGap;
  }

  const float at_end = buttons.left + buttons.width - speed_width + 8;
  buttons.speed_among_words = !buttons.low && x - kButtonGap + 8 > at_end;
  const float middle = buttons.speed_among_words ? buttons.words : top + row.height / 2;
  buttons.speed = {buttons.low ? rect.x + rect.width - speed_width - 8 : at_end, middle - speed_height / 2, speed_width,
                   speed_height};
  return buttons;
}

}  // namespace snug::app
