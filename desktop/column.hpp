// Writing from top to bottom in a panel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/look.hpp"
#include "app/widgets.hpp"

namespace snug::desktop {

/// A place that moves down as things are written.
class Column {
 public:
  Column(const app::Look& look, float x, float y, float width)
      : look_(look), list_(ImGui::GetWindowDrawList()), x_(x), width_(width), y_(y) {}

  [[nodiscard]] const app::Look& look() const { return look_; }
  [[nodiscard]] ImDrawList* list() const { return list_; }
  [[nodiscard]] float x() const { return x_; }
  [[nodiscard]] float y() const { return y_; }
  [[nodiscard]] float width() const { return width_; }
  void gap(float height) { y_ += height; }

  void title(std::string_view words);
  void heading(std::string_view words, app::Color color = 0);
  void words(std::string_view words, app::Face face = app::Face::kRegular, float size = 15, app::Color color = 0);
  /// Buttons in rows, as many as fit in each. Returns the one that was clicked, or -1. chosen: the one that is on.
  /// enabled: of each; none for all.
  int buttons(const char* id, const std::vector<std::string>& words, int chosen = -1,
              const std::vector<bool>& enabled = {});
  /// A button for a choice among many, which opens a list; within the row that starts here, which the caller leaves.
  /// Returns the one that was chosen, or -1.
  int chooser(const char* id, float from, float width, const std::vector<std::string>& words, int chosen);
  /// What is written until end_card stands on a card.
  void begin_card();
  void end_card();

 private:
  const app::Look& look_;
  ImDrawList* list_;
  float x_, width_, y_;
  float card_top_ = 0;
};

/// The list of a choice, at a place; to be opened by ImGui::OpenPopup(id). Returns the one that was chosen, or -1.
int choice_list(const app::Look& look, const char* id, ImVec2 at, float width, const std::vector<std::string>& words,
                int chosen);

}  // namespace snug::desktop
