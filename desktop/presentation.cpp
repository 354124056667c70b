#include "desktop/presentation.hpp"

#include <algorithm>
#include <array>

#include "app/look.hpp"
#include "app/widgets.hpp"
#include "lesson/door_words.hpp"

namespace snug::desktop {
namespace {

using app::Face;
using app::Icon;

constexpr float kCorner = 12, kApart = 8;
constexpr int kButtons = 4;

constexpr float kTitleSize = 15, kTitleLeading = 21, kTitleMargin = 24, kAbove = 20, kBeneath = 8;  // of the title

float side_of(const app::Look& look) { return look.px(32); }

std::string title_of(const Shell& shell) {
  return std::to_string(shell.opened() + 1) + " · " + shell.lessons()[shell.opened()].lesson.title;
}

}  // namespace

float presentation_reach(const app::Look& look) {
  return kCorner + static_cast<float>(kButtons) * (side_of(look) + kApart);
}

void draw_presentation(Shell& shell, const app::Rect& stage) {
  const app::Look& look = shell.app().look();
  const float side = side_of(look);
  const app::Pane pane("##presentation", {stage.x, stage.y, presentation_reach(look) + kApart, side + 2 * kCorner},
                       app::Pane::Kind::kOver);
  float x = stage.x + kCorner;
  const auto press = [&](const char* name, Icon icon, bool enabled, bool on) {
    const app::Rect rect{x, stage.y + kCorner, side, side};
    x += side + kApart;
    return app::button(pane.list(), look,
                       {.id = name,
                        .rect = rect,
                        .icon = icon,
                        .kind = on ? app::ButtonKind::kChosen : app::ButtonKind::kOutlined,
                        .enabled = enabled});
  };
  const auto before = shell.beside(-1), after = shell.beside(1);
  const bool leave = press(lesson::kLeaveKeyed, Icon::kClose, true, false);
  const bool back = press(lesson::kPreviousKeyed, Icon::kPreviousLesson, before.has_value(), false);
  const bool on = press(lesson::kNextKeyed, Icon::kNextLesson, after.has_value(), false);
  if (press(lesson::kTextKeyed, Icon::kText, true, shell.text_shown)) shell.text_shown = !shell.text_shown;
  if (back && before) shell.open_at_place(*before);
  if (on && after) shell.open_at_place(*after);
  if (leave) shell.present(false);
}

float title_height(const Shell& shell, const app::Look& look, float width) {
  const auto lines = app::lines_of(look, Face::kSemiBold, kTitleSize, title_of(shell), width - 2 * kTitleMargin);
  return look.px(kTitleLeading) * static_cast<float>(lines.size()) + kAbove + kBeneath;
}

void draw_title(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const app::Pane pane("##title", rect);
  app::paragraph(pane.list(), look, Face::kSemiBold, kTitleSize, kTitleLeading,
                 {rect.x + kTitleMargin, rect.y + kAbove}, rect.width - 2 * kTitleMargin, look->ink, title_of(shell));
}

void draw_invitation(const app::App& app, const app::Rect& stage) {
  constexpr float kSize = 14, kPadX = 12, kPadY = 8, kRoom = 8, kTip = 6;
  constexpr float kBelow = 96;  // pixels at the stage's foot that belong to its sentence
  const auto& invitation = app.invitation();
  if (!invitation || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return;
  const app::Look& look = app.look();
  const app::Rect& at = invitation->at;
  const float width = app::measure(look, Face::kSemiBold, kSize, invitation->words).x + 2 * kPadX;
  const float height = look.px(kSize) + 2 * kPadY;
  const bool below = at.y + at.height + height + kRoom < stage.y + stage.height - kBelow;
  const float y = below ? at.y + at.height + kRoom : at.y - kRoom - height, middle = at.x + at.width / 2;
  const float x = std::clamp(middle - width / 2, stage.x + 8, std::max(stage.x + 8, stage.x + stage.width - width - 8));
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  list->AddRectFilled({x, y}, {x + width, y + height}, look->current, 8);
  const float edge = below ? y : y + height, point = below ? y - kTip : y + height + kTip;
  const std::array<ImVec2, 3> tip{ImVec2{middle - kTip, edge}, {middle, point}, {middle + kTip, edge}};
  if (below) list->AddTriangleFilled(tip[0], tip[1], tip[2], look->current);
  else list->AddTriangleFilled(tip[2], tip[1], tip[0], look->current);
  app::text(list, look, Face::kSemiBold, kSize, {x + kPadX, y + kPadY}, look->on_current, invitation->words);
}

}  // namespace snug::desktop
