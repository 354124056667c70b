#include "desktop/header.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "app/commands.hpp"
#include "app/look.hpp"
#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "desktop/column.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr std::array kTextScales{0.9f, 1.0f, 1.15f, 1.3f, 1.5f};

void next_text_scale(app::Settings& settings) {
  const auto at = std::find(kTextScales.begin(), kTextScales.end(), settings.text_scale);
  settings.text_scale = at == kTextScales.end() || at + 1 == kTextScales.end() ? kTextScales[0] : *(at + 1);
}

void next_theme(app::Settings& settings) {
  settings.theme = static_cast<app::Theme>((static_cast<int>(settings.theme) + 1) % 4);
}

float draw_titles(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect) {
  const float middle = rect.y + rect.height / 2;
  float x = rect.x + 24;
  app::text(list, look, Face::kSemiBold, 18, {x, app::middle_of(middle, look.px(18))}, look->ink, "Snug");
  const float brand = app::measure(look, Face::kSemiBold, 18, "Snug").x;
  if (app::touch_area("course", {x - 6, rect.y + 6, brand + 12, rect.height - 12}).clicked && !shell.course_shown)
    shell.show_course();
  x += brand + 18;
  if (shell.course_shown) return x;
  const std::string& chapter = shell.chapter();
  app::text(list, look, Face::kRegular, 14, {x, app::middle_of(middle, look.px(14))}, look->muted, chapter);
  x += app::measure(look, Face::kRegular, 14, chapter).x + 10;
  app::text(list, look, Face::kRegular, 14, {x, app::middle_of(middle, look.px(14))}, look->line, "/");
  return x + 8;
}

void draw_picker(Shell& shell, const app::Look& look, ImDrawList* list, const app::Rect& rect, float x) {
  std::vector<std::string> titles;
  int chosen = -1;
  for (const LessonFile& file : shell.lessons()) {
    if (file.lesson.id == shell.session().lesson().id) chosen = static_cast<int>(titles.size());
    titles.push_back(file.lesson.title);
  }
  const std::string& title = shell.session().lesson().title;
  const float height = look.px(32), width = app::measure(look, Face::kSemiBold, 14, title).x + 40;
  const app::Rect place{x, rect.y + (rect.height - height) / 2, width, height};
  if (app::button(list, look, {.id = "lesson", .rect = place, .kind = app::ButtonKind::kQuiet}))
    ImGui::OpenPopup("lessons");
  const float middle = place.y + height / 2;
  app::text(list, look, Face::kSemiBold, 14, {x + 8, app::middle_of(middle, look.px(14))}, look->ink, title);
  const float cx = x + width - 16;
  list->AddTriangleFilled({cx - 5, middle - 2.5f}, {cx + 5, middle - 2.5f}, {cx, middle + 3.5f}, look->muted);
  const int picked =
      choice_list(look, "lessons", {x, rect.y + rect.height}, std::max(width, look.px(340)), titles, chosen);
  if (picked >= 0) shell.open_at_place(static_cast<std::size_t>(picked));
}

}  // namespace

void draw_header(Shell& shell, const app::Rect& rect) {
  const app::Pane pane("##header", rect);
  const app::Look& look = shell.app().look();
  ImDrawList* list = pane.list();
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->panel);
  app::rule(list, rect.x, rect.y + rect.height - 1, rect.width, look->line);
  if (const float x = draw_titles(shell, look, list, rect); !shell.course_shown)
    draw_picker(shell, look, list, rect, x);

  app::Settings& settings = shell.app().settings();
  const float height = look.px(32), y = rect.y + (rect.height - height) / 2;
  float right = rect.x + rect.width - 16;
  const auto place = [&](float width) {
    right -= width;
    const app::Rect at{right, y, width, height};
    right -= 4;
    return at;
  };
  if (app::button(
          list, look,
          {.id = "theme", .rect = place(look.px(40)), .icon = app::Icon::kTheme, .kind = app::ButtonKind::kQuiet}))
    next_theme(settings);
  if (app::button(list, look,
                  {.id = "size", .rect = place(look.px(44)), .words = "Aa", .kind = app::ButtonKind::kQuiet}))
    next_text_scale(settings);
  if (app::button(list, look,
                  {.id = "keys", .rect = place(look.px(56)), .words = "Keys", .kind = app::ButtonKind::kQuiet}))
    shell.keys_shown = !shell.keys_shown;
}

void draw_keys(Shell& shell, const app::Rect& window) {
  if (!shell.keys_shown) return;
  const app::Look& look = shell.app().look();
  std::vector<app::KeyHelp> rows(std::begin(app::kKeyHelp), std::end(app::kKeyHelp));
  rows.push_back({"F2", "the course, and back to the lesson"});
  const float width = std::min(look.px(620), window.width - 32);
  const float row = std::min(look.px(28), (window.height - 16 - look.px(84)) /
                                              static_cast<float>(rows.size()));  // all of it, even in a low window
  const float height = row * static_cast<float>(rows.size()) + look.px(84);
  const app::Rect card{window.x + (window.width - width) / 2, window.y + std::max(8.0f, (window.height - height) / 2),
                       width, height};
  const app::Pane pane("##keys", window, app::Pane::Kind::kOver);
  ImDrawList* list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height},
                      app::with_alpha(look->ground, 0.75f));
  list->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->line, 8, 0, 1);
  app::text(list, look, Face::kSemiBold, 18, {card.x + 28, card.y + look.px(24)}, look->ink, "Keys");
  float y = card.y + look.px(60);
  for (const app::KeyHelp& help : rows) {
    app::text(list, look, Face::kMonoBold, 13, {card.x + 28, app::middle_of(y + row / 2, look.px(13))},
              look->current_text, help.keys);
    app::text(list, look, Face::kRegular, 14, {card.x + 28 + look.px(140), app::middle_of(y + row / 2, look.px(14))},
              look->ink, help.does);
    y += row;
  }
  if (app::touch_area("keys away", window).clicked) shell.keys_shown = false;
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
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->wrong, 8, 0, 1.5f);
  app::paragraph(list, look, Face::kRegular, 14, 21, {card.x + 16, card.y + 12}, inner, look->ink, shell.notice);
  app::draw_icon(list, app::Icon::kClose, {card.x + width - 22, card.y + 22}, look.px(13), look->muted);
  if (app::touch_area("notice away", card).clicked) shell.notice.clear();
}

}  // namespace snug::desktop
