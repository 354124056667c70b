// The few controls that stage, timeline and panels share, drawn in the palette over ImGui's invisible buttons.
#pragma once

#include <string_view>

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
  ImDrawList* list_;
};

struct Touch {
  bool clicked = false, hovered = false, held = false;
};
/// An area that answers the pointer.
Touch touch_area(const char* id, const Rect& rect, bool enabled = true);

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
  float size = 14;  // size of the words
};
/// Draws it and returns whether it was clicked.
bool button(ImDrawList* list, const Look& look, const Button& button);

/// A one-pixel rule.
void rule(ImDrawList* list, float x, float y, float width, Color color);

}  // namespace snug::app
