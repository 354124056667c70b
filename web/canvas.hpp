// Dear ImGui's platform side in a browser: a WebGL 2 context on the page's canvas, input as the page reports it.
#pragma once

#include <string>

namespace snug::web {

inline constexpr const char* kGlslVersion = "#version 300 es";

/// Makes the context of the canvas that the selector names, and it current. smooth: several samples a pixel.
/// false: the browser has no WebGL 2.
bool make_graphics_context(const char* selector, bool smooth);

/// ImGui's renderer and its objects; again after a lost context.
void start_renderer();
void abandon_renderer();

/// css: the canvas in page pixels; scale: device pixels for each. seconds: since the last frame.
void begin_frame(float css_width, float css_height, float scale, float seconds);

/// Whether ImGui still has events in its queue, or has seen one so lately that what it hovers or presses may follow.
bool input_pending();

/// source: "mouse", "pen" or "touch", as pointer events name it. Places are in page pixels from the canvas' corner.
void pointer_moved(float x, float y, const std::string& source);
void pointer_left();
/// button: as the page counts them, 0 the main one, 1 the middle one, 2 the other one.
void pointer_button(int button, bool down, const std::string& source);
/// The scroll in notches of a wheel, y away from the user.
void wheel_turned(float x, float y);
void modifiers_held(bool shift, bool control, bool alt);

/// The CSS name of the pointer's shape.
std::string cursor();

}  // namespace snug::web
