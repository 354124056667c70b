#include "app/ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace snug::app {
namespace {

constexpr float kMostLines = 400;  // in one direction
constexpr int kPieces = 12;        // pieces of a line on the plane, which fades from piece to piece

float smooth(float low, float high, float at) {
  const float t = std::clamp((at - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// A place on the stage, in device pixels from its middle, and the opacity of a line there.
struct End {
  float x, y, share;
};

class Strips {
 public:
  Strips(int width, int height, float thick)
      : x_(2 / static_cast<float>(width)), y_(2 / static_cast<float>(height)), half_(0.5f * thick + 0.5f) {}

  void add(const End& a, const End& b) {
    const float dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    if (length <= 0 || (a.share <= 0 && b.share <= 0)) return;
    const float nx = -dy / length * half_, ny = dx / length * half_;
    const auto corner = [&](const End& end, float side) {
      return GroundVertex{(end.x + side * nx) * x_, (end.y + side * ny) * y_, side * half_, end.share};
    };
    const GroundVertex a0 = corner(a, -1), a1 = corner(a, 1), b0 = corner(b, -1), b1 = corner(b, 1);
    vertices_.insert(vertices_.end(), {a0, b0, a1, a1, b0, b1});
  }

  std::vector<GroundVertex> vertices_;

 private:
  float x_, y_, half_;
};

void flat(const GlScene& scene, int width, int height, float scale, Strips& strips) {
  const float pitch = scene.grid_step * scale;
  const std::array<float, 2> size{static_cast<float>(width), static_cast<float>(height)};
  const std::array<float, 2> origin{std::round(scene.grid_x * scale) + 0.5f, std::round(scene.grid_y * scale) + 0.5f};
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    if (!(pitch * kMostLines > size[axis])) continue;
    const float half = 0.5f * size[axis], reach = 0.5f * size[1 - axis];
    for (float at = origin[axis] - std::floor((origin[axis] + 1) / pitch) * pitch; at < size[axis] + 1; at += pitch)
      axis == 0 ? strips.add({at - half, -reach, 1}, {at - half, reach, 1})
                : strips.add({-reach, at - half, 1}, {reach, at - half, 1});
  }
}

/// The ground plane in perspective.
class GroundPlane {
 public:
  GroundPlane(const GlScene& scene, int width, int height)
      : scene_(scene), half_width_(0.5f * static_cast<float>(width)), half_height_(0.5f * static_cast<float>(height)) {}

  struct Seen {
    float x, y, w;  // homogeneous, device pixels
  };

  [[nodiscard]] Seen seen(float x, float z) const {
    const auto row = [&](std::size_t i) {
      const auto& m = scene_.view_projection;
      return m[i] * x + m[4 + i] * scene_.plane_height + m[8 + i] * z + m[12 + i];
    };
    return {row(0) * half_width_, row(1) * half_height_, row(3)};
  }

  /// The opacity of a line along one axis at a place: lines fade out before their cells would shimmer.
  [[nodiscard]] float share(float x, float z, bool along_z) const {
    const Seen at = seen(x, z);
    const float step = 0.01f * scene_.plane_step;
    const Seen right = seen(x + step, z), front = seen(x, z + step);
    if (at.w <= kNear || right.w <= kNear || front.w <= kNear) return 0;
    const auto moved = [&](const Seen& to) {
      return std::array{(to.x / to.w - at.x / at.w) * 100, (to.y / to.w - at.y / at.w) * 100};
    };
    const auto u = moved(right), v = moved(front);  // pixels per cell
    const float area = std::abs(u[0] * v[1] - u[1] * v[0]);
    const auto& other = along_z ? v : u;
    const float cells_per_pixel = area > 0 ? (std::abs(other[0]) + std::abs(other[1])) / area : 1;
    const float fade = 1 - smooth(0.25f * scene_.plane_reach, scene_.plane_reach, std::hypot(x, z));
    return fade * (1 - smooth(0.15f, 0.5f, cells_per_pixel));
  }

  void add(float ax, float az, float bx, float bz, bool along_z, Strips& strips) const {
    Seen a = seen(ax, az), b = seen(bx, bz);
    if (a.w <= kNear && b.w <= kNear) return;
    float a_share = share(ax, az, along_z), b_share = share(bx, bz, along_z);
    const auto cut = [](const Seen& in, const Seen& out) {
      const float t = (in.w - kNear) / (in.w - out.w);
      return Seen{in.x + (out.x - in.x) * t, in.y + (out.y - in.y) * t, kNear};
    };
    if (a.w < kNear) a = cut(b, a), a_share = b_share;
    if (b.w < kNear) b = cut(a, b), b_share = a_share;
    const End from{a.x / a.w, a.y / a.w, a_share}, to{b.x / b.w, b.y / b.w, b_share};
    if (std::min(from.x, to.x) > half_width_ || std::max(from.x, to.x) < -half_width_ ||
        std::min(from.y, to.y) > half_height_ || std::max(from.y, to.y) < -half_height_)
      return;
    strips.add(from, to);
  }

 private:
  static constexpr float kNear = 1e-2f;
  const GlScene& scene_;
  float half_width_, half_height_;
};

void perspective(const GlScene& scene, int width, int height, Strips& strips) {
  const GroundPlane plane(scene, width, height);
  const float reach = scene.plane_reach, step = scene.plane_step;
  if (!(step > 0) || reach / step > kMostLines) return;
  const int lines = static_cast<int>(reach / step);
  for (int i = -lines; i <= lines; ++i) {
    const float aside = static_cast<float>(i) * step;
    const float half = std::sqrt(std::max(0.0f, reach * reach - aside * aside));
    for (int piece = 0; piece < kPieces; ++piece) {
      const auto at = [&](int p) { return half * (2 * static_cast<float>(p) / kPieces - 1); };
      plane.add(aside, at(piece), aside, at(piece + 1), true, strips);
      plane.add(at(piece), aside, at(piece + 1), aside, false, strips);
    }
  }
}

}  // namespace

std::vector<GroundVertex> ground_lines(const GlScene& scene, int width, int height, float scale, float thick) {
  Strips strips(width, height, thick);
  if (width < 1 || height < 1) return {};
  scene.three_d ? perspective(scene, width, height, strips) : flat(scene, width, height, scale, strips);
  return std::move(strips.vertices_);
}

}  // namespace snug::app
