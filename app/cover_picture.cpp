#include "app/cover_picture.hpp"

#include "app/chart_pen.hpp"
#include "app/chart_svg.hpp"
#include "app/cover.hpp"

namespace snug::app {

std::vector<std::string_view> formats_of(const Cover& cover) {
  std::vector<std::string_view> formats(cover.formats().begin(), cover.formats().end());
  if (cover.picture() != nullptr) formats.insert(formats.end(), {"svg", "png"});
  return formats;
}

std::string cover_svg(App& app, std::string_view address) {
  const Cover* const cover = app.cover();
  if (cover == nullptr || cover->picture() == nullptr || cover->file(cover->formats().front()).empty()) return {};
  return chart_svg(app.look(), kPictureWidth, kPictureHeight, *cover->picture(), address, app.settings().ground);
}

void draw_cover_picture(App& app, const Rect& rect) {
  if (app.cover() == nullptr || app.cover()->picture() == nullptr) return;
  ImDrawList* const list = ImGui::GetBackgroundDrawList();
  if (app.settings().ground)
    list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, app.look()->ground);
  ScreenPen pen(list);
  draw_chart(pen, app.look(), rect, *app.cover()->picture());
}

}  // namespace snug::app
