// The few controls that stage, timeline and panels share, drawn in the palette over ImGui's invisible buttons.
#pragma once

#include <string_view>

#include "app/focus.hpp"
#include "app/look.hpp"

namespace snug::app {

/// A part of the canvas: an ImGui window without decoration.
class Pane {
 public:
  enum class Kind { kStill, kScrolls, kOver };  // kOver: above all others, from when it appears
  Pane(const char* id, const Rect& rect, Kind kind = Kind::kStill);
  ~Pane();
  Pane(const Pane&) = delete;
  Pane& operator=(const Pane&) = delete;
  [[nodiscard]] ImDrawList* list() const { return list_; }

 private:
  Focus::Part part_;
  ImDrawList* list_;
};

/// A menu over all else, while it is open; to be opened by ImGui::OpenPopup(id).
class Popup {
 public:
  Popup(const char* id, const Rect& rect);
  ~Popup();
  Popup(const Popup&) = delete;
  Popup& operator=(const Popup&) = delete;
  explicit operator bool() const { return open_; }

 private:
  Focus::Part part_;
  bool open_;
};

struct Touch {
  bool clicked = false, hovered = false, held = false, focused = false;
};
/// An area that answers the pointer.
Touch pointer_area(const char* id, const Rect& rect, bool enabled = true);
/// One that the keyboard presses as well. name: what it is called; empty for its id. first: of a card, where the
/// keyboard begins.
Touch touch_area(const char* id, const Rect& rect, std::string_view name = {}, bool enabled = true, bool first = false);
/// The ImGui text field that was just drawn is one of the keyboard's places too. id: its own; 0 for that of the last
/// item.
void offer_field(std::string_view name, ImGuiID id = 0);
/// The same for an ImGui slider. Returns whether the keyboard is on it.
bool offer_slider(std::string_view name);

enum class Icon {
  kNone,
  kFirst,
  kBack,
  kStep,
  kPlay,
  kPause,
  kLast,
  kLock,
  kFit,
  kPlus,
  kMinus,
  kUndo,
  kRedo,
  kTheme,
  kSettings,
  kText,
  kPreviousLesson,
  kNextLesson,
  kClose
};
void draw_icon(ImDrawList* list, Icon icon, ImVec2 middle, float size, Color color);

enum class ButtonKind { kPlain, kPrimary, kOutlined, kChosen, kQuiet };
struct Button {
  const char* id;
  Rect rect;
  std::string_view words = {};
  Icon icon = Icon::kNone;
  ButtonKind kind = ButtonKind::kPlain;
  bool enabled = true;
  float size = 14;             // size of the words
  std::string_view name = {};  // where its words do not say it, and none stand for it: its id
};
/// Draws it and returns whether it was clicked.
bool button(ImDrawList* list, const Look& look, const Button& button);

/// At the foot of a pane that scrolls, where there is more below: what is cut off there fades away.
void fade_foot(ImDrawList* list, const Rect& rect, Color ground);

/// A one-pixel rule.
void rule(ImDrawList* list, float x, float y, float width, Color color);

}  // namespace snug::app
