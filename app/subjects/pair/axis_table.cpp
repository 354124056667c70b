#include "app/subjects/pair/axis_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <utility>

#include "app/marks.hpp"
#include "app/shown.hpp"
#include "app/subjects/pair/shown.hpp"
#include "app/subjects/pair/table_unit.hpp"
#include "app/widgets.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

namespace snug::app {
namespace {

using Axis = query::AxisTested<double, 3>;

constexpr float kCell = 12, kSmallCell = 10, kHead = 11, kRow = 21,
                kBetween = 7;  // the last: between columns, at least
constexpr std::array<const char*, 4> kHeads{"distance", "r_A", "r_B", "separation"};

/// The tested axes, by their row in the table.
std::vector<const Axis*> rows_of(const std::vector<Axis>& seen, int dim) {
  std::vector<const Axis*> rows(lesson::axis_names(dim).size(), nullptr);
  for (const Axis& axis : seen) rows[lesson::axis_index(dim, axis.axis)] = &axis;
  return rows;
}

/// A number with a power of ten in few signs, "2.22e-16"; any other as it is.
std::string brief_text(double value, std::string text) {
  if (text.find("×") == std::string::npos) return text;
  std::array<char, 32> brief{};
  std::snprintf(brief.data(), brief.size(), "%.2e", std::abs(value));
  std::string number = brief.data();
  const std::size_t power = number.find('e') + 2;  // after its sign
  while (power + 1 < number.size() && number[power] == '0') number.erase(power, 1);
  return (value < 0 ? "−" : "") + number;
}

/// A row's figures, as they are on the stage and in the sentence; brief: where those do not fit.
std::array<std::string, 4> figures_of(const Axis& axis, bool brief) {
  const auto shown = [&](double value, std::string text) {
    return brief ? brief_text(value, std::move(text)) : std::move(text);
  };
  const auto along = [&](double length) { return shown(length, lesson::length_along(axis, length)); };
  return {along(axis.distance), along(axis.radius_a), along(axis.radius_b),
          shown(axis.axis.gap, lesson::gap_text(axis.axis.gap))};
}

/// Where the columns of figures end: as wide as their figures, at equal distances.
struct Columns {
  std::array<float, 4> ends{};  // from the table's left
  float cell = kCell;           // the size of the figures, smaller if there are so many digits that they need it
  bool brief = false;           // powers of ten in few signs, if that is not enough

  Columns(const Look& look, std::span<const lesson::AxisName> names, std::span<const Axis> seen, float width) {
    if (place(look, names, seen, width) >= kBetween) return;
    cell = kSmallCell;
    if (place(look, names, seen, width) >= kBetween) return;
    brief = true;
    place(look, names, seen, width);
  }

 private:
  /// Returns the distance between columns.
  float place(const Look& look, std::span<const lesson::AxisName> names, std::span<const Axis> seen, float width) {
    std::array<float, 4> widths{};
    float sum = 0, name_width = 0;
    for (int i = 0; i < 4; ++i) {
      widths[i] = measure(look, Face::kRegular, kHead, kHeads[i]).x;
      for (const Axis& axis : seen)
        if (!axis.skipped)
          widths[i] = std::max(
              widths[i], measure(look, i == 3 ? Face::kMonoBold : Face::kMono, cell, figures_of(axis, brief)[i]).x);
      sum += widths[i];
    }
    for (const lesson::AxisName& name : names)
      name_width = std::max(name_width, measure(look, Face::kMonoBold, cell, name.text).x);
    const float between = (width - name_width - sum) / 4;
    ends[3] = width;
    for (int i = 3; i > 0; --i) ends[i - 1] = ends[i] - widths[i] - between;
    return between;
  }
};

struct AxisTable {
  const Look& look;
  ImDrawList* list;
  float x, width;
  Columns columns;

  /// The right end of a column of figures.
  [[nodiscard]] float right(int column) const { return x + columns.ends[column]; }

  /// The columns' names, above rows that end there; where one has scrolled past them, over the first row in sight.
  void head(float y, float rows_end) const {
    const float top = ImGui::GetWindowPos().y, height = look.px(kRow);
    if (y < top && rows_end > top + 2 * height) {
      y = top;
      list->AddRectFilled({x - 6, y}, {x + width + 6, y + height}, look->panel);
    }
    for (int i = 0; i < 4; ++i)
      text_right(list, look, Face::kRegular, kHead, {right(i), y + look.px(4)}, look->muted, kHeads[i]);
  }

  void row(float y, const lesson::AxisName& name, const Axis* axis, bool lit) const {
    const float cell = columns.cell, middle = middle_of(y + look.px(kRow) / 2, look.px(cell));
    if (lit) list->AddRectFilled({x - 6, y}, {x + width + 6, y + look.px(kRow)}, with_alpha(look->current, 0.14f), 4);
    const bool separates = axis != nullptr && axis->separates;
    const Color ink = separates ? look->wrong_text : axis != nullptr ? look->ink : look->muted;
    text(list, look, lit ? Face::kMonoBold : Face::kMono, cell, {x, middle}, ink, name.text);
    if (axis == nullptr) return;
    if (name.kind == query::AxisKind::kEdgeEdge) length_bar(y, name, axis->length);
    if (axis->skipped)
      return text_right(list, look, Face::kRegular, kHead, {x + width, middle}, look->muted, "parallel: none");
    const std::array<std::string, 4> figures = figures_of(*axis, columns.brief);
    for (int i = 0; i < 4; ++i)
      text_right(list, look, i == 3 ? Face::kMonoBold : Face::kMono, cell, {right(i), middle}, i == 3 ? ink : look->ink,
                 figures[i]);
  }

  /// Under the name of two edges, how long their cross product is: as wide as the name where they are perpendicular.
  void length_bar(float y, const lesson::AxisName& name, double length) const {
    const float whole = measure(look, Face::kMonoBold, columns.cell, name.text).x, foot = y + look.px(kRow) - 2;
    list->AddRectFilled({x, foot}, {x + whole, foot + 2}, look->track);
    list->AddRectFilled({x, foot}, {x + whole * static_cast<float>(std::min(1.0, length)), foot + 2}, look->examined);
  }
};

/// Draws the frame of a row that can be chosen.
void draw_choice(const AxisTable& table, const lesson::Session& session, int row, float y, bool hovered) {
  const Look& look = table.look;
  if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const lesson::Answer* picked = session.conversation().picked();
  const bool chosen = picked != nullptr && is_picked(*session.conversation().asked(), *picked, row);
  table.list->AddRect({table.x - 6, y + 1}, {table.x + table.width + 6, y + look.px(kRow) - 1},
                      with_alpha(look->current, chosen || hovered ? 0.9f : 0.35f), 4, 0, chosen ? 2.5f : 1.0f);
}

/// A cross before a row that says what is not so.
void draw_wrong_row(const AxisTable& table, float y) {
  cross(table.list, {table.x - 12, y + table.look.px(kRow) / 2}, 3.5f, table.look->wrong, 2);
}

/// The rows whose verdict is not the exact one, of a naive test.
std::vector<bool> wrong_rows(const lesson::Session& session) {
  std::vector<bool> wrong(lesson::axis_names(session.stage().subject().dim()).size(), false);
  const lesson::PairRun& run = lesson::pair_run(session.player().run(0));
  for (int i = 0; i < session.player().step(); ++i) {
    const auto* row = std::get_if<Axis>(&run.trace()[i].step.fact);
    if (row != nullptr && run.truth(i) != nullptr && lesson::is_wrong(*row, *run.truth(i)))
      wrong[lesson::axis_index(session.stage().subject().dim(), row->axis)] = true;
  }
  return wrong;
}

/// What the pointer, a finger or the keyboard does on a row.
Touch touch_row(const AxisTable& table, const lesson::AxisName& name, float y) {
  const Rect rect{table.x - 6, y, table.width + 12, table.look.px(kRow)};
  return touch_area(("axis " + name.text).c_str(), rect, name.text);
}

/// Scrolls the panel to the row of the step where that is out of sight, once for each step that moves to another row
/// and each time that the panel gets another height.
void follow_row(const Look& look, int row, float y) {
  ImGuiStorage& storage = *ImGui::GetStateStorage();
  int& before = *storage.GetIntRef(ImGui::GetID("row followed"), -1);
  float& room = *storage.GetFloatRef(ImGui::GetID("in a height of"));
  if (row == before && room == ImGui::GetWindowHeight()) return;
  before = row;
  room = ImGui::GetWindowHeight();
  if (row < 0) return;
  const float height = look.px(kRow), top = ImGui::GetWindowPos().y + height,  // below the head
      bottom = ImGui::GetWindowPos().y + room;
  if (y < top || y + 2 * height > bottom) ImGui::SetScrollFromPosY(y + height / 2 - ImGui::GetWindowPos().y);
}

/// Draws the table and returns its height.
float draw_table(const Look& look, lesson::Session& session, const TableUnit& unit, ImVec2 at, float width,
                 AxisLight* light) {
  const int dim = session.stage().subject().dim();
  std::vector<Axis> seen = lesson::axes_seen(steps_shown(session));
  for (Axis& axis : seen)
    for (double* length : {&axis.distance, &axis.radius_a, &axis.radius_b, &axis.axis.gap}) *length = unit.in(*length);
  const auto rows = rows_of(seen, dim);
  const int at_hand = lit_row(session), lit = light != nullptr ? light->row(dim) : -1;
  const auto names = lesson::axis_names(dim);
  const std::vector<bool> wrong = wrong_rows(session);
  const AxisTable table{look, ImGui::GetWindowDrawList(), at.x, width, Columns(look, names, seen, width)};
  const lesson::Asked* asked = session.conversation().asked();
  const bool choosing = asked != nullptr && asked->on_axes;
  if (light != nullptr) light->pointed = -1;
  float y = at.y + look.px(kRow);
  for (int i = 0; i < static_cast<int>(names.size()); ++i, y += look.px(kRow)) {
    const Touch touch = choosing || light != nullptr ? touch_row(table, names[i], y) : Touch{};
    if (light != nullptr && (touch.hovered || touch.focused)) light->pointed = i;
    if (choosing) draw_choice(table, session, i, y, touch.hovered);
    if (choosing && touch.clicked) {
      static_cast<void>(session.conversation().pick(lesson::OneChoice{i}));
      return y - at.y;  // the click may have closed the question
    }
    if (light != nullptr && touch.clicked) light->tapped = light->tapped == i ? -1 : i;
    table.row(y, names[i], rows[i], i == (lit >= 0 ? lit : at_hand));
    if (wrong[i]) draw_wrong_row(table, y);
    if (i == at_hand) follow_row(look, i, y);
  }
  table.head(at.y, y);
  return y - at.y;
}

}  // namespace

int lit_row(const lesson::Session& session) {
  const auto axis = lesson::axis_at(steps_shown(session));
  return axis ? lesson::axis_index(session.stage().subject().dim(), axis->axis) : -1;
}

float draw_axis_panel(const Look& look, lesson::Session& session, const TableUnit& unit, ImVec2 at, float width,
                      AxisLight* light) {
  if (lesson::axes_seen(lesson::pair_run(session.player().run(0)).trace()).empty()) {
    if (light != nullptr) light->pointed = light->tapped = -1;  // no row is there to be left or tapped again
    return 0;
  }
  text(ImGui::GetWindowDrawList(), look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted,
       unit.power == 0 ? "The axes" : "The axes, in " + unit.words());
  const float head = look.px(24);
  return head + draw_table(look, session, unit, {at.x, at.y + head}, width, light);
}

}  // namespace snug::app
