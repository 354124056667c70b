#include "desktop/controls.hpp"

#include <algorithm>
#include <cmath>

#include "desktop/column.hpp"
#include "desktop/cover_table.hpp"
#include "lesson/situations.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kAside = 16, kApart = 24;
constexpr float kLeastSlider = 250;  // pixels that a slider takes with its title and its value

float row_height(const Shell& shell, const app::Look& look) { return look.px(shell.low ? 28 : 34); }
float row_gap(const Shell& shell) { return shell.low ? 4 : 8; }

std::vector<std::string> titles_of(const lesson::Lesson& lesson) {
  std::vector<std::string> titles;
  if (lesson.situations.empty()) return titles;
  for (const std::string_view name : lesson::situation_names(lesson))
    titles.push_back(lesson::situation_title(lesson, name));
  return titles;
}

float button_width(const app::Look& look, const std::string& title) {
  return std::max(app::measure(look, Face::kSemiBold, 14, title).x + look.px(26), look.px(56));
}

/// Where things of these widths stand, from left to right in rows.
std::vector<app::Rect> laid_out(const Shell& shell, const app::Look& look, const std::vector<float>& widths,
                                float width, float gap) {
  std::vector<app::Rect> places;
  float x = 0, y = 0;
  for (const float own : widths) {
    if (x > 0 && x + own > width + 0.5f) x = 0, y += row_height(shell, look) + row_gap(shell);
    places.push_back({x, y, std::min(own, width), row_height(shell, look)});
    x += own + gap;
  }
  return places;
}

struct Places {
  std::vector<app::Rect> buttons, sliders;
  float height = 0;
};

Places places_of(Shell& shell, const app::Look& look, float width) {
  Places places;
  const float inside = width - 2 * kAside;
  std::vector<float> widths;
  for (const std::string& title : titles_of(shell.session().lesson())) widths.push_back(button_width(look, title));
  places.buttons = laid_out(shell, look, widths, inside, 4);
  const float end = places.buttons.empty() ? 0 : places.buttons.back().x + places.buttons.back().width + kApart;
  float top = places.buttons.empty() ? 0 : places.buttons.back().y;
  const auto sliders = static_cast<float>(shell.session().stage().sliders().size());
  const bool beside = end + sliders * look.px(kLeastSlider) <= inside;  // in one row with the situations
  if (!beside && !places.buttons.empty() && sliders > 0) top += row_height(shell, look) + row_gap(shell);
  const float from = beside ? end : 0, room = inside - from;
  const float across =
      std::clamp(std::floor((room + kApart) / (look.px(kLeastSlider) + kApart)), 1.0f, std::max(sliders, 1.0f));
  const float own = (room + kApart) / across - kApart;
  places.sliders = laid_out(shell, look, std::vector<float>(static_cast<std::size_t>(sliders), own), room, kApart);
  for (app::Rect& slider : places.sliders) slider.x += from, slider.y += top;
  const app::Rect* last = !places.sliders.empty()   ? &places.sliders.back()
                          : !places.buttons.empty() ? &places.buttons.back()
                                                    : nullptr;
  if (last != nullptr) places.height = last->y + last->height + 2 * row_gap(shell);
  return places;
}

/// ImGui's slider in the palette: a track, and a knob that a hand or a key moves.
void draw_slider(Shell& shell, const lesson::ShownSlider& slider, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  lesson::Session& session = shell.session();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const std::string& title = slider.slider->title;
  const float middle = rect.y + rect.height / 2, before = app::measure(look, Face::kRegular, 14, title).x + 12;
  const float value = std::max(look.px(76), app::measure(look, Face::kMono, 13, slider.text).x);
  app::text(list, look, Face::kRegular, 14, {rect.x, app::middle_of(middle, look.px(14))}, look->ink, title);
  const float shown = app::measure(look, Face::kMono, 13, slider.text).x;
  app::text(list, look, Face::kMono, 13, {rect.x + rect.width - shown, app::middle_of(middle, look.px(13))}, look->ink,
            slider.text);
  ImGui::PushID(static_cast<int>(slider.number));
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::PushStyleColor(ImGuiCol_FrameBgHovered, 0);
  ImGui::PushStyleColor(ImGuiCol_FrameBgActive, 0);
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, look->current);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, look->current);
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 16);
  ImGui::PushStyleVar(ImGuiStyleVar_GrabRounding, 8);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  const float width = std::max(rect.width - before - value - 12, 40.0f), height = 20;
  const ImVec2 at{rect.x + before, std::round(middle - height / 2)};
  ImGui::PushFont(look.font(Face::kMono), 14);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, (height - 14) / 2));
  list->AddRectFilled({at.x, middle - 2}, {at.x + width, middle + 2}, look->line, 2);
  ImGui::SetCursorScreenPos(at);
  ImGui::SetNextItemWidth(width);
  int place = slider.place;
  const bool moved = ImGui::SliderInt("##slider", &place, 0, slider.places, "", ImGuiSliderFlags_NoInput);
  if (ImGui::IsItemActivated()) session.stage().begin_drag();
  if (moved) shell.tell(session.stage().slide_to_place(slider.number, place));
  if (ImGui::IsItemDeactivated()) shell.tell(session.stage().end_drag());
  shell.tracks.emplace_back(slider.number, app::Rect{at.x, at.y, width, height});
  if (app::offer_slider(title)) shell.slider = static_cast<int>(slider.number);
  ImGui::PopStyleVar(4);
  ImGui::PopFont();
  ImGui::PopStyleColor(5);
  ImGui::PopID();
}

}  // namespace

float controls_height(Shell& shell, const app::Look& look, float width) {
  if (shell.app().session() == nullptr) return 0;  // the course waits for a file that can be drawn
  return std::ceil(places_of(shell, look, width).height + cover_table_height(shell, look, width));
}

void draw_controls(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const app::Pane pane("##controls", rect);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  app::rule(pane.list(), rect.x, rect.y, rect.width, look->line);
  const float table = cover_table_height(shell, look, rect.width);
  draw_cover_table(shell, {rect.x, rect.y, rect.width, table});
  const Places places = places_of(shell, look, rect.width);
  lesson::Session& session = shell.session();
  const std::vector<std::string> titles = titles_of(session.lesson());
  const std::vector<std::string_view> names = lesson::situation_names(session.lesson());
  const auto there = [&](app::Rect place) {
    place.x += rect.x + kAside, place.y += rect.y + table + row_gap(shell);
    return place;
  };
  std::string_view chosen;
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const std::string id = "situation " + std::to_string(i);
    const bool on = names[i] == session.stage().situation();
    if (app::button(pane.list(), look,
                    {.id = id.c_str(),
                     .rect = there(places.buttons[i]),
                     .words = titles[i],
                     .kind = on ? app::ButtonKind::kChosen : app::ButtonKind::kOutlined}))
      chosen = names[i];
  }
  const std::vector<lesson::ShownSlider> sliders = session.stage().sliders();
  for (std::size_t i = 0; i < sliders.size(); ++i) draw_slider(shell, sliders[i], there(places.sliders[i]));
  if (!chosen.empty()) shell.tell(session.stage().show_situation(chosen));
}

bool slide_by_key(Shell& shell, const std::string& key) {
  if (shell.slider < 0) return false;
  for (const lesson::ShownSlider& slider : shell.session().stage().sliders()) {
    if (static_cast<int>(slider.number) != shell.slider) continue;
    constexpr int kPage = 10;
    const int by = key == "ArrowRight" || key == "ArrowUp"    ? 1
                   : key == "ArrowLeft" || key == "ArrowDown" ? -1
                   : key == "PageUp"                          ? kPage
                   : key == "PageDown"                        ? -kPage
                   : key == "Home"                            ? -slider.places
                   : key == "End"                             ? slider.places
                                                              : 0;
    if (by == 0) return false;
    const int to = std::clamp(slider.place + by, 0, slider.places);
    if (to != slider.place) shell.tell(shell.session().stage().slide_to_place(slider.number, to));
    return true;
  }
  return false;
}

}  // namespace snug::desktop
