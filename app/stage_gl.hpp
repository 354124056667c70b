// The part of the stage that OpenGL draws, beneath ImGui's draw lists: grounds, grids, meshes, translucent volumes,
// points. It knows neither lessons nor ImGui: it turns plain buffers into pixels.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/app.hpp"
#include "app/palette.hpp"

namespace snug::app {

using Point3f = Vector<float, 3>;

/// A ball or an ellipsoid, as the image of the unit sphere in stage units.
struct GlVolume {
  Matrix<float, 3> axes = Matrix<float, 3>::Identity();  // columns: half axes
  Point3f center = Point3f::Zero();
  Color color = 0;
  float fill = 0.09f;  // alpha looking straight through one side; higher at the rim
};

/// One of many things that are too small for a drawing of their own, as a mark.
struct GlMark {
  enum Shape { kDot, kSquare, kDiamond, kCross };  // a dot; filled; hollow; crossed out
  Point3f at = Point3f::Zero();                    // stage units
  float radius = 0;                                // stage units: on the screen it becomes smaller with the distance
  float shape = kDot;
  Color color = 0;
};

/// All of them, the ones that are to be on top last.
struct GlMarks {
  std::vector<GlMark> marks;
  std::uint64_t version = 0;              // changes with them
  float least_radius = 1, greatest = 24;  // page pixels
};

struct GlScene {
  Rect stage;
  Color ground = 0, grid = 0, surface = 0, point = 0;
  bool three_d = false;
  std::array<float, 16> view_projection{};  // column-major, into the stage's rectangle
  Point3f eye = Point3f::Zero();
  float eye_to_target = 1;           // 3-D: stage units
  Point3f light = Point3f::UnitY();  // direction towards the light

  float grid_step = 40;          // 2-D: page pixels
  float grid_x = 0, grid_y = 0;  // 2-D: the place of one line, page pixels from the stage's left and bottom
  float plane_height = -1, plane_step = 0.25f, plane_reach = 4;  // 3-D: stage units

  std::vector<Point3f> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Point3f> normals;          // one per point if there are triangles
  std::uint64_t points_version = 0;      // changes with the points or the triangles
  float point_radius = 5;                // page pixels
  std::vector<GlVolume> volumes;         // 3-D: the farthest first
  float focal = 1;                       // 3-D: page pixels of a stage unit at the distance of one
  std::shared_ptr<const GlMarks> marks;  // 3-D; null for none
};

class StageGl {
 public:
  /// Compiles and allocates, and forgets what it made before. Returns false on failure: see error().
  bool create(const char* glsl_version);
  /// Forgets every object without freeing it, because the context is gone.
  void abandon();
  [[nodiscard]] bool ready() const { return programs_[0] != 0; }
  [[nodiscard]] const std::string& error() const { return error_; }

  /// Draws; the depth is cleared. The framebuffer's size is in device pixels; scale: device pixels per page pixel.
  void draw(const GlScene& scene, int framebuffer_width, int framebuffer_height, float scale);

 private:
  enum Program { kLine, kMesh, kVolume, kPoint, kMark, kPrograms };
  struct Shape {
    std::uint32_t array = 0, vertices = 0, indices = 0;
    int count = 0;
  };

  bool build(const char* glsl_version, Program program, const char* vertex, const char* fragment);
  [[nodiscard]] int uniform(Program program, const char* name) const;
  void use(Program program, const GlScene& scene) const;
  void set_color(Program program, const char* name, Color color) const;
  void make_shapes();
  void upload(const GlScene& scene);
  void draw_ground(const GlScene& scene, int width, int height, float scale);
  void draw_mesh(const GlScene& scene) const;
  void draw_volumes(const GlScene& scene) const;
  void draw_points(const GlScene& scene, float scale) const;
  void draw_marks(const GlScene& scene, float scale);

  std::array<std::uint32_t, kPrograms> programs_{};
  Shape lines_, sphere_, mesh_, points_, marks_;
  std::uint64_t uploaded_ = ~std::uint64_t{0};
  std::weak_ptr<const GlMarks> uploaded_marks_;
  std::uint64_t uploaded_version_ = 0;
  int point_count_ = 0;
  std::string error_;
};

}  // namespace snug::app
