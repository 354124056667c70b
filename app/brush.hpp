// What the stage's drawing passes around for the length of a frame.
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
};

/// What the hands on the stage are at.
struct Hands {
  Index selected = kNoIndex, hovered = kNoIndex;
  bool arrows = false;    // whether the arrow keys move the selected handle
  bool grabs = false;     // whether a press where the pointer is would grab a handle
  bool dragging = false;  // the selected one
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
  std::span<const ScreenPoint> handles;  // where each stands on the screen
  float point_radius = 5;
  std::optional<fit::Volume3> volume;  // on its way to where the step has it
  std::vector<Label> labels;

  [[nodiscard]] int dim() const { return canvas.camera.dim(); }
  [[nodiscard]] float stroke(float share = 1) const { return p.stroke * share; }
  [[nodiscard]] ImVec2 at(const Point3& point) const { return canvas.at(point); }
  [[nodiscard]] Point3 point(Index i) const { return view.place_of(session, i); }

  /// A label beside a place of the screen. The anchor's own mark is gap / 2 across.
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

/// Whether the question that stands is answered on the stage.
[[nodiscard]] inline bool answered_on_stage(const lesson::Session& session) {
  return session.asked() != nullptr && session.asked()->on_stage;
}

/// Whether a name is of plus and minus alone, as a corner's is; a halo would close it up.
[[nodiscard]] inline bool is_of_signs(std::string_view words) {
  return words.find_first_not_of("+\u2212") == std::string_view::npos;
}

/// A sentence on a pill at the stage's foot, which is then among the obstacles.
void draw_sentence(ImDrawList* list, const Look& look, Obstacles& obstacles, const Rect& stage,
                   std::string_view sentence);

}  // namespace snug::app
