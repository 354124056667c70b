#include "app/stage_gl.hpp"

#include <Eigen/LU>
#include <snug_gl.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "app/ground.hpp"

namespace snug::app {
namespace {

// ---- shaders: each follows the door's version line and a precision that desktop GL ignores -------------------

// A renderer without a GPU pays for every pixel that a shader runs on. So grids are lines, not a shader over the whole
// stage, and light is computed for vertices.

constexpr const char* kLineVertex = R"(
in vec4 position;  // z: pixels from the line's middle, w: how much of the line is left
out vec2 line;
void main() {
  line = position.zw;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
)";
constexpr const char* kLineFragment = R"(
uniform float width;  // device pixels
uniform vec4 color;
in vec2 line;
out vec4 result;
void main() {
  result = vec4(color.rgb, color.a * line.y * clamp(0.5 * width + 0.5 - abs(line.x), 0.0, 1.0));
}
)";

constexpr const char* kMeshVertex = R"(
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec3 light;
in vec3 position;
in vec3 normal;
out vec2 shade;  // of the front, of the back
// Matte: light wraps a little round the edge, and what faces away keeps its shape.
float shaded(float towards_eye, float towards_light) {
  float lit = pow(0.5 + 0.5 * towards_light, 1.4);
  float edge = 1.0 - clamp(towards_eye, 0.0, 1.0);
  return (0.58 + 0.48 * lit) * (1.0 - 0.25 * edge * edge * edge);
}
void main() {
  float towards_eye = dot(normal, normalize(eye - position)), towards_light = dot(normal, light);
  shade = vec2(shaded(towards_eye, towards_light), shaded(-towards_eye, -towards_light));
  gl_Position = view_projection * vec4(position, 1.0);
}
)";
constexpr const char* kMeshFragment = R"(
uniform vec4 color;
in vec2 shade;
out vec4 result;
void main() { result = vec4(color.rgb * (gl_FrontFacing ? shade.x : shade.y), 1.0); }
)";

constexpr const char* kVolumeVertex = R"(
uniform mat4 view_projection;
uniform mat3 axes;
uniform mat3 axes_inverse_transposed;
uniform vec3 center;
uniform vec3 eye;
uniform vec3 light;
uniform vec4 color;  // a: the fill
in vec3 position;
out vec4 tint;
// Only the half towards the eye is drawn, with the far half's share in it: what is seen through both is painted once.
void main() {
  vec3 place = center + axes * position;
  vec3 n = normalize(axes_inverse_transposed * position);
  float facing = dot(n, normalize(eye - place)), rim = 1.0 - abs(facing);
  float lit = 0.5 + 0.5 * dot(n, light) * sign(facing);
  float near = step(0.0, facing) * (color.a * (0.8 + 0.4 * (1.0 - lit)) + 0.30 * rim * rim * rim);
  float far = 0.45 * (color.a + 0.30 * rim * rim * rim);  // paler, and all that is seen from inside
  tint = vec4(mix(color.rgb, vec3(1.0), 0.16 * lit), 1.0 - (1.0 - near) * (1.0 - far));
  gl_Position = view_projection * vec4(place, 1.0);
}
)";
constexpr const char* kVolumeFragment = R"(
in vec4 tint;
out vec4 result;
void main() { result = tint; }
)";

// Points are point sprites, not instanced quads, because renderers without a GPU draw each instance
// separately.
constexpr const char* kPointVertex = R"(
uniform mat4 view_projection;
uniform vec3 eye;
uniform float radius;  // device pixels
uniform float towards; // how much nearer to the eye, so that a surface does not swallow its own vertices
uniform float reach;   // the depth at which a point has its size: nearer ones are larger; 0 where there is no depth
in vec3 position;
out float size;
void main() {
  gl_Position = view_projection * vec4(mix(position, eye, towards), 1.0);
  size = reach > 0.0 ? radius * clamp(reach / gl_Position.w, 0.6, 1.5) : radius;
  gl_PointSize = 2.0 * (size + 1.0);
}
)";
constexpr const char* kPointFragment = R"(
uniform vec4 color;
in float size;
out vec4 result;
void main() {
  float from_center = length(gl_PointCoord - 0.5) * 2.0 * (size + 1.0);
  float inside = clamp(size + 0.5 - from_center, 0.0, 1.0);
  if (inside <= 0.0) discard;
  result = vec4(color.rgb, color.a * inside);
}
)";

// Many marks in one call, each of its own size, shape and colour.
constexpr const char* kMarkVertex = R"(
uniform mat4 view_projection;
uniform vec2 reach;   // the least and the greatest radius, device pixels
uniform float focal;  // device pixels
in vec3 position;
in vec2 style;        // x: radius, y: shape
in vec4 tint;
out float size;
out float shape;
out vec4 color;
void main() {
  gl_Position = view_projection * vec4(position, 1.0);
  size = clamp(focal * style.x / max(gl_Position.w, 0.0001), reach.x, reach.y);
  shape = style.y;
  color = tint;
  gl_PointSize = 2.0 * (size + 1.0);
}
)";
constexpr const char* kMarkFragment = R"(
in float size;
in float shape;
in vec4 color;
out vec4 result;
void main() {
  vec2 p = abs(gl_PointCoord - 0.5) * 2.0 * (size + 1.0);
  float thick = max(1.0, 0.28 * size), inside;
  if (shape < 0.5) inside = 0.6 * size + 0.5 - length(p);
  else if (shape < 1.5) inside = 0.85 * size + 0.5 - max(p.x, p.y);
  else if (shape < 2.5) inside = 0.5 * thick + 0.5 - abs(0.7071 * (p.x + p.y - size) + 0.5 * thick);
  else inside = min(0.5 * thick + 0.5 - 0.7071 * abs(p.x - p.y), 0.8 * size + 0.5 - max(p.x, p.y));
  inside = clamp(inside, 0.0, 1.0);
  if (inside <= 0.0) discard;
  result = vec4(color.rgb, color.a * inside);
}
)";

constexpr int kPositionSlot = 0, kNormalSlot = 1, kStyleSlot = 2, kTintSlot = 3;

struct Rgba {
  float r, g, b, a;
};

Rgba channels(Color color) {
  const auto part = [&](int shift) { return static_cast<float>(color >> shift & 0xffu) / 255.0f; };
  return {part(0), part(8), part(16), part(24)};
}

GLuint compile(GLenum kind, const char* version, const char* body, std::string& error) {
  const GLuint shader = glCreateShader(kind);
  const std::array<const char*, 3> parts{version, "\nprecision highp float;\n", body};
  glShaderSource(shader, 3, parts.data(), nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::array<char, 1024> log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  error = log.data();
  glDeleteShader(shader);
  return 0;
}

template <class T>
void fill_buffer(GLenum target, GLuint buffer, std::span<const T> data, GLenum usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), usage);
}

void attribute(int slot, int size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(static_cast<GLuint>(slot));
  glVertexAttribPointer(static_cast<GLuint>(slot), size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

/// A unit sphere made of rings, fine enough that its polygonal edge is hidden by the outline.
void unit_sphere(std::vector<Point3f>& vertices, std::vector<std::uint32_t>& indices) {
  constexpr int kRings = 24, kSectors = 48;
  constexpr float kPi = std::numbers::pi_v<float>;
  for (int ring = 0; ring <= kRings; ++ring) {
    const float polar = kPi * static_cast<float>(ring) / kRings;
    for (int sector = 0; sector <= kSectors; ++sector) {
      const float around = 2 * kPi * static_cast<float>(sector) / kSectors;
      vertices.push_back({std::sin(polar) * std::cos(around), std::cos(polar), std::sin(polar) * std::sin(around)});
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t sector = 0; sector < kSectors; ++sector) {
      const std::uint32_t a = ring * (kSectors + 1) + sector, b = a + kSectors + 1;
      indices.insert(indices.end(), {a, a + 1, b, a + 1, b + 1, b});  // counter-clockwise from outside
    }
  }
}

/// Position, normal, position, normal …
std::vector<Point3f> interleaved(std::span<const Point3f> points, std::span<const Point3f> normals) {
  std::vector<Point3f> mixed;
  mixed.reserve(points.size() * 2);
  for (std::size_t i = 0; i < points.size(); ++i) mixed.insert(mixed.end(), {points[i], normals[i]});
  return mixed;
}

}  // namespace

bool StageGl::build(const char* version, Program program, const char* vertex, const char* fragment) {
  const GLuint v = compile(GL_VERTEX_SHADER, version, vertex, error_);
  const GLuint f = v != 0 ? compile(GL_FRAGMENT_SHADER, version, fragment, error_) : 0;
  if (v == 0 || f == 0) return false;
  const GLuint linked = glCreateProgram();
  glAttachShader(linked, v);
  glAttachShader(linked, f);
  glBindAttribLocation(linked, kPositionSlot, "position");
  glBindAttribLocation(linked, kNormalSlot, "normal");
  glBindAttribLocation(linked, kStyleSlot, "style");
  glBindAttribLocation(linked, kTintSlot, "tint");
  glLinkProgram(linked);
  glDeleteShader(v);
  glDeleteShader(f);
  GLint good = 0;
  glGetProgramiv(linked, GL_LINK_STATUS, &good);
  if (!good) {
    std::array<char, 1024> log{};
    glGetProgramInfoLog(linked, static_cast<GLsizei>(log.size()), nullptr, log.data());
    error_ = log.data();
    return false;
  }
  programs_[program] = linked;
  return true;
}

bool StageGl::create(const char* glsl_version) {
  abandon();
  error_.clear();
  const bool built = build(glsl_version, kLine, kLineVertex, kLineFragment) &&
                     build(glsl_version, kMesh, kMeshVertex, kMeshFragment) &&
                     build(glsl_version, kVolume, kVolumeVertex, kVolumeFragment) &&
                     build(glsl_version, kPoint, kPointVertex, kPointFragment) &&
                     build(glsl_version, kMark, kMarkVertex, kMarkFragment);
  if (!built) {
    programs_ = {};
    if (error_.empty()) error_ = "the graphics driver refused a shader without saying why";
    return false;
  }
  make_shapes();
  return true;
}

void StageGl::abandon() {
  programs_ = {};
  lines_ = sphere_ = mesh_ = points_ = marks_ = {};
  uploaded_marks_.reset();
  uploaded_ = ~std::uint64_t{0};
  point_count_ = 0;
}

void StageGl::make_shapes() {
  for (Shape* shape : {&lines_, &sphere_, &mesh_, &points_, &marks_}) {
    glGenVertexArrays(1, &shape->array);
    glGenBuffers(1, &shape->vertices);
    glGenBuffers(1, &shape->indices);
  }
  glBindVertexArray(lines_.array);
  glBindBuffer(GL_ARRAY_BUFFER, lines_.vertices);
  attribute(kPositionSlot, 4, sizeof(GroundVertex), 0);

  std::vector<Point3f> vertices;
  std::vector<std::uint32_t> indices;
  unit_sphere(vertices, indices);
  glBindVertexArray(sphere_.array);
  fill_buffer<Point3f>(GL_ARRAY_BUFFER, sphere_.vertices, vertices, GL_STATIC_DRAW);
  fill_buffer<std::uint32_t>(GL_ELEMENT_ARRAY_BUFFER, sphere_.indices, indices, GL_STATIC_DRAW);
  attribute(kPositionSlot, 3, sizeof(Point3f), 0);
  sphere_.count = static_cast<int>(indices.size());

  glBindVertexArray(mesh_.array);
  glBindBuffer(GL_ARRAY_BUFFER, mesh_.vertices);
  attribute(kPositionSlot, 3, 2 * sizeof(Point3f), 0);
  attribute(kNormalSlot, 3, 2 * sizeof(Point3f), sizeof(Point3f));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh_.indices);

  glBindVertexArray(points_.array);
  glBindBuffer(GL_ARRAY_BUFFER, points_.vertices);
  attribute(kPositionSlot, 3, sizeof(Point3f), 0);

  glBindVertexArray(marks_.array);
  glBindBuffer(GL_ARRAY_BUFFER, marks_.vertices);
  attribute(kPositionSlot, 3, sizeof(GlMark), offsetof(GlMark, at));
  attribute(kStyleSlot, 2, sizeof(GlMark), offsetof(GlMark, radius));
  glEnableVertexAttribArray(kTintSlot);
  glVertexAttribPointer(kTintSlot, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(GlMark),
                        reinterpret_cast<const void*>(offsetof(GlMark, color)));
  glBindVertexArray(0);
}

void StageGl::upload(const GlScene& scene) {
  if (uploaded_ == scene.points_version) return;
  uploaded_ = scene.points_version;
  fill_buffer<Point3f>(GL_ARRAY_BUFFER, points_.vertices, scene.points, GL_DYNAMIC_DRAW);
  point_count_ = static_cast<int>(scene.points.size());
  mesh_.count = static_cast<int>(scene.triangles.size()) * 3;
  if (mesh_.count == 0) return;
  const auto mixed = interleaved(scene.points, scene.normals);
  glBindVertexArray(mesh_.array);
  fill_buffer<Point3f>(GL_ARRAY_BUFFER, mesh_.vertices, mixed, GL_DYNAMIC_DRAW);
  fill_buffer<std::array<Index, 3>>(GL_ELEMENT_ARRAY_BUFFER, mesh_.indices, scene.triangles, GL_DYNAMIC_DRAW);
  glBindVertexArray(0);
}

int StageGl::uniform(Program program, const char* name) const { return glGetUniformLocation(programs_[program], name); }

void StageGl::set_color(Program program, const char* name, Color color) const {
  const Rgba c = channels(color);
  glUniform4f(uniform(program, name), c.r, c.g, c.b, c.a);
}

void StageGl::use(Program program, const GlScene& scene) const {
  glUseProgram(programs_[program]);
  glUniformMatrix4fv(uniform(program, "view_projection"), 1, GL_FALSE, scene.view_projection.data());
  glUniform3fv(uniform(program, "eye"), 1, scene.eye.data());
  glUniform3fv(uniform(program, "light"), 1, scene.light.data());
}

void StageGl::draw_ground(const GlScene& scene, int width, int height, float scale) {
  const float thick = scene.three_d ? 1.9f : scale;  // device pixels
  const std::vector<GroundVertex> lines = ground_lines(scene, width, height, scale, thick);
  if (lines.empty()) return;
  glDisable(GL_DEPTH_TEST);
  glUseProgram(programs_[kLine]);
  set_color(kLine, "color", scene.grid);
  glUniform1f(uniform(kLine, "width"), thick);
  glBindVertexArray(lines_.array);
  fill_buffer<GroundVertex>(GL_ARRAY_BUFFER, lines_.vertices, lines, GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(lines.size()));
}

void StageGl::draw_mesh(const GlScene& scene) const {
  if (mesh_.count == 0) return;
  glDisable(GL_BLEND);
  use(kMesh, scene);
  set_color(kMesh, "color", scene.surface);
  glBindVertexArray(mesh_.array);
  glDrawElements(GL_TRIANGLES, mesh_.count, GL_UNSIGNED_INT, nullptr);
  glEnable(GL_BLEND);
}

void StageGl::draw_volumes(const GlScene& scene) const {
  if (scene.volumes.empty()) return;
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  use(kVolume, scene);
  glBindVertexArray(sphere_.array);
  for (const GlVolume& volume : scene.volumes) {
    const Eigen::Matrix3f axes = volume.axes;
    const Eigen::Matrix3f inverse_transposed = axes.inverse().transpose();
    // From inside, only the half towards the eye is drawn, and its back faces are visible.
    const bool inside = (axes.inverse() * (scene.eye - volume.center)).squaredNorm() < 1;
    glFrontFace((axes.determinant() < 0) != inside ? GL_CW : GL_CCW);
    glUniformMatrix3fv(uniform(kVolume, "axes"), 1, GL_FALSE, axes.data());
    glUniformMatrix3fv(uniform(kVolume, "axes_inverse_transposed"), 1, GL_FALSE, inverse_transposed.data());
    glUniform3fv(uniform(kVolume, "center"), 1, volume.center.data());
    set_color(kVolume, "color", with_alpha(volume.color, volume.fill));
    glDrawElements(GL_TRIANGLES, sphere_.count, GL_UNSIGNED_INT, nullptr);
  }
  glFrontFace(GL_CCW);
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
}

void StageGl::draw_points(const GlScene& scene, float scale) const {
  if (point_count_ == 0 || scene.point_radius <= 0) return;
  glDepthMask(GL_FALSE);
  use(kPoint, scene);
  set_color(kPoint, "color", scene.point);
  glUniform1f(uniform(kPoint, "radius"), scene.point_radius * scale);
  glUniform1f(uniform(kPoint, "towards"), scene.three_d ? 0.004f : 0.0f);
  glUniform1f(uniform(kPoint, "reach"), scene.three_d ? scene.eye_to_target : 0.0f);
  glBindVertexArray(points_.array);
  let_shaders_size_points();
  glDrawArrays(GL_POINTS, 0, point_count_);
  glDepthMask(GL_TRUE);
}

/// Nothing hides a mark, so that one on top can be seen wherever it is.
void StageGl::draw_marks(const GlScene& scene, float scale) {
  if (scene.marks == nullptr || scene.marks->marks.empty()) return;
  const GlMarks& all = *scene.marks;
  glBindVertexArray(marks_.array);
  if (uploaded_marks_.lock() != scene.marks || uploaded_version_ != all.version) {
    uploaded_marks_ = scene.marks, uploaded_version_ = all.version;
    fill_buffer<GlMark>(GL_ARRAY_BUFFER, marks_.vertices, all.marks, GL_DYNAMIC_DRAW);
  }
  glDisable(GL_DEPTH_TEST);
  use(kMark, scene);
  glUniform2f(uniform(kMark, "reach"), all.least_radius * scale, all.greatest * scale);
  glUniform1f(uniform(kMark, "focal"), scene.focal * scale);
  let_shaders_size_points();
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(all.marks.size()));
  glEnable(GL_DEPTH_TEST);
}

void StageGl::draw(const GlScene& scene, int width, int height, float scale) {
  const auto px = [&](float v) { return static_cast<int>(std::lround(v * scale)); };
  const Rgba ground = channels(scene.ground);
  if (!ready() || scene.stage.width < 1 || scene.stage.height < 1) return;
  const int x = px(scene.stage.x), y = height - px(scene.stage.y + scene.stage.height);
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, px(scene.stage.width), px(scene.stage.height));
  glViewport(x, y, px(scene.stage.width), px(scene.stage.height));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glClearColor(ground.r, ground.g, ground.b, ground.a);
  if (ground.a > 0) glClear(GL_COLOR_BUFFER_BIT);  // only the stage: the door clears the rest, and the depth
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  upload(scene);
  draw_ground(scene, px(scene.stage.width), px(scene.stage.height), scale);
  if (scene.three_d) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    draw_marks(scene, scale);
    draw_mesh(scene);
    draw_volumes(scene);
  }
  draw_points(scene, scale);
  glBindVertexArray(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, width, height);
}

}  // namespace snug::app
