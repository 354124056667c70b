// Buttons for what is done by hand, beside the stage.
#pragma once

#include <algorithm>
#include <string>

#include "app/widgets.hpp"

namespace snug::app {

inline constexpr float kHandHead = 26;  // the height of the heading above them

/// Buttons from left to right, and then in the next row.
struct HandButtons {
  const Look& look;
  ImDrawList* list;
  ImVec2 at;
  float width;
  float x = 0, y = 0;

  [[nodiscard]] float row() const { return look.fingers ? 44.0f : look.px(32); }

  bool press(const std::string& words, const std::string& name, ButtonKind kind, bool enabled = true) {
    const float wide = std::min(measure(look, Face::kSemiBold, 13, words).x + look.px(18), width);
    if (x > 0 && x + wide > width) x = 0, y += row() + kGap;
    const Rect rect{at.x + x, at.y + y, wide, row()};
    x += wide + kGap;
    return button(list, look,
                  {.id = name.c_str(), .rect = rect, .words = words, .kind = kind, .enabled = enabled, .size = 13});
  }
  void next_row() {
    if (x > 0) y += row() + kGap;
    x = 0;
  }
  /// The height of the heading and all rows.
  [[nodiscard]] float height() const { return y + look.px(kHandHead) + row(); }

 private:
  static constexpr float kGap = 6;
};

}  // namespace snug::app
