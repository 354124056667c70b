// What a cover shows, as a picture that a door saves.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"

namespace snug::app {

inline constexpr float kPictureWidth = 1280, kPictureHeight = 800;

/// The formats in which a cover can be saved: those of its table, and if it is a chart, "svg" and "png". A door draws
/// the PNG.
[[nodiscard]] std::vector<std::string_view> formats_of(const Cover& cover);

/// The chart that the app's cover shows. Empty if nothing has been measured, as its table's files are then, or if it is
/// no chart. address: of what shows it.
[[nodiscard]] std::string cover_svg(App& app, std::string_view address);
/// Draws it over a rectangle of the current ImGui frame.
void draw_cover_picture(App& app, const Rect& rect);

}  // namespace snug::app
