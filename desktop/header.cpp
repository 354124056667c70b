#include "desktop/header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/look.hpp"
#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "desktop/column.hpp"
#include "desktop/menus.hpp"
#include "lesson/door_words.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr std::array kTextScales{0.9f, 1.0f, 1.15f, 1.3f, 1.5f, 2.0f};
constexpr float kBrandMargin = 24;

/// Where the size stands among those that can be chosen, or where it would.
std::ptrdiff_t text_scale_at(const app::Settings& settings) {
  return std::lower_bound(kTextScales.begin(), kTextScales.end(), settings.text_scale) - kTextScales.begin();
}

/// The next larger one; after the largest the smallest.
void next_text_scale(Shell& shell) {
  shell.resize_text(shell.may_resize(1) ? 1 : -static_cast<int>(kTextScales.size()));
}

std::string text_size_words(const app::Settings& settings) {
  return std::string(lesson::kTextSizeWord) + ": " +
         std::to_string(static_cast<int>(std::lround(settings.text_scale * 100))) + " %";
}

std::string theme_words(const app::Settings& settings) {
  return std::string(lesson::kThemeWord) + ": " +
         std::string(lesson::kThemeWords[static_cast<std::size_t>(settings.theme)]);
}

/// What is kept on this device, and the two presses that take it away.
void draw_erase(Shell& shell, Column& column) {
  SettingsPanel& panel = shell.settings_panel;
  column.words(panel.sure     ? lesson::kEraseWarning
               : panel.erased ? lesson::kErased
                              : lesson::kKeptHere,
               Face::kRegular, 14);
  column.gap(8);
  const std::string words(panel.sure ? lesson::kEraseSureWord : lesson::kEraseWord);
  if (column.buttons("erase", {words}) < 0) return;
  if (panel.sure) shell.erase_answers();
  panel.erased = panel.sure;
  panel.sure = !panel.sure;
}

void draw_settings(Shell& shell, ImVec2 corner) {
  constexpr float kPad = 16;
  const app::Look& look = shell.app().look();
  SettingsPanel& panel = shell.settings_panel;
  const float width = look.px(304);
  const app::Popup popup("settings panel", {corner.x - width, corner.y, width, panel.height});
  if (!popup) {
    panel = {.height = panel.height};
    return;
  }
  app::Settings& settings = shell.app().settings();
  Column column(look, corner.x - width + kPad, corner.y + kPad, width - 2 * kPad);
  if (column.buttons("text size", {text_size_words(settings)}) == 0) next_text_scale(shell);
  if (column.buttons("theme", {theme_words(settings)}) == 0) shell.next_theme();
  column.gap(8);
  draw_erase(shell, column);
  const float height = column.y() - corner.y + kPad - 8;
  if (height != panel.height) panel.height = height, shell.measured_anew = true;
}

struct Tool {
  enum class Kind { kSettings, kTheme, kTextSize, kKeys, kPresent } kind;
  const char* id;
  std::string_view words;
  app::Icon icon = app::Icon::kNone;
};

/// The tools at the bar's right end, the last one first.
std::vector<Tool> tools_of(const Shell& shell) {
  using Kind = Tool::Kind;
  std::vector<Tool> tools{{Kind::kSettings, "settings", {}, app::Icon::kSettings},
                          {Kind::kTheme, "theme", {}, app::Icon::kTheme},
                          {Kind::kTextSize, "text size", "Aa"}};
  if (shell.narrow) return tools;  // the others are in the menu: the lesson's title needs the room
  tools.push_back({Kind::kKeys, "keys", "Keys"});
  if (!shell.course_shown) tools.push_back({Kind::kPresent, "present", lesson::kPresentWord});
  return tools;
}

float width_of(const app::Look& look, const Tool& tool) {
  return tool.words.empty() ? look.px(40) : app::measure(look, Face::kRegular, 14, tool.words).x + look.px(24);
}

/// Where they begin.
float tools_left(const Shell& shell, const app::Look& look, const app::Rect& rect) {
  float left = rect.x + rect.width - 16;
  for (const Tool& tool : tools_of(shell)) left -= width_of(look, tool) + 4;
  return left;
}

void use_tool(Shell& shell, Tool::Kind tool) {
  switch (tool) {
    case Tool::Kind::kSettings: return ImGui::OpenPopup("settings panel");
    case Tool::Kind::kTheme: return shell.next_theme();
    case Tool::Kind::kTextSize: return next_text_scale(shell);
    case Tool::Kind::kKeys: shell.keys_shown = !shell.keys_shown; return;
    case Tool::Kind::kPresent: return shell.present(true);
  }
}

/// What the keyboard's focus calls it.
std::string name_of(const Tool& tool, const app::Settings& settings) {
  switch (tool.kind) {
    case Tool::Kind::kSettings: return std::string(lesson::kSettingsWord);
    case Tool::Kind::kTheme: return theme_words(settings);
    case Tool::Kind::kTextSize: return text_size_words(settings);
    case Tool::Kind::kKeys:
    case Tool::Kind::kPresent: break;
  }
  return std::string(tool.words);
}

void draw_tools(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect) {
  const float height = look.px(32), y = rect.y + (rect.height - height) / 2;
  float x = tools_left(shell, look, rect);
  std::vector<Tool> tools = tools_of(shell);
  std::reverse(tools.begin(), tools.end());
  for (const Tool& tool : tools) {
    const float width = width_of(look, tool);
    const std::string name = name_of(tool, shell.app().settings());
    if (app::button(list, look,
                    {.id = tool.id,
                     .rect = {x + 4, y, width, height},
                     .words = tool.words,
                     .icon = tool.icon,
                     .kind = app::ButtonKind::kQuiet,
                     .name = name}))
      use_tool(shell, tool.kind);
    x += width + 4;
  }
  draw_settings(shell, {rect.x + rect.width - 16, rect.y + rect.height - 4});
}

/// The way to the course; returns where it ends.
float draw_brand(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect) {
  const float x = rect.x + kBrandMargin, width = app::measure(look, Face::kSemiBold, 18, "Snug").x;
  app::text(list, look, Face::kSemiBold, 18, {x, app::middle_of(rect.y + rect.height / 2, look.px(18))}, look->ink,
            "Snug");
  const app::Rect place{x - 6, rect.y + 8, width + 12, rect.height - 16};
  if (app::touch_area("course", place, "Snug, the course").clicked && !shell.course_shown) shell.show_course();
  return x + width + 18;
}

/// Chapter and lesson between the two; the chapter goes where there is no room for both.
void draw_picker(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect, float x, float right) {
  std::vector<std::string> titles;
  for (const LessonFile& file : shell.lessons()) titles.push_back(file.lesson.title);
  const std::string& title = shell.session().lesson().title;
  const std::string chapter = shell.chapter() + "  /";
  const float middle = rect.y + rect.height / 2, height = look.px(32);
  const float before = app::measure(look, Face::kRegular, 14, chapter).x + 8;
  const float wanted = app::measure(look, Face::kSemiBold, 14, title).x + 42;
  if (x + before + wanted <= right) {
    app::text(list, look, Face::kRegular, 14, {x, app::middle_of(middle, look.px(14))}, look->muted, chapter);
    x += before;
  }
  const float width = std::min(wanted, right - x);
  const app::Rect place{x, rect.y + (rect.height - height) / 2, width, height};
  const app::Touch touch = app::touch_area("lesson", place, title);
  if (touch.clicked) ImGui::OpenPopup("lessons");
  if (touch.hovered)
    list->AddRectFilled({x, place.y}, {x + width, place.y + height}, app::with_alpha(look->ink, 0.07f), 8);
  app::text(list, look, Face::kSemiBold, 14, {x + 8, app::middle_of(middle, look.px(14))}, look->ink,
            app::shortened(look, Face::kSemiBold, 14, title, width - 40));
  const float cx = x + width - 16;
  list->AddTriangleFilled({cx - 5, middle - 2.5f}, {cx + 5, middle - 2.5f}, {cx, middle + 3.5f}, look->muted);
  const int picked = choice_list(look, "lessons", {x, rect.y + rect.height}, std::max(width, look.px(380)), titles,
                                 static_cast<int>(shell.opened()));
  if (picked >= 0) shell.open_at_place(picked);
}

}  // namespace

void draw_header(Shell& shell, const app::Rect& rect) {
  const app::Pane pane("##header", rect);
  const app::Look& look = shell.app().look();
  ImDrawList* list = pane.list();
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  app::rule(list, rect.x, rect.y + rect.height - 1, rect.width, look->line);
  const float right = tools_left(shell, look, rect) - 8;
  const float left = draw_menus(shell, rect, draw_brand(shell, look, list, rect), right);
  if (shell.course_shown) shell.course.draw_search(shell, {left, rect.y, right - left, rect.height});
  else draw_picker(shell, look, list, rect, left, right);
  draw_tools(shell, look, list, rect);
}

void Shell::next_theme() {
  app::Settings& settings = app_.settings();
  settings.theme = static_cast<app::Theme>((static_cast<int>(settings.theme) + 1) % 4);
}

bool Shell::may_resize(int by) const {
  const std::ptrdiff_t to = text_scale_at(app_.settings()) + by;
  return to >= 0 && to < std::ssize(kTextScales);
}

void Shell::resize_text(int by) {
  const std::ptrdiff_t to = text_scale_at(app_.settings()) + by;
  app_.settings().text_scale = kTextScales[std::clamp<std::ptrdiff_t>(to, 0, std::ssize(kTextScales) - 1)];
}

void draw_notice(Shell& shell, const app::Rect& stage) {
  if (shell.notice.empty()) return;
  const app::Look& look = shell.app().look();
  const float width = std::min(stage.width - 32, look.px(520)), inner = width - 64;
  const auto lines = app::lines_of(look, Face::kRegular, 14, shell.notice, inner);
  const float height = look.px(21) * static_cast<float>(lines.size()) + 24;
  const app::Rect card{stage.x + (stage.width - width) / 2, stage.y + 56, width, height};
  const app::Pane pane("##notice", card, app::Pane::Kind::kOver);
  ImDrawList* list = pane.list();
  list->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, shell.is_said() ? look->muted : look->wrong, 8, 0,
                1.5f);
  app::paragraph(list, look, Face::kRegular, 14, 21, {card.x + 16, card.y + 12}, inner, look->ink, shell.notice);
  app::draw_icon(list, app::Icon::kClose, {card.x + width - 22, card.y + 22}, look.px(13), look->muted);
  if (app::touch_area("notice away", card, lesson::kDismissWord).clicked) shell.notice.clear();
}

}  // namespace snug::desktop
