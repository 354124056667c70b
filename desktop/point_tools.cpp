// The tools for points and boxes: buttons for what the pointer does on the stage, and number fields for exact values.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "desktop/cli/files.hpp"
#include "desktop/column.hpp"
#include "desktop/prose_panel.hpp"
#include "lesson/boxes.hpp"
#include "lesson/figures.hpp"
#include "lesson/point_subject.hpp"

namespace snug::desktop {
namespace {

using app::Face;

/// A row of ImGui number fields, in the palette and with tabular figures.
class Fields {
 public:
  Fields(Column& column, const char* id) : column_(column) {
    ImGui::PushID(id);
    ImGui::PushFont(column.look().font(Face::kMono), app::font_size(column.look(), Face::kMono, 13));
  }
  ~Fields() {
    ImGui::PopFont();
    ImGui::PopID();
  }
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  /// Whether a new value was entered.
  bool number(const char* name, double& value) {
    row(name);
    ImGui::InputDouble("##value", &value, 0, 0, "%.6g");
    return done();
  }
  bool whole(const char* name, std::uint64_t& value) {
    row(name);
    ImGui::InputScalar("##value", ImGuiDataType_U64, &value);
    return done();
  }

 private:
  void row(const char* name) {
    const app::Look& look = column_.look();
    const float height = ImGui::GetFrameHeight(), label = look.px(64);
    app::text(column_.list(), look, Face::kRegular, 14,
              {column_.x(), app::middle_of(column_.y() + height / 2, look.px(14))}, look->ink, name);
    ImGui::PushID(name);
    ImGui::SetCursorScreenPos({column_.x() + label, column_.y()});
    ImGui::SetNextItemWidth(column_.width() - label);
    column_.gap(height + 8);
  }
  bool done() {
    const bool entered = ImGui::IsItemDeactivatedAfterEdit();
    ImGui::PopID();
    return entered;
  }
  Column& column_;
};

void draw_edits(Shell& shell, Column& column) {
  const std::array<const char*, 4> commands{"add_point", "delete_point", "undo", "redo"};
  const lesson::Session& session = shell.session();
  const bool can_delete = shell.app().selected() != kNoIndex && session.size() > 1;
  const std::vector<bool> can{true, can_delete, session.can_undo(), session.can_redo()};
  const int clicked = column.buttons("edit", {"Add", "Delete", "Undo", "Redo"}, -1, can);
  if (clicked >= 0) shell.app().command(commands[clicked]);
}

void draw_selected(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  const Index selected = shell.app().selected();
  column.gap(12);
  if (selected == kNoIndex) {
    column.heading("No point selected");
    column.words("Click a point to type its coordinates, or drag it. Double-click the ground to add one.",
                 Face::kRegular, 14, column.look()->muted);
    return;
  }
  column.heading(lesson::point_name(selected));
  Vector<double, 3> at = session.point(selected);
  Fields fields(column, "coordinates");
  bool entered = false;
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  for (int axis = 0; axis < session.dim(); ++axis) entered = fields.number(kNames[axis], at[axis]) || entered;
  if (entered) shell.tell(session.move(selected, at));
}

/// Draws the number fields of a box; in space, buttons rotate it about the world axes.
void draw_box(Shell& shell, Column& column, int i) {
  constexpr std::array<const char*, 3> kCenter{"centre x", "centre y", "centre z"}, kHalf{"half x", "half y", "half z"};
  constexpr std::array<const char*, 3> kTurns{"Turn 15° x", "Turn 15° y", "Turn 15° z"};
  constexpr double kDegree = std::numbers::pi / 180;
  lesson::Session& session = shell.session();
  const lesson::BoxSubject& subject = *lesson::as_boxes(session.subject());
  lesson::BoxPair pair = *subject.boxes();
  Obb<double, 3>& box = pair.boxes[i];
  column.gap(12);
  column.heading(subject.words_of(i).heading);
  bool entered = false;
  {
    Fields fields(column, i == 0 ? "box a" : "box b");
    for (int axis = 0; axis < session.dim(); ++axis)
      entered = fields.number(kCenter[axis], box.center[axis]) || entered;
    for (int axis = 0; axis < session.dim(); ++axis)
      entered = fields.number(kHalf[axis], box.half_extents[axis]) || entered;
    double degrees = lesson::angle_of(box) / kDegree;
    if (session.dim() == 2 && fields.number("degrees", degrees)) {
      box.axes = Matrix<double, 3>::Identity();
      box = lesson::turned_by(box, 2, degrees * kDegree);
      entered = true;
    }
  }
  if (session.dim() == 3) {
    const int clicked = column.buttons(i == 0 ? "turn a" : "turn b", {kTurns.begin(), kTurns.end()});
    if (clicked >= 0) box = lesson::turned_by(box, clicked, 15 * kDegree);
    entered = entered || clicked >= 0;
  }
  if (entered) shell.tell(session.set_boxes(pair));
}

void draw_scatter(Shell& shell, Column& column) {
  lesson::Session& session = shell.session();
  column.gap(12);
  column.heading("Scatter");
  std::uint64_t seed = session.seed();
  {
    Fields fields(column, "scatter");
    if (fields.whole("Seed", seed)) session.scatter(seed);
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
      if (names[i] == session.source()) return static_cast<int>(i);
    return -1;
  };
  if (!lesson.generators.empty()) {
    column.gap(12);
    column.heading("Other points");
    constexpr int kUsual = 26;
    const int count = lesson.points.count > 0 ? lesson.points.count : kUsual;
    const int clicked = column.buttons("generator", lesson.generators, now(lesson.generators));
    if (clicked >= 0)
      shell.tell(session.set_generator(lesson.generators[clicked], count, lesson.points.dim, session.seed()));
  }
  if (!lesson.meshes.empty()) {
    column.gap(12);
    column.heading("Meshes");
    const int clicked = column.buttons("mesh", lesson.meshes, now(lesson.meshes));
    if (clicked >= 0) shell.use_mesh(lesson.meshes[clicked]);
  }
  column.gap(12);
  column.heading("Your own");
  column.words("Drop a point file on this window: xyz, csv, obj, ply or stl.", Face::kRegular, 14,
               column.look()->muted);
}

}  // namespace

void draw_point_tools(Shell& shell, Column& column) {
  const lesson::Session& session = shell.session();
  if (session.subject().points() == nullptr) {
    column.title(std::string(session.subject().tools_title()));
    for (int box = 0; session.subject().boxes() != nullptr && box < 2; ++box) draw_box(shell, column, box);
    return draw_scatter(shell, column);
  }
  const std::string source = session.source().empty() ? "" : " · " + session.source();
  column.title(std::to_string(session.size()) + (session.size() == 1 ? " point" : " points"));
  column.words(std::to_string(session.dim()) + "-D" + source + (session.edited() ? " · changed by you" : ""),
               Face::kRegular, 14, column.look()->muted);
  column.gap(10);
  draw_edits(shell, column);
  draw_selected(shell, column);
  draw_scatter(shell, column);
  draw_sources(shell, column);
}

}  // namespace snug::desktop
