// Which control the keyboard is on. Tab goes from one to the next in the order in which they are drawn, Enter and Space
// press the one that has the ring. A door that has one keeps it in ImGui's UserData; a canvas in a page has none.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "app/palette.hpp"

namespace snug::app {

class Focus {
 public:
  /// Null where the door has none.
  static Focus* current() { return static_cast<Focus*>(ImGui::GetIO().UserData); }

  /// What lies over the rest has the keyboard: a card first, a popup alone.
  enum class Layer { kPanel, kCard, kPopup };
  /// While one lives, what is drawn belongs to a part of that name.
  class Part {
   public:
    Part(std::string_view name, Layer layer);
    ~Part();
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

   private:
    std::string_view name_before_;
    Layer layer_before_ = Layer::kPanel;
  };

  /// Around the drawing of a frame. color: of the ring. A press of the mouse takes the ring away.
  void begin_frame(Color color);
  void end_frame();

  struct Control {
    ImGuiID id;
    ImVec2 low, high;
    std::string_view name;
    bool enabled = true;
    bool first = false;  // of a card: what its keyboard begins with
  };
  struct Here {
    bool focused = false;
    bool arrived = false;  // just now
    bool pressed = false;
  };
  /// One of the frame's controls: draws its ring, and scrolls to it when it has just come there.
  Here offer(const Control& control);
  /// The ring alone, for a control that has more than one part.
  void draw_ring(ImVec2 low, ImVec2 high) const;

  /// Moves to the next control (1) or the previous one (-1), around the ends.
  void move(int by);
  /// The same within the part that it is in; false where there is none.
  bool move_within(int by);
  void go_to(ImGuiID id);
  /// Presses the control at the next frame. false: the keyboard is on none.
  bool press();
  /// false: it was on none.
  bool leave();
  [[nodiscard]] ImGuiID at() const { return at_; }
  /// The names of the control and of its part; empty for none.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& part() const { return part_; }
  /// Whether a frame is due to show what was done.
  [[nodiscard]] bool wants_frame() const { return due_ > 0; }

 private:
  struct Drawn {
    ImGuiID id;
    std::string name, part;
    Layer layer;
    bool enabled, first;
  };
  [[nodiscard]] std::vector<const Drawn*> reachable() const;
  [[nodiscard]] const Drawn* first_of(std::string_view part) const;
  void stand(const Drawn* control);

  std::vector<Drawn> drawn_, drawing_;  // of the last frame, and of this one
  std::string_view drawing_part_;
  Layer drawing_layer_ = Layer::kPanel;
  ImGuiID at_ = 0, pressed_ = 0, opener_ = 0;  // opener_: what a popup was opened by
  std::string name_, part_;
  Layer layer_ = Layer::kPanel;
  bool arrives_ = false;
  bool scrolled_ = false, again_ = false;  // it was scrolled to as it arrived; it arrives for the second time
  int due_ = 0;
  Color color_ = 0;
};

}  // namespace snug::app
