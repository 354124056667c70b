#include "app/subjects/pair/frame_panel.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/subjects/pair/shown.hpp"
#include "app/subjects/pair/table_unit.hpp"
#include "app/widgets.hpp"
#include "lesson/formula.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

namespace snug::app {
namespace {

constexpr float kEntry = 10, kLine = 18, kNames = 24, kFormula = 11;

/// A number of R, t or the half extents in at most seven signs: "0.422", "−12.5", "3e-07" where edges are nearly
/// parallel.
std::string entry_text(double value) {
  const double size = std::abs(value);
  if (size == 0) return "0";
  std::array<char, 32> text{};
  const char* format = size < 0.0005 ? "%.0e" : size < 10 ? "%.3f" : size < 1e4 ? "%.1f" : "%.1e";
  std::snprintf(text.data(), text.size(), format, size);
  return (value < 0 ? "−" : "") + std::string(text.data());
}

constexpr std::string_view kUnknown = "—";

using Related = query::FramesRelated<double, 3>;

/// How the frames are related, null before the step that computes it.
const Related* related(const lesson::Session& session) { return last_fact<Related>(steps_shown(session)); }

bool tests_axes(const lesson::Session& session) {
  return !lesson::axes_seen(lesson::pair_run(session.player().run(0)).trace()).empty();
}

std::string title_in(const TableUnit& unit) {
  return unit.power == 0 ? "B in A's frame: R, t; half extents a, b" : "B in A's frame; t, a, b in " + unit.words();
}

/// "A x"
std::string axis_of(char box, int i) { return {box, ' ', "xyz"[i]}; }

/// R with t and a at its right and b below, in columns of equal width.
struct FrameTable {
  const Look& look;
  ImDrawList* list;
  ImVec2 at;
  float width;
  int dim;
  lesson::RowEntries lit;

  [[nodiscard]] float column() const { return (width - look.px(kNames)) / static_cast<float>(dim + 2); }
  [[nodiscard]] float right(int i) const { return at.x + look.px(kNames) + static_cast<float>(i + 1) * column(); }
  [[nodiscard]] float top(int row) const { return at.y + static_cast<float>(row) * look.px(kLine); }

  void head() const {
    for (int i = 0; i < dim; ++i) name(right(i), 0, axis_of('B', i));
    name(right(dim), 0, "t");
    name(right(dim + 1), 0, "a");
    for (int i = 0; i < dim; ++i)
      text(list, look, Face::kRegular, kEntry, {at.x, top(i + 1) + look.px(3)}, look->muted, axis_of('A', i));
    text(list, look, Face::kRegular, kEntry, {at.x, top(dim + 1) + look.px(3)}, look->muted, "b");
    rule(list, at.x, top(dim + 1), width, look->line);
  }
  void name(float right_end, int row, const std::string& words) const {
    text_right(list, look, Face::kRegular, kEntry, {right_end, top(row) + look.px(3)}, look->muted, words);
  }
  void number(int row, int i, double value, bool is_lit, bool known) const {
    const float y = top(row + 1);
    if (is_lit)
      list->AddRectFilled({right(i) - column() + 5, y + 1}, {right(i) + 3, y + look.px(kLine) - 1},
                          with_alpha(look->examined, 0.28f), 3);
    text_right(list, look, is_lit ? Face::kMonoBold : Face::kMono, kEntry, {right(i), y + look.px(3)},
               known ? look->ink : look->muted, known ? entry_text(value) : kUnknown);
  }
};

/// Whether the open question is answered by entries of R.
bool asks_for_entries(const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  return asked != nullptr && asked->kind != nullptr && asked->kind->name.starts_with("entries");
}

/// The entries of R as buttons.
void draw_choices(const FrameTable& table, lesson::Session& session) {
  for (int choice = 0; choice < table.dim * table.dim; ++choice) {
    const int i = choice / table.dim, j = choice % table.dim;
    const Rect rect{table.right(j) - table.column() + 5, table.top(i + 1) + 1, table.column() - 2,
                    table.look.px(kLine) - 2};
    const std::string name = "R" + std::to_string(i + 1) + std::to_string(j + 1);
    const Touch touch = touch_area(("entry " + name).c_str(), rect, name);
    const lesson::Answer* picked = session.conversation().picked();
    const bool chosen = picked != nullptr && is_picked(*session.conversation().asked(), *picked, choice);
    if (touch.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    table.list->AddRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height},
                        with_alpha(table.look->current, chosen || touch.hovered ? 0.9f : 0.35f), 3, 0,
                        chosen ? 2.5f : 1.0f);
    if (touch.clicked) return static_cast<void>(session.conversation().pick(lesson::OneChoice{choice}));
  }
}

void draw_numbers(const FrameTable& table, const lesson::BoxPair& pair, const TableUnit& unit, const Related* frames) {
  const auto bit = [](auto mask, int i) { return (mask >> i & 1) != 0; };
  const Related known = frames != nullptr ? *frames : Related{};
  for (int i = 0; i < table.dim; ++i) {
    for (int j = 0; j < table.dim; ++j)
      table.number(i, j, known.rotation(i, j), bit(table.lit.rotation, 3 * i + j), frames != nullptr);
    table.number(i, table.dim, unit.in(known.translation[i]), bit(table.lit.translation, i), frames != nullptr);
    table.number(i, table.dim + 1, unit.in(pair.boxes[0].half_extents[i]), bit(table.lit.half_a, i), true);
    table.number(table.dim, i, unit.in(pair.boxes[1].half_extents[i]), bit(table.lit.half_b, i), true);
  }
}

/// Draws the three formulas of a row and returns the room for them, which is the same before any row is meant.
float draw_formulas(const Look& look, int dim, int row, bool asks, ImVec2 at) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  constexpr int kLines = 4;
  const float room = kLines * look.px(kLine);
  if (row < 0) {
    text(list, look, Face::kRegular, kFormula, at, look->muted,
         asks ? "Pick entries of R, here or below." : "Point at a row to see its formulas.");
    return room;
  }
  const lesson::RowFormulas formulas = lesson::row_formulas(dim, row);
  float y = at.y;
  const auto line = [&](std::string_view name, const std::string& tex) {
    text(list, look, Face::kRegular, kFormula, {at.x, y}, look->muted, name);
    text(list, look, Face::kMono, kFormula, {at.x + look.px(54), y}, look->ink,
         lesson::plain_formula(tex).value_or(std::string()));
    y += look.px(kLine);
  };
  line("distance", formulas.distance);
  line("r_A", formulas.radius_a);
  line("r_B", formulas.radius_b);
  if (lesson::axis_names(dim)[row].kind == query::AxisKind::kEdgeEdge)
    text(list, look, Face::kRegular, kEntry, {at.x, y}, look->muted, "each divided by the axis's length");
  return room;
}

}  // namespace

float draw_frame_panel(const Look& look, lesson::Session& session, const AxisLight& light, ImVec2 at, float width) {
  if (!tests_axes(session)) return 0;
  const bool asks = asks_for_entries(session);
  const int dim = session.stage().subject().dim(), lit = light.row(dim),
            row = asks       ? -1
                  : lit >= 0 ? lit
                             : lit_row(session);
  const float head = look.px(22);
  const lesson::BoxPair& pair = lesson::boxes_of(session.stage().subject());
  const TableUnit unit = table_unit(pair);
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(3)}, look->muted, title_in(unit));
  const FrameTable table{look,  list, {at.x, at.y + head},
                         width, dim,  row < 0 ? lesson::RowEntries{} : lesson::row_entries(dim, row)};
  table.head();
  draw_numbers(table, pair, unit, related(session));
  if (asks) draw_choices(table, session);
  const float numbers = head + static_cast<float>(dim + 2) * look.px(kLine) + look.px(6);
  return numbers + draw_formulas(look, dim, row, asks, {at.x, at.y + numbers}) + look.px(8);
}

std::optional<PanelWords> frames_in_words(const lesson::Session& session) {
  if (!tests_axes(session)) return std::nullopt;
  const int dim = session.stage().subject().dim();
  const lesson::BoxPair& pair = lesson::boxes_of(session.stage().subject());
  const TableUnit unit = table_unit(pair);
  const Related* const frames = related(session);
  const auto if_known = [&](auto value) { return frames != nullptr ? entry_text(value()) : std::string(kUnknown); };
  PanelWords words{{.head = {""}, .title = title_in(unit)}};
  std::vector<std::string> last{"b"};
  for (int i = 0; i < dim; ++i) {
    words.table.head.push_back(axis_of('B', i));
    std::vector<std::string>& row = words.table.rows.emplace_back(1, axis_of('A', i));
    for (int j = 0; j < dim; ++j) row.push_back(if_known([&] { return frames->rotation(i, j); }));
    row.push_back(if_known([&] { return unit.in(frames->translation[i]); }));
    row.push_back(entry_text(unit.in(pair.boxes[0].half_extents[i])));
    last.push_back(entry_text(unit.in(pair.boxes[1].half_extents[i])));
  }
  words.table.head.insert(words.table.head.end(), {"t", "a"});
  last.resize(words.table.head.size());
  words.table.rows.push_back(std::move(last));
  return words;
}

}  // namespace snug::app
