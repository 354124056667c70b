#include "app/crowded.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace snug::app {
namespace {

constexpr std::size_t kManyFaces = 60;
constexpr double kSmallFace = 64;  // pixels squared, on average: edges about twelve pixels long
constexpr double kShade = 0.5;     // of a face that the light only grazes
constexpr float kShadeOver = 0.5f;

std::vector<ImVec2> face_on_screen(const std::vector<ImVec2>& screen, const std::vector<int>& face) {
  std::vector<ImVec2> outline;
  for (const int corner : face) outline.push_back(screen[corner]);
  return outline;
}

double area_of(const std::vector<ImVec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ImVec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    twice += static_cast<double>(a.x) * b.y - static_cast<double>(b.x) * a.y;
  }
  return std::abs(twice) / 2;
}

}  // namespace

bool is_crowded(const Polytope& polytope, const std::vector<ImVec2>& screen, const std::vector<bool>& front) {
  if (polytope.faces.size() < kManyFaces) return false;
  const auto seen = static_cast<double>(std::count(front.begin(), front.end(), true));
  return area_of(convex_outline(screen)) < kSmallFace * seen;
}

void draw_crowded(const Canvas& canvas, const Polytope& polytope, const std::vector<ImVec2>& screen,
                  const std::vector<bool>& front, const VolumeStyle& style) {
  const Camera& camera = canvas.camera;
  const Vector<double, 3> towards = camera.right().cross(camera.up());
  const Vector<double, 3> light = (camera.up() - camera.right() + towards).normalized();  // from above left
  const ImDrawListFlags flags = canvas.list->Flags;
  canvas.list->Flags &= ~ImDrawListFlags_AntiAliasedFill;  // whose fringes would draw the edges again
  for (std::size_t f = 0; style.fill > 0 && f < polytope.faces.size(); ++f) {
    if (!front[f]) continue;
    const auto corner = [&](std::size_t i) { return polytope.corners[polytope.faces[f][i]]; };
    const Vector<double, 3> normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    const double lit = std::max(0.0, normal.dot(light));
    const std::vector<ImVec2> outline = face_on_screen(screen, polytope.faces[f]);
    canvas.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()),
                                     with_alpha(shaded(style.color, kShade + (1.3 - kShade) * lit), kShadeOver));
  }
  canvas.list->Flags = flags;
  const std::vector<ImVec2> outline = convex_outline(screen);
  path(canvas.list, outline, true, style.stroke, style.color, style.width);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const ImVec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
}

}  // namespace snug::app
