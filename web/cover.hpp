// Files and pictures of what is shown, for the page.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "app/cover.hpp"

namespace snug::web {

/// The provenance of this program; the page provides the processor, as far as a browser tells.
[[nodiscard]] cost::Provenance web_provenance(const std::string& processor);

/// A file of what the cover shows (app/told/door.hpp). The page makes a PNG of what draw_cover draws. address: for a
/// picture.
[[nodiscard]] emscripten::val cover_file(const std::string& format, const std::string& address);

/// Draws the cover's chart alone onto the whole canvas, whose size the page has set: page pixels, and device pixels for
/// each. Returns false if nothing can be drawn.
bool draw_cover(float width, float height, float scale);

/// Draws the stage alone on the canvas, which has that size times the scale; the next frame draws the page's again.
/// Returns false if nothing can be drawn.
bool draw_picture(float width, float height, float scale);
/// The stage alone as SVG, of that size in page pixels, with the address of what it shows; empty if it cannot be drawn.
[[nodiscard]] std::string picture_svg(float width, float height, const std::string& address);

}  // namespace snug::web
