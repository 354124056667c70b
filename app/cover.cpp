#include "app/cover.hpp"

#include <algorithm>

#include "app/look.hpp"

namespace snug::app {

CoverRoom cover_room(const Look& look, const Rect& rect, float below) {
  constexpr float kLow = 300, kWide = 1.5f, kBeside = 24;
  if (rect.height > kLow || rect.width < kWide * rect.height) {
    const float above = look.fingers ? 60 : look.px(44);
    return {{rect.x, rect.y + above, rect.width, rect.height - above - below}};
  }
  const float left = std::max(0.0f, look.tools - 8);
  return {{rect.x + left, rect.y, rect.width - left, rect.height - below},
          look.tools_right > 0 ? look.tools_right + kBeside : 0};
}

}  // namespace snug::app
