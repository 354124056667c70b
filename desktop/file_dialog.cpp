#include "desktop/file_dialog.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/cover.hpp"
#include "desktop/card_parts.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/steps.hpp"
#include "desktop/column.hpp"
#include "desktop/portal.hpp"
#include "desktop/shell.hpp"
#include "desktop/typing.hpp"

namespace snug::desktop {
namespace {

using app::Face;
using What = FileCard::What;

/// A text to type, called by that name. Returns whether Enter was pressed in it.
bool draw_field(Column& column, const char* id, const char* name, std::string& text) {
  const app::Look& look = column.look();
  ImGui::PushFont(look.font(Face::kRegular), app::font_size(look, Face::kRegular, 14));
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  ImGui::SetNextItemWidth(column.width());
  ImGui::PushStyleColor(ImGuiCol_Border, look->muted);
  const bool entered =
      ImGui::InputText(id, text.data(), text.capacity() + 1,
                       ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_EnterReturnsTrue, &grow, &text);
  column.gap(ImGui::GetItemRectSize().y + 12);
  app::offer_field(name);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  return entered;
}

bool saves(What what) { return what != What::kOpenPoints && what != What::kOpenLesson; }

const char* card_title(What what) {
  switch (what) {
    case What::kOpenPoints: return "Open points";
    case What::kOpenLesson: return "Open a lesson's file";
    case What::kSavePoints: return "Save points";
    case What::kSavePicture: return "Save picture";
    case What::kExportTable: return "Export table";
    case What::kHandIn: return "Hand in";
    case What::kNone: break;
  }
  return "";
}

const char* says_of(What what) {
  switch (what) {
    case What::kOpenPoints: return "PLY, STL, OBJ, OFF, or rows of two or three numbers (XYZ, CSV, TXT).";
    case What::kOpenLesson: return "A TOML file, which opens in a window of its own.";
    case What::kSavePoints: return "Rows of numbers: the name ends in .xyz or .csv.";
    case What::kSavePicture: return "Pixels, shapes with words as text, or steps as an animation.";
    case What::kExportTable: return "The name ends in .csv or .json.";
    case What::kHandIn:
      return "There it cannot be saved. Name a folder that is yours, or a stick: the name ends in .json.";
    case What::kNone: break;
  }
  return "";
}

std::vector<std::string> endings_of(What what) {
  switch (what) {
    case What::kOpenPoints: return {"ply", "stl", "obj", "off", "xyz", "csv", "txt"};
    case What::kOpenLesson: return {"toml"};
    case What::kSavePoints: return {"xyz", "csv"};
    case What::kSavePicture: return {"png", "svg", "gif"};
    case What::kExportTable: return {"csv", "json"};
    case What::kHandIn: return {"json"};
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

bool shows_chart(Shell& shell) {
  const app::Cover* const cover = shell.app().cover();
  return cover != nullptr && cover->shown();
}

/// Has the picture drawn. Returns what is wrong, or an empty text.
std::string take_picture(Shell& shell, const std::string& path) {
  constexpr int kMost = 200;
  PictureHow how = shell.file_card.how;
  if (ending_of(path) == "gif") {
    how.steps = steps_of(shell.file_card.steps);
    const int steps = shell.session().player().steps();
    if (shows_chart(shell)) return "A chart has no steps: the name must end in .png or .svg.";
    if (!how.steps || (*how.steps)[1] > steps || (*how.steps)[1] - (*how.steps)[0] >= kMost)
      return "Steps are a range such as 0-12, up to " + std::to_string(steps) + ", and at most " +
             std::to_string(kMost) + '.';
  }
  shell.picture_wanted = path, shell.picture_how = how;
  return {};
}

/// How a picture is drawn: its format, which is its name's ending, and what else can be chosen. Returns whether Enter
/// was pressed in a field.
bool draw_how(Shell& shell, Column& column) {
  FileCard& card = shell.file_card;
  PictureHow& how = card.how;
  const std::string ending = ending_of(card.path);
  const auto endings = endings_of(card.what);
  const bool chart = shows_chart(shell), gif = ending == "gif";
  const auto at = std::find(endings.begin(), endings.end(), ending);
  const int format = column.buttons("format", {"PNG", "SVG", "GIF"}, static_cast<int>(at - endings.begin()),
                                    {true, true, !chart && shell.session().player().steps() > 0});
  if (format >= 0) {
    card.path = std::filesystem::path(card.path).replace_extension(endings[static_cast<std::size_t>(format)]).string();
    card.replaces = false, card.wrong.clear();
  }
  constexpr std::array kScales{1, 2, 4};
  const auto scale = std::find(kScales.begin(), kScales.end(), how.scale) - kScales.begin();
  if (ending == "png")
    if (const int one = column.buttons("scale", {"1x", "2x", "4x"}, static_cast<int>(scale)); one >= 0)
      how.scale = kScales[static_cast<std::size_t>(one)];
  const bool dark = how.theme ? *how.theme == app::Theme::kDark : shell.app().settings().theme == app::Theme::kDark;
  if (const int one = column.buttons("theme", {"Light", "Dark"}, dark ? 1 : 0); one >= 0)
    how.theme = one == 1 ? app::Theme::kDark : app::Theme::kLight;
  if (!chart)
    if (const int one = column.buttons("labels", {"With names", "Without names"}, how.labels ? 0 : 1); one >= 0)
      how.labels = one == 0;
  if (!gif)
    if (const int one = column.buttons("ground", {"With a ground", "Transparent"}, how.transparent ? 1 : 0); one >= 0)
      how.transparent = one == 1;
  return gif && draw_field(column, "##steps", "Steps, the first and the last", card.steps);
}

/// Does what was asked for, at a path that may be replaced. Returns what is wrong, or an empty text.
std::string done_with(Shell& shell, What what, const std::string& path) {
  const auto endings = endings_of(what);
  if (saves(what) && std::find(endings.begin(), endings.end(), ending_of(path)) == endings.end())
    return "The name must end in ." + endings[0] + (endings.size() > 2 ? ", ." + endings[1] : "") +
           (endings.size() > 1 ? " or ." + endings.back() : "") + '.';
  switch (what) {
    case What::kOpenPoints: shell.open_points(path); break;
    case What::kOpenLesson: shell.open_lesson_file(path); break;
    case What::kSavePoints: shell.save_points(path); break;
    case What::kSavePicture: return take_picture(shell, path);
    case What::kExportTable: shell.export_table(path); break;
    case What::kHandIn: return shell.hand_in_as(path) ? std::string() : std::exchange(shell.notice, {});
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
  if (what == What::kSavePicture) {  // the system's dialog would not ask how it is drawn
    shell.file_card.how.theme = shell.app().settings().theme;
    shell.file_card.steps = "0-" + std::to_string(shell.session().player().steps());
    return;
  }
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
  bool entered = draw_field(column, "##path", "The file's path", card.path);
  if (ImGui::IsItemEdited()) card.replaces = false, card.wrong.clear();
  if (card.opened && !ImGui::IsItemActive()) ImGui::SetKeyboardFocusHere(-1), shell.measured_anew = true;
  else card.opened = false;
  if (card.what == What::kSavePicture) entered = draw_how(shell, column) || entered;
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
