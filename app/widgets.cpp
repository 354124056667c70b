#include "app/widgets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/marks.hpp"

namespace snug::app {
namespace {

constexpr float kCorner = 8;

void triangle(ImDrawList* list, ImVec2 m, float size, float direction, Color color) {
  const float w = size * 0.5f * direction, h = size * 0.55f;
  // AddTriangleFilled wants clockwise corners for its fringe.
  if (direction > 0) list->AddTriangleFilled({m.x - w, m.y - h}, {m.x + w, m.y}, {m.x - w, m.y + h}, color);
  else list->AddTriangleFilled({m.x - w, m.y + h}, {m.x + w, m.y}, {m.x - w, m.y - h}, color);
}

/// The name of a control that shows none, beside it, while it is pointed at or has the keyboard.
void show_name(const Look& look, const Rect& rect, std::string_view name) {
  constexpr float kSize = 13;
  const ImVec2 size = measure(look, Face::kRegular, kSize, name), screen = ImGui::GetIO().DisplaySize;
  const float width = size.x + 20, height = size.y + 14;
  const float x = std::clamp(rect.x + (rect.width - width) / 2, 4.0f, std::max(4.0f, screen.x - width - 4));
  const float y = rect.y < screen.y / 2 ? rect.y + rect.height + 8 : rect.y - height - 8;
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  list->AddRectFilled({x, y}, {x + width, y + height}, look->ink, 6);
  text(list, look, Face::kRegular, kSize, {x + 10, middle_of(y + height / 2, size.y)}, look->panel, name);
}

/// The sign for one step.
void chevron(ImDrawList* list, ImVec2 m, float size, float direction, Color color) {
  const float w = size * 0.26f * direction, h = size * 0.5f;
  list->PathLineTo({m.x - w, m.y - h});
  list->PathLineTo({m.x + w, m.y});
  list->PathLineTo({m.x - w, m.y + h});
  list->PathStroke(color, 0, size * 0.19f);
}

void bar(ImDrawList* list, float x, float y, float size, float width, Color color) {
  list->AddRectFilled({x - width / 2, y - size * 0.58f}, {x + width / 2, y + size * 0.58f}, color, 1);
}

void turning_arrow(ImDrawList* list, ImVec2 m, float size, float direction, Color color) {
  const float r = size * 0.42f;
  std::array<ImVec2, 14> arc;
  for (std::size_t i = 0; i < arc.size(); ++i) {
    const float t = -0.15f + 3.5f * static_cast<float>(i) / static_cast<float>(arc.size() - 1);
    arc[i] = {m.x + direction * r * std::cos(t), m.y + size * 0.08f - r * std::sin(t)};
  }
  path(list, arc, false, Stroke::kSolid, color, 1.75f);
  const ImVec2 tip = arc.back();
  const float h = size * 0.3f;
  list->AddTriangleFilled({tip.x - h, tip.y - h * 0.2f}, {tip.x + h, tip.y - h * 0.2f}, {tip.x, tip.y + h * 0.9f},
                          color);
}

void lock(ImDrawList* list, ImVec2 m, float size, Color color) {
  const float w = size * 0.36f;
  list->AddRectFilled({m.x - w, m.y - size * 0.05f}, {m.x + w, m.y + size * 0.5f}, color, 2);
  list->PathArcTo({m.x, m.y - size * 0.05f}, w * 0.66f, 3.14159f, 6.28318f, 12);
  list->PathStroke(color, ImDrawFlags_None, 1.75f);
}

}  // namespace

Pane::Pane(const char* id, const Rect& rect, Kind kind)
    : part_(id, kind == Kind::kOver ? Focus::Layer::kCard : Focus::Layer::kPanel) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({std::max(rect.width, 1.0f), std::max(rect.height, 1.0f)});
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                           ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav;
  if (kind != Kind::kOver) flags |= ImGuiWindowFlags_NoBringToFrontOnFocus;
  if (ImGui::GetIO().WantTextInput) flags |= ImGuiWindowFlags_NoFocusOnAppearing;  // who types goes on typing
  if (kind == Kind::kScrolls) flags &= ~ImGuiWindowFlags_NoScrollbar;
  else flags |= ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(id, nullptr, flags);
  list_ = ImGui::GetWindowDrawList();
}

Pane::~Pane() { ImGui::End(); }

Popup::Popup(const char* id, const Rect& rect) : part_(id, Focus::Layer::kPopup) {
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  open_ = ImGui::BeginPopup(id);
  if (open_ && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) ImGui::CloseCurrentPopup();
}

Popup::~Popup() {
  if (open_) ImGui::EndPopup();
}

Touch pointer_area(const char* id, const Rect& rect, bool enabled) {
  if (rect.width < 1 || rect.height < 1) return {};
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::BeginDisabled(!enabled);
  Touch touch;
  touch.clicked = ImGui::InvisibleButton(id, {rect.width, rect.height});
  touch.hovered = enabled && ImGui::IsItemHovered();
  touch.held = enabled && ImGui::IsItemActive();
  ImGui::EndDisabled();
  return touch;
}

Touch touch_area(const char* id, const Rect& rect, std::string_view name, bool enabled, bool first) {
  Touch touch = pointer_area(id, rect, enabled);
  Focus* const focus = Focus::current();
  if (focus == nullptr || rect.width < 1 || rect.height < 1) return touch;
  const Focus::Here here = focus->offer({.id = ImGui::GetItemID(),
                                         .low = {rect.x, rect.y},
                                         .high = {rect.x + rect.width, rect.y + rect.height},
                                         .name = name.empty() ? std::string_view(id) : name,
                                         .enabled = enabled,
                                         .first = first});
  touch.focused = here.focused;
  touch.clicked = touch.clicked || here.pressed;
  return touch;
}

void offer_field(std::string_view name, ImGuiID id) {
  Focus* const focus = Focus::current();
  if (focus == nullptr) return;
  if (id == 0) id = ImGui::GetItemID();
  if (ImGui::IsItemActivated() && focus->at() != id) focus->go_to(id);
  const Focus::Here here =
      focus->offer({.id = id, .low = ImGui::GetItemRectMin(), .high = ImGui::GetItemRectMax(), .name = name});
  if ((here.arrived || here.pressed) && !ImGui::IsItemActive()) ImGui::SetKeyboardFocusHere(-1);
  if (here.focused && ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) focus->leave();
}

bool offer_slider(std::string_view name) {
  Focus* const focus = Focus::current();
  if (focus == nullptr) return false;
  return focus
      ->offer({.id = ImGui::GetItemID(), .low = ImGui::GetItemRectMin(), .high = ImGui::GetItemRectMax(), .name = name})
      .focused;
}

void draw_icon(ImDrawList* list, Icon icon, ImVec2 m, float size, Color color) {
  switch (icon) {
    case Icon::kNone: break;
    case Icon::kFirst:
      bar(list, m.x - size * 0.5f, m.y, size, 2, color),
          triangle(list, {m.x + size * 0.15f, m.y}, size * 0.95f, -1, color);
      break;
    case Icon::kBack: chevron(list, m, size, -1, color); break;
    case Icon::kStep: chevron(list, m, size, 1, color); break;
    case Icon::kPlay: triangle(list, m, size, 1, color); break;
    case Icon::kPause:
      bar(list, m.x - size * 0.25f, m.y, size * 0.9f, 3.5f, color),
          bar(list, m.x + size * 0.25f, m.y, size * 0.9f, 3.5f, color);
      break;
    case Icon::kLast:
      bar(list, m.x + size * 0.5f, m.y, size, 2, color),
          triangle(list, {m.x - size * 0.15f, m.y}, size * 0.95f, 1, color);
      break;
    case Icon::kLock: lock(list, m, size, color); break;
    case Icon::kFit: {
      const float s = size * 0.5f, c = size * 0.22f;
      for (const float dx : {-1.0f, 1.0f})
        for (const float dy : {-1.0f, 1.0f}) {
          const std::array<ImVec2, 3> corner{ImVec2{m.x + dx * (s - c), m.y + dy * s},
                                             {m.x + dx * s, m.y + dy * s},
                                             {m.x + dx * s, m.y + dy * (s - c)}};
          path(list, corner, false, Stroke::kSolid, color, 1.6f);
        }
      disc(list, m, 2, color);
      break;
    }
    case Icon::kPlus: plus(list, m, size * 0.45f, color, 1.75f); break;
    case Icon::kMinus: list->AddLine({m.x - size * 0.45f, m.y}, {m.x + size * 0.45f, m.y}, color, 1.75f); break;
    case Icon::kUndo: turning_arrow(list, m, size, 1, color); break;
    case Icon::kRedo: turning_arrow(list, m, size, -1, color); break;
    case Icon::kTheme:
      list->AddCircle(m, size * 0.42f, color, 24, 1.5f);
      list->PathArcTo(m, size * 0.42f, -1.5708f, 1.5708f, 16);
      list->PathFillConvex(color);
      break;
    case Icon::kSettings:
      for (const float side : {-1.0f, 1.0f}) {  // two sliders
        const float y = m.y + side * size * 0.26f, knob = m.x - side * size * 0.22f;
        list->AddLine({m.x - size * 0.5f, y}, {m.x + size * 0.5f, y}, color, 1.6f);
        disc(list, {knob, y}, size * 0.2f, color);
      }
      break;
    case Icon::kText:
      for (const float row : {-0.32f, 0.0f, 0.32f})
        list->AddLine({m.x - size * 0.45f, m.y + row * size},
                      {m.x + size * (row > 0.1f ? 0.2f : 0.45f), m.y + row * size}, color, 1.75f);
      break;
    case Icon::kPreviousLesson:
      chevron(list, {m.x - size * 0.14f, m.y}, size, -1, color);
      bar(list, m.x + size * 0.42f, m.y, size * 0.9f, 2, color);
      break;
    case Icon::kNextLesson:
      chevron(list, {m.x + size * 0.14f, m.y}, size, 1, color);
      bar(list, m.x - size * 0.42f, m.y, size * 0.9f, 2, color);
      break;
    case Icon::kClose: cross(list, m, size * 0.35f, color, 1.75f); break;
  }
}

bool button(ImDrawList* list, const Look& look, const Button& b) {
  const Palette& p = *look.palette;
  const bool filled = b.kind == ButtonKind::kPrimary;
  const std::string_view unsaid = !b.name.empty() ? b.name : b.words.empty() ? b.id : std::string_view();
  const Touch touch = touch_area(b.id, b.rect, unsaid.empty() ? b.words : unsaid, b.enabled, filled);
  const ImVec2 low{b.rect.x, b.rect.y}, high{b.rect.x + b.rect.width, b.rect.y + b.rect.height};
  Color ground = filled                                                            ? p.current
                 : b.kind == ButtonKind::kQuiet || b.kind == ButtonKind::kOutlined ? p.panel
                                                                                   : p.raised;
  if (b.kind == ButtonKind::kChosen) ground = p.panel;
  Color ink = filled ? p.on_current : b.kind == ButtonKind::kChosen ? p.current_text : p.ink;
  if (!b.enabled) {
    if (filled) ground = p.raised;
    ink = p.muted;
  }
  if (b.kind != ButtonKind::kQuiet) list->AddRectFilled(low, high, ground, kCorner);
  if (touch.hovered) list->AddRectFilled(low, high, with_alpha(p.ink, touch.held ? 0.14f : 0.07f), kCorner);
  if (b.kind == ButtonKind::kChosen) list->AddRect(low, high, p.current, kCorner, 0, 2);
  else if (b.kind == ButtonKind::kOutlined || (p.panel == p.ground && b.kind != ButtonKind::kQuiet))
    list->AddRect(low, high, p.line, kCorner, 0, 1);

  const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
  const float icon = b.icon == Icon::kNone ? 0 : look.px(13), gap = icon > 0 && !b.words.empty() ? look.px(8) : 0;
  const Face face = b.kind == ButtonKind::kQuiet ? Face::kRegular : Face::kSemiBold;
  const std::string words = shortened(look, face, b.size, b.words, b.rect.width - icon - gap - 8);
  const float width = b.words.empty() ? 0 : measure(look, face, b.size, words).x;
  const float left = middle.x - (icon + gap + width) / 2;
  draw_icon(list, b.icon, {left + icon / 2, middle.y}, icon, ink);
  if (width > 0) text(list, look, face, b.size, {left + icon + gap, middle_of(middle.y, look.px(b.size))}, ink, words);
  if (icon + width > 0 && !unsaid.empty() && Focus::current() != nullptr && (touch.hovered || touch.focused))
    show_name(look, b.rect, unsaid);
  return touch.clicked;
}

void fade_foot(ImDrawList* list, const Rect& rect, Color ground) {
  constexpr float kHeight = 28, kScrollBar = 12;
  if (ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1) return;
  const float bottom = rect.y + rect.height;
  const Color none = with_alpha(ground, 0);
  list->AddRectFilledMultiColor({rect.x, bottom - kHeight}, {rect.x + rect.width - kScrollBar, bottom}, none, none,
                                ground, ground);
}

void rule(ImDrawList* list, float x, float y, float width, Color color) {
  list->AddRectFilled({x, std::floor(y)}, {x + width, std::floor(y) + 1}, color);
}

}  // namespace snug::app
