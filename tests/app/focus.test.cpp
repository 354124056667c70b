// The keyboard goes from control to control: cards first, popups alone, and on when what it was on is gone.
#include "app/focus.hpp"

#include <doctest/doctest.h>

#include "bench.hpp"

namespace snug::app {
namespace {

/// Controls of some parts, offered frame by frame.
class Controls {
 public:
  Controls() : context_(ImGui::CreateContext()), font_(font_bytes("Inter-Regular")) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    ImGui::GetIO().Fonts->AddFontFromMemoryTTF(font_.data(), static_cast<int>(font_.size()), 15, &config);
    ImGui::GetIO().DisplaySize = {400, 400};
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
    ImGui::GetIO().UserData = &focus;
  }
  ~Controls() {
    for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
      texture->SetTexID(ImTextureID_Invalid);
      texture->SetStatus(ImTextureStatus_Destroyed);
    }
    ImGui::DestroyContext(context_);
  }
  Controls(const Controls&) = delete;
  Controls& operator=(const Controls&) = delete;

  struct Part {
    const char* name;
    Focus::Layer layer;
    std::vector<Focus::Control> controls;
  };
  /// Returns the name of what was pressed.
  std::string frame(const std::vector<Part>& parts) {
    std::string pressed;
    ImGui::NewFrame();
    focus.begin_frame(0);
    ImGui::Begin("window");
    for (const Part& part : parts) {
      const Focus::Part now(part.name, part.layer);
      for (const Focus::Control& control : part.controls)
        if (focus.offer(control).pressed) pressed = control.name;
    }
    ImGui::End();
    focus.end_frame();
    ImGui::Render();
    for (ImTextureData* texture : ImGui::GetPlatformIO().Textures) {
      texture->SetTexID(1);
      texture->SetStatus(ImTextureStatus_OK);
    }
    return pressed;
  }

  Focus focus;

 private:
  ImGuiContext* context_;
  std::string font_;  // the program has no font of ImGui's own
};

Focus::Control control(ImGuiID id, std::string_view name, bool enabled = true, bool first = false) {
  return {.id = id, .low = {0, 0}, .high = {10, 10}, .name = name, .enabled = enabled, .first = first};
}

const Controls::Part kPanel{
    "panel", Focus::Layer::kPanel, {control(1, "one"), control(2, "two", false), control(3, "three")}};
const Controls::Part kCard{"card", Focus::Layer::kCard, {control(4, "choice"), control(5, "answer", true, true)}};

}  // namespace

TEST_CASE("Tab goes round the controls that can be pressed") {
  Controls controls;
  Focus& focus = controls.focus;
  controls.frame({kPanel});
  CHECK_FALSE(focus.press());
  focus.move(1);
  CHECK(focus.name() == "one");
  focus.move(1);
  CHECK(focus.name() == "three");
  focus.move(1);
  CHECK(focus.name() == "one");
  focus.move(-1);
  CHECK(focus.name() == "three");
  CHECK(focus.wants_frame());
  REQUIRE(focus.press());
  CHECK(controls.frame({kPanel}) == "three");
  CHECK(controls.frame({kPanel}).empty());  // once
  CHECK_FALSE(focus.move_within(1));
  CHECK(focus.move_within(-1));
  REQUIRE(focus.leave());
  CHECK(focus.name().empty());
}

TEST_CASE("a card has the keyboard first, and begins with its main button") {
  Controls controls;
  controls.frame({kPanel, kCard});
  controls.focus.move(1);
  CHECK(controls.focus.name() == "answer");
  controls.focus.move(1);
  CHECK(controls.focus.name() == "one");
  controls.focus.move(-1);
  CHECK(controls.focus.name() == "answer");
  SUBCASE("and where it says something else, goes on with that") {
    controls.frame({kPanel, {"card", Focus::Layer::kCard, {control(6, "watch"), control(7, "continue", true, true)}}});
    CHECK(controls.focus.name() == "continue");
  }
  SUBCASE("and where it goes, the keyboard is on none") {
    controls.frame({kPanel});
    CHECK(controls.focus.name().empty());
  }
}

TEST_CASE("a popup has the keyboard alone, and gives it back to what opened it") {
  const Controls::Part popup{"list", Focus::Layer::kPopup, {control(8, "first"), control(9, "chosen", true, true)}};
  Controls controls;
  controls.frame({kPanel});
  controls.focus.move(1);
  controls.frame({kPanel, popup});
  CHECK(controls.focus.name() == "chosen");
  controls.frame({kPanel, popup});
  controls.focus.move(1);
  CHECK(controls.focus.name() == "first");
  controls.focus.move(1);
  CHECK(controls.focus.name() == "chosen");
  controls.frame({kPanel});
  CHECK(controls.focus.name() == "one");
}

TEST_CASE("a press of the mouse takes the ring away") {
  Controls controls;
  controls.frame({kPanel});
  controls.focus.move(1);
  ImGui::GetIO().AddMousePosEvent(300, 300);
  ImGui::GetIO().AddMouseButtonEvent(0, true);
  controls.frame({kPanel});
  controls.frame({kPanel});
  CHECK(controls.focus.name().empty());
}

}  // namespace snug::app
