// The tools: buttons for what the pointer does on the stage, and number fields for exact values.
#include <array>
#include <cmath>
#include <span>

#include "desktop/cli/files.hpp"
#include "desktop/column.hpp"
#include "desktop/prose_panel.hpp"
#include "lesson/door_words.hpp"
#include "lesson/figures.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/situations.hpp"

namespace snug::desktop {
namespace {

using app::Face;

/// ImGui number fields side by side, each after its name, in the palette and with tabular figures.
class Fields {
 public:
  Fields(Column& column, const std::string& id, int count) : column_(column), id_(id), count_(count) {
    ImGui::PushID(id.c_str());
    ImGui::PushFont(column.look().font(Face::kMono), app::font_size(column.look(), Face::kMono, 13));
    height_ = ImGui::GetFrameHeight();
  }
  ~Fields() {
    ImGui::PopFont();
    ImGui::PopID();
    column_.gap(height_ + 8);
  }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  /// Whether a new value was entered.
  bool number(std::string_view name, double& value) {
    begin(name);
    ImGui::InputDouble("##value", &value, 0, 0, "%.6g");
    return end(name);
  }
  bool whole(std::string_view name, std::uint64_t& value) {
    begin(name);
    ImGui::InputScalar("##value", ImGuiDataType_U64, &value);
    return end(name);
  }

 private:
  void begin(std::string_view name) {
    const app::Look& look = column_.look();
    const float width = (column_.width() + kBetween) / static_cast<float>(count_) - kBetween;
    const float x = column_.x() + (width + kBetween) * static_cast<float>(at_++);
    const float before = name.empty() ? 0 : app::measure(look, Face::kRegular, 14, name).x + 8;
    app::text(column_.list(), look, Face::kRegular, 14, {x, app::middle_of(column_.y() + height_ / 2, look.px(14))},
              look->ink, name);
    ImGui::PushID(at_);
    ImGui::SetCursorScreenPos({x + before, column_.y()});
    ImGui::SetNextItemWidth(width - before);
  }
  bool end(std::string_view name) {
    const bool entered = ImGui::IsItemDeactivatedAfterEdit();
    app::offer_field(name.empty() ? std::string_view(id_) : name);
    ImGui::PopID();
    return entered;
  }

  static constexpr float kBetween = 12;
  Column& column_;
  std::string id_;
  int count_, at_ = 0;
  float height_ = 0;
};

/// Draws the fields of a row. Returns whether a value was entered.
bool draw_fields(Column& column, const std::string& id, std::span<const std::string_view> names,
                 std::span<double> values) {
  Fields fields(column, id, static_cast<int>(values.size()));
  bool entered = false;
  for (std::size_t i = 0; i < values.size(); ++i)
    entered = fields.number(names.empty() ? std::string_view() : names[i], values[i]) || entered;
  return entered;
}

void draw_edits(Shell& shell, Column& column) {
  const std::array<const char*, 4> commands{"add_point", "delete_point", "undo", "redo"};
  const lesson::Session& session = shell.session();
  const bool can_delete = shell.app().selected() != kNoIndex && lesson::count_of(session.stage().subject()) > 1;
  const std::vector<bool> can{true, can_delete, session.stage().can_undo(), session.stage().can_redo()};
  const int clicked = column.buttons("edit", {"Add", "Delete", "Undo", "Redo"}, -1, can);
  if (clicked >= 0) shell.app().command(commands[clicked]);
}

/// The switch between float and double.
void draw_scalar(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  if (session.stage().subject().scalar() == nullptr) return;
  const bool in_float = session.stage().subject().in_float();
  column.gap(12);
  column.heading(lesson::kScalarWord);
  const int clicked = column.buttons("scalar", {"double", "float"}, in_float ? 1 : 0);
  if (clicked >= 0) shell.tell(session.stage().set_float(clicked == 1));
  if (in_float) column.words("Every number is rounded to float.", Face::kRegular, 14, column.look()->muted);
}

void draw_selected(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  const Index selected = shell.app().selected();
  column.gap(12);
  if (selected == kNoIndex) {
    const std::string word(session.stage().subject().handle_words()[0]);
    column.heading("No " + word + " selected");
    column.words("Click a " + word + " to type its coordinates, or drag it. Double-click the background to add one.",
                 Face::kRegular, 14, column.look()->muted);
    return;
  }
  column.heading(session.stage().subject().name_of(selected));
  constexpr std::array<std::string_view, 3> kNames{"x", "y", "z"};
  Vector<double, 3> at = session.stage().subject().at(selected);
  if (draw_fields(column, "coordinates", kNames,
                  {at.data(), static_cast<std::size_t>(session.stage().subject().dim())}))
    shell.tell(session.stage().move(selected, at));
}

/// Draws a button for each axis of rotation. Returns whether one was pressed.
bool draw_turns(Column& column, const std::string& id, lesson::NumberRow& row) {
  std::vector<std::string> words;
  for (const std::string_view name : row.names)
    words.push_back(std::string(row.words) + " " + std::to_string(std::lround(row.turn)) + "° " + std::string(name));
  const int clicked = column.buttons(id.c_str(), words);
  if (clicked >= 0) row.values[clicked] = row.turn;
  return clicked >= 0;
}

/// Draws the subject's number fields.
void draw_numbers(Shell& shell, Column& column) {
  std::size_t g = 0;
  for (lesson::NumberGroup& group : shell.session().stage().subject().numbers()) {
    column.gap(12);
    column.heading(group.heading);
    for (std::size_t r = 0; r < group.rows.size(); ++r) {
      lesson::NumberRow& row = group.rows[r];
      const std::string id = std::to_string(g) + " " + std::to_string(r);
      const bool turns = row.turn > 0;
      if (!turns) {
        const std::string words = std::string(row.words) + (row.unit.empty() ? "" : ", ") + std::string(row.unit);
        column.words(words, Face::kRegular, 13, column.look()->muted);
      }
      if (turns ? draw_turns(column, id, row) : draw_fields(column, id, row.names, row.values))
        shell.tell(shell.session().stage().set_numbers(g, r, row.values));
    }
    ++g;
  }
}

void draw_scatter(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  column.gap(12);
  column.heading("Scatter");
  std::uint64_t seed = session.stage().subject().origin().seed;
  {
    Fields fields(column, "scatter", 1);
    if (fields.whole("Seed", seed)) session.stage().scatter(seed);
  }
  const int clicked = column.buttons("scatter", {"Scatter again", "The lesson's own"});
  if (clicked == 0) shell.app().command("scatter");
  if (clicked == 1) shell.app().command("reset_points");
}

void draw_sources(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  const lesson::Lesson& lesson = session.lesson();
  const auto now = [&](const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == session.stage().subject().origin().source) return static_cast<int>(i);
    return -1;
  };
  if (!lesson.generators.empty()) {
    column.gap(12);
    column.heading("Other points");
    constexpr int kUsual = 26;
    const lesson::Points& own = lesson::points_in(lesson, session.stage().situation());
    const int count = own.count > 0 ? own.count : kUsual;
    const int clicked = column.buttons("generator", lesson.generators, now(lesson.generators));
    if (clicked >= 0)
      shell.tell(session.stage().set_generator(lesson.generators[clicked], count, own.dim,
                                               session.stage().subject().origin().seed));
  }
  if (!lesson.meshes.empty()) {
    column.gap(12);
    column.heading("Meshes");
    const int clicked = column.buttons("mesh", lesson.meshes, now(lesson.meshes));
    if (clicked >= 0) shell.use_mesh(lesson.meshes[clicked]);
  }
  column.gap(12);
  column.heading("Your own");
  column.words("Drop a point file on this window: xyz, csv, obj, ply, stl or off.", Face::kRegular, 14,
               column.look()->muted);
}

}  // namespace

void draw_tools(Shell& shell, Column& column) {
  const lesson::Session& session = shell.session();
  const lesson::Tools tools = session.stage().subject().tools();
  if (!tools.points) {
    column.title(tools.title);
    draw_numbers(shell, column);
    draw_scalar(shell, column);
    return draw_scatter(shell, column);
  }
  const std::string source =
      session.stage().subject().origin().source.empty() ? "" : " · " + session.stage().subject().origin().source;
  const Index count = lesson::count_of(session.stage().subject());
  column.title(std::to_string(count) + " " + std::string(session.stage().subject().handle_words()[count == 1 ? 0 : 1]));
  column.words(std::to_string(session.stage().subject().dim()) + "-D" + source +
                   (session.stage().edited() ? " · changed by you" : ""),
               Face::kRegular, 14, column.look()->muted);
  column.gap(10);
  draw_edits(shell, column);
  draw_selected(shell, column);
  if (session.stage().conduct().builds) return;
  draw_scalar(shell, column);
  draw_scatter(shell, column);
  draw_sources(shell, column);
}

}  // namespace snug::desktop
