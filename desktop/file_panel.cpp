// The file of the scene on the stage, edited here and checked as one types.
#include <algorithm>
#include <string>

#include "desktop/column.hpp"
#include "desktop/prose_panel.hpp"
#include "desktop/typing.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kFewestLines = 8;

/// Draws the text field; what is typed is on the stage at once.
void draw_file_text(Shell& shell, Column& column, const lesson::StageFile& file, float height) {
  const app::Look& look = column.look();
  std::string& text = shell.file_text;
  ImGui::PushFont(look.font(Face::kMono), app::font_size(look, Face::kMono, 13));
  ImGui::PushID("scene file");
  if (!shell.file_typing && text != file.typed) text = file.typed;  // undone, or another situation's
  ImGui::SetCursorScreenPos({column.x(), column.y()});
  const bool typed = ImGui::InputTextMultiline("##text", text.data(), text.capacity() + 1, {column.width(), height},
                                               ImGuiInputTextFlags_CallbackResize, &grow, &text);
  shell.file_typing = ImGui::IsItemActive();
  const bool left = ImGui::IsItemDeactivated();
  app::offer_field("The stage's file");
  ImGui::PopID();
  ImGui::PopFont();
  column.gap(height);
  if (typed) shell.tell(shell.session().stage().set_file(text));
  if (left) shell.session().stage().end_typing();
}

}  // namespace

void draw_file(Shell& shell, Column& column, float height) {
  const auto file = shell.session().stage().subject().file();
  if (!file) return;
  const app::Look& look = column.look();
  const float top = column.y();
  column.title("The stage's file");
  column.words(
      "Change a number, add an effect: the stage answers at once. Bodies with at_points stand where you drag them.",
      Face::kRegular, 13, look->muted);
  column.gap(8);
  const float line = look.px(20);
  const float below = file->mistakes.empty() ? 0 : line * (static_cast<float>(file->mistakes.size()) * 2 + 2);
  draw_file_text(shell, column, *file, std::max(kFewestLines * line, height - (column.y() - top) - below));
  if (file->mistakes.empty()) return;
  column.gap(8);
  column.words(file->heading(), Face::kSemiBold, 13, look->wrong_text);
  for (const std::string& mistake : file->mistakes) column.words(mistake, Face::kMono, 12, look->wrong_text);
}

}  // namespace snug::desktop
