// What the stage's drawing passes around for the length of a frame. For the stage's own files.
#pragma once

#include "app/stage.hpp"

namespace snug::app {

struct Stage::Brush {
  ImDrawList* list;
  const Look& look;
  const Palette& p;
  const lesson::Session& session;
  Rect rect;
  Canvas canvas;
  std::vector<Label> labels;

  [[nodiscard]] float stroke(float share = 1) const { return p.stroke * share; }
  [[nodiscard]] ImVec2 at(const Point3& point) const { return canvas.at(point); }

  [[nodiscard]] Point3 point(Index i) const { return place_of(session, i); }

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

/// A sentence on a pill at the stage's foot, which is then among the obstacles.
void draw_sentence(ImDrawList* list, const Look& look, Obstacles& obstacles, const Rect& stage,
                   std::string_view sentence);

}  // namespace snug::app
