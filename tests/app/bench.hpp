// A front end without a screen: ImGui is fed with a mouse, and what it draws is thrown away.
#pragma once

#include <doctest/doctest.h>
#include <imgui.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/app.hpp"
#include "app/look.hpp"
#include "places.hpp"

namespace snug::app {

inline std::string font_bytes(std::string_view name) {
  for (const char* extension : {".otf", ".ttf"}) {
    std::ifstream file(assets_folder() + "fonts/" + std::string(name) + extension, std::ios::binary);
    if (file) return {std::istreambuf_iterator<char>(file), {}};
  }
  return {};
}

class Bench {
 public:
  /// 800 by 600 pixels, unless the layout says otherwise.
  explicit Bench(lesson::Lesson lesson,
                 const Layout& layout = {.stage = {0, 0, 800, 440}, .timeline = {0, 440, 800, 160}},
                 std::optional<io::PointFile> mesh = {})
      : context_(ImGui::CreateContext()), layout_(layout), app({.font = font_bytes}) {
    ImGui::GetIO().DisplaySize = {layout.stage.x + layout.stage.width, layout.timeline.y + layout.timeline.height};
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
    app.settings().reduced_motion = true;
    REQUIRE(app.open(std::move(lesson), std::move(mesh)));
    frames(3);
  }
  ~Bench() {
    for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
      texture->SetTexID(ImTextureID_Invalid);
      texture->SetStatus(ImTextureStatus_Destroyed);
    }
    ImGui::DestroyContext(context_);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      now_ += 0.02;
      ImGui::GetIO().DeltaTime = 0.02f;
      ImGui::NewFrame();
      app.frame(layout_, now_);
      ImGui::Render();
      for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
        texture->SetTexID(1);
        texture->SetStatus(ImTextureStatus_OK);
      }
    }
  }
  /// The words of one more frame, with their places.
  [[nodiscard]] std::vector<DrawnWords> drawn_words() {
    std::vector<DrawnWords> drawn;
    app.note_words(&drawn);
    frames(1);
    app.note_words(nullptr);
    return drawn;
  }
  /// The words alone.
  [[nodiscard]] std::vector<std::string> words() {
    std::vector<std::string> all;
    for (const DrawnWords& one : drawn_words()) all.push_back(one.words);
    return all;
  }
  [[nodiscard]] Handle handle(const std::string& id) const {
    for (const Handle& handle : app.handles())
      if (handle.id == id) return handle;
    FAIL("no handle ", id);
    return {};
  }
  void press(float x, float y) {
    ImGui::GetIO().AddMousePosEvent(x, y);
    frames(2);
    ImGui::GetIO().AddMouseButtonEvent(0, true);
    frames(2);
  }
  void move(float x, float y) {
    ImGui::GetIO().AddMousePosEvent(x, y);
    frames(2);
  }
  void release() {
    ImGui::GetIO().AddMouseButtonEvent(0, false);
    frames(2);
  }
  void drag(float x, float y, float dx, float dy) {
    press(x, y);
    for (int i = 1; i <= 4; ++i) move(x + dx * static_cast<float>(i) / 4, y + dy * static_cast<float>(i) / 4);
    release();
  }
  void click(const std::string& id) {
    const Handle at = handle(id);
    press(at.x, at.y);
    release();
  }
  [[nodiscard]] lesson::Session& session() { return *app.session(); }
  [[nodiscard]] std::string key(std::string_view name) const {
    return std::string(app.command_of_key(name, false, false));
  }
  void wait(double seconds) {
    now_ += seconds;
    frames(1);
  }

 private:
  ImGuiContext* context_;
  Layout layout_;
  double now_ = 0;

 public:
  App app;
};

}  // namespace snug::app
