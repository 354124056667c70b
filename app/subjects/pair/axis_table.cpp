#include "app/subjects/pair/axis_table.hpp"

#include <array>
#include <cstdio>
#include <string>

#include "app/shown.hpp"
#include "app/subjects/pair/shown.hpp"
#include "app/widgets.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;

constexpr float kCell = 12, kRow = 24;
constexpr std::array<const char*, 4> kHeads{"distance", "r_A", "r_B", "separation"};
constexpr std::array<float, 4> kRight{0.42f, 0.575f, 0.73f, 1.0f};  // each column's end, as a fraction of the width

/// The tested axes, by their row in the table.
std::vector<const Axis*> rows_of(const std::vector<Axis>& seen, int dim) {
  std::vector<const Axis*> rows(lesson::axis_names(dim).size(), nullptr);
  for (const Axis& axis : seen) rows[lesson::axis_index(dim, axis.axis)] = &axis;
  return rows;
}

struct AxisTable {
  const Look& look;
  ImDrawList* list;
  float x, width;

  /// The right end of a column of figures.
  [[nodiscard]] float right(int column) const { return x + width * kRight[column]; }

  void head(float y) const {
    for (int i = 0; i < 4; ++i)
      text_right(list, look, Face::kRegular, 11, {right(i), y + look.px(4)}, look->muted, kHeads[i]);
  }

  void row(float y, const lesson::AxisName& name, const Axis* axis, bool lit) const {
    const float middle = middle_of(y + look.px(kRow) / 2, look.px(kCell));
    if (lit) list->AddRectFilled({x - 6, y}, {x + width + 6, y + look.px(kRow)}, with_alpha(look->current, 0.14f), 4);
    const bool separates = axis != nullptr && axis->separates;
    const Color ink = separates ? look->wrong_text : axis != nullptr ? look->ink : look->muted;
    text(list, look, lit ? Face::kMonoBold : Face::kMono, kCell, {x, middle}, ink, name.text);
    if (axis == nullptr) return;
    if (axis->skipped)
      return text_right(list, look, Face::kRegular, 11, {x + width, middle}, look->muted, "parallel: none");
    const std::array<double, 4> figures{axis->distance, axis->radius_a, axis->radius_b, axis->axis.gap};
    for (int i = 0; i < 4; ++i)
      text_right(list, look, i == 3 ? Face::kMonoBold : Face::kMono, kCell, {right(i), middle},
                 i == 3 ? ink : look->ink, lesson::number_text(figures[i], i == 3 ? 4 : 3));  // as elsewhere
  }
};

/// Draws the frame of a row that can be chosen, and returns whether it was clicked.
bool choice_clicked(const AxisTable& table, const lesson::Session& session, int row, float y) {
  const Look& look = table.look;
  const float height = look.px(kRow);
  ImGui::SetCursorScreenPos({table.x - 6, y});
  ImGui::PushID(row);
  const bool clicked = ImGui::InvisibleButton("axis", {table.width + 12, height});
  const bool hovered = ImGui::IsItemHovered();
  ImGui::PopID();
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const lesson::Answer* picked = session.picked();
  const bool chosen = picked != nullptr && picked->value == row;
  table.list->AddRect({table.x - 6, y + 1}, {table.x + table.width + 6, y + height - 1},
                      with_alpha(look->current, chosen || hovered ? 0.9f : 0.35f), 4, 0, chosen ? 2.5f : 1.0f);
  return clicked;
}

/// Draws the table and returns its height.
float draw_table(const Look& look, lesson::Session& session, ImVec2 at, float width) {
  const int dim = session.dim();
  const std::vector<Axis> seen = lesson::axes_seen(steps_shown(session));
  const auto rows = rows_of(seen, dim);
  const int at_hand = lit_row(session);
  const auto names = lesson::axis_names(dim);
  const AxisTable table{look, ImGui::GetWindowDrawList(), at.x, width};
  const lesson::Asked* asked = session.asked();
  const bool choosing = asked != nullptr && asked->on_axes;
  table.head(at.y);
  float y = at.y + look.px(kRow);
  for (int i = 0; i < static_cast<int>(names.size()); ++i, y += look.px(kRow)) {
    if (choosing && choice_clicked(table, session, i, y)) {
      static_cast<void>(session.pick({lesson::Answer::Kind::kChoice, i}));
      return y - at.y;  // the click may have closed the question
    }
    table.row(y, names[i], rows[i], i == at_hand);
  }
  return y - at.y;
}

}  // namespace

int lit_row(const lesson::Session& session) {
  const auto axis = lesson::axis_at(steps_shown(session));
  return axis ? lesson::axis_index(session.dim(), axis->axis) : -1;
}

float draw_axis_panel(const Look& look, lesson::Session& session, ImVec2 at, float width) {
  if (lesson::axes_seen(lesson::pair_run(session.run(0)).trace()).empty()) return 0;
  text(ImGui::GetWindowDrawList(), look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted, "The axes");
  const float head = look.px(24);
  return head + draw_table(look, session, {at.x, at.y + head}, width);
}

}  // namespace snug::app
