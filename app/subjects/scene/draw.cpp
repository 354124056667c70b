// Draws a moving scene: its bodies in the current frame, their loose volumes, and the pairs that each stage of the
// funnel left.
#include "app/subjects/scene/draw.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

#include "app/subjects/scene/contacts.hpp"
#include "app/subjects/scene/owner.hpp"
#include "app/subjects/scene/pairs.hpp"
#include "app/subjects/scene/search.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;

constexpr std::size_t kBoxesOfAll =
    60;                   // more boxes than these hide what is inside them: then only those in pairs are drawn
constexpr int kRim = 24;  // points of the outline around a vertex with a radius

/// Which of the colours a body was given; -1 for none.
int painted(const Brush& brush, std::size_t i) {
  return declared(lesson::set_of(brush.session), i, brush.session.stage().subject().size()).color;
}

/// Mixes a fraction of the second colour into the first.
Color mixed(Color a, Color b, double share) {
  const auto part = [&](int shift) {
    const double from = a >> shift & 0xff, to = b >> shift & 0xff;
    return static_cast<Color>(from + (to - from) * share + 0.5) << shift;
  };
  return 0xff000000u | part(0) | part(8) | part(16);
}

/// Which bodies are in one of the pairs.
std::vector<bool> in_pairs(std::size_t bodies, const std::vector<BodyPair>& pairs) {
  std::vector<bool> flags(bodies, false);
  for (const BodyPair& pair : pairs) flags[pair.a] = flags[pair.b] = true;
  return flags;
}

/// Draws the shadows, trails and rays of bodies.
void draw_traces(Brush& brush, const SceneFrame& frame) {
  const Palette& p = brush.p;
  for (const auto& shadow : frame.shadows) {
    std::vector<ImVec2> outline;
    for (const Point3& corner : shadow) outline.push_back(brush.at(corner));
    if (outline.size() < 3) continue;
    outline = convex_outline(std::move(outline));
    brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), with_alpha(p.ink, 0.13f));
  }
  for (const auto& trail : frame.trails)
    for (std::size_t i = 1; i < trail.size(); ++i)
      line(brush.list, brush.at(trail[i - 1]), brush.at(trail[i]), Stroke::kSolid,
           with_alpha(p.muted, 0.15f + 0.7f * static_cast<float>(i) / static_cast<float>(trail.size())),
           brush.stroke(0.7f));
  for (const scene::Ray& ray : frame.rays) {
    if (ray.from == ray.to) continue;
    line(brush.list, brush.at(ray.from), brush.at(ray.to), Stroke::kDotted, p.muted, brush.stroke(0.7f));
    plus(brush.list, brush.at(ray.to), 4 * p.mark, p.muted, brush.stroke(0.7f));
  }
}

/// Before the first frame there are no volumes; for a question about them, draws those of the bodies at their start.
void draw_loose_to_come(Brush& brush, const SceneFrame& frame) {
  const auto& members = lesson::members_of(brush.session);
  const auto& effects = lesson::set_of(brush.session).effects;
  const bool come =
      std::any_of(effects.begin(), effects.end(), [](const auto& effect) { return effect.name == "broad_phase"; });
  if (brush.session.conversation().asked() == nullptr || !come || frame.bodies.size() > kBoxesOfAll) return;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    if (members[i].shape.kind != scene::Shape::Kind::kBox) continue;
    const Point3 half = frame.bodies[i].rotation().cwiseAbs() * members[i].shape.half_extents;
    draw_box(brush.canvas, frame.bodies[i].position - half, frame.bodies[i].position + half,
             {Stroke::kSolid, with_alpha(brush.p.current, 0.35f), brush.stroke(0.4f)});
  }
  brush.canvas.obstacles.segments.clear();  // names may cover so many edges
}

/// Draws the AABBs that the broad phase compares, paler if nothing overlaps them; and the selected body's sphere.
void draw_loose(Brush& brush, const SceneFrame& frame) {
  if (brush.view.shows_points(brush.session)) return;  // its volume is drawn separately
  if (brush.session.player().step() == 0) return draw_loose_to_come(brush, frame);
  const Palette& p = brush.p;
  const std::vector<bool> paired = in_pairs(frame.bodies.size(), frame.pairs);
  const Index chosen = brush.hands.hovered != kNoIndex ? brush.hands.hovered : brush.hands.selected;
  const std::size_t hand = chosen != kNoIndex
                               ? owner_of(lesson::set_of(brush.session)).body + static_cast<std::size_t>(chosen)
                               : frame.volumes.size();
  for (std::size_t i = 0; i < frame.volumes.size(); ++i) {
    const Aabb<double, 3>& box = frame.volumes[i];
    if (i != hand && frame.volumes.size() <= (paired[i] ? kCrowd : kBoxesOfAll))
      draw_box(brush.canvas, box.min, box.max,
               {Stroke::kSolid, with_alpha(p.current, paired[i] ? 0.5f : 0.2f), brush.stroke(0.4f)});
    if (i != hand) continue;
    draw_volume(brush.canvas, polytope_of(box, 3), {Stroke::kSolid, p.current, brush.stroke(0.7f), p.fill});
    const fit::Sphere3 ball{frame.bodies[i].position, lesson::members_of(brush.session)[i].shape.reach};
    draw_volume(brush.canvas, ball, {Stroke::kDotted, p.previous, brush.stroke(0.8f)});
  }
  brush.canvas.obstacles.segments.clear();  // names may cover so many edges
}

/// Draws the faces of a box that face the eye, shaded. There may be thousands of boxes, so nothing here
/// allocates.
void draw_faces(Brush& brush, const scene::Shape& shape, const SceneFrame::Placed& body, Color fill, Color edge,
                float width) {
  const Matrix<double, 3> rotation = body.rotation();
  std::array<ImVec2, 8> places;  // of the vertices, by their bits (1: +x, 2: +y, 4: +z)
  for (int bits = 0; bits < 8; ++bits) {
    const Point3 own((bits & 1) != 0 ? 1 : -1, (bits & 2) != 0 ? 1 : -1, (bits & 4) != 0 ? 1 : -1);
    places[bits] = brush.at(body.position + rotation * own.cwiseProduct(shape.half_extents));
  }
  const Point3 to_eye = brush.canvas.camera.eye() - body.position;
  for (int axis = 0; axis < 3; ++axis) {
    const double away = rotation.col(axis).dot(to_eye), half = shape.half_extents[axis];
    if (std::abs(away) <= half) continue;  // both faces are seen from behind
    const bool positive = away > 0;
    const int corner = positive ? 1 << axis : 0, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    const auto place = [&](int bits) { return places[corner | bits]; };
    // Clockwise as seen from outside, which is the way round that ImGui fills.
    const std::array<ImVec2, 4> outline{place(0), place(positive ? v : u), place(u | v), place(positive ? u : v)};
    const double light =
        0.78 + 0.26 * (positive ? 1 : -1) * rotation.col(axis).dot(brush.canvas.gl.light.cast<double>());
    brush.list->AddConvexPolyFilled(outline.data(), 4, shaded(fill, light));
    if (width > 0) path(brush.list, outline, true, Stroke::kSolid, edge, width);
  }
}

/// Draws a solid body: the faces of a box, or the outline of any other shape.
void draw_body(Brush& brush, const scene::Shape& shape, const SceneFrame::Placed& body, Color fill, bool touching) {
  const Palette& p = brush.p;
  const Color edge = touching ? p.support_text : p.ink;
  const bool crowd = lesson::members_of(brush.session).size() > kCrowd;
  const float width = crowd ? 0 : brush.stroke(touching ? 0.9f : 0.5f);
  if (shape.kind == scene::Shape::Kind::kBox) {
    draw_faces(brush, shape, body, fill, edge, width);
    return;
  }
  const Matrix<double, 3> rotation = body.rotation();
  std::vector<ImVec2> rims;
  for (const Point3& corner : shape.corners) {
    const Point3 at = body.position + rotation * corner;
    const ImVec2 middle = brush.at(at);
    const double apart = (brush.canvas.camera.eye() - at).norm();
    const double sine = shape.radius / std::max(apart, shape.radius);
    const double seen =
        sine < 1 ? shape.radius / std::sqrt(1 - sine * sine) : shape.radius;  // the radius of its silhouette
    const auto radius = static_cast<float>(seen * brush.canvas.camera.scale_at(at));
    for (int k = 0; k < (shape.radius > 0 ? kRim : 1); ++k) {
      const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(k) / kRim;
      rims.push_back({middle.x + radius * std::cos(turn), middle.y + radius * std::sin(turn)});
    }
  }
  const std::vector<ImVec2> outline = convex_outline(std::move(rims));
  if (outline.size() > 2) brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), fill);
  if (width > 0) path(brush.list, outline, true, Stroke::kSolid, edge, width);
}

/// A body's colour: that of all, which touching bodies have with some of theirs, or the one that it was given.
Color fill_of(const Brush& brush, std::size_t i, bool touching) {
  constexpr double kTouching = 0.35, kPainted = 0.5;
  const Palette& p = brush.p;
  const std::array<Color, lesson::kBodyColors.size()> colors{p.current, p.optimum, p.wrong, p.muted};
  const int own = painted(brush, i);
  if (own >= 0) return mixed(p.surface, colors[own], kPainted);
  return touching && lesson::members_of(brush.session)[i].moves() ? mixed(p.surface, p.support, kTouching) : p.surface;
}

/// Bars in the middle of a painted body, one more for each colour, for those who cannot tell the colours apart.
void draw_bars(Brush& brush, const Seen& body, int color) {
  constexpr float kPitch = 4;
  const ImVec2 at = brush.at(body.at.position);
  const float half = std::clamp(
      static_cast<float>(0.25 * body.shape.reach * brush.canvas.camera.scale_at(body.at.position)), 3.0f, 7.0f);
  for (int bar = 0; bar <= color; ++bar) {
    const float x = at.x + kPitch * (static_cast<float>(bar) - static_cast<float>(color) / 2);
    line(brush.list, {x, at.y - half}, {x, at.y + half}, Stroke::kSolid, brush.p.ink, 1.5f);
  }
}

/// Whether a body is drawn before all small ones, or after them: a floor that the eye looks down on is under what lies
/// on it, wherever its middle is. 0: by its middle.
int side_of_large(const Brush& brush, const SceneFrame& frame, std::size_t large) {
  const Seen wall = body_in(brush, frame, large);
  if (wall.shape.kind != scene::Shape::Kind::kBox) return 0;
  const Matrix<double, 3> to_local = wall.at.rotation().transpose();
  const auto beyond = [&](const Point3& p, int axis) {  // which of both faces across an axis it is beyond
    const double at = to_local.row(axis).dot(p - wall.at.position);
    return at > wall.shape.half_extents[axis] ? 1 : at < -wall.shape.half_extents[axis] ? -1 : 0;
  };
  int before = 0, after = 0;
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    if (body_in(brush, frame, i).shape.reach * kMuchLarger > wall.shape.reach) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const int body = beyond(frame.bodies[i].position, axis);
      if (body == 0) continue;
      ++(beyond(brush.canvas.camera.eye(), axis) == body ? before : after);
      break;
    }
  }
  return before > after ? -1 : after > before ? 1 : 0;
}

/// The bodies with a shape of their own, in the order in which they are drawn: nearer ones cover farther ones.
std::vector<std::size_t> by_depth(const Brush& brush, const SceneFrame& frame) {
  const std::span<const scene::Member> members = lesson::members_of(brush.session);
  double least = std::numeric_limits<double>::infinity();
  for (const scene::Member& member : members) least = std::min(least, member.shape.reach);
  std::vector<std::tuple<int, double, std::size_t>> order;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (members[i].shape.cloud != nullptr) continue;
    const int side = members[i].shape.reach > kMuchLarger * least ? side_of_large(brush, frame, i) : 0;
    order.emplace_back(side, -brush.canvas.camera.forward().dot(frame.bodies[i].position), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> bodies;
  for (const auto& [side, nearness, i] : order) bodies.push_back(i);
  return bodies;
}

/// Names keep clear of bodies, so that a pile is not covered with them.
void keep_clear_of(Brush& brush, const Seen& body) {
  constexpr double kFilled = 0.8;  // of the ball around a body, about what its picture fills
  const ImVec2 at = brush.at(body.at.position);
  const double reach = kFilled * body.shape.reach * brush.canvas.camera.scale_at(body.at.position);
  brush.canvas.obstacles.discs.push_back({at.x, at.y, static_cast<float>(reach)});
}

/// Draws the bodies, and after both bodies of a touching pair the place where they touch, which nearer bodies cover.
void draw_bodies(Brush& brush, const SceneFrame& frame) {
  const std::span<const scene::Member> members = lesson::members_of(brush.session);
  const std::vector<bool> touching = in_pairs(members.size(), frame.touching);
  const bool crowd = members.size() > kCrowd;
  const ImDrawListFlags flags = brush.list->Flags;
  if (crowd)
    brush.list->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // the antialiased fringe is half of their triangles
  const std::vector<std::vector<std::size_t>> partners = crowd ? decltype(partners){} : partners_in(frame);
  std::vector<bool> drawn(members.size(), false);
  for (const std::size_t i : by_depth(brush, frame)) {
    const Seen body = body_in(brush, frame, i);
    draw_body(brush, body.shape, body.at, fill_of(brush, i, touching[i]), touching[i]);
    drawn[i] = true;
    if (crowd) continue;
    if (const int color = painted(brush, i); color >= 0) draw_bars(brush, body, color);
    for (const std::size_t other : partners[i])
      if (drawn[other]) draw_contact(brush, body, body_in(brush, frame, other));
    if (members[i].moves()) keep_clear_of(brush, body);
  }
  brush.list->Flags = flags;
}

}  // namespace

void draw_scene(Brush& brush) {
  const SceneFrame& frame = *lesson::frame_of(brush.session);
  draw_traces(brush, frame);
  draw_loose(brush, frame);
  draw_update(brush, frame);
  if (const auto search = search_at(brush, frame)) draw_search(brush, frame, *search);
  draw_pairs(brush, frame);
  draw_bodies(brush, frame);
  if (frame.bodies.size() > kCrowd) draw_touching_in_crowd(brush, frame);
}

}  // namespace snug::app
