// The exercises on the window's first screen, under their sets.
#include <algorithm>
#include <iterator>
#include <utility>

#include "app/look.hpp"
#include "app/widgets.hpp"
#include "desktop/course_screen.hpp"
#include "desktop/shell.hpp"
#include "io/text.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"
#include "lesson/search.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kLine = 44;

/// "7.5 of 9", "Begun", or how long it takes.
std::string state_of(const Shell& shell, const lesson::Exercise& exercise) {
  const KeptExercise* const kept = shell.kept().exercise(exercise.id);
  if (kept != nullptr && kept->of > 0) return lesson::plain_number(kept->mark) + " of " + std::to_string(kept->of);
  return kept != nullptr && kept->now ? "Begun" : std::to_string(exercise.stage.minutes) + " min";
}

/// Returns whether it was clicked.
bool draw_line(Shell& shell, const lesson::ExerciseSet& set, const lesson::Exercise& exercise, const app::Rect& line) {
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto touch = app::touch_area((set.id + '/' + exercise.id).c_str(), line, exercise.stage.title);
  app::rule(list, line.x, line.y, line.width, look->line);
  const std::string state = state_of(shell, exercise);
  const float room = line.width - app::measure(look, Face::kRegular, 13, state).x - 24;
  app::text(list, look, Face::kSemiBold, 14, {line.x + 4, line.y + look.px(6)},
            touch.hovered ? look->current_text : look->ink, exercise.stage.title);
  app::text(list, look, Face::kRegular, 13, {line.x + 4, line.y + look.px(24)}, look->muted,
            app::shortened(look, Face::kRegular, 13, exercise.stage.summary, room));
  app::text_right(list, look, Face::kRegular, 13, {line.x + line.width - 4, line.y + look.px(14)}, look->muted, state);
  return touch.clicked;
}

}  // namespace

std::vector<const lesson::Exercise*> CourseScreen::found_in(const Shell& shell, const lesson::ExerciseSet& set) const {
  const std::string where = std::string(lesson::kExercisesWord) + ' ' + set.title;
  std::vector<const lesson::Exercise*> found;
  for (const std::string& id : set.exercises)
    if (const lesson::Exercise* const one = shell.exercise(id);
        one != nullptr && (!lesson::is_search(asked()) ||
                           lesson::is_found(lesson::search_text(one->stage, 0, where, {&set.lecture, 1}), asked())))
      found.push_back(one);
  return found;
}

void CourseScreen::draw_sets(Shell& shell, const Grid& grid, float& y) {
  const bool all = !lesson::is_search(asked());
  std::vector<std::pair<const lesson::ExerciseSet*, std::vector<const lesson::Exercise*>>> shown;
  for (const lesson::ExerciseSet& set : shell.sets())
    if (auto found = found_in(shell, set); all || !found.empty()) shown.emplace_back(&set, std::move(found));
  if (shown.empty()) return;
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  y += look.px(all ? 52 : 36);
  const float room = std::min(grid.width, look.px(640));
  y += app::paragraph(list, look, Face::kSemiBold, 20, 28, {grid.left, y}, room, look->ink, lesson::kExercisesWord) + 4;
  if (all)
    y += app::paragraph(list, look, Face::kRegular, 15, 24, {grid.left, y}, room, look->ink, lesson::kExercisesSay);
  y += look.px(20);
  const int across = grid.across > 1 ? 2 : 1;
  const float gap = look.px(40),
              width = (grid.width - gap * static_cast<float>(across - 1)) / static_cast<float>(across);
  float top = y, bottom = y;
  std::string opened;  // after the last line, because that ends the screen
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const lesson::ExerciseSet& set = *shown[i].first;
    const auto column = static_cast<int>(i) % across;
    if (column == 0 && i > 0) top = bottom + look.px(28);
    const float left = grid.left + static_cast<float>(column) * (width + gap);
    float at = top;
    app::text(list, look, Face::kSemiBold, 16, {left, at}, look->ink, set.title);
    at += look.px(24);
    at += app::paragraph(list, look, Face::kRegular, 13, 19, {left, at}, width, look->muted, set.lecture) + 8;
    for (const lesson::Exercise* const exercise : shown[i].second) {
      const app::Rect line{left, at, width, look.px(kLine)};
      if (draw_line(shell, set, *exercise, line)) opened = exercise->id;
      cards_.push_back({0, ImGui::GetItemID(), line, exercise->id});
      at += look.px(kLine);
    }
    const auto elsewhere = all ? std::ssize(set.exercises) - std::ssize(shown[i].second) : 0;
    if (elsewhere > 0)
      at += app::paragraph(list, look, Face::kRegular, 13, 19, {left, at + 6}, width, look->muted,
                           "On the web page: " + io::counted(elsewhere, "exercise") + " in which code is written.") +
            6;
    bottom = std::max(bottom, at);
  }
  y = bottom;
  if (!opened.empty()) shell.go_on_with_exercise(opened);
}

}  // namespace snug::desktop
