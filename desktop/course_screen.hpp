// The window's first screen: where to start or to continue, every lesson under its chapter, and the exercises.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"

namespace snug::lesson {
struct Exercise;
struct ExerciseSet;
}  // namespace snug::lesson

namespace snug::desktop {

class Shell;

class CourseScreen {
 public:
  CourseScreen() = default;
  CourseScreen(const CourseScreen&) = delete;
  CourseScreen& operator=(const CourseScreen&) = delete;

  void draw(Shell& shell, const app::Rect& rect);
  /// Forgets what it has worked out of the lessons.
  void lessons_changed() { texts_.clear(), cards_.clear(); }
  /// The field by whose words lessons and exercises are found, at the right end of the bar.
  void draw_search(Shell& shell, const app::Rect& bar);
  /// Arrow keys, Home and End go through lessons and exercises, Enter opens the one that has the keyboard, or what
  /// comes first; a slash begins a search, Escape ends it. false: the key does nothing here.
  bool answer_key(Shell& shell, std::string_view key);
  /// Which lesson has the keyboard, counted from 0; -1 for none, and for an exercise.
  [[nodiscard]] int chosen(const Shell& shell) const;
  /// The course's lessons that are shown, counted from 0, in their order.
  [[nodiscard]] std::vector<std::size_t> found(const Shell& shell) const;
  /// The ids of the exercises and of the lab sheets that are shown.
  [[nodiscard]] std::vector<std::string> found_beside(const Shell& shell) const;
  [[nodiscard]] std::string_view asked() const { return asked_.data(); }

 private:
  struct Card {
    std::size_t lesson;
    std::uint32_t id;  // of its control
    app::Rect rect;
    std::string exercise = {};  // in place of a lesson; empty for none
  };
  static void open(Shell& shell, const Card& card);
  struct Grid {
    float left, width, card, height;
    int across;
  };
  void draw_hero(Shell& shell, const app::Rect& place, float& y);
  void draw_start(Shell& shell, const app::Rect& place, float& y);
  void draw_found(Shell& shell, const app::Rect& place, float& y);
  void draw_chapter(Shell& shell, const Grid& grid, std::size_t from, std::size_t to, float& y);
  void draw_sets(Shell& shell, const Grid& grid, float& y);
  /// The set's exercises that the window has and that are found.
  [[nodiscard]] std::vector<const lesson::Exercise*> found_in(const Shell& shell, const lesson::ExerciseSet& set) const;
  void draw_card(Shell& shell, std::size_t lesson, const app::Rect& card);
  void draw_case(Shell& shell, std::size_t lesson, const app::Rect& card);
  void draw_picture(Shell& shell, const std::string& id, const app::Rect& place, bool all_round);
  [[nodiscard]] const std::string& text_of(const Shell& shell, std::size_t lesson);
  [[nodiscard]] const Card* next_card(const Card* from, std::string_view key) const;
  [[nodiscard]] std::uint32_t picture(const std::string& id, bool dark);

  std::map<std::string, std::uint32_t> pictures_;  // textures by file; 0 if there is none
  std::vector<std::string> texts_;                 // what each lesson is found by
  std::array<char, 64> asked_{};                   // of the search
  std::vector<Card> cards_;                        // as last drawn
  std::uint32_t start_ = 0, search_ = 0;           // controls
};

}  // namespace snug::desktop
