#include "app/picture_svg.hpp"

#include <imgui_internal.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "app/ground.hpp"
#include "app/svg_text.hpp"

namespace snug::app {
namespace {

constexpr float kSeam = 0.02f;  // pixels
constexpr int kShares = 10;     // opacities that lines of the ground fade by

bool is_clear(Color color) { return color >> 24 == 0; }

std::string fill_text(Color color) { return " fill=\"" + hex(color) + '"' + opacity_text("fill-opacity", color); }
std::string stroke_text(Color color, float width) {
  return " fill=\"none\" stroke=\"" + hex(color) + '"' + opacity_text("stroke-opacity", color) + " stroke-width=\"" +
         px_text(width) + '"';
}
std::string place_text(float x, float y) { return px_text(x) + ' ' + px_text(y); }
std::string rect_text(float x, float y, float width, float height) {
  return "<rect x=\"" + px_text(x) + "\" y=\"" + px_text(y) + "\" width=\"" + px_text(width) + "\" height=\"" +
         px_text(height) + '"';
}
std::string disc_text(float x, float y, float radius) {
  return "<circle cx=\"" + px_text(x) + "\" cy=\"" + px_text(y) + "\" r=\"" + px_text(radius) + '"';
}

// ---- what ImGui drew -------------------------------------------------------------------------------------------

/// Triangles of one colour, as the outlines of what they cover together: an edge that two of them share is inside.
class ShapeOutline {
 public:
  void add(const std::array<ImDrawIdx, 3>& at, const ImDrawVert* all) {
    const ImVec2 a = all[at[0]].pos, b = all[at[1]].pos, c = all[at[2]].pos;
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) return;
    const bool turned = area < 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const ImDrawIdx from = at[i], to = at[(i + 1) % 3];
      turned ? edge(to, from) : edge(from, to);
    }
    last_ = std::max({last_, at[0], at[1], at[2]});
  }
  [[nodiscard]] bool empty() const { return edges_.empty(); }
  [[nodiscard]] ImDrawIdx last() const { return last_; }

  /// The path, and forgets it.
  std::string take(const ImDrawVert* all) {
    std::string path;
    while (!edges_.empty()) {
      const ImDrawIdx start = edges_.begin()->first;
      ImDrawIdx at = start;
      char command = 'M';
      do {
        const auto next = edges_.find(at);
        if (next == edges_.end()) break;
        path += command + place_text(all[at].pos.x, all[at].pos.y);
        command = 'L';
        at = next->second;
        edges_.erase(next);
      } while (at != start);
      path += 'Z';
    }
    last_ = 0;
    return path;
  }

 private:
  void edge(ImDrawIdx from, ImDrawIdx to) {
    const auto [begin, end] = edges_.equal_range(to);
    const auto back = std::find_if(begin, end, [&](const auto& one) { return one.second == from; });
    if (back != end) edges_.erase(back);
    else edges_.emplace(from, to);
  }

  std::multimap<ImDrawIdx, ImDrawIdx> edges_;
  ImDrawIdx last_ = 0;
};

class Svg {
 public:
  explicit Svg(const SvgPicture& picture) : picture_(picture) {}

  /// words: those on the list, in their order.
  void add(const ImDrawList& list, std::span<const DrawnWords> words) {
    for (const ImDrawCmd& command : list.CmdBuffer)
      if (command.UserCallback == nullptr) add(list, command, words);
    for (const DrawnWords& one : words) put_words(one);
  }
  void add(const GlScene& scene);

  [[nodiscard]] std::string text() const {
    const std::string size = px_text(picture_.width) + ' ' + px_text(picture_.height);
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px_text(picture_.width) + "\" height=\"" +
                       px_text(picture_.height) + "\" viewBox=\"0 0 " + size +
                       "\" xml:space=\"preserve\" role=\"img\" aria-labelledby=\"title note\">\n<title id=\"title\">" +
                       escaped(picture_.title) + "</title>\n<desc id=\"note\">" + escaped(picture_.sentence) +
                       "</desc>\n<metadata>" + escaped(picture_.address) +
                       "</metadata>\n<style>text{font-family:Inter,\"Helvetica Neue\",Arial,sans-serif;white-space:pre}"
                       ".mono{font-family:\"JetBrains Mono\",Menlo,Consolas,monospace}</style>\n";
    if (!is_clear(picture_.ground))
      text += rect_text(0, 0, picture_.width, picture_.height) + fill_text(picture_.ground) + "/>\n";
    return text + body_ + (clip_.empty() ? "" : "</g>\n") + "</svg>\n";
  }

 private:
  /// words: those that are still to be put; the ones that are leave it.
  void add(const ImDrawList& list, const ImDrawCmd& command, std::span<const DrawnWords>& words);
  void put_words(const DrawnWords& words);
  void put_path(ShapeOutline& outline, Color color, const ImDrawVert* all) {
    if (outline.empty()) return;
    const std::string path = outline.take(all);
    if (!path.empty()) body_ += "<path d=\"" + path + '"' + fill_text(color) + "/>\n";
  }
  /// What follows is seen within a rectangle alone.
  void clip(float x, float y, float width, float height) {
    const bool all = x <= 0 && y <= 0 && x + width >= picture_.width && y + height >= picture_.height;
    const std::string rect = all ? "" : rect_text(x, y, width, height);
    if (rect == clip_) return;
    if (!clip_.empty()) body_ += "</g>\n";
    clip_ = rect;
    if (all) return;
    const auto [at, added] = clips_.emplace(rect, clips_.size());
    const std::string id = "within" + std::to_string(at->second);
    if (added) body_ += "<clipPath id=\"" + id + "\">" + rect + "/></clipPath>\n";
    body_ += "<g clip-path=\"url(#" + id + ")\">\n";
  }

  // The scene, in page pixels.
  struct Seen {
    float x, y, w;
  };
  [[nodiscard]] static Seen seen(const GlScene& scene, const Point3f& p);
  void put_ground(const GlScene& scene);
  void put_marks(const GlScene& scene);
  void put_mesh(const GlScene& scene);
  void put_volume(const GlScene& scene, const GlVolume& volume);
  void put_points(const GlScene& scene);

  const SvgPicture& picture_;
  std::string body_;
  std::map<std::string, std::size_t> clips_;
  std::string clip_;  // the rectangle of the group that is open; empty for none
  int gradients_ = 0;
};

void Svg::put_words(const DrawnWords& words) {
  const ImVec2 low = words.clip_low, high = words.clip_high;
  clip(low.x, low.y, high.x - low.x, high.y - low.y);
  const bool mono = words.face == Face::kMono || words.face == Face::kMonoBold;
  const bool bold = words.face == Face::kSemiBold || words.face == Face::kMonoBold;
  body_ += "<text x=\"" + px_text(words.at.x) + "\" y=\"" + px_text(words.at.y + kBaseline * words.size) +
           "\" font-size=\"" + px_text(words.size) + "\" textLength=\"" + px_text(words.high.x - words.low.x) +
           "\" lengthAdjust=\"spacingAndGlyphs\"" + fill_text(words.color);
  if (mono) body_ += " class=\"mono\"";
  if (bold) body_ += " font-weight=\"600\"";
  if (words.halo != 0)
    body_ += " stroke=\"" + hex(words.halo) + "\" stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  body_ += '>';
  float moved = 0;  // the baseline, from the line's
  for (const Letters& letters : with_scripts(words.words)) {
    const float to =
        letters.script == Script::kNone ? 0 : words.size * (letters.script == Script::kLowered ? kLowered : -kRaised);
    const std::string inside = escaped(letters.text);
    if (letters.script == Script::kNone && moved == 0) body_ += inside;
    else {
      body_ += "<tspan dy=\"" + px_text(to - moved) + '"';
      if (letters.script != Script::kNone) body_ += " font-size=\"" + px_text(words.size * kScriptSize) + '"';
      body_ += '>' + inside + "</tspan>";
    }
    moved = to;
  }
  body_ += "</text>\n";
}

void Svg::add(const ImDrawList& list, const ImDrawCmd& command, std::span<const DrawnWords>& words) {
  const auto begin = static_cast<int>(command.IdxOffset), end = begin + static_cast<int>(command.ElemCount);
  const ImDrawVert* const all = list.VtxBuffer.Data + command.VtxOffset;
  const auto put = [&](ShapeOutline& outline, Color color) {
    const ImVec4& within = command.ClipRect;
    clip(within.x, within.y, within.z - within.x, within.w - within.y);
    put_path(outline, color, all);
  };
  ShapeOutline outline;
  Color color = 0;
  for (int i = begin; i + 2 < end; i += 3) {
    for (; !words.empty() && words.front().after <= i; words = words.subspan(1)) {
      put(outline, color);
      put_words(words.front());
    }
    const ImDrawIdx* const at = list.IdxBuffer.Data + i;
    const std::array<ImDrawIdx, 3> corners{at[0], at[1], at[2]};
    if (std::any_of(corners.begin(), corners.end(), [&](ImDrawIdx one) { return is_clear(all[one].col); })) continue;
    const Color now = all[corners[0]].col;
    // Each translucent shape is a path of its own, so that the overlap of two is darker.
    const bool another = now >> 24 != 0xff && std::min({corners[0], corners[1], corners[2]}) > outline.last();
    if (now != color || another) put(outline, color);
    color = now;
    outline.add(corners, all);
  }
  put(outline, color);
}

// ---- what OpenGL drew ------------------------------------------------------------------------------------------

Svg::Seen Svg::seen(const GlScene& scene, const Point3f& p) {
  const auto row = [&](std::size_t i) {
    const auto& m = scene.view_projection;
    return m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i];
  };
  const float w = row(3);
  const Rect& stage = scene.stage;
  return {stage.x + (0.5f + 0.5f * row(0) / w) * stage.width, stage.y + (0.5f - 0.5f * row(1) / w) * stage.height, w};
}

void Svg::put_ground(const GlScene& scene) {
  const Rect& stage = scene.stage;
  if (!is_clear(scene.ground))
    body_ += rect_text(stage.x, stage.y, stage.width, stage.height) + fill_text(scene.ground) + "/>\n";
  if (is_clear(scene.grid)) return;
  const auto lines = ground_lines(scene, static_cast<int>(stage.width), static_cast<int>(stage.height), 1, 1);
  std::array<std::string, kShares + 1> paths;
  for (std::size_t i = 0; i + 5 < lines.size(); i += 6) {  // two triangles: from the middle of one end to the other's
    const auto middle = [&](const GroundVertex& a, const GroundVertex& b) {
      return place_text(stage.x + (0.5f + 0.25f * (a.x + b.x)) * stage.width,
                        stage.y + (0.5f - 0.25f * (a.y + b.y)) * stage.height);
    };
    const float share = (lines[i].share + lines[i + 1].share) / 2;
    paths[static_cast<std::size_t>(std::lround(share * kShares))] +=
        'M' + middle(lines[i], lines[i + 2]) + 'L' + middle(lines[i + 1], lines[i + 5]);
  }
  for (std::size_t i = 1; i < paths.size(); ++i) {
    const float alpha = static_cast<float>(scene.grid >> 24) / 255 * static_cast<float>(i) / kShares;
    if (!paths[i].empty())
      body_ += "<path d=\"" + paths[i] + '"' + stroke_text(with_alpha(scene.grid, alpha), 1) + "/>\n";
  }
}

void Svg::put_marks(const GlScene& scene) {
  if (scene.marks == nullptr) return;
  for (const GlMark& mark : scene.marks->marks) {
    const Seen at = seen(scene, mark.at);
    if (at.w <= 0) continue;
    const float size = std::clamp(scene.focal * mark.radius / at.w, scene.marks->least_radius, scene.marks->greatest);
    const float thick = std::max(1.0f, 0.28f * size), square = 0.85f * size, cross = 0.8f * size;
    const int shape = static_cast<int>(mark.shape);
    const auto corner = [&](char command, float x, float y) { return command + place_text(at.x + x, at.y + y); };
    if (shape == GlMark::kDot) body_ += disc_text(at.x, at.y, 0.6f * size) + fill_text(mark.color) + "/>\n";
    else if (shape == GlMark::kSquare)
      body_ += rect_text(at.x - square, at.y - square, 2 * square, 2 * square) + fill_text(mark.color) + "/>\n";
    else if (shape == GlMark::kDiamond)
      body_ += "<path d=\"" + corner('M', -size, 0) + corner('L', 0, -size) + corner('L', size, 0) +
               corner('L', 0, size) + "Z\"" + stroke_text(mark.color, thick) + "/>\n";
    else
      body_ += "<path d=\"" + corner('M', -cross, -cross) + corner('L', cross, cross) + corner('M', -cross, cross) +
               corner('L', cross, -cross) + '"' + stroke_text(mark.color, thick) + "/>\n";
  }
}

/// As the shader of the mesh has it.
float shaded_share(float towards_eye, float towards_light) {
  const float lit = std::pow(0.5f + 0.5f * towards_light, 1.4f), edge = 1 - std::clamp(towards_eye, 0.0f, 1.0f);
  return (0.58f + 0.48f * lit) * (1 - 0.25f * edge * edge * edge);
}

Color times(Color color, float share) {
  const auto part = [&](int shift) {
    return static_cast<Color>(std::clamp(static_cast<float>(color >> shift & 0xff) * share, 0.0f, 255.0f)) << shift;
  };
  return 0xff000000u | part(0) | part(8) | part(16);
}

void Svg::put_mesh(const GlScene& scene) {
  struct Face {
    float depth;
    std::array<Seen, 3> corners;
    Color color;
  };
  std::vector<Face> faces;
  for (const auto& triangle : scene.triangles) {
    Face face{};
    Point3f normal = Point3f::Zero(), middle = Point3f::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(triangle[i]);
      face.corners[i] = seen(scene, scene.points[at]);
      face.depth += face.corners[i].w;
      normal += scene.normals[at], middle += scene.points[at] / 3;
    }
    const auto& c = face.corners;
    if (std::any_of(c.begin(), c.end(), [](const Seen& one) { return one.w <= 0; })) continue;
    const bool front = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[1].y - c[0].y) * (c[2].x - c[0].x) < 0;  // y is down
    normal.normalize();
    const float sign = front ? 1 : -1;
    const float towards_eye = sign * normal.dot((scene.eye - middle).normalized());
    face.color = times(scene.surface, shaded_share(towards_eye, sign * normal.dot(scene.light)));
    faces.push_back(face);
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth > b.depth; });
  for (const Face& face : faces) {
    const auto& c = face.corners;
    const std::string color = hex(face.color);  // a line of the same colour closes the seams between faces
    body_ += "<path d=\"M" + place_text(c[0].x, c[0].y) + 'L' + place_text(c[1].x, c[1].y) + 'L' +
             place_text(c[2].x, c[2].y) + "Z\" fill=\"" + color + "\" stroke=\"" + color +
             "\" stroke-width=\"0.5\"/>\n";
  }
}

/// The ellipse that an ellipsoid is seen as, and the volume shader's opacity from its middle to its rim.
void Svg::put_volume(const GlScene& scene, const GlVolume& volume) {
  const float fill = volume.fill;
  const Eigen::Matrix3f axes = volume.axes;
  const Point3f eye = axes.inverse() * (scene.eye - volume.center);  // from a unit sphere
  if (eye.squaredNorm() <= 1) {
    body_ += rect_text(scene.stage.x, scene.stage.y, scene.stage.width, scene.stage.height) +
             fill_text(with_alpha(volume.color, 0.45f * fill)) + "/>\n";
    return;
  }
  const Seen middle = seen(scene, volume.center);
  if (middle.w <= 0) return;
  constexpr float kStep = 0.01f;
  Eigen::Matrix<float, 2, 3> reach;  // where the half axes lead to on the screen
  for (int i = 0; i < 3; ++i) {
    const Seen ahead = seen(scene, volume.center + kStep * axes.col(i)),
               behind = seen(scene, volume.center - kStep * axes.col(i));
    reach.col(i) << (ahead.x - behind.x) / (2 * kStep), (ahead.y - behind.y) / (2 * kStep);
  }
  const float nearer =
      1 / std::sqrt(1 - 1 / eye.squaredNorm());  // a sphere's outline is larger than its middle's section
  // The ellipse's half axes are the square roots of this matrix's eigenvalues.
  const Eigen::Matrix2f square = reach * reach.transpose();
  const float mean = square.trace() / 2, half = (square(0, 0) - square(1, 1)) / 2, mixed = square(0, 1);
  const float a = std::sqrt(mean + std::hypot(half, mixed)) * nearer;
  const float b = std::sqrt(std::max(0.0f, mean - std::hypot(half, mixed))) * nearer;
  const std::string id = "volume" + std::to_string(++gradients_);
  const auto part = [&](int shift) {
    const float one = static_cast<float>(volume.color >> shift & 0xff);
    return static_cast<Color>(one + 0.08f * (255 - one)) << shift;
  };
  const Color tint = 0xff000000u | part(0) | part(8) | part(16);
  body_ += "<radialGradient id=\"" + id + "\">";
  for (const float at : {0.0f, 0.5f, 0.7f, 0.85f, 0.95f, 1.0f}) {
    const float rim = 1 - std::sqrt(std::max(0.0f, 1 - at * at)), edge = 0.3f * rim * rim * rim;
    const float alpha = 1 - (1 - (fill + edge)) * (1 - 0.45f * (fill + edge));
    body_ += "<stop offset=\"" + px_text(at) + "\" stop-color=\"" + hex(tint) + "\" stop-opacity=\"" +
             printed("%.3f", static_cast<double>(std::clamp(alpha, 0.0f, 1.0f))) + "\"/>";
  }
  body_ += "</radialGradient>\n<ellipse rx=\"" + px_text(a) + "\" ry=\"" + px_text(b) + "\" transform=\"translate(" +
           place_text(middle.x, middle.y) + ") rotate(" + px_text(std::atan2(mixed, half) / 2 * 57.29578f) +
           ")\" fill=\"url(#" + id + ")\"/>\n";
}

void Svg::put_points(const GlScene& scene) {
  if (is_clear(scene.point) || scene.point_radius <= 0) return;
  body_ += "<g" + fill_text(scene.point) + ">\n";
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Point3f& p = scene.points[i];
    const bool away = i < scene.normals.size() && scene.normals[i].dot(scene.eye - p) < 0;  // behind its own surface
    const Seen at = seen(scene, p);
    if (away || at.w <= 0) continue;
    const float nearer = scene.three_d ? std::clamp(scene.eye_to_target / at.w, 0.6f, 1.5f) : 1;
    body_ += disc_text(at.x, at.y, scene.point_radius * nearer) + "/>\n";
  }
  body_ += "</g>\n";
}

void Svg::add(const GlScene& scene) {
  const Rect& stage = scene.stage;
  clip(stage.x, stage.y, stage.width, stage.height);
  put_ground(scene);
  if (scene.three_d) {
    put_marks(scene);
    put_mesh(scene);
    for (const GlVolume& volume : scene.volumes) put_volume(scene, volume);
  }
  put_points(scene);
}

}  // namespace

std::string stage_svg(App& app, SvgPicture picture, double now) {
  std::vector<DrawnWords> words;
  ImGui::GetDrawListSharedData()->InitialFringeScale = kSeam;  // of ImGui's shapes, until the next frame
  app.note_words(&words, true);
  app.frame({.stage = {0, 0, picture.width, picture.height}}, now);
  app.note_words(nullptr);
  ImGui::Render();
  picture.ground = app.settings().ground ? app.look()->ground : 0;
  picture.title = app.session()->lesson().title, picture.sentence = app.caption();
  return picture_svg(*ImGui::GetDrawData(), words, app.scene(), picture);
}

std::string picture_svg(const ImDrawData& drawn, std::span<const DrawnWords> words, const GlScene* scene,
                        const SvgPicture& picture) {
  Svg svg(picture);
  if (scene != nullptr) svg.add(*scene);
  for (const ImDrawList* list : drawn.CmdLists) {
    std::vector<DrawnWords> on_it;
    for (const DrawnWords& one : words)
      if (one.list == list) on_it.push_back(one);
    svg.add(*list, on_it);
  }
  return svg.text();
}

}  // namespace snug::app
