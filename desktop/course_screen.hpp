// The window's first screen: where to start or to continue, and every lesson under its chapter.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "app/app.hpp"

namespace snug::desktop {

class Shell;

class CourseScreen {
 public:
  CourseScreen() = default;
  CourseScreen(const CourseScreen&) = delete;
  CourseScreen& operator=(const CourseScreen&) = delete;

  void draw(Shell& shell, const app::Rect& rect);
  /// Arrow keys, Home and End go through the lessons, Enter opens the one that is chosen. false: the key does nothing
  /// here.
  bool answer_key(Shell& shell, std::string_view key);
  /// Which lesson is chosen, counted from 0; -1: the button to start or to continue.
  [[nodiscard]] int chosen() const { return chosen_; }

 private:
  void draw_hero(Shell& shell, const app::Rect& place, float& y);
  void draw_card(Shell& shell, std::size_t lesson, const app::Rect& card);
  [[nodiscard]] std::uint32_t picture(const std::string& id, bool dark);

  std::map<std::string, std::uint32_t> pictures_;  // textures by file; 0 where there is none
  int chosen_ = -1;
  int across_ = 1;     // cards in a row
  bool show_ = false;  // the chosen one is to be scrolled to
};

}  // namespace snug::desktop
