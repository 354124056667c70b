// What a cover shows, as a picture that a door saves.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "app/app.hpp"

namespace snug::app {

/// The formats besides those of the cover's table. A door draws the PNG, at this size.
inline constexpr std::array<std::string_view, 2> kPictureFormats{"svg", "png"};
inline constexpr float kPictureWidth = 1280, kPictureHeight = 800;

/// The chart that the app's cover shows. Empty if nothing has been measured, as its table's files are then.
[[nodiscard]] std::string cover_svg(App& app);
/// Draws it over a rectangle of the current ImGui frame.
void draw_cover_picture(App& app, const Rect& rect);

}  // namespace snug::app
