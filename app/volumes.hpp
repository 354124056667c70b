// Draws each kind of volume, in 2-D and in 3-D: the outline on ImGui's draw list, the body with OpenGL.
// Any volume is drawn by its outline; a kind that shows more has an overload of draw_volume.
#pragma once

#include "app/camera.hpp"
#include "app/labels.hpp"
#include "app/marks.hpp"
#include "app/polytope.hpp"
#include "app/stage_gl.hpp"

namespace snug::app {

/// The origin and unit of stage coordinates, so that OpenGL's floats are precise: scene = origin + unit * stage.
struct Frame {
  Vector<double, 3> origin = Vector<double, 3>::Zero();
  double unit = 1;

  [[nodiscard]] Point3f to_stage(const Vector<double, 3>& p) const;
};

/// What volumes are drawn on.
struct Canvas {
  ImDrawList* list;
  const Look& look;
  const Camera& camera;
  const Frame& frame;
  GlScene& gl;
  Obstacles& obstacles;  // lines that labels keep clear of are added as they are drawn

  [[nodiscard]] ImVec2 at(const Vector<double, 3>& p) const {
    const ScreenPoint screen = camera.project(p);
    return {screen.x, screen.y};
  }
};

struct VolumeStyle {
  Stroke stroke = Stroke::kSolid;
  Color color = 0;
  float width = 2;
  float fill = 0;  // alpha; 0: the outline alone
};

struct Ellipsoid {
  Vector<double, 3> center;
  Matrix<double, 3> half_axes;  // as columns; in 2-D those with a z are left out
};

void draw_volume(const Canvas& canvas, const Sphere<double, 3>& ball, const VolumeStyle& style);
void draw_volume(const Canvas& canvas, const Ellipsoid& ellipsoid, const VolumeStyle& style);
/// Faces that face away have thinner and paler edges.
void draw_volume(const Canvas& canvas, const Polytope& polytope, const VolumeStyle& style);
void draw_volume(const Canvas& canvas, const Capsule<double, 3>& capsule, const VolumeStyle& style);
void draw_volume(const Canvas& canvas, const Lozenge<double, 3>& lozenge, const VolumeStyle& style);
/// Draws any kind of volume.
void draw_volume(const Canvas& canvas, const fit::Volume3& volume, const VolumeStyle& style);
/// The vertices of the points' convex hull, in order around it.
/// Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
[[nodiscard]] std::vector<ImVec2> convex_outline(std::vector<ImVec2> points);
/// Draws the edges of an axis-aligned box.
void draw_box(const Canvas& canvas, const Vector<double, 3>& least, const Vector<double, 3>& greatest,
              const VolumeStyle& style);
/// Draws a straight line of the scene, which labels keep clear of.
void draw_line(const Canvas& canvas, const Vector<double, 3>& a, const Vector<double, 3>& b, const VolumeStyle& style);

}  // namespace snug::app
