#include "desktop/column.hpp"

#include <algorithm>

#include "app/marks.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kCardPad = 18;

}  // namespace

void Column::title(std::string_view words) {
  y_ += app::paragraph(list_, look_, Face::kSemiBold, 20, 26, {x_, y_}, width_, look_->ink, words) + look_.px(6);
}

void Column::heading(std::string_view words, app::Color color) {
  app::text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(3)}, color != 0 ? color : look_->muted, words);
  y_ += look_.px(24);
}

void Column::words(std::string_view words, Face face, float size, app::Color color) {
  y_ += app::paragraph(list_, look_, face, size, size + 7, {x_, y_}, width_, color != 0 ? color : look_->ink, words);
}

int Column::buttons(const char* id, const std::vector<std::string>& words, int chosen, const std::vector<bool>& enabled,
                    const std::vector<std::string>& room) {
  int clicked = -1;
  float x = 0;
  const float height = look_.px(34), gap = 8;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const float wanted = app::measure(look_, Face::kSemiBold, 14, room.empty() ? words[i] : room[i]).x + look_.px(26);
    const float width = std::min(std::max(wanted, look_.px(56)), width_);
    if (x > 0 && x + width > width_ + 0.5f) x = 0, y_ += height + gap;
    const std::string name = std::string(id) + std::to_string(i);
    const bool on = static_cast<int>(i) == chosen;
    if (app::button(list_, look_,
                    {.id = name.c_str(),
                     .rect = {x_ + x, y_, width, height},
                     .words = words[i],
                     .kind = on ? app::ButtonKind::kChosen : app::ButtonKind::kOutlined,
                     .enabled = enabled.empty() || enabled[i]}))
      clicked = static_cast<int>(i);
    x += width + gap;
  }
  row_taken_ = x;
  if (!words.empty()) y_ += height + gap;
  return clicked;
}

int Column::chooser(const char* id, float from, float width, const std::vector<std::string>& words, int chosen) {
  const float height = look_.px(34), middle = y_ + height / 2;
  const app::Rect rect{x_ + from, y_, width, height};
  const std::string button_id = std::string(id) + " button";
  if (app::button(list_, look_, {.id = button_id.c_str(), .rect = rect, .kind = app::ButtonKind::kOutlined}))
    ImGui::OpenPopup(id);
  const std::string_view now = chosen >= 0 ? std::string_view(words[chosen]) : std::string_view();
  app::text(list_, look_, Face::kSemiBold, 14, {rect.x + 12, app::middle_of(middle, look_.px(14))}, look_->ink,
            app::shortened(look_, Face::kSemiBold, 14, now, rect.width - 40));
  const float cx = rect.x + rect.width - 16;
  list_->AddTriangleFilled({cx - 5, middle - 2.5f}, {cx + 5, middle - 2.5f}, {cx, middle + 3.5f}, look_->muted);
  const float list_width = std::max(width, look_.px(180));
  return choice_list(look_, id, {std::min(rect.x, x_ + width_ - list_width), rect.y + height + 4}, list_width, words,
                     chosen);
}

// The card's ground is drawn beneath its content, although its height is known only afterwards.
void Column::begin_card() {
  list_->ChannelsSplit(2);
  list_->ChannelsSetCurrent(1);
  card_top_ = y_;
  y_ += kCardPad - 4;
  x_ += kCardPad;
  width_ -= 2 * kCardPad;
}

void Column::end_card() {
  y_ += kCardPad - 4;
  x_ -= kCardPad;
  width_ += 2 * kCardPad;
  list_->ChannelsSetCurrent(0);
  list_->AddRectFilled({x_, card_top_}, {x_ + width_, y_}, look_->raised, 8);
  list_->AddRect({x_, card_top_}, {x_ + width_, y_}, look_->line, 8, 0, 1);
  list_->ChannelsMerge();
  y_ += 12;
}

int choice_list(const app::Look& look, const char* id, ImVec2 at, float width, const std::vector<std::string>& words,
                int chosen) {
  const float row = look.px(34), height = row * static_cast<float>(words.size()) + 8;
  const float below = ImGui::GetIO().DisplaySize.y - at.y - 8;
  const float top = below >= height ? at.y : std::max(8.0f, ImGui::GetIO().DisplaySize.y - height - 8);
  const app::Popup popup(id, {at.x, top, width, height});
  int clicked = -1;
  if (!popup) return clicked;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const app::Rect rect{at.x + 4, top + 4 + row * static_cast<float>(i), width - 8, row};
    const std::string name = "choice " + std::to_string(i);
    const bool on = static_cast<int>(i) == chosen;
    const app::Touch touch = app::touch_area(name.c_str(), rect, words[i], true, on);
    if (touch.hovered || on)
      list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + row}, look->raised, 6);
    app::text(list, look, on ? Face::kSemiBold : Face::kRegular, 14,
              {rect.x + 10, app::middle_of(rect.y + row / 2, look.px(14))}, on ? look->current_text : look->ink,
              app::shortened(look, Face::kSemiBold, 14, words[i], rect.width - 20));
    if (touch.clicked) {
      clicked = static_cast<int>(i);
      ImGui::CloseCurrentPopup();
    }
  }
  return clicked;
}

}  // namespace snug::desktop
