// Rows of a name and a number, from top to bottom.
#pragma once

#include <string>

#include "app/widgets.hpp"

namespace snug::app {

inline constexpr float kPanelRow = 24, kPanelWords = 13;

struct PanelRows {
  const Look& look;
  ImDrawList* list;
  float x, y, width;

  void row(const std::string& name, const std::string& value, Color color, bool lit = false) {
    const float height = look.px(kPanelRow), middle = middle_of(y + height / 2, look.px(kPanelWords));
    if (lit) list->AddRectFilled({x - 8, y}, {x + width + 8, y + height - 1}, look->lit, 4);
    text(list, look, lit ? Face::kSemiBold : Face::kRegular, kPanelWords, {x, middle}, look->ink, name);
    text_right(list, look, Face::kMonoBold, kPanelWords, {x + width, middle}, color, value);
    y += height;
    rule(list, x, y - 1, width, look->line);
  }
};

}  // namespace snug::app
