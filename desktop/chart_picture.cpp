#include "desktop/chart_picture.hpp"

#include <imgui.h>

#include "app/chart_svg.hpp"

namespace snug::desktop {
namespace {

/// An ImGui context without a renderer: it measures words, and nothing is drawn.
class Measuring {
 public:
  Measuring(float width, float height) : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {width, height};
    io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
  }
  ~Measuring() {
    for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
      texture->SetTexID(ImTextureID_Invalid);
      texture->SetStatus(ImTextureStatus_Destroyed);
    }
    ImGui::DestroyContext(context_);
  }
  Measuring(const Measuring&) = delete;
  Measuring& operator=(const Measuring&) = delete;

 private:
  ImGuiContext* context_;
};

}  // namespace

std::string svg_of(const app::Chart& chart, float width, float height, app::Theme theme,
                   std::string (*font)(std::string_view name), bool ground) {
  const Measuring measuring(width, height);
  app::App app({.font = font});
  app.settings().theme = theme;
  ImGui::NewFrame();
  app.frame({}, 0);  // sets the fonts and palette
  std::string svg = app::chart_svg(app.look(), width, height, chart, {}, ground);
  ImGui::EndFrame();
  return svg;
}

}  // namespace snug::desktop
