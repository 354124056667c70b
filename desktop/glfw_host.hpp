// A GLFW window with its OpenGL context and ImGui's input: the operating system's side of the window.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

struct GLFWwindow;

namespace snug::desktop {

/// Sizes in page pixels, which are `scale` device pixels each.
struct Extent {
  float width = 0, height = 0, scale = 1;
  int device_width = 0, device_height = 0;
  float window_per_page = 1;  // the window system's own units for one page pixel
};

/// A key that is no letter, as browsers name it; empty for any other.
[[nodiscard]] std::string key_name(int glfw_key);

class GlfwHost {
 public:
  struct Size {
    int width, height;
    bool asked_for;      // else a window that is larger than what the screen has free shrinks to that
    float enlarged = 1;  // how much larger a page pixel is than the screen makes it
    std::optional<std::array<int, 2>> place = {};  // where it opens, if a screen is there; none: as the system likes
  };
  /// Errors, each one sentence: no display, no OpenGL 3.3.
  static tl::expected<std::unique_ptr<GlfwHost>, std::string> make(const Size& size, bool visible);
  ~GlfwHost();
  GlfwHost(const GlfwHost&) = delete;
  GlfwHost& operator=(const GlfwHost&) = delete;

  /// Receives a key, as browsers name it, and the modifiers; not while a text field has the focus.
  std::function<void(const std::string& key, bool shift, bool control)> on_key;
  /// A key is held, and the keyboard tells it again. Returns whether that is all that it means.
  std::function<bool(const std::string& key)> on_held;
  std::function<void(const std::vector<std::string>& paths)> on_drop;

  [[nodiscard]] bool open() const;
  void close();
  void set_title(const std::string& title);
  void fill_screen(bool on);
  [[nodiscard]] bool fills_screen() const;
  [[nodiscard]] Extent extent() const;
  /// Frames have another extent from now on, as for a picture; none: the window's own again.
  void draw_as(std::optional<Extent> extent) { drawn_as_ = extent; }
  /// The window's x, y, width and height, in the window system's own units; while it fills the screen, those which it
  /// had before. A system that tells nobody where windows are (Wayland) has them all at 0, 0.
  [[nodiscard]] std::array<int, 4> windowed_extent() const;
  [[nodiscard]] double now() const;

  /// Waits for an event, at most so many seconds; seconds < 0: without limit. Returns whether there was one.
  bool wait(double seconds);
  /// Ends the waiting; from any thread.
  static void wake();
  /// Begins and ends an ImGui frame; drawing happens in between.
  void begin_frame();
  void swap();

 private:
  struct Callbacks;
  GlfwHost() = default;
  void install(bool visible);
  void fit_screen();
  void put_at(const std::array<int, 2>& place);

  GLFWwindow* window_ = nullptr;
  float enlarged_ = 1;
  std::optional<Extent> drawn_as_;
  bool imgui_ = false;
  bool dirty_ = true;     // whether there was input since the last frame
  bool repeats_ = false;  // whether the last key is being held
  /// A key, or a letter, as GLFW reports it.
  struct Typed {
    int key = 0, scancode = 0, action = 0, mods = 0;
    unsigned letter = 0;  // 0: a key
  };
  /// A Tab waits for the letters before it, and what is typed behind it for the field that it leads to.
  std::deque<Typed> held_back_;
  int settling_ = 0;  // frames until that field takes letters
  [[nodiscard]] bool holds_back() const { return settling_ > 0 || !held_back_.empty(); }
  void catch_up();
  int windowed_[4] = {0, 0, 1280, 800};
};

}  // namespace snug::desktop
