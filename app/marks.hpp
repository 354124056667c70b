// The marks of the stage, each with one meaning, on ImGui's draw lists. Callers know the meaning and the colour.
#pragma once

#include <span>

#include "app/look.hpp"

namespace snug::app {

/// A colour under the light.
[[nodiscard]] Color shaded(Color color, double share);

enum class Stroke { kSolid, kDotted, kDashed, kLongDashed };

void path(ImDrawList* list, std::span<const ImVec2> points, bool closed, Stroke stroke, Color color, float width);
void line(ImDrawList* list, ImVec2 a, ImVec2 b, Stroke stroke, Color color, float width);
/// Only the part within the list's clip rectangle is computed, so that a very large circle costs no more.
void circle(ImDrawList* list, ImVec2 center, float radius, Stroke stroke, Color color, float width);
/// Fills a circle of any size, as far as the clip rectangle shows it.
void filled_circle(ImDrawList* list, ImVec2 center, float radius, Color color);
void disc(ImDrawList* list, ImVec2 center, float radius, Color color);
/// size: from the centre to a corner. It has a rim, so that it stands out from lines that end at it.
void diamond(ImDrawList* list, ImVec2 center, float size, Color color, Color rim);
void ring(ImDrawList* list, ImVec2 center, float radius, Color color, float width);
void plus(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void cross(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void tick(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void arrow(ImDrawList* list, ImVec2 from, ImVec2 to, Color color, float width);
/// Draws slanted lines within a circle.
void hatching(ImDrawList* list, ImVec2 center, float radius, Color color);
/// Draws words on a halo in the ground's colour.
void halo_text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
               std::string_view words);

}  // namespace snug::app
