#include "desktop/keys_card.hpp"

#include <imgui.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/look.hpp"
#include "app/widgets.hpp"
#include "desktop/menus.hpp"
#include "lesson/door_words.hpp"

namespace snug::desktop {
namespace {

using app::Face, app::KeyRow;

constexpr float kKeysSize = 13, kWordsSize = 14, kLine = 19, kBetween = 8;  // kBetween: rows
constexpr float kPad = 28, kHead = 60, kFoot = 24, kAside = 16;             // kAside: between keys and words, columns

/// How wide the keys are, and the words beside them in so wide a column.
struct Widths {
  float keys, words;
};

Widths widths_of(const app::Look& look, const std::vector<KeyRow>& rows, float column) {
  float keys = 0;
  for (const KeyRow& row : rows) keys = std::max(keys, app::measure(look, Face::kMonoBold, kKeysSize, row.keys).x);
  return {keys, std::max(column - keys - kAside, look.px(80))};
}

float height_of(const app::Look& look, const KeyRow& row, float words) {
  const auto lines = app::lines_of(look, Face::kRegular, kWordsSize, row.words, words).size();
  return look.px(kLine) * static_cast<float>(lines) + look.px(kBetween);
}

/// How many rows the first of two columns has, so that both are about as high; and the height of the higher one.
std::pair<std::size_t, float> split(const app::Look& look, const std::vector<KeyRow>& rows, float words, int columns) {
  float all = 0;
  for (const KeyRow& row : rows) all += height_of(look, row, words);
  if (columns == 1) return {rows.size(), all};
  float first = 0;
  std::size_t count = 0;
  while (count < rows.size() && first < all / 2) first += height_of(look, rows[count++], words);
  return {count, std::max(first, all - first)};
}

void draw_rows(ImDrawList* list, const app::Look& look, const std::vector<KeyRow>& rows, ImVec2 at, float column,
               int columns) {
  const Widths widths = widths_of(look, rows, column);
  const std::size_t in_first = split(look, rows, widths.words, columns).first;
  const float top = at.y;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == in_first) at = {at.x + column + 2 * kAside, top};
    float y = at.y;
    app::text(list, look, Face::kMonoBold, kKeysSize,
              {at.x, app::middle_of(y + look.px(kLine) / 2, look.px(kKeysSize))}, look->current_text, rows[i].keys);
    for (const auto& line : app::lines_of(look, Face::kRegular, kWordsSize, rows[i].words, widths.words)) {
      app::text(list, look, Face::kRegular, kWordsSize,
                {at.x + widths.keys + kAside, app::middle_of(y + look.px(kLine) / 2, look.px(kWordsSize))}, look->ink,
                line);
      y += look.px(kLine);
    }
    at.y = y + look.px(kBetween);
  }
}

}  // namespace

std::vector<KeyRow> key_rows(Shell& shell) {
  std::vector<KeyRow> rows = app::key_rows();
  rows.push_back({"Tab  Shift Tab", "the next or the previous button, link or field; Enter presses it"});
  rows.push_back({"F10", "the menus"});
  for (KeyRow& row : keys_of_menus(shell)) rows.push_back(std::move(row));
  rows.push_back({"/", "on the course’s page, search it"});
  rows.push_back({"N  P  T  Esc", "while presenting: the next lesson, the previous one, the text; the end"});
  rows.push_back({"L  W  R", "while presenting: a spotlight, a pen that fades, a ruler for the height of type"});
  rows.push_back(
      {"B  .  F", "while presenting: black, and the picture again; the picture is frozen while you prepare another"});
  rows.push_back({"Q", "this state as a code that a phone scans"});
  rows.push_back({"Shift D", "add this state to a demo’s file, which grows by one each time"});
  rows.push_back({"Ctrl S", "the stage as a picture; with Shift as SVG, whose words are text"});
  if (shell.demo) {
    rows.push_back({"PgDn →  PgUp ←", "the demo: the next reveal or state, and back"});
    rows.push_back({"Home  H", "the demo: this state as it was; so does a key for next or back that is held"});
    rows.push_back({"S  F5", "the demo: the notes in a second window; the whole screen"});
    rows.push_back({"Esc", "the demo: puts the pointers away; then leaves it, and the lesson stays"});
    rows.push_back(
        {"V, a number", "the class votes: hands for each answer, Enter after each; V again: the second vote"});
  }
  return rows;
}

void draw_keys(Shell& shell, const app::Rect& window) {
  const float scroll = std::exchange(shell.keys_scroll, 0.0f);
  if (!shell.keys_shown) return;
  const app::Look& look = shell.app().look();
  const std::vector<KeyRow> rows = key_rows(shell);
  const float head = look.px(kHead), room = window.height - 16 - head - look.px(kFoot);
  const auto try_columns = [&](int columns) {
    const float most = look.px(600) * static_cast<float>(columns) + 2 * kAside * static_cast<float>(columns - 1);
    const float inner = std::min(most, window.width - 32 - 2 * kPad);
    const float column = (inner - 2 * kAside * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    return std::pair(column, split(look, rows, widths_of(look, rows, column).words, columns).second);
  };
  int columns = 1;
  auto [column, all] = try_columns(1);
  if (all > room && window.width - 32 - 2 * kPad > look.px(720)) columns = 2, std::tie(column, all) = try_columns(2);
  const float width = column * static_cast<float>(columns) + 2 * kAside * static_cast<float>(columns - 1) + 2 * kPad;
  const float shown = std::min(all, room), height = head + shown + look.px(kFoot);
  const app::Rect card{window.x + (window.width - width) / 2, window.y + std::max(8.0f, (window.height - height) / 2),
                       width, height};
  const app::Pane pane("##keys", window, app::Pane::Kind::kOver);
  ImDrawList* list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height},
                      app::with_alpha(look->ground, 0.75f));
  list->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->line, 8, 0, 1);
  app::text(list, look, Face::kSemiBold, 18, {card.x + kPad, card.y + look.px(kFoot)}, look->ink, "Keys");
  if (all > room)
    app::text_right(list, look, Face::kRegular, 13, {card.x + width - kPad, card.y + look.px(kFoot + 3)}, look->muted,
                    "↑ ↓ scroll");
  ImGui::SetCursorScreenPos({card.x + kPad, card.y + head});
  if (ImGui::BeginChild("##key rows", {width - 2 * kPad, shown}, 0,
                        ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar)) {
    if (scroll != 0) ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + scroll, 0.0f, std::max(0.0f, all - shown)));
    draw_rows(ImGui::GetWindowDrawList(), look, rows, ImGui::GetCursorScreenPos(), column, columns);
    ImGui::Dummy({1, all});
  }
  const bool pressed = ImGui::IsWindowHovered() && ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  ImGui::EndChild();
  if (app::touch_area("keys away", window, lesson::kDismissWord).clicked || pressed) shell.keys_shown = false;
}

}  // namespace snug::desktop
