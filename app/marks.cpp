#include "app/marks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace snug::app {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kDotPitch = 6.5f, kDash = 8, kDashGap = 5, kLongDash = 22, kLongGap = 7;  // page pixels at a width of 2
constexpr float kFlat = 0.1f;                                                             // device pixels
constexpr std::size_t kMostParts = 4000;                                                  // in one patterned path

bool near_clip(const ImDrawList* list, ImVec2 p, float reach) {
  const ImVec2 low = list->GetClipRectMin(), high = list->GetClipRectMax();
  return p.x > low.x - reach && p.x < high.x + reach && p.y > low.y - reach && p.y < high.y + reach;
}

ImVec2 between(ImVec2 a, ImVec2 b, float share) { return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share}; }

/// Stretches of `on` pixels, `off` pixels apart, along a path.
struct Pattern {
  float on, off;
  float left = on;  // of the current stretch or gap
  bool drawing = true;

  void pass(float length) {
    left -= length;
    if (left <= 0) drawing = !drawing, left = drawing ? on : off;
  }
  /// Passes by what is not drawn.
  void skip(float length) {
    for (float rest = std::fmod(length, on + off); rest > 0;) {
      const float step = std::min(left, rest);
      rest -= step;
      pass(step);
    }
  }
};

/// From where to where a segment may be seen, as fractions of it; the second is less than the first if nowhere.
std::array<float, 2> seen_of(const ImDrawList* list, ImVec2 a, ImVec2 b) {
  constexpr float kReach = 24;
  const ImVec2 low = list->GetClipRectMin(), high = list->GetClipRectMax();
  float enter = 0, leave = 1;
  const auto cut = [&](float from, float way, float least, float most) {
    if (way == 0 && (from < least || from > most)) leave = -1;
    if (way == 0) return;
    const float first = (least - from) / way, second = (most - from) / way;
    enter = std::max(enter, std::min(first, second)), leave = std::min(leave, std::max(first, second));
  };
  cut(a.x, b.x - a.x, low.x - kReach, high.x + kReach);
  cut(a.y, b.y - a.y, low.y - kReach, high.y + kReach);
  return {enter, leave};
}

/// Walks a path and calls part(from, to) for each stretch of the pattern, where it may be seen.
template <class Part>
void walk(const ImDrawList* list, std::span<const ImVec2> points, bool closed, Pattern pattern, Part part) {
  std::size_t parts = 0;
  for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size() && parts < kMostParts; ++i) {
    const ImVec2 a = points[i], b = points[(i + 1) % points.size()];
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const auto [enter, leave] = seen_of(list, a, b);
    if (leave <= enter) {
      pattern.skip(length);
      continue;
    }
    pattern.skip(enter * length);
    float done = enter * length;
    const float end = leave * length;
    while (done < end && parts < kMostParts) {
      const float step = std::min(pattern.left, end - done);
      if (pattern.drawing) part(between(a, b, done / length), between(a, b, (done + step) / length)), ++parts;
      if (done + step == done) break;  // shorter than a float can tell
      done += step;
      pattern.pass(step);
    }
    pattern.skip(length - end);
  }
}

void patterned(ImDrawList* list, std::span<const ImVec2> points, bool closed, Stroke stroke, Color color, float width) {
  const float scale = std::max(1.0f, width / 2);
  if (stroke != Stroke::kDotted) {
    const bool is_long = stroke == Stroke::kLongDashed;
    const Pattern dashes{(is_long ? kLongDash : kDash) * scale, (is_long ? kLongGap : kDashGap) * scale};
    walk(list, points, closed, dashes, [&](ImVec2 a, ImVec2 b) { list->AddLine(a, b, color, width); });
    return;
  }
  // A dot is a stretch of almost no length, so the walk gives its place.
  walk(list, points, closed, {0.01f, kDotPitch * scale}, [&](ImVec2 a, ImVec2) {
    if (near_clip(list, a, 4)) list->AddCircleFilled(a, std::max(1.1f, width * 0.62f), color, 8);
  });
}

/// A circle as far as the clip rectangle shows it.
class Arc {
 public:
  Arc(const ImDrawList* list, ImVec2 center, float radius) : center_(center), radius_(radius) {
    const ImVec2 low = list->GetClipRectMin(), high = list->GetClipRectMax();
    across_ = std::hypot(high.x - low.x, high.y - low.y);
    const ImVec2 middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    away_ = std::hypot(middle.x - center.x, middle.y - center.y);
    if (!is_part()) return;
    const float towards = std::atan2(middle.y - center.y, middle.x - center.x);
    const float half = std::min(kPi, 1.2f * across_ / radius);
    from_ = towards - half, to_ = towards + half;
  }

  /// Whether the line may reach the clip rectangle; if not, whether the rectangle is inside the circle.
  [[nodiscard]] bool crosses() const { return std::abs(away_ - radius_) <= across_ || away_ + radius_ <= across_; }
  [[nodiscard]] bool is_inside() const { return away_ < radius_; }
  /// Whether only the arc towards the clip rectangle is drawn.
  [[nodiscard]] bool is_part() const { return radius_ > 2 * across_; }

  /// Chords deviate from the arc by at most kFlat; more of them would make no visible difference.
  [[nodiscard]] std::vector<ImVec2> points() const {
    const float flat = kFlat / std::max(1.0f, ImGui::GetIO().DisplayFramebufferScale.x);
    const int count = std::clamp(static_cast<int>((to_ - from_) / 2 * std::sqrt(radius_ / (2 * flat))), 24, 512);
    std::vector<ImVec2> points(count);
    const auto last = static_cast<float>(is_part() ? count - 1 : count);
    for (int i = 0; i < count; ++i) points[i] = at(from_ + (to_ - from_) * static_cast<float>(i) / last, radius_);
    return points;
  }

  /// Closes a part towards the centre, so far in that the clip rectangle does not reach there.
  void close(std::vector<ImVec2>& points) const {
    const float inner = std::max(0.0f, radius_ - 3 * across_);
    points.insert(points.end(), {at(to_, inner), at(from_, inner)});
  }

 private:
  [[nodiscard]] ImVec2 at(float angle, float radius) const {
    return {center_.x + radius * std::cos(angle), center_.y + radius * std::sin(angle)};
  }

  ImVec2 center_;
  float radius_, across_ = 0, away_ = 0, from_ = 0, to_ = 2 * kPi;
};

}  // namespace

void path(ImDrawList* list, std::span<const ImVec2> points, bool closed, Stroke stroke, Color color, float width) {
  if (points.size() < 2) return;
  if (stroke == Stroke::kSolid)
    list->AddPolyline(points.data(), static_cast<int>(points.size()), color,
                      closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
  else patterned(list, points, closed, stroke, color, width);
}

void line(ImDrawList* list, ImVec2 a, ImVec2 b, Stroke stroke, Color color, float width) {
  const std::array<ImVec2, 2> ends{a, b};
  path(list, ends, false, stroke, color, width);
}

void circle(ImDrawList* list, ImVec2 center, float radius, Stroke stroke, Color color, float width) {
  const Arc arc(list, center, radius);
  if (radius >= 0.5f && arc.crosses()) path(list, arc.points(), !arc.is_part(), stroke, color, width);
}

void filled_circle(ImDrawList* list, ImVec2 center, float radius, Color color) {
  const Arc arc(list, center, radius);
  if (radius < 0.5f) return;
  if (!arc.crosses()) {
    if (arc.is_inside()) list->AddRectFilled(list->GetClipRectMin(), list->GetClipRectMax(), color);
    return;
  }
  std::vector<ImVec2> points = arc.points();
  if (arc.is_part()) arc.close(points);
  list->AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), color);
}

Color shaded(Color color, double share) {
  const auto part = [&](int shift) {
    return static_cast<Color>(std::clamp(static_cast<double>(color >> shift & 0xff) * share, 0.0, 255.0)) << shift;
  };
  return (color & 0xff000000u) | part(0) | part(8) | part(16);
}

void disc(ImDrawList* list, ImVec2 center, float radius, Color color) {
  list->AddCircleFilled(center, radius, color, radius > 40 ? 128 : 0);
}

void diamond(ImDrawList* list, ImVec2 center, float size, Color color, Color rim) {
  const auto quad = [&](float s, Color c) {
    list->AddQuadFilled({center.x, center.y - s}, {center.x + s, center.y}, {center.x, center.y + s},
                        {center.x - s, center.y}, c);
  };
  quad(size + 2.5f, rim);
  quad(size, color);
}

void ring(ImDrawList* list, ImVec2 center, float radius, Color color, float width) {
  list->AddCircle(center, radius, color, 0, width);
}

void plus(ImDrawList* list, ImVec2 center, float size, Color color, float width) {
  list->AddLine({center.x - size, center.y}, {center.x + size, center.y}, color, width);
  list->AddLine({center.x, center.y - size}, {center.x, center.y + size}, color, width);
}

void cross(ImDrawList* list, ImVec2 center, float size, Color color, float width) {
  list->AddLine({center.x - size, center.y - size}, {center.x + size, center.y + size}, color, width);
  list->AddLine({center.x - size, center.y + size}, {center.x + size, center.y - size}, color, width);
}

void tick(ImDrawList* list, ImVec2 center, float size, Color color, float width) {
  const std::array<ImVec2, 3> points{ImVec2{center.x - size, center.y},
                                     {center.x - size * 0.3f, center.y + size * 0.65f},
                                     {center.x + size, center.y - size * 0.7f}};
  path(list, points, false, Stroke::kSolid, color, width);
}

void arrow(ImDrawList* list, ImVec2 from, ImVec2 to, Color color, float width) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  if (length < 1) return;
  const float head = std::min(length * 0.6f, 5 + 3 * width), half = head * 0.42f;
  const ImVec2 along{(to.x - from.x) / length, (to.y - from.y) / length};
  const ImVec2 neck{to.x - along.x * head, to.y - along.y * head};
  list->AddLine(from, neck, color, width);
  list->AddTriangleFilled(to, {neck.x - along.y * half, neck.y + along.x * half},
                          {neck.x + along.y * half, neck.y - along.x * half}, color);
}

void hatching(ImDrawList* list, ImVec2 center, float radius, Color color) {
  constexpr float kPitch = 12;
  const ImVec2 low = list->GetClipRectMin(), high = list->GetClipRectMax();
  const float half_root = std::sqrt(0.5f);
  const int most = std::min(static_cast<int>(radius / kPitch), 400);
  for (int i = -most; i <= most; ++i) {
    const float off = kPitch * static_cast<float>(i);
    const float half = std::sqrt(std::max(0.0f, radius * radius - off * off)) * half_root;
    const ImVec2 middle{center.x + off * half_root, center.y + off * half_root};
    const ImVec2 a{middle.x - half, middle.y + half}, b{middle.x + half, middle.y - half};
    if (std::max(a.x, b.x) < low.x || std::min(a.x, b.x) > high.x || std::max(a.y, b.y) < low.y ||
        std::min(a.y, b.y) > high.y)
      continue;
    list->AddLine(a, b, color, 1);
  }
}

void halo_text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
               std::string_view words) {
  constexpr std::array<ImVec2, 8> kAround{ImVec2{-2, 0},  {2, 0},        {0, -2},       {0, 2},
                                          {-1.5f, -1.5f}, {1.5f, -1.5f}, {-1.5f, 1.5f}, {1.5f, 1.5f}};
  if (look.words_apart) return note_text(list, look, face, size, at, color, halo, words);
  for (const ImVec2 off : kAround)
    text(list, look, face, size, {at.x + off.x, at.y + off.y}, with_alpha(halo, 0.7f), words);
  text(list, look, face, size, at, color, words);
}

}  // namespace snug::app
