#include "desktop/menus.hpp"

#include <spawn.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/cover.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/column.hpp"
#include "desktop/file_dialog.hpp"
#include "lesson/door_words.hpp"
#include "lesson/say.hpp"

extern char** environ;

namespace snug::desktop {
namespace {

using app::Face;
using What = FileCard::What;

/// A line of a menu. key: as app::Command has it.
struct Item {
  std::string words, key;
  bool enabled = true;
  std::function<void()> run;
  bool begins_part = false;  // whether a rule stands above it
};

using Items = std::vector<Item>;

/// A menu whose items are made only while it is open, or for its keys.
struct Menu {
  const char* title;
  Items (*items)(Shell& shell);
};

bool has_points(Shell& shell) {
  return !shell.course_shown && shell.app().session() != nullptr &&
         shell.app().session()->stage().subject().points() != nullptr;
}

/// Whether a lesson is on the screen, and no exercise, whose stage nobody may replace.
bool is_open_lesson(Shell& shell) {
  return !shell.course_shown && shell.app().session() != nullptr && shell.app().sitting() == nullptr;
}

/// An item that runs one of the app's commands.
Item item_of(Shell& shell, const char* name, bool enabled, bool begins_part = false) {
  const app::Command& command = *app::find_command(name);
  return {std::string(command.menu), std::string(command.keys), enabled, [&shell, name] { shell.app().command(name); },
          begins_part};
}

Items file_items(Shell& shell) {
  const bool open = is_open_lesson(shell), chart = open && shell.app().cover() != nullptr;
  const bool takes_points = open || (shell.course_shown && shell.lesson_for_points());
  Items items{
      {"Open points …", "Ctrl+o", takes_points, [&] { ask_path(shell, What::kOpenPoints); }},
      {"Open lesson …", "", true, [&] { ask_path(shell, What::kOpenLesson); }},
  };
  for (const std::string& path : shell.kept().recent)
    items.push_back({std::filesystem::path(path).filename().string(), "", takes_points,
                     [&shell, path] { shell.open_points(path); }, items.size() == 2});
  items.push_back({"Save points …", "", has_points(shell), [&] { ask_path(shell, What::kSavePoints); }, true});
  items.push_back({"Save picture …", "", open, [&] { ask_path(shell, What::kSavePicture); }});
  items.push_back({"Add to a demo", "", open, [&] { shell.record(); }});
  items.push_back({"Export table …", "", chart && !shell.app().cover()->file("csv").empty(),
                   [&] { ask_path(shell, What::kExportTable); }});
  const bool exercise = !shell.course_shown && shell.app().sitting() != nullptr;
  items.push_back({std::string(lesson::kHandInWord), "", exercise || (open && shell.sheet() != nullptr),
                   [&shell] { shell.hand_in(); }, true});
  items.push_back({"Quit", "Ctrl+q", true, [&] { shell.wish = "quit"; }, true});
  return items;
}

Items edit_items(Shell& shell) {
  const bool lesson = !shell.course_shown && shell.app().session() != nullptr;
  return {item_of(shell, "undo", lesson && shell.session().stage().can_undo()),
          item_of(shell, "redo", lesson && shell.session().stage().can_redo()),
          {"Copy picture", "", lesson, [&] { shell.wish = "copy_picture"; }, true},
          {"Copy points", "Ctrl+c", has_points(shell), [&] { shell.copy_points(); }},
          {"Paste points", "Ctrl+v", is_open_lesson(shell) && has_points(shell), [&] { shell.paste_points(); }}};
}

Items view_items(Shell& shell) {
  const bool lesson = !shell.course_shown;
  return {{lesson ? "Course" : "Back to the lesson", "F2", true, [&] { shell.switch_course(); }},
          item_of(shell, "zoom_in", lesson, true),
          item_of(shell, "zoom_out", lesson),
          item_of(shell, "reset_view", lesson),
          {"Next theme", "", true, [&] { shell.next_theme(); }, true},
          {"Larger text", "", shell.may_resize(1), [&] { shell.resize_text(1); }},
          {"Smaller text", "", shell.may_resize(-1), [&] { shell.resize_text(-1); }},
          {"Full screen", "F11", true, [&] { shell.wish = "full_screen"; }, true},
          {std::string(lesson::kPresentWord), "F5", lesson, [&] { shell.present(!shell.presenting); }}};
}

Items lesson_items(Shell& shell) {
  const bool lesson = is_open_lesson(shell), any = !shell.course_shown;
  const auto go = [&](int by) {
    const auto to = lesson ? shell.beside(by) : std::nullopt;
    return Item{by < 0 ? "Previous lesson" : "Next lesson", "", to.has_value(),
                [&shell, to] { shell.open_at_place(*to); }};
  };
  return {go(-1),
          go(1),
          item_of(shell, "play", any, true),
          item_of(shell, "first", any),
          item_of(shell, "last", any),
          item_of(shell, "next_mark", any),
          item_of(shell, "previous_mark", any),
          item_of(shell, "reset_points", any, true)};
}

Items help_items(Shell& shell) {
  return {{"Keys", "F1", true, [&] { shell.keys_shown = !shell.keys_shown; }},
          {"About Snug", "", true, [&] { shell.about_shown = true; }}};
}

constexpr std::array kMenus{Menu{"File", &file_items}, Menu{"Edit", &edit_items}, Menu{"View", &view_items},
                            Menu{"Lesson", &lesson_items}, Menu{"Help", &help_items}};

/// All menus one below the other, for a bar that has no room for their words.
Items all_items(Shell& shell) {
  Items all;
  for (const Menu& menu : kMenus) {
    Items items = menu.items(shell);
    items.front().begins_part = !all.empty();
    std::move(items.begin(), items.end(), std::back_inserter(all));
  }
  return all;
}

/// A menu's list, while it is open. From its top it has as much of the window as it needs.
void draw_menu(Shell& shell, const Menu& menu, ImVec2 at) {
  const std::string id = std::string("menu ") + menu.title;
  if (!ImGui::IsPopupOpen(id.c_str())) return;
  const Items items = menu.items(shell);
  const app::Look& look = shell.app().look();
  float widest = 0;
  for (const Item& item : items)
    widest = std::max(widest, app::measure(look, Face::kRegular, 14, item.words).x +
                                  app::measure(look, Face::kRegular, 13, app::shown_key(item.key)).x);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = std::min(std::max(look.px(200), widest + look.px(64)), window.x - 16);
  const float room = window.y - at.y - 16, count = static_cast<float>(items.size());
  const float row = std::clamp(room / count, look.px(22), look.px(32));  // a list that is still too high scrolls
  const app::Popup popup(id.c_str(),
                         {std::min(at.x, window.x - width - 8), at.y, width, std::min(row * count, room) + 8});
  if (!popup) return;
  const float left = ImGui::GetWindowPos().x, top = at.y + 4 - ImGui::GetScrollY();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  std::function<void()> chosen;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    const app::Rect rect{left + 4, top + row * static_cast<float>(i), width - 8, row};
    if (item.begins_part) app::rule(list, rect.x + 6, rect.y, rect.width - 12, look->line);
    const auto touch = app::touch_area(("item " + std::to_string(i)).c_str(), rect, item.words, item.enabled, i == 0);
    if (touch.hovered && item.enabled)
      list->AddRectFilled({rect.x, rect.y + 1}, {rect.x + rect.width, rect.y + row - 1}, look->raised, 6);
    const app::Color color = item.enabled ? look->ink : app::with_alpha(look->muted, 0.6f);
    const float key_width = app::measure(look, Face::kRegular, 13, app::shown_key(item.key)).x;
    app::text(list, look, Face::kRegular, 14, {rect.x + 10, app::middle_of(rect.y + row / 2, look.px(14))}, color,
              app::shortened(look, Face::kRegular, 14, item.words, rect.width - key_width - 32));
    app::text_right(list, look, Face::kRegular, 13,
                    {rect.x + rect.width - 10, app::middle_of(rect.y + row / 2, look.px(13))}, look->muted,
                    app::shown_key(item.key));
    if (touch.clicked) chosen = item.run;
  }
  if (!chosen) return;
  ImGui::CloseCurrentPopup();
  chosen();
}

/// A word of the bar that opens a list.
void draw_menu_word(const app::Look& look, ImDrawList* list, const char* words, const app::Rect& place) {
  const std::string name = std::string(words) + " menu";  // a tab is called "File" as well
  const auto touch = app::touch_area(words, place, name);
  if (touch.hovered)
    list->AddRectFilled({place.x, place.y}, {place.x + place.width, place.y + place.height},
                        app::with_alpha(look->ink, 0.07f), 8);
  app::text(list, look, Face::kRegular, 14, {place.x + 10, app::middle_of(place.y + place.height / 2, look.px(14))},
            look->ink, words);
  if (touch.clicked) ImGui::OpenPopup((std::string("menu ") + words).c_str());
}

}  // namespace

float draw_menus(Shell& shell, const app::Rect& bar, float x, float right) {
  constexpr float kLeastBeside = 230;  // for the lesson's title, or the search
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float height = look.px(32), y = bar.y + (bar.height - height) / 2, below = bar.y + bar.height - 2;
  const auto width_of = [&](const char* words) { return app::measure(look, Face::kRegular, 14, words).x + 20; };
  float all = 0;
  for (const Menu& menu : kMenus) all += width_of(menu.title);
  if (x + all + look.px(kLeastBeside) > right) {
    const app::Rect place{x, y, width_of("Menu"), height};
    draw_menu_word(look, list, "Menu", place);
    shell.first_menu = ImGui::GetItemID();
    draw_menu(shell, {"Menu", &all_items}, {x, below});
    return x + place.width + 8;
  }
  for (const Menu& menu : kMenus) {
    const app::Rect place{x, y, width_of(menu.title), height};
    draw_menu_word(look, list, menu.title, place);
    if (&menu == &kMenus.front()) shell.first_menu = ImGui::GetItemID();
    draw_menu(shell, menu, {x, below});
    x += place.width;
  }
  return x + 8;
}

void draw_about(Shell& shell, const app::Rect& window) {
  if (!shell.about_shown) return;
  const std::array<std::string, 5> says_all{
      "Snug teaches bounding volumes: how they are fitted, tested and culled, how tight they are, and what that costs. "
      "It is free software under the MIT licence.",
      "It contains Dear ImGui, CLI11, JSON for Modern C++, toml++ and fast_float (MIT, BSD), Eigen (MPL 2.0), "
      "tl::expected (CC0), Inter and JetBrains Mono (OFL 1.1), and the bunny, the teapot and the dragon.",
      "It uses GLFW (zlib), libepoxy (MIT), libpng, zlib, libzip (BSD), Brotli (MIT) and Nettle (LGPL). The licences "
      "are in the folder licenses of its documentation.",
      shell.parts + ".", "No screen reader can read this window. The page has the same lessons as real text."};
  const app::Look& look = shell.app().look();
  const float width = std::min(look.px(560), window.width - 32), inner = width - 56;
  float height = look.px(76);
  for (const std::string& says : says_all)
    height += look.px(22) * static_cast<float>(app::lines_of(look, Face::kRegular, 15, says, inner).size()) + 10;
  const app::Rect card{window.x + (window.width - width) / 2, window.y + std::max(8.0f, (window.height - height) / 2),
                       width, height};
  const app::Pane pane("##about", window, app::Pane::Kind::kOver);
  ImDrawList* const list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height},
                      app::with_alpha(look->ground, 0.75f));
  list->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->line, 8, 0, 1);
  float y = card.y + look.px(24);
  app::text(list, look, Face::kSemiBold, 18, {card.x + 28, y}, look->ink, "Snug " + shell.version);
  y += look.px(34);
  for (const std::string& says : says_all)
    y += app::paragraph(list, look, Face::kRegular, 15, 22, {card.x + 28, y}, inner, look->ink, says) + 10;
  if (app::touch_area("about away", window, lesson::kDismissWord).clicked) shell.about_shown = false;
}

/// The items with a key that is none of the app's own commands.
std::vector<Item> items_with_keys(Shell& shell) {
  std::vector<Item> keyed = all_items(shell);
  std::erase_if(keyed, [](const Item& item) {
    const auto is_same = [&](const app::Command& command) { return command.keys == item.key; };
    return item.key.empty() || std::any_of(app::commands().begin(), app::commands().end(), is_same);
  });
  return keyed;
}

bool menu_by_key(Shell& shell, const std::string& key, bool shift, bool control) {
  for (const Item& item : items_with_keys(shell)) {
    if (!app::has_key(item.key, key, shift, control)) continue;
    if (item.enabled) item.run();
    return true;
  }
  return false;
}

std::vector<app::KeyRow> keys_of_menus(Shell& shell) {
  std::vector<app::KeyRow> rows;
  for (const Item& item : items_with_keys(shell)) {
    std::string words = item.words.ends_with(" …") ? item.words.substr(0, item.words.rfind(' ')) : item.words;
    words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
    rows.push_back({app::shown_key(item.key), std::move(words)});
  }
  return rows;
}

void Shell::open_lesson_file(const std::string& path) {
  const std::string program = window_program().string();
  std::array<char*, 3> arguments{const_cast<char*>(program.c_str()), const_cast<char*>(path.c_str()), nullptr};
  pid_t child = 0;
  if (posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    notice = "The lesson cannot be opened in a window of its own.";
}

}  // namespace snug::desktop
