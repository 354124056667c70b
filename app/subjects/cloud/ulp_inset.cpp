#include "app/subjects/cloud/ulp_inset.hpp"

#include <algorithm>
#include <cmath>

#include "app/close_up.hpp"
#include "app/marks.hpp"
#include "app/numbers.hpp"
#include "app/subjects/cloud/by_place.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

constexpr float kButtons = 42;              // how high the stage's own buttons are, pixels
constexpr double kSeenAsItIs = 1e-2;        // in parts of the volume's extent: from there on, the stage itself shows it
constexpr int kTicksOut = 4, kTicksIn = 2;  // on either side of the boundary
constexpr double kLongestShare = 3;         // ticks that the worst point is out, at most
constexpr float kRulerSize = 11;            // of the numbers on the ruler
constexpr float kMostRuler = 0.35f;         // of the picture's width, that they may take

/// The boundary, so far enlarged that it is a straight line, and the point beyond it.
class UlpPicture {
 public:
  UlpPicture(Brush& brush, const lesson::LeftOutside& left, const Rect& picture)
      : brush_(brush), p_(brush.p), left_(left), picture_(picture),
        tick_(std::max(1.0, nice_at_least(left.ulps() / kLongestShare))) {}

  /// How many ulps the picture is high.
  [[nodiscard]] double height() const { return tick_ * (kTicksOut + kTicksIn); }

  void draw() {
    draw_inside();
    draw_ruler();
    draw_point();
    draw_scale();
  }

 private:
  [[nodiscard]] float y_of(double ulps) const {
    const double share = (ulps / tick_ + kTicksIn) / (kTicksOut + kTicksIn);
    return picture_.y + picture_.height * static_cast<float>(1 - share);
  }
  [[nodiscard]] float right() const { return picture_.x + picture_.width; }
  /// Beside the widest number on the ruler.
  [[nodiscard]] float ruler_x() const {
    float widest = 0;
    for (int tick = 1 - kTicksIn; tick < kTicksOut; ++tick)
      if (tick != 0) widest = std::max(widest, measure(brush_.look, Face::kMono, kRulerSize, tick_words(tick)).x);
    return picture_.x + widest + 14;
  }
  /// In full where that leaves most of the picture free; "4×10⁶" else.
  [[nodiscard]] std::string tick_words(int tick) const {
    std::string words = lesson::plain_number(tick * tick_);
    const float most = kMostRuler * picture_.width;
    return measure(brush_.look, Face::kMono, kRulerSize, words).x <= most ? words
                                                                          : lesson::number_text(tick * tick_, 1);
  }

  void draw_inside() {
    brush_.list->AddRectFilled({picture_.x, y_of(0)}, {right(), picture_.y + picture_.height},
                               with_alpha(p_.current, 0.09f), 7, ImDrawFlags_RoundCornersBottom);
    line(brush_.list, {picture_.x, y_of(0)}, {right(), y_of(0)}, Stroke::kSolid, p_.current, brush_.stroke());
  }

  void draw_ruler() {
    line(brush_.list, {ruler_x(), picture_.y}, {ruler_x(), y_of(-tick_)}, Stroke::kSolid, p_.ink, 1.5f);
    for (int tick = 1 - kTicksIn; tick < kTicksOut; ++tick) {
      const float y = y_of(tick * tick_);
      line(brush_.list, {ruler_x() - 4, y}, {ruler_x() + 4, y}, Stroke::kSolid, p_.ink, 1.5f);
      if (tick == 0) continue;  // the boundary itself
      text_right(brush_.list, brush_.look, Face::kMono, kRulerSize,
                 {ruler_x() - 7, middle_of(y, brush_.look.px(kRulerSize))}, p_.ink, tick_words(tick));
    }
  }

  void draw_point() {
    const ImVec2 at{std::max(picture_.x + picture_.width * 0.62f, ruler_x() + 16), y_of(left_.ulps())};
    line(brush_.list, {at.x, y_of(0)}, at, Stroke::kDotted, p_.examined, brush_.stroke());
    disc(brush_.list, at, 4, p_.examined);
    ring(brush_.list, at, 8, p_.examined, brush_.stroke(0.8f));
    // Beside the point, clear of the boundary, where there is room; else above it.
    const std::string name = brush_.session.stage().subject().name_of(left_.worst);
    const float size = brush_.look.px(12), room = right() - 4 - measure(brush_.look, Face::kSemiBold, 12, name).x;
    const float clear = y_of(0) - size - 3;
    const ImVec2 beside{at.x + 13, std::min(middle_of(at.y, size), clear)},
        above{std::min(at.x - 4, room), at.y - 12 - size};
    text(brush_.list, brush_.look, Face::kSemiBold, 12, beside.x <= room ? beside : above, p_.examined_text, name);
  }

  void draw_scale() {
    std::string words = "1 ulp = " + lesson::number_text(left_.radius_ulp, 3);
    if (measure(brush_.look, Face::kMono, 11, words).x > picture_.width - 12) words = "ulps";
    text_right(brush_.list, brush_.look, Face::kMono, 11,
               {right() - 6, picture_.y + picture_.height - brush_.look.px(16)}, p_.ink, words);
  }

  Brush& brush_;
  const Palette& p_;
  const lesson::LeftOutside& left_;
  const Rect picture_;
  const double tick_;
};

}  // namespace

void mark_left_outside(Brush& brush, const CloudShown& shown) {
  if (!shown.left) return;
  for (const Index i : shown.left->points) {
    const ImVec2 at = brush.at(brush.point(i));
    ring(brush.list, at, (kRing + 4) * brush.p.mark, brush.p.examined, brush.stroke());
    brush.canvas.obstacles.discs.push_back({at.x, at.y, kRing + 6});
  }
  for (const Index i : shown.left->dents) cross(brush.list, brush.at(brush.point(i)), 9, brush.p.wrong, 2);
}

void name_left_outside(PointNames& names, const CloudShown& shown) {
  if (!shown.left) return;
  const Palette& p = names.brush.p;
  const auto name = [&](Index i, const std::string& words) {
    names.name(i, names.brush.session.stage().subject().name_of(i) + words, p.examined_text, Face::kSemiBold,
               19 * p.mark, 15);
  };
  for (const Index i : shown.left->dents)
    names.name(i, "dent at " + names.brush.session.stage().subject().name_of(i), p.wrong_text, Face::kSemiBold,
               19 * p.mark, 15);
  if (shown.left->points.empty()) return;
  const double ulps = shown.left->ulps();
  const auto point = [&](Index i) { return names.brush.point(i); };
  for (const auto& [first, more] : by_place(shown.left->points, shown.left->worst, point)) {
    const std::string also = more > 0 ? " and " + std::to_string(more) + " more" : "";
    const bool told = first == shown.left->worst && std::isfinite(ulps);
    name(first, also + " outside" + (told ? " by " + lesson::ulps_text(ulps) : ""));
  }
}

Rect draw_ulp_inset(Brush& brush, const CloudShown& shown, ImVec2 at) {
  if (!shown.left || shown.left->points.empty()) return {};
  if (!(shown.left->by < kSeenAsItIs * shown.left->extent)) return {};
  const Point3 worst = brush.point(shown.left->worst);
  const ImVec2 source = brush.at(worst);
  const auto panel = free_place(brush, source, at.y + brush.look.px(kButtons), {}, true);
  if (!panel) return {};
  CloseUp close_up{.at = worst, .panel = *panel, .x = source.x, .y = source.y};
  const Rect picture = picture_of(close_up, brush.look);
  UlpPicture drawn(brush, *shown.left, picture);
  close_up.size = drawn.height() * shown.left->radius_ulp;
  close_up.times = picture.height / (close_up.size * brush.canvas.camera.scale_at(worst));
  draw_close_up_panel(brush, close_up);
  drawn.draw();
  brush.list->AddRect({panel->x, panel->y}, {panel->x + panel->width, panel->y + panel->height}, brush.p.muted, 8, 0,
                      1);
  return *panel;
}

}  // namespace snug::app
