#include "app/chart_pen.hpp"

namespace snug::app {

void ScreenPen::line(ImVec2 a, ImVec2 b, Color color, float width) { list_->AddLine(a, b, color, width); }

void ScreenPen::path(std::span<const ImVec2> points, Stroke stroke, Color color, float width) {
  app::path(list_, points, false, stroke, color, width);
}

void ScreenPen::polygon(std::span<const ImVec2> corners, Color fill, Color color, float width) {
  const int count = static_cast<int>(corners.size());
  list_->AddConvexPolyFilled(corners.data(), count, fill);
  list_->AddPolyline(corners.data(), count, color, ImDrawFlags_Closed, width);
}

void ScreenPen::disc(ImVec2 center, float radius, Color fill, Color color, float width) {
  if (fill != kNoColor) list_->AddCircleFilled(center, radius, fill);
  list_->AddCircle(center, radius, color, 0, width);
}

void ScreenPen::box(const Rect& rect, Color fill, Color color) {
  constexpr float kRadius = 8;
  const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
  list_->AddRectFilled(low, high, fill, kRadius);
  list_->AddRect(low, high, color, kRadius);
}

void ScreenPen::words(const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words) {
  text(list_, look, face, size, at, color, words);
}

void ScreenPen::halo_words(const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
                           std::string_view words) {
  halo_text(list_, look, face, size, at, color, halo, words);
}

void ScreenPen::clip(const Rect* within) {
  if (within == nullptr) return list_->PopClipRect();
  list_->PushClipRect({within->x, within->y}, {within->x + within->width, within->y + within->height}, true);
}

}  // namespace snug::app
