#include "web/canvas.hpp"

#include <emscripten/html5.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>

namespace snug::web {
namespace {

// ImGui handles an event over up to this many frames: it separates a press from its release, and then draws the result.
constexpr int kFramesAfterInput = 3;
int g_frames_owed = 0;

void owe_frames() { g_frames_owed = kFramesAfterInput; }

void name_source(const std::string& source) {
  ImGui::GetIO().AddMouseSourceEvent(source == "touch" ? ImGuiMouseSource_TouchScreen
                                     : source == "pen" ? ImGuiMouseSource_Pen
                                                       : ImGuiMouseSource_Mouse);
}

}  // namespace

bool make_graphics_context(const char* selector, bool smooth) {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.alpha = false;
  wanted.antialias = smooth;
  wanted.enableExtensionsByDefault = true;
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context(selector, &wanted);
  return context > 0 && emscripten_webgl_make_context_current(context) == EMSCRIPTEN_RESULT_SUCCESS;
}

void start_renderer() {
  ImGui_ImplOpenGL3_Init(kGlslVersion);
  owe_frames();
}

void abandon_renderer() { ImGui_ImplOpenGL3_Shutdown(); }

void begin_frame(float css_width, float css_height, float scale, float seconds) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {css_width, css_height};
  io.DisplayFramebufferScale = {scale, scale};
  io.DeltaTime = std::clamp(seconds, 1e-4F, 0.25F);  // ImGui refuses 0, and motion must not jump after a pause
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  if (g_frames_owed > 0) --g_frames_owed;
}

bool input_pending() { return g_frames_owed > 0 || ImGui::GetCurrentContext()->InputEventsQueue.Size > 0; }

void pointer_moved(float x, float y, const std::string& source) {
  name_source(source);
  ImGui::GetIO().AddMousePosEvent(x, y);
  owe_frames();
}

void forget_input() {
  ImGui::GetIO().ClearEventsQueue();
  ImGui::GetIO().ClearInputMouse();
}

void pointer_left() {
  ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
  owe_frames();
}

void pointer_button(int button, bool down, const std::string& source) {
  if (button < 0 || button > 2) return;
  // A press where nothing was hovered before (a tap, a pen, a script's click) would be lost: an item that others
  // may overlap can be pressed only a frame after it was hovered, and ImGui waits for that frame only with touch
  // input.
  name_source(down ? "touch" : source);
  const int as_imgui_counts = button == 0   ? ImGuiMouseButton_Left
                              : button == 1 ? ImGuiMouseButton_Middle
                                            : ImGuiMouseButton_Right;
  ImGui::GetIO().AddMouseButtonEvent(as_imgui_counts, down);
  owe_frames();
}

void wheel_turned(float x, float y) {
  ImGui::GetIO().AddMouseWheelEvent(x, y);
  owe_frames();
}

void modifiers_held(bool shift, bool control, bool alt) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Ctrl, control);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
}

std::string cursor() {
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput: return "text";
    case ImGuiMouseCursor_ResizeAll: return "move";
    case ImGuiMouseCursor_ResizeNS: return "ns-resize";
    case ImGuiMouseCursor_ResizeEW: return "ew-resize";
    case ImGuiMouseCursor_Hand: return "pointer";
    case ImGuiMouseCursor_NotAllowed: return "not-allowed";
    default: return "default";
  }
}

}  // namespace snug::web
