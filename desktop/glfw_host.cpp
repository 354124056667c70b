#include "desktop/glfw_host.hpp"

#include <snug_gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "desktop/window.hpp"

namespace snug::desktop {
namespace {

constexpr const char* kGlslVersion = "#version 330 core";

/// A key that is held goes on stepping or moving: it neither answers nor skips twice.
bool may_repeat(int key) {
  return key == GLFW_KEY_RIGHT || key == GLFW_KEY_LEFT || key == GLFW_KEY_UP || key == GLFW_KEY_DOWN ||
         key == GLFW_KEY_TAB || key == GLFW_KEY_BACKSPACE;
}

std::string utf8(unsigned code) { return code < 0x80 ? std::string(1, static_cast<char>(code)) : std::string(); }

}  // namespace

std::string key_name(int key) {
  switch (key) {
    case GLFW_KEY_RIGHT: return "ArrowRight";
    case GLFW_KEY_LEFT: return "ArrowLeft";
    case GLFW_KEY_UP: return "ArrowUp";
    case GLFW_KEY_DOWN: return "ArrowDown";
    case GLFW_KEY_HOME: return "Home";
    case GLFW_KEY_END: return "End";
    case GLFW_KEY_PAGE_UP: return "PageUp";
    case GLFW_KEY_PAGE_DOWN: return "PageDown";
    case GLFW_KEY_DELETE: return "Delete";
    case GLFW_KEY_BACKSPACE: return "Backspace";
    case GLFW_KEY_ESCAPE: return "Escape";
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return "Enter";
    case GLFW_KEY_TAB: return "Tab";
    case GLFW_KEY_F1: return "F1";
    case GLFW_KEY_F2: return "F2";
    case GLFW_KEY_F5: return "F5";
    case GLFW_KEY_F10: return "F10";
    case GLFW_KEY_F11: return "F11";
    default: return {};
  }
}

/// GLFW's callbacks are plain functions, which find their host in the window's user pointer.
struct GlfwHost::Callbacks {
  static GlfwHost& host(GLFWwindow* window) {
    GlfwHost& found = *static_cast<GlfwHost*>(glfwGetWindowUserPointer(window));
    found.dirty_ = true;
    return found;
  }
  // ImGui works in page pixels, GLFW in those of the window system.
  static void cursor(GLFWwindow* window, double x, double y) {
    const double per_page = static_cast<double>(host(window).extent().window_per_page);
    ImGui_ImplGlfw_CursorPosCallback(window, x / per_page, y / per_page);
  }
  static void enter(GLFWwindow* window, int entered) {
    host(window);
    ImGui_ImplGlfw_CursorEnterCallback(window, entered);
  }
  static void button(GLFWwindow* window, int which, int action, int mods) {
    host(window);
    ImGui_ImplGlfw_MouseButtonCallback(window, which, action, mods);
  }
  static void scroll(GLFWwindow* window, double x, double y) {
    host(window);
    ImGui_ImplGlfw_ScrollCallback(window, x, y);
  }
  static void focus(GLFWwindow* window, int focused) {
    host(window);
    ImGui_ImplGlfw_WindowFocusCallback(window, focused);
  }
  static void key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    GlfwHost& self = host(window);
    const bool is_tab = key == GLFW_KEY_TAB && action != GLFW_RELEASE;
    if (is_tab || self.holds_back()) self.held_back_.push_back({key, scancode, action, mods});
    else answer_key(self, window, key, scancode, action, mods);
  }
  static void answer_key(GlfwHost& self, GLFWwindow* window, int key, int scancode, int action, int mods) {
    const bool control = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0, shift = (mods & GLFW_MOD_SHIFT) != 0;
    // A key that writes a letter would hold up the next one by a frame: ImGui needs the letter alone.
    const bool writes = key <= GLFW_KEY_WORLD_2 && !control && action != GLFW_RELEASE;
    if (!writes) ImGui_ImplGlfw_KeyCallback(window, key, scancode, action, mods);
    self.repeats_ = action == GLFW_REPEAT;
    if (self.repeats_ && self.on_held && self.on_held(key_name(key))) return;
    if (self.repeats_ && !may_repeat(key)) return;
    if (action == GLFW_RELEASE || !self.on_key) return;
    if (ImGui::GetIO().WantTextInput && key != GLFW_KEY_TAB) return;
    std::string name = key_name(key);
    if (name.empty() && control)  // letters come as characters, except with Control
      if (const char* letter = glfwGetKeyName(key, scancode)) name = letter;
    if (!name.empty()) self.on_key(name, shift, control);
  }
  static void character(GLFWwindow* window, unsigned code) {
    GlfwHost& self = host(window);
    if (self.holds_back()) self.held_back_.push_back({.letter = code});
    else answer_letter(self, window, code);
  }
  static void answer_letter(GlfwHost& self, GLFWwindow* window, unsigned code) {
    ImGui_ImplGlfw_CharCallback(window, code);
    const bool held = self.repeats_ && (code == ' ' || std::isalnum(static_cast<int>(std::min(code, 127u))) != 0);
    if (held || !self.on_key || ImGui::GetIO().WantTextInput || utf8(code).empty()) return;
    self.on_key(utf8(code), false, false);
  }
  static void drop(GLFWwindow* window, int count, const char** paths) {
    GlfwHost& self = host(window);
    if (self.on_drop) self.on_drop({paths, paths + count});
  }
  static void refresh(GLFWwindow* window) { host(window); }
  static void resize(GLFWwindow* window, int, int) { host(window); }
};

tl::expected<std::unique_ptr<GlfwHost>, std::string> GlfwHost::make(const Size& size, bool visible) {
  if (!glfwInit())
    return tl::unexpected(std::string("there is no display to open a window on; without a screen, use xvfb-run"));
  std::unique_ptr<GlfwHost> host(new GlfwHost());
  host->enlarged_ = size.enlarged;
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // hidden until it has its size
  for (const int samples : {4, 0}) {         // without multisampling if the driver has none
    glfwWindowHint(GLFW_SAMPLES, samples);
    host->window_ = glfwCreateWindow(size.width, size.height, "Snug", nullptr, nullptr);
    if (host->window_ != nullptr) break;
  }
  if (host->window_ == nullptr)
    return tl::unexpected(std::string("the display has no OpenGL 3.3, which the window needs"));
  glfwMakeContextCurrent(host->window_);
  glfwSwapInterval(1);
  host->install(visible);
  if (visible && !size.asked_for) host->fit_screen();
  if (visible && size.place) host->put_at(*size.place);
  if (visible) glfwShowWindow(host->window_);
  return host;
}

/// Puts the window where it was, unless that screen is gone: then its title could not be taken hold of.
void GlfwHost::put_at(const std::array<int, 2>& place) {
  constexpr int kHold = 100;  // as much of its upper edge is on a screen
  int count = 0, own_width = 0, own_height = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  glfwGetWindowSize(window_, &own_width, &own_height);
  for (int i = 0; i < count; ++i) {
    int x = 0, y = 0, width = 0, height = 0;
    glfwGetMonitorWorkarea(monitors[i], &x, &y, &width, &height);
    const int across = std::min(place[0] + own_width, x + width) - std::max(place[0], x);
    if (across >= kHold && place[1] >= y && place[1] + kHold <= y + height)
      return glfwSetWindowPos(window_, place[0], place[1]);
  }
}

/// Shrinks a window, including its frame and title, to the screen's free area.
void GlfwHost::fit_screen() {
  constexpr int kTitle = 40;  // for a frame whose size is unknown before the window is shown
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (monitor == nullptr) return;
  int x = 0, y = 0, width = 0, height = 0, left = 0, top = 0, right = 0, bottom = 0, own_width = 0, own_height = 0;
  glfwGetMonitorWorkarea(monitor, &x, &y, &width, &height);
  glfwGetWindowFrameSize(window_, &left, &top, &right, &bottom);
  glfwGetWindowSize(window_, &own_width, &own_height);
  if (top == 0) top = kTitle;
  const int room_across = width - left - right, room_down = height - top - bottom;
  if (own_width <= room_across && own_height <= room_down) return;
  glfwSetWindowSize(window_, std::max(kLeastWidth, std::min(own_width, room_across)),
                    std::max(kLeastHeight, std::min(own_height, room_down)));
  glfwSetWindowPos(window_, x + left, y + top);
}

void GlfwHost::install(bool visible) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().ConfigInputTextCursorBlink = false;  // an idle window draws nothing
  ImGui_ImplGlfw_InitForOpenGL(window_, false);
  ImGui_ImplOpenGL3_Init(kGlslVersion);
  imgui_ = true;
  glfwSetWindowUserPointer(window_, this);
  if (visible) glfwSetWindowSizeLimits(window_, kLeastWidth, kLeastHeight, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetCursorPosCallback(window_, Callbacks::cursor);
  glfwSetCursorEnterCallback(window_, Callbacks::enter);
  glfwSetMouseButtonCallback(window_, Callbacks::button);
  glfwSetScrollCallback(window_, Callbacks::scroll);
  glfwSetWindowFocusCallback(window_, Callbacks::focus);
  glfwSetKeyCallback(window_, Callbacks::key);
  glfwSetCharCallback(window_, Callbacks::character);
  glfwSetDropCallback(window_, Callbacks::drop);
  glfwSetWindowRefreshCallback(window_, Callbacks::refresh);
  glfwSetFramebufferSizeCallback(window_, Callbacks::resize);
}

GlfwHost::~GlfwHost() {
  if (imgui_) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  if (window_ != nullptr) glfwDestroyWindow(window_);
  glfwTerminate();
}

bool GlfwHost::open() const { return !glfwWindowShouldClose(window_); }
void GlfwHost::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
void GlfwHost::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
double GlfwHost::now() const { return glfwGetTime(); }

std::array<int, 4> GlfwHost::windowed_extent() const {
  std::array<int, 4> extent{windowed_[0], windowed_[1], windowed_[2], windowed_[3]};
  if (fills_screen()) return extent;
  glfwGetWindowPos(window_, &extent[0], &extent[1]);
  glfwGetWindowSize(window_, &extent[2], &extent[3]);
  return extent;
}

bool GlfwHost::fills_screen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void GlfwHost::fill_screen(bool on) {
  if (on == fills_screen()) return;
  if (!on) return glfwSetWindowMonitor(window_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], 0);
  glfwGetWindowPos(window_, &windowed_[0], &windowed_[1]);
  glfwGetWindowSize(window_, &windowed_[2], &windowed_[3]);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode != nullptr) glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

Extent GlfwHost::extent() const {
  if (drawn_as_) return *drawn_as_;
  Extent extent;
  int window_width = 1, window_height = 1;
  float scale_y = 1;
  glfwGetWindowSize(window_, &window_width, &window_height);
  glfwGetFramebufferSize(window_, &extent.device_width, &extent.device_height);
  glfwGetWindowContentScale(window_, &extent.scale, &scale_y);
  if (!(extent.scale >= 0.5f)) extent.scale = 1;
  extent.scale *= enlarged_;
  extent.width = static_cast<float>(extent.device_width) / extent.scale;
  extent.height = static_cast<float>(extent.device_height) / extent.scale;
  const float device_per_window =
      window_width > 0 ? static_cast<float>(extent.device_width) / static_cast<float>(window_width) : 1;
  extent.window_per_page = device_per_window > 0 ? extent.scale / device_per_window : 1;
  return extent;
}

/// Answers what was held back, one Tab a frame; behind a Tab what is no Tab waits for the field that it leads to.
void GlfwHost::catch_up() {
  constexpr int kSettles = 4;  // the ring moves, the field is asked to take letters, it does, and says so
  dirty_ = true;
  if (settling_ > 0) --settling_;
  if (!ImGui::GetCurrentContext()->InputEventsQueue.empty()) return;
  for (bool pressed = false; !held_back_.empty();) {
    const Typed typed = held_back_.front();
    const bool press = typed.letter != 0 || typed.action != GLFW_RELEASE;
    const bool tab = press && typed.letter == 0 && typed.key == GLFW_KEY_TAB;
    if (tab ? pressed : press && settling_ > 0) return;
    pressed = pressed || press;
    held_back_.pop_front();
    if (typed.letter != 0) Callbacks::answer_letter(*this, window_, typed.letter);
    else Callbacks::answer_key(*this, window_, typed.key, typed.scancode, typed.action, typed.mods);
    if (tab) settling_ = kSettles;
  }
}

bool GlfwHost::wait(double seconds) {
  if (holds_back()) catch_up();
  if (dirty_ || seconds == 0) glfwPollEvents();
  else if (seconds < 0) glfwWaitEvents();
  else glfwWaitEventsTimeout(seconds);
  return std::exchange(dirty_, false);
}

void GlfwHost::wake() { glfwPostEmptyEvent(); }

void GlfwHost::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  const Extent now = extent();
  ImGui::GetIO().DisplaySize = {now.width, now.height};
  ImGui::GetIO().DisplayFramebufferScale = {now.scale, now.scale};
  ImGui::NewFrame();
  // ImGui takes one press or letter a frame: what waits is due, or it would come with whatever is done next.
  dirty_ = dirty_ || !ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

void GlfwHost::swap() { glfwSwapBuffers(window_); }

}  // namespace snug::desktop
