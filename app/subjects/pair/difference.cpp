// Draws the Minkowski difference A - B in a corner of the stage, and how GJK's simplex gets near to the origin in it.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "app/labels.hpp"
#include "app/subjects/pair/draw.hpp"
#include "lesson/subjects/pair/difference.hpp"

namespace snug::app {
namespace {

using lesson::DifferenceVertex;

constexpr float kInsetRim = 12, kVertexNames = 10;
constexpr float kInsetShape = 0.8f, kLeastInset = 110;  // height over width, without its head
constexpr float kNarrowInset = 160;                     // no names in a panel that is narrower
constexpr float kInsetHead = 22;

/// How wide the panel is if the stage is high enough.
float inset_width(const Look& look, const Rect& stage) {
  return stage.width < 440 ? 180 : look.px(stage.width < 900 ? 220 : 272);
}

/// What GJK knows about the difference at a step.
struct ShownSimplex {
  std::vector<Index> kept;  // its vertices, as query::NearestFound has them
  const query::SupportFound* support = nullptr;
  void operator()(const auto&) {}
  void operator()(const query::NearestFound& fact) { kept = fact.corners, support = nullptr; }
  void operator()(const query::SupportFound& fact) { support = &fact; }
  /// Whether it is the vertex that was just found.
  [[nodiscard]] bool is_found(Index a, Index b) const {
    return support != nullptr && support->a == a && support->b == b;
  }
  [[nodiscard]] bool has(Index a, Index b) const {
    bool found = is_found(a, b);
    for (std::size_t i = 0; i + 1 < kept.size(); i += 2) found = found || (kept[i] == a && kept[i + 1] == b);
    return found;
  }
};

/// The panel, and the plane of A - B in it.
struct DifferenceInset {
  Brush& brush;
  const lesson::VolumePair& pair;
  Rect panel;
  float head;
  std::vector<DifferenceVertex> outline;
  ImVec2 middle;
  float scale = 1;
  Point3 center;
  std::vector<Rect> taken;  // by words

  DifferenceInset(Brush& b, const lesson::VolumePair& volumes, const Rect& rect, float head_height)
      : brush(b), pair(volumes), panel(rect), head(head_height), outline(lesson::difference_outline(volumes)) {
    Point3 least = Point3::Zero(), greatest = Point3::Zero();  // starts at the origin, which is in the picture
    for (const DifferenceVertex& vertex : outline)
      least = least.cwiseMin(vertex.at), greatest = greatest.cwiseMax(vertex.at);
    const Point3 size = (greatest - least).cwiseMax(1e-9 * (1 + greatest.norm()));
    const float aside = named() ? 46 : 2 * kInsetRim, above = named() ? 20 : kInsetRim;
    scale =
        static_cast<float>(std::min((panel.width - 2 * aside) / size[0], (panel.height - head - 2 * above) / size[1]));
    middle = {panel.x + panel.width / 2, panel.y + head + (panel.height - head) / 2};
    center = (least + greatest) / 2;
  }

  [[nodiscard]] bool named() const { return panel.width >= kNarrowInset; }
  [[nodiscard]] ImVec2 at(const Point3& p) const {
    return {middle.x + static_cast<float>(p[0] - center[0]) * scale,
            middle.y - static_cast<float>(p[1] - center[1]) * scale};
  }
  [[nodiscard]] std::string name_of(Index a, Index b) const {
    const lesson::PairRun::Where where{lesson::pair_run(brush.session.player().run(0)), 0, nullptr};
    return where.vertex(0, a).name + "−" + where.vertex(1, b).name;
  }

  void ground() const {
    brush.panel(panel);
    text(brush.list, brush.look, Face::kSemiBold, 12, {panel.x + kInsetRim, panel.y + brush.look.px(5)}, brush.p.muted,
         lesson::radius_of(pair.held[0]) + lesson::radius_of(pair.held[1]) > 0 ? "Cores: A − B" : "A − B");
  }
  void difference() const {
    std::vector<ImVec2> places;
    for (const DifferenceVertex& vertex : outline) places.push_back(at(vertex.at));
    if (places.size() > 2)
      brush.list->AddConvexPolyFilled(places.data(), static_cast<int>(places.size()),
                                      with_alpha(brush.p.current, brush.p.fill));
    path(brush.list, places, places.size() > 2, Stroke::kSolid, brush.p.current, brush.stroke(0.7f));
    for (const ImVec2 place : places) disc(brush.list, place, 2, brush.p.current);
  }
  /// At the first of the places where the words stand over no others; nowhere if there is none.
  void say(Face face, float size, std::initializer_list<ImVec2> places, Color color, std::string_view words) {
    const ImVec2 room = measure(brush.look, face, size, words);
    for (const ImVec2 place : places) {
      const Rect box{place.x, place.y, room.x, room.y};
      if (std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return overlap(box, other); })) continue;
      taken.push_back(box);
      halo_text(brush.list, brush.look, face, size, place, color, brush.p.panel, words);
      return;
    }
  }
  /// Names a vertex, on the side away from the middle.
  void name(const Point3& vertex, const std::string& words, Color color) {
    if (!named()) return;
    const ImVec2 place = at(vertex), size = measure(brush.look, Face::kSemiBold, kVertexNames, words);
    const ImVec2 out{place.x - middle.x, place.y - middle.y};
    const float length = std::max(1.0f, std::hypot(out.x, out.y));
    const ImVec2 corner{place.x + out.x / length * (size.x / 2 + 8) - size.x / 2,
                        place.y + out.y / length * (size.y / 2 + 6) - size.y / 2};
    const auto moved = [&](float rows) {
      return ImVec2{
          std::clamp(corner.x, panel.x + 3, panel.x + panel.width - size.x - 3),
          std::clamp(corner.y + rows * (size.y + 1), panel.y + head - 4, panel.y + panel.height - size.y - 3)};
    };
    say(Face::kSemiBold, kVertexNames, {moved(0), moved(1), moved(-1)}, color, words);
  }
  void arrow_to(const Point3& v) {
    const ImVec2 from = at(Point3::Zero()), to = at(v);
    if (std::hypot(to.x - from.x, to.y - from.y) < 8) return;
    arrow(brush.list, from, to, brush.p.examined, brush.stroke(1.1f));
    const ImVec2 half{(from.x + to.x) / 2, (from.y + to.y) / 2};
    if (named())
      say(Face::kSemiBold, 12, {{half.x + 4, half.y - 14}, {half.x - 12, half.y - 14}, {half.x - 12, half.y + 2}},
          brush.p.examined_text, "v");
  }
  /// The line across v that has all of A - B on its far side.
  void bound(const Point3& vertex, const Point3& v) const {
    if (!(v.norm() > 0)) return;
    const ImVec2 on = at(vertex), way{static_cast<float>(v[1] / v.norm()), static_cast<float>(v[0] / v.norm())};
    brush.list->PushClipRect({panel.x, panel.y + head}, {panel.x + panel.width, panel.y + panel.height}, true);
    line(brush.list, {on.x - way.x * panel.width, on.y - way.y * panel.width},
         {on.x + way.x * panel.width, on.y + way.y * panel.width}, Stroke::kDashed, brush.p.optimum,
         brush.stroke(0.7f));
    brush.list->PopClipRect();
  }
  /// Its name stands away from v, whose arrow begins here, unless there is no room on that side.
  void origin(const Point3& v) {
    const ImVec2 place = at(Point3::Zero()), to = at(v);
    plus(brush.list, place, 6, brush.p.ink, brush.stroke(0.9f));
    const float words = measure(brush.look, Face::kRegular, 11, "origin").x;
    const float before = place.x - 7 - words, after = place.x + 7, above = place.y - 16, below = place.y + 3;
    const bool fits_before = before > panel.x + 4, fits_after = after + words < panel.x + panel.width - 4;
    const float x = to.x > place.x ? (fits_before ? before : after) : (fits_after ? after : before);
    const bool rises = to.y <= place.y;
    say(Face::kRegular, 11, {{x, rises ? below : above}, {x, rises ? above : below}}, brush.p.ink, "origin");
  }
};

/// Whether the open question is which vertex comes next.
bool asks_for_vertex(const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  return asked != nullptr && asked->kind != nullptr && asked->kind->name == "next_vertex";
}

void draw_simplex(DifferenceInset& inset, const ShownSimplex& simplex, std::span<const Point3> kept, const Point3& v) {
  Brush& brush = inset.brush;
  const Palette& p = brush.p;
  std::vector<ImVec2> places;
  for (const Point3& vertex : kept) places.push_back(inset.at(vertex));
  if (simplex.support != nullptr) {
    const std::array pair{simplex.support->a, simplex.support->b};
    const Point3 found = lesson::difference_points(inset.pair, pair).front();
    inset.bound(found, v);
    for (const ImVec2 place : places)
      line(brush.list, place, inset.at(found), Stroke::kDotted, p.examined, brush.stroke(0.9f));
    ring(brush.list, inset.at(found), 6, p.examined, brush.stroke(0.9f));
    inset.name(found, inset.name_of(pair[0], pair[1]), p.examined_text);
  }
  if (places.size() > 2)
    brush.list->AddConvexPolyFilled(places.data(), static_cast<int>(places.size()), with_alpha(p.examined, 0.18f));
  if (places.size() > 1) path(brush.list, places, places.size() > 2, Stroke::kSolid, p.examined, brush.stroke(1.2f));
  for (const ImVec2 place : places) disc(brush.list, place, 4, p.examined);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (const Index a = simplex.kept[2 * i], b = simplex.kept[2 * i + 1]; !simplex.is_found(a, b))
      inset.name(kept[i], inset.name_of(a, b), p.examined_text);
  inset.arrow_to(v);
}

}  // namespace

float difference_height(const Look& look, const Rect& stage) {
  return inset_width(look, stage) * kInsetShape + look.px(kInsetHead);
}

Rect draw_difference(Brush& brush, lesson::PairSteps steps, ImVec2 at) {
  if (brush.dim() != 2) return {};
  const lesson::VolumePair& pair = lesson::as<lesson::VolumesSubject>(brush.session.stage().subject())->pair();
  ShownSimplex simplex;
  for (const auto& entry : steps) std::visit(simplex, entry.step.fact);
  const std::vector<Point3> kept = lesson::difference_points(pair, simplex.kept);
  if (kept.empty()) return {};  // nothing yet, or smooth

  const Look& look = brush.look;
  // As large as the stage has room for above a card.
  const float head = look.px(kInsetHead), free = brush.canvas.camera.free_bottom() - at.y;
  const float width = std::min(inset_width(look, brush.rect), (free - head) / kInsetShape);
  if (width < kLeastInset) return {};
  const Rect panel{at.x, at.y, width, width * kInsetShape + head};
  DifferenceInset inset(brush, pair, panel, head);
  inset.ground();
  inset.difference();
  if (asks_for_vertex(brush.session))
    for (const DifferenceVertex& vertex : inset.outline)
      if (!simplex.has(vertex.a, vertex.b))
        inset.name(vertex.at, inset.name_of(vertex.a, vertex.b), brush.p.current_text);
  const Point3 nearest = lesson::nearest_of(kept);
  inset.origin(nearest);
  draw_simplex(inset, simplex, kept, nearest);
  return panel;
}

}  // namespace snug::app
