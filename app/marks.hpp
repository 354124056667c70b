// The marks of the stage, each with one meaning, on ImGui's draw lists. Colours come from those who know the meaning.
#pragma once

#include <span>

#include "app/look.hpp"

namespace snug::app {

enum class Stroke { kSolid, kDotted, kDashed, kLongDashed };

void path(ImDrawList* list, std::span<const ImVec2> points, bool closed, Stroke stroke, Color color, float width);
void line(ImDrawList* list, ImVec2 a, ImVec2 b, Stroke stroke, Color color, float width);
/// Only what lies within the list's clip rectangle is worked out, so that a circle zoomed into costs no more.
void circle(ImDrawList* list, ImVec2 center, float radius, Stroke stroke, Color color, float width);
void disc(ImDrawList* list, ImVec2 center, float radius, Color color);
/// size: from the middle to a corner; rimmed, so that it stands off from lines that end in it.
void diamond(ImDrawList* list, ImVec2 center, float size, Color color, Color rim);
void ring(ImDrawList* list, ImVec2 center, float radius, Color color, float width);
void plus(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void cross(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void tick(ImDrawList* list, ImVec2 center, float size, Color color, float width);
void arrow(ImDrawList* list, ImVec2 from, ImVec2 to, Color color, float width);
/// Slanted lines within a circle.
void hatching(ImDrawList* list, ImVec2 center, float radius, Color color);
/// Words on a halo of the ground's colour.
void halo_text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
               std::string_view words);

}  // namespace snug::app
