#include "app/volumes.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/crowded.hpp"
#include "geometry/convert.hpp"
#include "query/distance/support_function.hpp"

namespace snug::app {
namespace {

using V3 = Vector<double, 3>;

constexpr int kParts = 128;                            // of an ellipse
constexpr int kStride = 2;                             // of them for each piece of a great circle
constexpr float kFrontLine = 0.42f, kBackLine = 0.2f;  // alpha of the front and back of great circles

float bounded(double value) { return static_cast<float>(std::clamp(value, -1e30, 1e30)); }

bool is_flat(const Canvas& canvas) { return canvas.camera.dim() == 2; }

/// The points center + u cos t + v sin t.
std::vector<V3> ellipse(const V3& center, const V3& u, const V3& v, int parts) {
  std::vector<V3> points;
  for (int i = 0; i < parts; ++i) {
    const double t = 2 * std::numbers::pi * i / parts;
    points.push_back(center + u * std::cos(t) + v * std::sin(t));
  }
  return points;
}

std::vector<ImVec2> projected(const Canvas& canvas, const std::vector<V3>& points) {
  std::vector<ImVec2> screen;
  for (const V3& p : points) screen.push_back(canvas.at(p));
  return screen;
}

void add_obstacle(const Canvas& canvas, const std::vector<ImVec2>& outline) {
  for (std::size_t i = 0; i < outline.size(); i += 4) {
    const ImVec2 a = outline[i], b = outline[(i + 4) % outline.size()];
    canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
}

/// The number of parts that a curve is made of. Its chords are next to nowhere off: a chord of a circle is at most
/// radius (pi / parts)^2 / 2 from it. radius: in pixels; magnified curves need more parts.
int parts_for(double radius) {
  constexpr double kOff = 0.1, kMostParts = 4096;  // the first in pixels
  return static_cast<int>(std::clamp(std::numbers::pi * std::sqrt(radius / (2 * kOff)), double{kParts}, kMostParts));
}

/// The silhouette of an ellipsoid: an ellipse, computed on the unit sphere whose image the ellipsoid is.
std::vector<V3> silhouette(const V3& center, const Eigen::Matrix3d& axes, const V3& unit_eye, int parts) {
  const double square = unit_eye.squaredNorm();
  if (square <= 1.0001) return {};  // the eye is inside
  const V3 direction = unit_eye / std::sqrt(square);
  const V3 aside = direction.cross(std::abs(direction[1]) < 0.9 ? V3(V3::UnitY()) : V3(V3::UnitX())).normalized();
  const double radius = std::sqrt(1 - 1 / square);
  return ellipse(center + axes * (unit_eye / square), axes * (aside * radius), axes * (direction.cross(aside) * radius),
                 parts);
}

/// Draws a great circle, with its far half thinner and paler.
void great_circle(const Canvas& canvas, const V3& center, const Eigen::Matrix3d& axes, const V3& unit_eye, int a, int b,
                  Color color) {
  const std::vector<V3> points = ellipse(center, axes.col(a), axes.col(b), kParts);
  const std::vector<ImVec2> screen = projected(canvas, points);
  for (int i = 0; i < kParts; i += kStride) {
    const double t = 2 * std::numbers::pi * (i + 0.5 * kStride) / kParts;
    V3 unit = V3::Zero();
    unit[a] = std::cos(t), unit[b] = std::sin(t);
    const bool front = unit.dot(unit_eye) > 1;
    canvas.list->AddLine(screen[i], screen[(i + kStride) % kParts], with_alpha(color, front ? kFrontLine : kBackLine),
                         front ? 1.25f : 0.8f);
  }
}

void fill_convex(const Canvas& canvas, const std::vector<ImVec2>& outline, const VolumeStyle& style, float share) {
  if (style.fill > 0 && outline.size() > 2)
    canvas.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                                     with_alpha(style.color, style.fill * share));
}

void draw_solid(const Canvas& canvas, const V3& center, const Eigen::Matrix3d& axes, const VolumeStyle& style) {
  const double reach = axes.cwiseAbs().maxCoeff();
  if (!(reach > 0)) return;
  // A flat ellipsoid (points in a plane) has no inverse: a hair's breadth of thickness gives it one.
  Eigen::Matrix3d full = axes;
  for (int i = 0; i < 3; ++i)
    if (full.col(i).norm() < 1e-4 * reach)
      full.col(i) = full.col((i + 1) % 3).cross(full.col((i + 2) % 3)).normalized() * 1e-4 * reach;
  const V3 unit_eye = full.inverse() * (canvas.camera.eye() - center);
  const double pixels = reach * canvas.camera.scale_at(center);
  const std::vector<ImVec2> outline = projected(canvas, silhouette(center, full, unit_eye, parts_for(pixels)));
  if (canvas.camera.magnifies()) {  // OpenGL draws the stage alone
    fill_convex(canvas, outline, style, 1);
  } else if (style.fill > 0) {
    GlVolume volume;
    volume.axes = (full / canvas.frame.unit).cast<float>();
    volume.center = canvas.frame.to_stage(center);
    volume.color = style.color;
    volume.fill = style.fill;
    canvas.gl.volumes.push_back(volume);
    for (const auto& [a, b] : {std::pair{0, 2}, {0, 1}, {1, 2}})
      great_circle(canvas, center, full, unit_eye, a, b, style.color);
  }
  path(canvas.list, outline, true, style.stroke, style.color, style.width);
  if (!outline.empty()) add_obstacle(canvas, outline);
}

std::vector<ImVec2> around(const std::vector<ImVec2>& screen, const std::vector<int>& face) {
  std::vector<ImVec2> outline;
  for (const int corner : face) outline.push_back(screen[corner]);
  return outline;
}

void add_sides(const Canvas& canvas, const std::vector<ImVec2>& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ImVec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
}

std::vector<bool> faces_in_front(const Canvas& canvas, const Polytope& polytope) {
  if (polytope.faces.size() == 1) return {true};  // flat, and seen from both sides
  std::vector<bool> front;
  for (const auto& face : polytope.faces) {
    const auto corner = [&](std::size_t i) -> const V3& { return polytope.corners[face[i]]; };
    const V3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    front.push_back(normal.dot(canvas.camera.eye() - corner(0)) > 0);
  }
  return front;
}

void draw_face(const Canvas& canvas, const std::vector<ImVec2>& outline, const VolumeStyle& style, bool front) {
  fill_convex(canvas, outline, style, front ? 0.8f : 0.4f);
  path(canvas.list, outline, true, style.stroke, front ? style.color : with_alpha(style.color, 0.35f),
       front ? style.width : 0.5f * style.width);
  if (front) add_sides(canvas, outline);
}

/// Finds the points where lines of sight just touch a convex volume, in order around it; none where the eye is inside.
/// For each direction on the screen, Newton's method tilts a tangent plane until it goes through the eye.
template <template <class, int> class Kind>
std::vector<V3> tangent_points(const Kind<double, 3>& volume, const V3& eye) {
  constexpr int kTilts = 8;
  const Aabb<double, 3> box = query::box_around(volume);
  const V3 to_eye = (eye - (box.min + box.max) / 2).normalized();
  if (!(to_eye.dot(eye - query::support(volume, to_eye)) > 0)) return {};
  const V3 aside = to_eye.cross(std::abs(to_eye[1]) < 0.9 ? V3(V3::UnitY()) : V3(V3::UnitX())).normalized();
  const V3 up = to_eye.cross(aside);
  std::vector<V3> points;
  for (int i = 0; i < kParts; ++i) {
    const double around = 2 * std::numbers::pi * i / kParts;
    const V3 outward = aside * std::cos(around) + up * std::sin(around);
    V3 touched = V3::Zero();
    double tilt = 0;
    for (int step = 0; step < kTilts; ++step) {
      const V3 normal = outward * std::cos(tilt) + to_eye * std::sin(tilt);
      touched = query::support(volume, normal);
      const double beyond = normal.dot(eye - touched);
      const double slope = (to_eye * std::cos(tilt) - outward * std::sin(tilt)).dot(eye - touched);
      if (slope > 0) tilt = std::clamp(tilt - beyond / slope, -1.5, 1.5);
    }
    points.push_back(touched);
  }
  return points;
}

/// The border of a convex volume of the plane. scale: pixels of a scene unit.
template <template <class, int> class Kind>
std::vector<V3> border_points(const Kind<double, 3>& volume, double scale) {
  const auto own = converted<double, 2>(volume);
  const Aabb<double, 2> box = query::box_around(own);
  const int parts = parts_for((box.max - box.min).maxCoeff() / 2 * scale);
  std::vector<V3> points;
  for (const V3& direction : ellipse(V3::Zero(), V3::UnitX(), V3::UnitY(), parts))
    convert_into(points.emplace_back(), query::support(own, direction.head<2>()));
  return points;
}

/// Leaves out points of an outline that lie where a neighbour lies: many directions have one vertex.
std::vector<ImVec2> apart(const std::vector<ImVec2>& points) {
  constexpr float kPixels = 0.25f;
  const auto same = [](ImVec2 p, ImVec2 q) { return std::abs(p.x - q.x) + std::abs(p.y - q.y) <= kPixels; };
  std::vector<ImVec2> kept;
  for (const ImVec2 p : points)
    if (kept.empty() || !same(p, kept.back())) kept.push_back(p);
  while (kept.size() > 1 && same(kept.front(), kept.back())) kept.pop_back();
  return kept;
}

/// Draws the outline of any convex volume.
template <template <class, int> class Kind>
void draw_volume(const Canvas& canvas, const Kind<double, 3>& volume, const VolumeStyle& style) {
  const std::vector<ImVec2> outline =
      apart(projected(canvas, is_flat(canvas) ? border_points(volume, canvas.camera.scale_at(V3::Zero()))
                                              : tangent_points(volume, canvas.camera.eye())));
  fill_convex(canvas, outline, style, 1);
  path(canvas.list, outline, true, style.stroke, style.color, style.width);
  add_sides(canvas, outline);
}

/// Draws what a sphere was swept over.
void draw_core(const Canvas& canvas, const std::vector<V3>& core, const VolumeStyle& style) {
  if (style.fill > 0)
    path(canvas.list, projected(canvas, core), core.size() > 2, Stroke::kDashed, with_alpha(style.color, 0.5f), 1);
}

}  // namespace

std::vector<ImVec2> convex_outline(std::vector<ImVec2> points) {
  std::sort(points.begin(), points.end(), [](ImVec2 a, ImVec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto turns = [](ImVec2 a, ImVec2 b, ImVec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
  };
  std::vector<ImVec2> outline;
  for (int side = 0; side < 2; ++side) {
    const std::size_t begin = outline.size() + 1;
    for (const ImVec2 p : points) {
      while (outline.size() > begin && !turns(outline[outline.size() - 2], outline.back(), p)) outline.pop_back();
      outline.push_back(p);
    }
    outline.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return outline;
}

Point3f Frame::to_stage(const V3& p) const {
  const V3 q = (p - origin) / unit;
  return {bounded(q[0]), bounded(q[1]), bounded(q[2])};
}

void draw_volume(const Canvas& canvas, const Sphere<double, 3>& ball, const VolumeStyle& style) {
  if (!is_flat(canvas)) {
    draw_solid(canvas, ball.center, Eigen::Matrix3d(Eigen::Matrix3d::Identity() * ball.radius), style);
    return;
  }
  const ImVec2 center = canvas.at(ball.center);
  const float radius = bounded(ball.radius * canvas.camera.scale_at(ball.center));
  if (style.fill > 0) filled_circle(canvas.list, center, radius, with_alpha(style.color, style.fill));
  circle(canvas.list, center, radius, style.stroke, style.color, style.width);
  canvas.obstacles.circles.push_back({center.x, center.y, radius});
}

void draw_volume(const Canvas& canvas, const Ellipsoid& ellipsoid, const VolumeStyle& style) {
  if (!is_flat(canvas)) {
    draw_solid(canvas, ellipsoid.center, Eigen::Matrix3d(ellipsoid.half_axes), style);
    return;
  }
  std::array<V3, 2> axes{V3::Zero(), V3::Zero()};
  std::size_t found = 0;
  for (int i = 2; i >= 0 && found < 2; --i)
    if (std::abs(ellipsoid.half_axes(2, i)) == 0) axes[found++] = ellipsoid.half_axes.col(i);
  if (axes[0].cross(axes[1])[2] < 0) std::swap(axes[0], axes[1]);  // the way round that ImGui fills
  const double reach = std::max(axes[0].norm(), axes[1].norm()) * canvas.camera.scale_at(ellipsoid.center);
  const std::vector<ImVec2> outline = projected(canvas, ellipse(ellipsoid.center, axes[0], axes[1], parts_for(reach)));
  fill_convex(canvas, outline, style, 1);
  path(canvas.list, outline, true, style.stroke, style.color, style.width);
  add_obstacle(canvas, outline);
}

void draw_volume(const Canvas& canvas, const Polytope& polytope, const VolumeStyle& style) {
  const std::vector<ImVec2> screen = projected(canvas, polytope.corners);
  if (is_flat(canvas)) {
    const std::vector<ImVec2> outline = around(screen, polytope.faces.front());
    fill_convex(canvas, outline, style, 1);
    path(canvas.list, outline, true, style.stroke, style.color, style.width);
    add_sides(canvas, outline);
    return;
  }
  // An edge is in front if at least one of its faces faces the eye.
  const std::vector<bool> front = faces_in_front(canvas, polytope);
  if (is_crowded(polytope, screen, front)) return draw_crowded(canvas, polytope, screen, front, style);
  for (const bool near : {false, true})
    for (std::size_t f = 0; f < polytope.faces.size(); ++f)
      if (front[f] == near) draw_face(canvas, around(screen, polytope.faces[f]), style, near);
}

void draw_volume(const Canvas& canvas, const Capsule<double, 3>& capsule, const VolumeStyle& style) {
  draw_volume<Capsule>(canvas, capsule, style);
  draw_core(canvas, {capsule.a, capsule.b}, style);
}

void draw_volume(const Canvas& canvas, const Lozenge<double, 3>& lozenge, const VolumeStyle& style) {
  const auto& [u, v] = lozenge.edges;
  draw_volume<Lozenge>(canvas, lozenge, style);
  draw_core(canvas, {lozenge.origin, lozenge.origin + u, lozenge.origin + u + v, lozenge.origin + v}, style);
}

void draw_volume(const Canvas& canvas, const fit::Volume3& volume, const VolumeStyle& style) {
  std::visit(
      [&]<class Kind>(const Kind& kind) {
        if constexpr (requires { polytope_of(kind, 2); })
          draw_volume(canvas, polytope_of(kind, canvas.camera.dim()), style);
        else draw_volume(canvas, kind, style);
      },
      volume);
}

void draw_box(const Canvas& canvas, const V3& least, const V3& greatest, const VolumeStyle& style) {
  const int corners = is_flat(canvas) ? 4 : 8;
  const auto corner = [&](int bits) {
    V3 p = least;
    for (int axis = 0; axis < 3; ++axis)
      if (bits >> axis & 1) p[axis] = greatest[axis];
    return p;
  };
  for (int from = 0; from < corners; ++from)
    for (int axis = 0; axis < canvas.camera.dim(); ++axis)
      if ((from >> axis & 1) == 0) draw_line(canvas, corner(from), corner(from | 1 << axis), style);
}

void draw_line(const Canvas& canvas, const V3& a, const V3& b, const VolumeStyle& style) {
  const ScreenPoint from = canvas.camera.project(a), to = canvas.camera.project(b);
  if (!from.visible || !to.visible) return;
  line(canvas.list, {from.x, from.y}, {to.x, to.y}, style.stroke, style.color, style.width);
  canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
}

}  // namespace snug::app
