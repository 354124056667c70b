// Writes from top to bottom in a panel.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/look.hpp"
#include "app/widgets.hpp"

namespace snug::desktop {

/// A column, with a position that moves down as things are written.
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
  /// Draws buttons in rows, as many as fit in each. Returns the one that was clicked, or -1. chosen: the one that is
  /// on. enabled: for each; empty for all. room: the words that each has room for, so that it keeps its width when
  /// others stand on it; empty for its own.
  int buttons(const char* id, const std::vector<std::string>& words, int chosen = -1,
              const std::vector<bool>& enabled = {}, const std::vector<std::string>& room = {});
  /// How far the last row of the buttons drawn last reaches, with the gap behind it; 0 if there were none.
  [[nodiscard]] float row_taken() const { return row_taken_; }
  /// Draws a button that opens a list of choices, in the current row, which the caller ends. Returns the choice that
  /// was made, or -1.
  int chooser(const char* id, float from, float width, const std::vector<std::string>& words, int chosen);
  /// Begins a card: what is written until end_card is on it.
  void begin_card();
  void end_card();

 private:
  const app::Look& look_;
  ImDrawList* list_;
  float x_, width_, y_;
  float card_top_ = 0, row_taken_ = 0;
};

/// Draws the list of choices, if ImGui::OpenPopup(id) has opened it. Returns the choice that was made, or -1.
int choice_list(const app::Look& look, const char* id, ImVec2 at, float width, const std::vector<std::string>& words,
                int chosen);

}  // namespace snug::desktop
