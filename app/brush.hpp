// What the stage's drawing functions share during a frame.
#pragma once

#include <span>

#include "app/subject.hpp"
#include "app/volumes.hpp"

namespace snug::app {

/// A label that is still to be placed.
struct Label {
  LabelRequest request;
  std::string words;
  Face face = Face::kSemiBold;
  float size = 14;
  Color color = 0;
  bool plate = false;  // on a plate of the ground's colour, where a halo is too little
};

/// What the user is doing on the stage.
struct Hands {
  Index selected = kNoIndex, hovered = kNoIndex;
  bool arrows = false;    // whether the arrow keys move the selected handle
  bool grabs = false;     // whether a press at the pointer would grab a handle
  bool dragging = false;  // whether the selected handle is being dragged
};

struct Brush {
  ImDrawList* list;
  const Look& look;
  const Palette& p;
  const lesson::Session& session;
  const SubjectView& view;
  Rect rect;
  Canvas canvas;
  Hands hands;
  std::span<const ScreenPoint> handles;  // where each handle is on the screen
  float point_radius = 5;
  std::optional<fit::Volume3> volume;  // moving towards the step's volume
  std::vector<Label> labels;

  [[nodiscard]] int dim() const { return canvas.camera.dim(); }
  [[nodiscard]] float stroke(float share = 1) const { return p.stroke * share; }
  [[nodiscard]] ImVec2 at(const Point3& point) const { return canvas.at(point); }
  [[nodiscard]] Point3 point(Index i) const { return view.place_of(session, i); }

  /// Draws the ground of a second picture.
  void panel(const Rect& at) const {
    const ImVec2 low{at.x, at.y}, high{at.x + at.width, at.y + at.height};
    list->AddRectFilled(low, high, p.panel, 8);
    list->AddRect(low, high, p.line, 8, 0, 1);
  }

  /// Requests a label beside a place on the screen. The anchor's mark is gap / 2 across.
  void label(ImVec2 anchor, float gap, ImVec2 toward, std::string words, Color color, Face face = Face::kSemiBold,
             float size = 14, bool optional = false) {
    const ImVec2 extent = measure(look, face, size, words);
    labels.push_back({{anchor.x, anchor.y, gap, extent.x + 6, extent.y + 2, toward.x, toward.y, optional},
                      std::move(words),
                      face,
                      size,
                      color});
  }
};

/// Whether the open question is answered on the stage.
[[nodiscard]] inline bool answered_on_stage(const lesson::Session& session) {
  return session.conversation().asked() != nullptr && session.conversation().asked()->on_stage;
}

/// Whether a name consists of plus and minus signs, like a vertex's; a halo would make it unreadable.
[[nodiscard]] inline bool is_of_signs(std::string_view words) {
  return words.find_first_not_of("+\u2212") == std::string_view::npos;
}

/// How much of the stage's foot a cover leaves for its sentence. in_canvas: it is drawn there; on the page it is HTML,
/// over a wide stage alone.
float room_for_sentence(const Look& look, const Rect& stage, std::string_view sentence, bool in_canvas);
/// Draws a sentence on a pill at the stage's foot, and adds it to the obstacles. Returns the place of the pill.
Rect draw_sentence(ImDrawList* list, const Look& look, Obstacles& obstacles, const Rect& stage,
                   std::string_view sentence);

}  // namespace snug::app
