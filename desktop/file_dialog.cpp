#include "desktop/file_dialog.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/cover.hpp"
#include "desktop/card_parts.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/column.hpp"
#include "desktop/portal.hpp"
#include "desktop/shell.hpp"
#include "desktop/typing.hpp"

namespace snug::desktop {
namespace {

using app::Face;
using What = FileCard::What;

bool saves(What what) { return what != What::kOpenPoints && what != What::kOpenLesson; }

const char* card_title(What what) {
  switch (what) {
    case What::kOpenPoints: return "Open points";
    case What::kOpenLesson: return "Open a lesson's file";
    case What::kSavePoints: return "Save points";
    case What::kSavePicture: return "Save picture";
    case What::kExportTable: return "Export table";
    case What::kNone: break;
  }
  return "";
}

const char* says_of(What what) {
  switch (what) {
    case What::kOpenPoints: return "PLY, STL, OBJ, OFF, or rows of two or three numbers (XYZ, CSV, TXT).";
    case What::kOpenLesson: return "A TOML file, which opens in a window of its own.";
    case What::kSavePoints: return "Rows of numbers: the name ends in .xyz or .csv.";
    case What::kSavePicture: return "What the stage shows, as PNG.";
    case What::kExportTable: return "The name ends in .csv or .json.";
    case What::kNone: break;
  }
  return "";
}

std::vector<std::string> endings_of(What what) {
  switch (what) {
    case What::kOpenPoints: return {"ply", "stl", "obj", "off", "xyz", "csv", "txt"};
    case What::kOpenLesson: return {"toml"};
    case What::kSavePoints: return {"xyz", "csv"};
    case What::kSavePicture: return {"png"};
    case What::kExportTable: return {"csv", "json"};
    case What::kNone: break;
  }
  return {};
}

/// Where a new file would go, in the class's folder of results.
std::string proposed(Shell& shell, What what) {
  const std::string ending = "." + endings_of(what).front();
  if (what == What::kSavePoints) return shell.new_file("points", ending);
  if (what == What::kExportTable) return shell.new_file(shell.app().cover()->file_name(), ending);
  return shell.new_file(shell.session().lesson().id, ending);
}

/// Does what was asked for, at a path that may be replaced. Returns what is wrong, or an empty text.
std::string done_with(Shell& shell, What what, const std::string& path) {
  const auto endings = endings_of(what);
  if (saves(what) && std::find(endings.begin(), endings.end(), ending_of(path)) == endings.end())
    return std::string("The name must end in .") + endings.front() + (endings.size() > 1 ? " or ." + endings[1] : "") +
           '.';
  switch (what) {
    case What::kOpenPoints: shell.open_points(path); break;
    case What::kOpenLesson: shell.open_lesson_file(path); break;
    case What::kSavePoints: shell.save_points(path); break;
    case What::kSavePicture: shell.picture_wanted = path; break;
    case What::kExportTable: shell.export_table(path); break;
    case What::kNone: break;
  }
  return {};
}

/// ~/ is the home.
std::string with_home(std::string path) {
  const char* const home = std::getenv("HOME");
  if (home != nullptr && path.starts_with("~/")) path.replace(0, 1, home);
  return path;
}

/// Opens or saves; a file that is there is only replaced by a second press.
void use_card(Shell& shell) {
  FileCard& card = shell.file_card;
  const std::string path = with_home(card.path);
  std::error_code error;
  const bool there = std::filesystem::exists(path, error);
  card.wrong.clear();
  if (path.empty()) return;
  if (!saves(card.what) && !there) return static_cast<void>(card.wrong = "There is no such file.");
  if (saves(card.what) && there && !card.replaces) return static_cast<void>(card.replaces = true);
  const What what = card.what;
  if ((card.wrong = done_with(shell, what, path)).empty()) card = {};
}

}  // namespace

void ask_path(Shell& shell, What what) {
  const std::string path = saves(what) ? proposed(shell, what) : std::string();
  if (saves(what) && path.empty()) return;  // the notice says why
  shell.file_card = {.what = what, .path = path, .opened = true};
  if (open_portal(card_title(what), endings_of(what), saves(what), path))
    shell.file_card.opened = false, shell.dialog_open = true;
}

bool poll_dialog(Shell& shell) {
  if (!shell.dialog_open) return false;
  const PortalAnswer answer = portal_answer();
  if (answer.kind == PortalAnswer::Kind::kWaits) return true;
  shell.dialog_open = false;
  if (answer.kind == PortalAnswer::Kind::kNone) shell.file_card.opened = true;  // no portal answers: a path is typed
  if (answer.kind == PortalAnswer::Kind::kCancelled) shell.file_card = {};
  if (answer.kind == PortalAnswer::Kind::kChosen) {
    const What what = shell.file_card.what;
    shell.file_card = {};
    if (const std::string wrong = done_with(shell, what, answer.path); !wrong.empty()) shell.notice = wrong;
  }
  shell.measured_anew = true;
  return false;
}

void draw_file_card(Shell& shell, const app::Rect& window) {
  FileCard& card = shell.file_card;
  if (card.what == What::kNone || shell.dialog_open) return;
  const app::Look& look = shell.app().look();
  const float width = std::min(look.px(560), window.width - 32), pad = 24;
  const app::Rect rect{window.x + (window.width - width) / 2, window.y + std::max(8.0f, window.height * 0.2f), width,
                       shell.file_card_height};
  const app::Pane pane("##file card", window, app::Pane::Kind::kOver);
  ImDrawList* const list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height},
                      app::with_alpha(look->ground, 0.75f));
  list->AddRectFilled({rect.x, rect.y}, {rect.x + width, rect.y + rect.height}, look->panel, 8);
  list->AddRect({rect.x, rect.y}, {rect.x + width, rect.y + rect.height}, look->line, 8, 0, 1);
  Column column(look, rect.x + pad, rect.y + pad - 4, width - 2 * pad);
  column.title(card_title(card.what));
  column.words(says_of(card.what), Face::kRegular, 13, look->muted);
  column.gap(12);
  ImGui::PushFont(look.font(Face::kRegular), app::font_size(look, Face::kRegular, 14));
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  ImGui::SetNextItemWidth(column.width());
  ImGui::PushStyleColor(ImGuiCol_Border, look->muted);
  const bool entered =
      ImGui::InputText("##path", card.path.data(), card.path.capacity() + 1,
                       ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_EnterReturnsTrue, &grow, &card.path);
  if (ImGui::IsItemEdited()) card.replaces = false, card.wrong.clear();
  if (card.opened && !ImGui::IsItemActive()) ImGui::SetKeyboardFocusHere(-1), shell.measured_anew = true;
  else card.opened = false;
  const float height = ImGui::GetItemRectSize().y;
  app::offer_field("The file's path");
  ImGui::PopStyleColor();
  ImGui::PopFont();
  column.gap(height + 12);
  const std::string says = card.replaces ? "That file is there already. Replace it?" : card.wrong;
  const std::vector<RowButton> row{{"file cancel", "Cancel", app::ButtonKind::kOutlined},
                                   {"file do",
                                    card.replaces      ? "Replace"
                                    : saves(card.what) ? "Save"
                                                       : "Open",
                                    app::ButtonKind::kPrimary, !card.path.empty()}};
  const int clicked = draw_row(column, says, look->wrong_text, row);
  const float wanted = column.y() - rect.y + pad;
  if (wanted != shell.file_card_height) shell.file_card_height = wanted, shell.measured_anew = true;
  if (clicked == 0) card = {};
  else if (clicked == 1 || entered) use_card(shell);
}

}  // namespace snug::desktop
