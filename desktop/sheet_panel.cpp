// What is handed in of a lab sheet: what was measured and built, and the answers, which are written here.
#include <algorithm>
#include <iterator>
#include <string>

#include "app/marks.hpp"
#include "desktop/cli/sheet_files.hpp"
#include "desktop/column.hpp"
#include "desktop/prose_panel.hpp"
#include "desktop/typing.hpp"
#include "io/text.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kLines = 3;  // of an answer

/// A line with a tick where something is there, and a ring where it is not yet.
void draw_part(Column& column, const std::string& prompt, bool there, const std::string& says) {
  const app::Look& look = column.look();
  const float middle = column.y() + look.px(11);
  if (there) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  else app::ring(column.list(), {column.x() + 6, middle}, 5, look->muted, 1.5f);
  Column beside(look, column.x() + 22, column.y(), column.width() - 22);
  beside.words(prompt, Face::kRegular, 14);
  beside.words(says, Face::kRegular, 13, there ? look->optimum_text : look->muted);
  column.gap(beside.y() - column.y() + 8);
}

/// A text field as wide as the column. Returns whether something was typed.
bool draw_field(Column& column, const std::string& id, std::string_view name, std::string& text, float lines) {
  const app::Look& look = column.look();
  const float height = look.px(20) * lines + 12;
  ImGui::PushFont(look.font(Face::kRegular), app::font_size(look, Face::kRegular, 14));
  ImGui::PushID(id.c_str());
  ImGui::PushStyleColor(ImGuiCol_Border, look->muted);
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  const ImGuiInputTextFlags flags = ImGuiInputTextFlags_CallbackResize;
  bool typed = false;
  if (lines > 1) {
    const ImVec2 size{column.width(), height};
    typed = ImGui::InputTextMultiline("##text", text.data(), text.capacity() + 1, size, flags, &grow, &text);
  } else {
    ImGui::SetNextItemWidth(column.width());
    typed = ImGui::InputText("##text", text.data(), text.capacity() + 1, flags, &grow, &text);
  }
  app::offer_field(name, ImGui::GetID("##text"));  // a field of lines that is out of view has none of its own
  ImGui::PopStyleColor();
  ImGui::PopID();
  ImGui::PopFont();
  column.gap(height + 12);
  return typed;
}

std::string part_says(const SheetWork& work, const std::string& id) {
  const auto found = work.measured.find(id);
  if (found == work.measured.end()) return "Not measured yet";
  const Json& table = found->second.table;
  return std::to_string(table["rows"].size()) + " rows, on " + table["provenance"]["points"].get<std::string>() + ", " +
         found->second.date;
}

/// What is kept, and what is to be said of what stands on the stage.
std::string built_says(Shell& shell, std::size_t task) {
  const auto found = shell.sheet_work().built.find(task);
  const lesson::Grade now = shell.session().grade(task);
  if (found == shell.sheet_work().built.end())
    return "None yet: it is kept as soon as it stands on the stage. " + now.says;
  const auto size = [](const lesson::Rows& rows) {
    return io::counted(std::ssize(rows), "point") + ", written in " +
           io::counted(static_cast<std::int64_t>(lesson::letters_of(rows)), "letter");
  };
  std::string says = "The smallest so far has " + size(found->second) + ".";
  const lesson::Rows rows = shell.session().stage().subject().rows();
  if (!now.done) says += " On the stage: " + now.says;
  else if (rows != found->second) says += " On the stage is another, of " + size(rows) + ".";
  return says;
}

/// What is wider than its field, below it: a field shows no more than a part of a line.
void draw_whole(Column& column, const std::string& text) {
  const app::Look& look = column.look();
  float widest = 0;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    widest = std::max(widest, app::measure(look, Face::kRegular, 14, text.substr(begin, end - begin)).x);
    begin = end + 1;
  }
  if (widest <= column.width() - 16) return;
  column.words(text, Face::kRegular, 13, look->muted);
  column.gap(12);
}

}  // namespace

void draw_sheet(Shell& shell, Column& column) {
  const lesson::Sheet& sheet = *shell.sheet();
  SheetWork& work = shell.sheet_work();
  const app::Look& look = column.look();
  column.title("What you hand in");
  column.words("All of it goes into one file. It is kept here until then.", Face::kRegular, 13, look->muted);
  column.gap(12);
  for (const lesson::Measured& one : sheet.measured) {
    draw_part(column, one.prompt, work.measured.count(one.id) > 0, part_says(work, one.id));
    const std::string button = "show " + one.id;
    if (work.measured.count(one.id) > 0 && column.buttons(button.c_str(), {"Show it"}) == 0)
      shell.show_measured(one.id);
  }
  for (std::size_t i = 0; i < sheet.lesson.tasks.size(); ++i) {
    draw_part(column, "An example of your own", work.built.count(i) > 0, built_says(shell, i));
    if (work.built.count(i) > 0 && column.buttons("back to built", {"Show it"}) == 0)
      shell.tell(shell.session().stage().set_rows(work.built[i]));
  }
  bool typed = false;
  for (std::size_t i = 0; i < sheet.written.size(); ++i) {
    const lesson::Written& one = sheet.written[i];
    column.words(std::to_string(i + 1) + ". " + one.prompt, Face::kRegular, 14);
    column.gap(4);
    const auto answer = work.written.find(one.id);
    std::string text = answer != work.written.end() ? answer->second : std::string();
    const bool changed = draw_field(column, one.id, "Answer " + std::to_string(i + 1), text, kLines);
    draw_whole(column, text);
    if (!changed) continue;
    work.written[one.id] = text;
    typed = true;
  }
  column.words("Your name, if the course asks for it", Face::kRegular, 14);
  column.gap(4);
  typed |= draw_field(column, "student", "Your name", shell.student(), 1);
  if (typed) shell.sheet_changed();
  column.gap(4);
  if (column.buttons("hand in sheet", {std::string(lesson::kHandInWord)}) == 0) shell.hand_in();
  const std::string lacks = shell.sheet_lacks();
  if (!lacks.empty()) column.words(lacks, Face::kRegular, 13, look->muted);
}

}  // namespace snug::desktop
