// Draws the state of the handles (hovered, selected, answered), and their names.
#include <algorithm>
#include <cmath>

#include "app/point_marks.hpp"
#include "app/stage.hpp"
#include "lesson/figures.hpp"
#include "lesson/speaking.hpp"
#include "lesson/stored.hpp"

namespace snug::app {
namespace {

constexpr Index kNameAll = 30;           // up to this many points have room for all their names
constexpr std::size_t kInviteAll = 250;  // more rings than this hide the points

std::string coordinates(const Point3& p, int dim) {
  std::string text = "(" + lesson::coordinate_text(p[0]) + ", " + lesson::coordinate_text(p[1]);
  if (dim == 3) text += ", " + lesson::coordinate_text(p[2]);
  return text + ")";
}

/// Draws four arrow heads around a point that the arrow keys move.
void arrow_heads(ImDrawList* list, ImVec2 at, float from, Color color, Color halo) {
  for (const ImVec2 way : {ImVec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    const auto head = [&](float base, float length, float half, Color fill) {
      list->AddTriangleFilled({at.x + way.x * (base + length), at.y + way.y * (base + length)},
                              {at.x + way.x * base - way.y * half, at.y + way.y * base + way.x * half},
                              {at.x + way.x * base + way.y * half, at.y + way.y * base - way.x * half}, fill);
    };
    head(from - 1.5f, 9, 7.5f, halo);
    head(from, 6, 5, color);
  }
}

}  // namespace

void Stage::light(std::string_view mark) {
  lit_ = mark;
  if (view_ != nullptr) view_->light(mark);
}

void Stage::draw_handles(Brush& brush) const {
  // On a mesh of thousands of points, labels keep clear only of the marked ones.
  if (brush.handles.size() <= 1500 && scene_.triangles.empty())
    for (const ScreenPoint& point : brush.handles)
      if (point.visible)
        brush.canvas.obstacles.discs.push_back(
            {point.x, point.y, brush.point_radius + (answered_on_stage(brush.session) ? 6 : 1)});
  draw_invitation(brush);
  view_->draw_marks(brush);
  draw_verdict(brush);
  draw_hovered(brush);
  draw_lit(brush);
  draw_selected(brush);
  name_handles(brush);
}

/// While a question is answered on the stage: rings around the possible answers, a strong one around the chosen.
void Stage::draw_invitation(Brush& brush) const {
  if (!answered_on_stage(brush.session)) return;
  const Palette& p = brush.p;
  const std::vector<Index> targets = brush.session.conversation().targets();
  const lesson::Answer* picked = brush.session.conversation().picked();
  for (const Index i : targets) {
    const ScreenPoint& point = brush.handles[i];
    const bool chosen = picked != nullptr && names_handle(*picked, i);
    if (!point.visible || (!chosen && targets.size() > kInviteAll)) continue;
    const ImVec2 at{point.x, point.y};
    if (chosen) disc(brush.list, at, brush.point_radius + 7, with_alpha(p.current, 0.3f));
    ring(brush.list, at, brush.point_radius + (chosen ? 7 : 5), chosen ? p.current : with_alpha(p.current, 0.75f),
         chosen ? brush.stroke(1.4f) : 1.5f);
  }
}

/// While an outcome is shown, draws a cross beside each point of a wrong answer and a tick beside the right ones.
void Stage::draw_verdict(Brush& brush) const {
  const Palette& p = brush.p;
  const auto badge = [&](Index i, bool right) {
    if (i < 0 || i >= brush.session.stage().subject().size()) return;
    const ImVec2 point = brush.at(brush.point(i));
    const float away = 13 * p.mark, radius = 9 * p.mark;
    const ImVec2 at{point.x + away, point.y - away};
    disc(brush.list, at, radius, p.ground);
    ring(brush.list, at, radius, right ? p.optimum : p.wrong, 1.5f);
    if (right) tick(brush.list, at, 5 * p.mark, p.optimum, brush.stroke());
    else cross(brush.list, at, 4 * p.mark, p.wrong, brush.stroke());
    brush.canvas.obstacles.discs.push_back({at.x, at.y, radius + 1});
  };
  for (const Index i : view_->shown().guessed_wrong) badge(i, false);
  for (const Index i : view_->shown().right) badge(i, true);
}

/// Draws the handle under the pointer.
void Stage::draw_hovered(Brush& brush) const {
  const Palette& p = brush.p;
  const Shown& shown = view_->shown();
  const Index i = hands_.hovered;
  if (i == kNoIndex || i >= brush.session.stage().subject().size()) return;
  const ImVec2 at = brush.at(brush.point(i));
  if (among(shown.support, i)) diamond(brush.list, at, kDiamond * p.mark + 2, p.support, p.ground);
  else disc(brush.list, at, std::max(brush.point_radius, 3.0f) + 2, i == shown.examined ? p.examined : p.ink);
  if (hands_.grabs || brush.look.fingers || answered_on_stage(brush.session))
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

/// Draws what a link in the prose, or a member of a stored volume, marks while it is pointed at.
void Stage::draw_lit(Brush& brush) const {
  if (lit_.empty()) return;
  const Palette& p = brush.p;
  const auto draw_all = [&](Color color, float width, float radius) {
    for (const std::vector<Point3>& points : lesson::stored_lines(brush.session, lit_)) {
      for (std::size_t i = 1; i < points.size(); ++i)
        draw_line(brush.canvas, points[i - 1], points[i], {Stroke::kSolid, color, width});
      if (points.size() == 1) disc(brush.list, brush.at(points.front()), radius, color);
    }
  };
  draw_all(p.ground, brush.stroke(2) + 4, brush.point_radius + 5);
  draw_all(p.support, brush.stroke(2), brush.point_radius + 3);
  for (const Index i : lesson::marked_handles(brush.session, lit_)) {
    if (!view_->draws(brush.session, i)) continue;
    const ImVec2 at = brush.at(brush.point(i));
    const float radius = std::max(brush.point_radius, 4.0f) + 9;
    ring(brush.list, at, radius, p.ground, brush.stroke() + 4);
    ring(brush.list, at, radius, p.current, brush.stroke(1.4f));
  }
}

/// Draws the selected handle with its ring and, while it is dragged, its coordinates.
void Stage::draw_selected(Brush& brush) const {
  const Palette& p = brush.p;
  if (hands_.selected == kNoIndex || hands_.selected >= brush.session.stage().subject().size()) return;
  const Point3 place = brush.point(hands_.selected);
  const ImVec2 at = brush.at(place);
  const float radius = std::max(brush.point_radius, 4.0f) + 6;
  ring(brush.list, at, radius + 2, p.ground, 2);
  ring(brush.list, at, radius, p.ink, 2);
  if (arrows_move()) arrow_heads(brush.list, at, radius + 5, p.ink, p.ground);
  brush.canvas.obstacles.discs.push_back({at.x, at.y, radius + (arrows_move() ? 11 : 2)});
  if (!hands_.dragging) return;
  // A finger covers what is below it, so the label is above.
  const bool finger = brush.look.fingers;
  brush.label(at, radius + (finger ? 26 : 4), {0.3f, finger ? -1.0f : 1.0f},
              coordinates(place, brush.session.stage().subject().dim()), p.ink, Face::kMono, 13);
  brush.labels.back().request.clear_of_points = true;
}

/// Names the handles that the step is about and the one in use; and all others, if there is room.
void Stage::name_handles(Brush& brush) const {
  const Palette& p = brush.p;
  const lesson::Session& session = brush.session;
  PointNames names(brush, brush.volume ? ball_around(*brush.volume, brush.dim()).center : framed_ball_.center);
  view_->name_marks(names);
  const lesson::Answer* picked = session.conversation().picked();
  if (picked != nullptr)
    for (Index i = 0; i < session.stage().subject().size(); ++i)
      if (names_handle(*picked, i)) names.name(i, session.stage().subject().name_of(i), p.ink, Face::kSemiBold, 13);
  for (const Index i : {hands_.selected, hands_.hovered})
    if (i != kNoIndex && i < session.stage().subject().size() && !view_->writes_name(session, i))
      names.name(i, session.stage().subject().name_of(i), p.ink, Face::kSemiBold, 13);
  if (!lit_.empty())
    for (const Index i : lesson::marked_handles(session, lit_))
      if (view_->draws(session, i) && !view_->writes_name(session, i))
        names.name(i, session.stage().subject().name_of(i), p.current_text, Face::kSemiBold, 13);
  names.plain(view_->shown().spoken_of);
  if (session.stage().subject().size() > kNameAll) return;
  const bool all = session.lesson().view.named;
  const bool asked = answered_on_stage(session), alone = asked && view_->names_answers_alone();
  const std::vector<Index> targets = alone || (asked && !all) ? session.conversation().targets() : std::vector<Index>{};
  for (Index i = 0; i < session.stage().subject().size(); ++i) {
    const bool must = among(targets, i);  // the possible answers are always named
    if (!view_->draws(session, i) || !view_->bears_name(session, i) || ((alone || !all) && !must)) continue;
    const bool signs = is_of_signs(session.stage().subject().name_of(i));  // signs are thin strokes on a volume's fill
    names.name(i, session.stage().subject().name_of(i),
               must    ? p.current_text
               : signs ? p.ink
                       : p.muted,
               must || signs ? Face::kSemiBold : Face::kRegular, asked ? 12 : 7, must || signs ? 13 : 12,
               !must && !view_->needs_name(session, i));
  }
}

}  // namespace snug::app
