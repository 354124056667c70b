// A frame as an SVG file: what ImGui drew as the outlines of its shapes, what OpenGL drew as circles, lines and
// polygons, and words as words, which can be searched, selected and set in another font.
#pragma once

#include <span>
#include <string>

#include "app/look.hpp"
#include "app/stage_gl.hpp"

namespace snug::app {

struct SvgPicture {
  float width = 0, height = 0;  // page pixels
  Color ground = 0;             // of all of it; 0: transparent
  std::string title, sentence;  // the lesson's, and the step's
  std::string address;          // of the state, for whoever finds the file
};

/// Draws a frame of the stage alone, which fills the picture, as SVG: call between ImGui::NewFrame and the door's own
/// drawing, in place of App::frame and ImGui::Render. picture: its size and its address.
[[nodiscard]] std::string stage_svg(App& app, SvgPicture picture, double now);
/// words: noted apart (App::note_words). scene: null for none. A mesh is drawn face by face, the farthest first, which
/// is right unless faces cut each other; a sphere or an ellipsoid becomes an ellipse whose rim is darker.
[[nodiscard]] std::string picture_svg(const ImDrawData& drawn, std::span<const DrawnWords> words, const GlScene* scene,
                                      const SvgPicture& picture);

}  // namespace snug::app
