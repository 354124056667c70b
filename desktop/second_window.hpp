// A second window beside the one that is presented, with an ImGui of its own that draws with the same letters. It reads
// keys and nothing else; closing it closes it alone.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "app/look.hpp"

struct GLFWwindow;
struct ImGuiContext;

namespace snug::desktop {

class SecondWindow {
 public:
  /// Null if the display gives none. To be called while the first window's context is current.
  [[nodiscard]] static std::unique_ptr<SecondWindow> make(const char* title, int width, int height);
  ~SecondWindow();
  SecondWindow(const SecondWindow&) = delete;
  SecondWindow& operator=(const SecondWindow&) = delete;

  /// Receives keys, as browsers name them; held: one that is held, which the keyboard tells again.
  std::function<void(const std::string& key, bool held)> on_key;
  /// Whether it still is to be there.
  [[nodiscard]] bool open() const;
  /// Whether it was resized or uncovered since it was drawn.
  [[nodiscard]] bool stale() const { return stale_; }
  /// Draws a frame: paint(list, rect). The first window's context and ImGui are the current ones again afterwards.
  void draw(const app::Look& look, const std::function<void(ImDrawList*, const app::Rect&)>& paint);

 private:
  SecondWindow() = default;
  GLFWwindow* window_ = nullptr;
  GLFWwindow* first_ = nullptr;
  ImGuiContext* imgui_ = nullptr;
  bool stale_ = true;
  bool held_ = false;  // whether the last key is
};

}  // namespace snug::desktop
