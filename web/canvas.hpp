// Dear ImGui's platform side in a browser: a WebGL 2 context on the page's canvas, input as the page reports it.
#pragma once

#include <string>

namespace snug::web {

inline constexpr const char* kGlslVersion = "#version 300 es";

/// Creates the context of the selected canvas and makes it current. smooth: several samples a pixel. Returns false if
/// the browser has no WebGL 2.
bool make_graphics_context(const char* selector, bool smooth);

/// Creates ImGui's renderer and its objects; again after a lost context.
void start_renderer();
void abandon_renderer();

/// css_width, css_height: the canvas in page pixels; scale: device pixels for each. seconds: since the last frame.
void begin_frame(float css_width, float css_height, float scale, float seconds);

/// Whether ImGui still has events in its queue, or had one so recently that its effect may still be to come.
bool input_pending();

/// source: "mouse", "pen" or "touch", as in pointer events. Positions are in page pixels from the canvas's corner.
void pointer_moved(float x, float y, const std::string& source);
void pointer_left();
/// What was pressed and not drawn yet is forgotten: it was meant for what stood there before.
void forget_input();
/// button: as in pointer events, 0 the main one, 1 the middle one, 2 the secondary one.
void pointer_button(int button, bool down, const std::string& source);
/// The scroll in notches of a wheel, y away from the user.
void wheel_turned(float x, float y);
void modifiers_held(bool shift, bool control, bool alt);

/// The CSS name of the pointer's shape.
std::string cursor();

}  // namespace snug::web
