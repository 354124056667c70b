// Draws two volumes of any kind, and what the step of their test is about.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/box_marks.hpp"
#include "app/polytope.hpp"
#include "app/subjects/pair/draw.hpp"
#include "lesson/subjects/pair/feature.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

using lesson::Handle;
using lesson::HeldVolume;
using Kind = Handle::Kind;

/// A box, axis-aligned or not, as an oriented box for the separating-axis test.
Obb<double, 3> as_box(const fit::Volume3& volume) {
  if (const auto* box = std::get_if<Obb<double, 3>>(&volume)) return *box;
  const auto& upright = *std::get_if<Aabb<double, 3>>(&volume);
  return {(upright.min + upright.max) / 2, Matrix<double, 3>::Identity(), (upright.max - upright.min) / 2};
}

struct Drawing {
  Brush& brush;
  const lesson::VolumePair& pair;
  const std::array<std::vector<Point3>, 2> cores{lesson::core_of(pair.held[0]), lesson::core_of(pair.held[1])};

  void volume(int side) const {
    const Palette& p = brush.p;
    const HeldVolume& held = pair.held[side];
    draw_volume(brush.canvas, held.volume, {Stroke::kSolid, p.current, brush.stroke(), p.fill});
    const Point3 center = lesson::at_handle(held, {});
    draw_center(brush, center, p.current);
    brush.label(brush.at(center), 12, {side == 0 ? -1.0f : 1.0f, -1}, side == 0 ? "A" : "B", p.current_text,
                Face::kSemiBold, 18);
    if (lesson::radius_of(held) > 0 && cores[side].size() > 1) core(side, p.muted, 0.7f);
    for (const Handle& handle : lesson::handles_of(held)) knob(held, handle, center);
  }

  void knob(const HeldVolume& held, const Handle& handle, const Point3& center) const {
    if (handle.kind == Kind::kCenter) return;
    const Point3 at = lesson::at_handle(held, handle);
    if (handle.kind == Kind::kVertex) {
      const ImVec2 place = brush.at(at);
      disc(brush.list, place, 3 * brush.p.mark, brush.p.current);
      return;
    }
    draw_knob(brush, handle.kind == Kind::kTurn ? center : at, at, handle.kind == Kind::kTurn);
  }

  /// Draws the cylinder on a capsule's axis: both rims, and the outline of all.
  void cylinder(int side) const {
    const auto* capsule = std::get_if<Capsule<double, 3>>(&pair.held[side].volume);
    if (capsule == nullptr || capsule->a == capsule->b) return;
    const Color color = brush.p.previous;
    std::vector<ImVec2> all;
    for (const Point3& end : {capsule->a, capsule->b}) {
      const std::vector<ImVec2> rim = rim_around(end, capsule->b - capsule->a, capsule->radius);
      path(brush.list, rim, true, Stroke::kDashed, color, brush.stroke(0.7f));
      all.insert(all.end(), rim.begin(), rim.end());
    }
    path(brush.list, convex_outline(all), true, Stroke::kDashed, color, brush.stroke(0.9f));
  }

  /// The circle of a radius around an axis, on the screen.
  std::vector<ImVec2> rim_around(const Point3& center, const Point3& axis, double radius) const {
    constexpr int kParts = 48;
    const Point3 u = axis.unitOrthogonal() * radius, v = axis.normalized().cross(u);
    std::vector<ImVec2> rim;
    for (int i = 0; i < kParts; ++i) {
      const double angle = 2 * std::numbers::pi * i / kParts;
      rim.push_back(brush.at(center + std::cos(angle) * u + std::sin(angle) * v));
    }
    return rim;
  }

  /// Draws the core.
  void core(int side, Color color, float width) const {
    const std::vector<Point3>& all = cores[side];
    const VolumeStyle style{Stroke::kDashed, color, brush.stroke(width)};
    if (all.size() == 4)
      for (const auto& [from, to] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}})
        draw_line(brush.canvas, all[from], all[to], style);
    else if (all.size() == 2) draw_line(brush.canvas, all[0], all[1], style);
  }

  void operator()(const auto&) const {}
  void operator()(const query::SlabTested& fact) const {
    Intervals both{.direction = fact.direction,
                   .ends = {{{fact.least_a, fact.greatest_a}, {fact.least_b, fact.greatest_b}}},
                   .separates = fact.separates,
                   .name = lesson::axis_name(fact.direction)};
    for (const int side : {0, 1}) {
      const fit::Volume3& volume = pair.held[side].volume;
      both.farthest[side] = {farthest_in(volume, -fact.direction, pair.dim),
                             farthest_in(volume, fact.direction, pair.dim)};
      both.reach.insert(both.reach.end(), cores[side].begin(), cores[side].end());
    }
    draw_intervals(brush, both);
  }
  void operator()(const query::AxisTested<double, 3>& fact) const {
    if (fact.skipped) return;
    draw_projections(brush, {.dim = pair.dim, .boxes = {as_box(pair.held[0].volume), as_box(pair.held[1].volume)}},
                     fact);
  }
  void operator()(const query::CoresCompared& fact) const {
    for (const int side : {0, 1}) core(side, brush.p.examined, 1.1f);
    for (const int side : {0, 1}) feature(side, side == 0 ? fact.on_a : fact.on_b, fact.distance);
    between_cores(fact.on_a, fact.on_b, fact.distance, fact.apart);
  }
  /// Draws the vertex, the edge or the face of a rectangle that is nearest to the other core.
  void feature(int side, const Point3& nearest, double distance) const {
    const auto* lozenge = std::get_if<Lozenge<double, 3>>(&pair.held[side].volume);
    if (lozenge == nullptr || !(distance > 0)) return;
    const Palette& p = brush.p;
    std::vector<ImVec2> at;
    for (const Point3& corner : lesson::feature_at(*lozenge, nearest).corners) at.push_back(brush.at(corner));
    if (at.size() == 1) return diamond(brush.list, at[0], 8 * p.mark, p.support, p.ground);
    if (at.size() > 2)
      brush.list->AddConvexPolyFilled(at.data(), static_cast<int>(at.size()), with_alpha(p.support, 0.14f));
    path(brush.list, at, at.size() > 2, Stroke::kSolid, p.support, brush.stroke(1.5f));
  }
  /// Draws the line between the nearest points, and the parts of it that the radii cover.
  void between_cores(const Point3& on_a, const Point3& on_b, double distance, bool known_apart) const {
    const Palette& p = brush.p;
    const Point3 way = on_b - on_a;
    const double length = way.norm();
    const ImVec2 from = brush.at(on_a), to = brush.at(on_b);
    const Color color = known_apart ? p.wrong : p.examined;
    line(brush.list, from, to, Stroke::kSolid, color, brush.stroke(1.1f));
    brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
    for (const int side : {0, 1}) {
      const double radius = lesson::radius_of(pair.held[side]);
      disc(brush.list, side == 0 ? from : to, 4.5f * p.mark, color);
      if (!(radius > 0) || !(length > 0)) continue;
      const Point3 foot = side == 0 ? on_a : on_b, unit = way / (side == 0 ? length : -length);
      const ImVec2 a = brush.at(foot), b = brush.at(foot + unit * radius);
      line(brush.list, a, b, Stroke::kSolid, p.current, brush.stroke(1.8f));
      const ImVec2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      brush.label(middle, 6, {b.y - a.y, a.x - b.x}, (side == 0 ? "r_A = " : "r_B = ") + lesson::number_text(radius),
                  p.current_text, Face::kSemiBold, 13);
    }
    const double radii = lesson::radius_of(pair.held[0]) + lesson::radius_of(pair.held[1]);
    brush.label({(from.x + to.x) / 2, (from.y + to.y) / 2}, 8, {from.y - to.y, to.x - from.x},
                "distance between the " + std::string(lesson::compared_in(pair)) + " " +
                    lesson::number_texts_apart(distance, radii).first,
                known_apart ? p.wrong_text : p.examined_text, Face::kSemiBold, 13);
  }
  void operator()(const query::NearestFound& fact) const {
    for (std::size_t i = 0; i < fact.corners.size(); i += 2) difference(fact.corners[i], fact.corners[i + 1], true);
  }
  void operator()(const query::SupportFound& fact) const { difference(fact.a, fact.b, false); }
  /// Draws a vertex of A - B as the two vertices whose difference it is; nothing where a point of a smooth core is no
  /// vertex.
  void difference(Index a, Index b, bool kept) const {
    if (a == kNoIndex || b == kNoIndex) return;
    const Palette& p = brush.p;
    const ImVec2 from = brush.at(cores[1][b]), to = brush.at(cores[0][a]);
    line(brush.list, from, to, kept ? Stroke::kSolid : Stroke::kDashed, p.examined, brush.stroke(0.9f));
    for (const ImVec2 at : {from, to}) ring(brush.list, at, 9 * p.mark, p.examined, brush.stroke());
    brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
  }
  /// Shows only the cores: the next step decides whether the volumes are apart.
  void operator()(const query::DistanceFound&) const {
    if (const auto apart = lesson::core_separation_of(pair))
      between_cores(apart->on_a, apart->on_b, apart->distance, false);
  }
  void operator()(const lesson::OverlapDecided& fact) const {
    if (!fact.overlap) nearest();
  }
  void nearest() const {
    const Palette& p = brush.p;
    const auto apart = lesson::separation_of(pair);
    if (!apart) return;
    const ImVec2 from = brush.at(apart->on_a), to = brush.at(apart->on_b);
    line(brush.list, from, to, Stroke::kSolid, p.wrong, brush.stroke(1.3f));
    for (const ImVec2 at : {from, to}) disc(brush.list, at, 4.5f * p.mark, p.wrong);
    brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
    brush.label({(from.x + to.x) / 2, (from.y + to.y) / 2}, 8, {from.y - to.y, to.x - from.x},
                "distance " + lesson::gap_text(apart->distance), p.wrong_text, Face::kSemiBold, 13);
    if (!pair.any) return;
    const Point3 middle = (apart->on_a + apart->on_b) / 2;
    if (pair.dim == 2) separating_line(middle, apart->direction);
    else separating_plane(middle, apart->direction);
  }
  /// The plane across the separating axis, half way between both volumes.
  void separating_plane(const Point3& middle, const Point3& axis) const {
    const auto corners = plane_across(axis, middle, 0.6 * (cores[0].front() - cores[1].front()).norm());
    std::vector<ImVec2> at;
    for (const Point3& corner : corners) at.push_back(brush.at(corner));
    brush.list->AddConvexPolyFilled(at.data(), static_cast<int>(at.size()), with_alpha(brush.p.optimum, 0.1f));
    path(brush.list, at, true, Stroke::kLongDashed, brush.p.optimum, brush.stroke(0.9f));
    const ImVec2 high = *std::min_element(at.begin(), at.end(), [](ImVec2 a, ImVec2 b) { return a.y < b.y; });
    brush.label(high, 6, {0, -1}, "separates A and B", brush.p.optimum_text, Face::kSemiBold, 13);
  }
  /// Draws the line across the separating axis, half way between both volumes.
  void separating_line(const Point3& middle, const Point3& axis) const {
    const Point3 along = Point3(-axis[1], axis[0], 0) * (1.2 * (cores[0].front() - cores[1].front()).norm());
    const ImVec2 from = brush.at(middle - along), to = brush.at(middle + along);
    line(brush.list, from, to, Stroke::kLongDashed, brush.p.optimum, brush.stroke(0.9f));
    brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
    brush.label(to, 6, {to.x - from.x, to.y - from.y}, "separates A and B", brush.p.optimum_text, Face::kSemiBold, 13);
  }
};

}  // namespace

std::array<Point3, 4> plane_across(const Point3& axis, const Point3& middle, double half) {
  const Point3 along = axis.unitOrthogonal() * half, across = axis.normalized().cross(along);
  return {middle + along + across, middle - along + across, middle - along - across, middle + along - across};
}

void draw_volumes(Brush& brush, lesson::PairSteps steps) {
  const Drawing drawing{brush, lesson::as<lesson::VolumesSubject>(brush.session.stage().subject())->pair()};
  for (const int side : {0, 1}) drawing.volume(side);
  if (drawing.pair.cylinders)
    for (const int side : {0, 1}) drawing.cylinder(side);
  if (steps.empty()) return;
  const auto is_box = [&](int side) { return std::holds_alternative<Aabb<double, 3>>(drawing.pair.held[side].volume); };
  if (is_box(0) && is_box(1))  // their intervals stay beside the axes
    for (const auto& entry : steps.first(steps.size() - 1))
      if (const auto* slab = std::get_if<query::SlabTested>(&entry.step.fact)) drawing(*slab);
  std::visit(drawing, steps.back().step.fact);
}

}  // namespace snug::app
