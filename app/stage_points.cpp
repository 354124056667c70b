// The points' own marks and their names.
#include <algorithm>
#include <cmath>

#include "app/numbers.hpp"
#include "app/stage_brush.hpp"
#include "lesson/figures.hpp"
#include "lesson/frustum_box.hpp"

namespace snug::app {
namespace {

constexpr Index kNameAll = 30;           // so many points have room for all their names
constexpr std::size_t kInviteAll = 250;  // more rings than this hide the points
constexpr float kTied = 14;  // a label so much farther out than it would stand has a line to what it names, pixels
constexpr float kDiamond = 7.5f, kRing = 11, kVertex = 13;

std::string coordinates(const Point3& p, int dim) {
  std::string text = "(" + lesson::number_text(p[0]) + ", " + lesson::number_text(p[1]);
  if (dim == 3) text += ", " + lesson::number_text(p[2]);
  return text + ")";
}

/// Four heads around a point: the arrow keys move it.
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

bool among(const std::vector<Index>& points, Index i) {
  return std::find(points.begin(), points.end(), i) != points.end();
}

/// A corner's name, of plus and minus alone, which a halo would close up.
bool is_of_signs(std::string_view words) { return words.find_first_not_of("+\u2212") == std::string_view::npos; }

/// A label that had to go far out is tied to what it names.
void draw_leader(ImDrawList* list, float width, const Label& label, const Rect& place) {
  const ImVec2 anchor{label.request.x, label.request.y};
  const ImVec2 from{std::clamp(anchor.x, place.x, place.x + place.width),
                    std::clamp(anchor.y, place.y, place.y + place.height)};
  const float dx = anchor.x - from.x, dy = anchor.y - from.y, away = std::hypot(dx, dy);
  if (away < label.request.gap + kTied) return;
  const float share = 1 - label.request.gap / away;
  list->AddLine(from, {from.x + dx * share, from.y + dy * share}, with_alpha(label.color, 0.6f), width);
}

}  // namespace

void Stage::draw_points(Brush& brush) const {
  const Palette& p = brush.p;
  // On a mesh of thousands, labels keep clear of the surface's marked points alone.
  if (screen_.size() <= 1500 && scene_.triangles.empty())
    for (const ScreenPoint& point : screen_)
      if (point.visible)
        brush.canvas.obstacles.discs.push_back({point.x, point.y, point_radius_ + (is_asked(brush.session) ? 6 : 1)});
  draw_invitation(brush);

  const auto at = [&](Index i) { return brush.at(brush.point(i)); };
  std::vector<Index> touching = shown_.support;
  if (shown_.extremes && !shown_.volume) touching = {};
  const auto mark = [&](Index i) {
    const ImVec2 place = at(i);
    diamond(brush.list, place, kDiamond * p.mark, p.support, p.ground);
    brush.canvas.obstacles.discs.push_back({place.x, place.y, kDiamond * p.mark});
  };
  for (const Index i : touching) mark(i);
  for (const Index i : shown_.forced) ring(brush.list, at(i), kRing * p.mark, p.support, brush.stroke(0.7f));
  if (shown_.extremes && !shown_.volume)
    for (int axis = 0; axis < camera_.dim(); ++axis)
      for (const Index i : {shown_.extremes->least[axis], shown_.extremes->greatest[axis]}) mark(i);
  if (shown_.pair && !shown_.volume)
    for (const Index i : {shown_.pair->a, shown_.pair->b}) mark(i);
  for (const Index& i : shown_.spoken_of) {
    const bool vertex = shown_.plane.has_value();  // the p-vertex, and then the n-vertex
    const ImVec2 place = at(i);
    diamond(brush.list, place, (vertex ? kVertex : kDiamond) * p.mark, p.support, p.ground);
    if (!vertex) continue;
    const float size = kVertex * p.mark / brush.look.text_scale;  // a mark, not a word: it does not grow with the text
    text_middle(brush.list, brush.look, Face::kSemiBold, size, {place.x, place.y - 0.6f * kVertex * p.mark}, p.ground,
                &i == shown_.spoken_of.data() ? "p" : "n");
    brush.canvas.obstacles.discs.push_back({place.x, place.y, kVertex * p.mark});
  }
  if (shown_.examined != kNoIndex) {
    const ImVec2 point = at(shown_.examined);
    if (!among(touching, shown_.examined)) disc(brush.list, point, (point_radius_ + 1) * p.mark, p.examined);
    ring(brush.list, point, (kRing + 4) * p.mark, p.examined, brush.stroke());
    brush.canvas.obstacles.discs.push_back({point.x, point.y, kRing + 6});
  }
  draw_verdict(brush);
  draw_selected(brush);
  name_points(brush);
}

/// Rings that say "tap me", while a question is answered on the stage; a strong one round what is chosen.
void Stage::draw_invitation(Brush& brush) const {
  if (!is_asked(brush.session)) return;
  const Palette& p = brush.p;
  const std::vector<Index> targets = brush.session.targets();
  const lesson::Answer* picked = brush.session.picked();
  const bool is_point = picked != nullptr && picked->kind == lesson::Answer::Kind::kPoint;
  for (const Index i : targets) {
    const ScreenPoint& point = screen_[i];
    const bool chosen = is_point && picked->value == i;
    if (!point.visible || (!chosen && targets.size() > kInviteAll)) continue;
    const ImVec2 at{point.x, point.y};
    if (chosen) disc(brush.list, at, point_radius_ + 7, with_alpha(p.current, 0.3f));
    ring(brush.list, at, point_radius_ + (chosen ? 7 : 5), chosen ? p.current : with_alpha(p.current, 0.75f),
         chosen ? brush.stroke(1.4f) : 1.5f);
  }
}

/// The point under the pointer, and the selected one with its ring and, while it is dragged, its coordinates.
void Stage::draw_selected(Brush& brush) const {
  const Palette& p = brush.p;
  const bool special = hovered_ != kNoIndex && among(shown_.support, hovered_);
  if (hovered_ != kNoIndex && hovered_ < brush.session.size()) {
    const ImVec2 at = brush.at(brush.point(hovered_));
    if (special) diamond(brush.list, at, kDiamond * p.mark + 2, p.support, p.ground);
    else disc(brush.list, at, std::max(point_radius_, 3.0f) + 2, hovered_ == shown_.examined ? p.examined : p.ink);
    if (grabs_ || brush.look.fingers || is_asked(brush.session)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (selected_ == kNoIndex || selected_ >= brush.session.size()) return;
  const Point3 place = brush.point(selected_);
  const ImVec2 at = brush.at(place);
  const float radius = std::max(point_radius_, 4.0f) + 6;
  ring(brush.list, at, radius + 2, p.ground, 2);
  ring(brush.list, at, radius, p.ink, 2);
  if (arrows_move()) arrow_heads(brush.list, at, radius + 5, p.ink, p.ground);
  brush.canvas.obstacles.discs.push_back({at.x, at.y, radius + (arrows_move() ? 11 : 2)});
  if (!dragging_) return;
  // A finger covers what is below it.
  const bool finger = brush.look.fingers;
  brush.label(at, radius + (finger ? 26 : 4), {0.3f, finger ? -1.0f : 1.0f}, coordinates(place, brush.session.dim()),
              p.ink, Face::kMono, 13);
  brush.labels.back().request.clear_of_points = true;
}

/// While an outcome stands: a cross beside each point of a wrong guess, a tick beside those that were right.
void Stage::draw_verdict(Brush& brush) const {
  const Palette& p = brush.p;
  const auto badge = [&](Index i, bool right) {
    if (i < 0 || i >= brush.session.size()) return;
    const ImVec2 point = brush.at(brush.point(i));
    const float away = 13 * p.mark, radius = 9 * p.mark;
    const ImVec2 at{point.x + away, point.y - away};
    disc(brush.list, at, radius, p.ground);
    ring(brush.list, at, radius, right ? p.optimum : p.wrong, 1.5f);
    if (right) tick(brush.list, at, 5 * p.mark, p.optimum, brush.stroke());
    else cross(brush.list, at, 4 * p.mark, p.wrong, brush.stroke());
    brush.canvas.obstacles.discs.push_back({at.x, at.y, radius + 1});
  };
  for (const Index i : shown_.guessed_wrong) badge(i, false);
  for (const Index i : shown_.right) badge(i, true);
}

/// Names of what the step speaks of; all others where there is room for them.
void Stage::name_points(Brush& brush) const {
  const Palette& p = brush.p;
  const lesson::Session& session = brush.session;
  std::vector<bool> named(static_cast<std::size_t>(session.size()), false);
  const ImVec2 middle = brush.at(volume_ ? ball_around(*volume_, camera_.dim()).center : framed_ball_.center);
  const auto name = [&](Index i, std::string words, Color color, Face face, float gap, float size = 14,
                        bool optional = false) {
    if (i == kNoIndex || named[i]) return;
    named[i] = true;
    const ImVec2 at = brush.at(brush.point(i));
    brush.label(at, gap, {at.x - middle.x, at.y - middle.y}, std::move(words), color, face, size, optional);
  };
  const auto plain = [&](Index i) { name(i, session.name_of(i), p.support_text, Face::kSemiBold, 11 * p.mark); };

  if (shown_.left_outside != kNoIndex) named[shown_.left_outside] = true;
  if (shown_.examined != kNoIndex) {
    std::string words = lesson::point_name(shown_.examined);
    if (shown_.examined_outside && shown_.outside_by > 0) words += " outside by " + short_figure(shown_.outside_by);
    else if (shown_.outside_by < 0) words += " inside";
    name(shown_.examined, std::move(words), p.examined_text, Face::kSemiBold, 19 * p.mark, 15);
  }
  if (shown_.extremes && !shown_.volume) {
    for (int axis = 0; axis < camera_.dim(); ++axis)
      for (const Index i : {shown_.extremes->least[axis], shown_.extremes->greatest[axis]}) plain(i);
  } else {
    for (const Index i : shown_.support) plain(i);
  }
  if (shown_.pair)
    for (const Index i : {shown_.pair->a, shown_.pair->b}) plain(i);
  if (shown_.plane && !shown_.plane_asked)
    for (const Index i : shown_.spoken_of) {  // p- and n-vertex, away from the box
      named[i] = true;
      const ImVec2 at = brush.at(brush.point(i)), box = brush.at(brush.point(0));
      brush.label(at, 15 * p.mark, {at.x - box.x, at.y - box.y}, session.name_of(i), p.support_text, Face::kSemiBold,
                  15);
    }
  const lesson::Answer* picked = session.picked();
  const bool is_point = picked != nullptr && picked->kind == lesson::Answer::Kind::kPoint;
  for (const Index i : {is_point ? static_cast<Index>(picked->value) : kNoIndex, selected_, hovered_})
    if (i != kNoIndex && i < session.size()) name(i, session.name_of(i), p.ink, Face::kSemiBold, 13);
  for (const Index i : shown_.spoken_of) plain(i);
  if (session.size() > kNameAll) return;
  const bool asked = is_asked(session);
  std::vector<bool> must(static_cast<std::size_t>(session.size()), false);  // what an answer names bears its name
  if (asked && session.boxes() != nullptr)
    for (const Index i : session.targets()) must[i] = true;
  for (Index i = 0; i < session.size(); ++i) {
    // A centre bears its box's name, a knob its arc.
    const lesson::Place place = lesson::place_of(session.dim(), i);
    if (session.boxes() != nullptr && place.kind != lesson::Place::Kind::kCorner) continue;
    if (session.boxes() != nullptr && lesson::has_frustum(*session.boxes()) && place.box == 1)
      continue;  // nobody speaks of its vertices
    if (asked && session.boxes() != nullptr && !must[i]) continue;
    const bool signs = is_of_signs(session.name_of(i));  // thin strokes on a volume's fill
    name(i, session.name_of(i),
         must[i] ? p.current_text
         : signs ? p.ink
                 : p.muted,
         must[i] || signs ? Face::kSemiBold : Face::kRegular, asked ? 12 : 7, must[i] || signs ? 13 : 12, !must[i]);
  }
}

void Stage::draw_labels(Brush& brush) const {
  std::vector<LabelRequest> requests;
  for (const Label& label : brush.labels) requests.push_back(label.request);
  const Rect& r = brush.rect;
  const auto places = place_labels(requests, brush.canvas.obstacles, {r.x + 4, r.y + 4, r.width - 8, r.height - 8});
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const Label& label = brush.labels[i];
    const ImVec2 at{places[i]->x + 3, places[i]->y + 1};
    draw_leader(brush.list, brush.p.mark, label, *places[i]);
    // A name that is only shown where it is clear of everything needs no halo.
    if (is_of_signs(label.words) || (label.request.optional && !scene_.three_d))
      text(brush.list, brush.look, label.face, label.size, at, label.color, label.words);
    else halo_text(brush.list, brush.look, label.face, label.size, at, label.color, brush.p.ground, label.words);
  }
}

}  // namespace snug::app
