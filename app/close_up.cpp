#include "app/close_up.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/numbers.hpp"
#include "lesson/figures.hpp"
#include "lesson/speaking.hpp"

namespace snug::app {
namespace {

constexpr float kHead = 22, kPanelMargin = 12, kPanelAspect = 0.8f;
constexpr double kGapShare = 1.0 / 3;  // of the picture's width that the gap takes, if the file does not say
constexpr double kLeastTimes = 5, kMostTimes = 1e6;  // below the first a gap can be seen as it is
constexpr float kSmallestMark = 9;                   // a ring of this radius marks what is smaller, pixels
constexpr float kNarrow = 560, kMiddling = 900, kNarrowWidth = 116;

bool holds(const Rect& rect, float x, float y, float reach) {
  return x > rect.x - reach && x < rect.x + rect.width + reach && y > rect.y - reach &&
         y < rect.y + rect.height + reach;
}

float head_of(const Look& look) { return look.px(kHead); }

/// How much a panel covers: the place itself counts most, then handles, those with a mark more than others.
int covered_by(const Rect& panel, const Brush& brush, ImVec2 source) {
  constexpr int kSource = 10000, kHandle = 4;
  const float reach = brush.look.fingers ? 22.0f : 8.0f;
  int count = holds(panel, source.x, source.y, kSmallestMark) ? kSource : 0;
  for (const ScreenPoint& handle : brush.handles)
    if (handle.visible && holds(panel, handle.x, handle.y, reach)) count += kHandle;
  for (const auto& mark : brush.canvas.obstacles.discs) count += holds(panel, mark.x, mark.y, 0) ? 1 : 0;
  return count;
}

/// How wide the panel may be, the best first.
std::vector<float> widths_for(const Brush& brush, bool may_shrink) {
  if (brush.rect.width < kNarrow) return {kNarrowWidth};
  std::vector<float> widths{brush.look.px(brush.rect.width < kMiddling ? 168 : 216)};
  if (may_shrink) widths.push_back(brush.look.px(kNarrowWidth));
  return widths;
}

/// Where a panel of that width may be, the best places first; in_middle: there too.
std::vector<Rect> places_for(const Brush& brush, float width, float top, bool in_middle) {
  const Rect& stage = brush.rect;
  const Look& look = brush.look;
  const float height = width * kPanelAspect + head_of(look);
  const float left = stage.x + kPanelMargin, right = stage.x + stage.width - kPanelMargin - width;
  const float high = stage.y + kPanelMargin, low = brush.canvas.camera.free_bottom() - height;
  std::vector<Rect> places;
  for (const auto& [x, y] : {std::pair{left, high},
                             {stage.x + look.tools + kPanelMargin, high},
                             {left, top},
                             {right, low},
                             {right, top},
                             {left, low}}) {
    const bool at_cross = brush.dim() == 3 && x == left && y == low;
    if (low >= top && !at_cross) places.push_back({x, y, width, height});
  }
  if (in_middle && low >= top) places.push_back({(left + right) / 2, (top + low) / 2, width, height});
  return places;
}

/// A round number that is shorter than a panel: "0.0002".
std::string scale_text(double length) {
  const int decimals = static_cast<int>(std::ceil(-std::log10(length) - 1e-9));
  return decimals > 0 && decimals < 7 ? lesson::decimal_text(length, decimals) : lesson::plain_number(length);
}

/// "40", "2.5", "1,200", "15 billion": two digits.
std::string times_text(double times) {
  constexpr double kBillion = 1e9, kMostBillions = 1e12;
  const double unit = std::pow(10, std::floor(std::log10(times)) - 1);
  const double rounded = std::round(times / unit) * unit;
  if (rounded < kBillion || rounded >= kMostBillions) return lesson::plain_number(rounded);
  return lesson::plain_number(rounded / kBillion) + " billion";
}

}  // namespace

std::optional<Rect> free_place(const Brush& brush, ImVec2 source, float top, const Rect& last, bool may_shrink) {
  const std::vector<Rect>& taken = brush.canvas.obstacles.taken;
  std::optional<Rect> widest;
  for (const float width : widths_for(brush, may_shrink)) {
    std::optional<Rect> best;
    int least = 0;
    for (const Rect& place : places_for(brush, width, top, may_shrink)) {
      if (std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return overlap(place, other); })) continue;
      const int covered = 2 * covered_by(place, brush, source) - (place.x == last.x && place.y == last.y ? 1 : 0);
      if (!best || covered < least) best = place, least = covered;
    }
    if (best && least <= 0) return best;
    if (!widest) widest = best;
  }
  return widest;
}

float room_above(float words) { return 2 * kPanelMargin + kNarrowWidth * kPanelAspect + kHead * words; }

std::optional<std::array<Point3, 2>> ends_of(const lesson::StagePlace& place, const SubjectView& view,
                                             const lesson::Session& session) {
  if (place.is_gap()) {
    const lesson::HasVolumes* const own = session.stage().subject().with_volumes();
    return own != nullptr ? own->gap() : std::nullopt;
  }
  if (place.handle.empty()) return std::array{Point3(place.at), Point3(place.at)};
  const auto handle = lesson::handle_named(session.stage().subject(), place.handle);
  if (!handle) return std::nullopt;
  const Point3 at = view.place_of(session, *handle);
  return std::array{at, at};
}

std::optional<CloseUp> close_up_of(const Brush& brush, float top, const Rect& last) {
  const std::optional<lesson::Inset>& wish = brush.session.lesson().view.inset;
  const auto ends = wish ? ends_of(wish->at, brush.view, brush.session) : std::nullopt;
  if (!ends) return std::nullopt;
  const Point3 middle = ((*ends)[0] + (*ends)[1]) / 2;
  const ImVec2 source = brush.at(middle);
  const auto panel = free_place(brush, source, top, last, false);
  if (!panel) return std::nullopt;
  const double scale = brush.canvas.camera.scale_at(middle), gap = ((*ends)[1] - (*ends)[0]).norm();
  const double size = wish->size > 0 ? wish->size : gap / kGapShare;
  const double times = std::min(panel->width / (size * scale), kMostTimes);  // infinite where both touch
  if (wish->size <= 0 && times < kLeastTimes) return std::nullopt;
  return CloseUp{middle, panel->width / (times * scale), times, *panel, source.x, source.y};
}

Rect picture_of(const CloseUp& close_up, const Look& look) {
  const Rect& panel = close_up.panel;
  return {panel.x + 1, panel.y + head_of(look), panel.width - 2, panel.height - head_of(look) - 1};
}

void draw_close_up_panel(const Brush& brush, const CloseUp& close_up) {
  const Palette& p = brush.p;
  const Look& look = brush.look;
  const Rect& panel = close_up.panel;
  const ImVec2 source{close_up.x, close_up.y}, low{panel.x, panel.y},
      high{panel.x + panel.width, panel.y + panel.height};
  const Rect picture = picture_of(close_up, look);
  const float half_x = picture.width / 2 / static_cast<float>(close_up.times),
              half_y = picture.height / 2 / static_cast<float>(close_up.times);
  const ImVec2 corner{std::clamp(source.x, low.x, high.x), std::clamp(source.y, low.y, high.y)};
  const float away = std::hypot(corner.x - source.x, corner.y - source.y);
  const float from = std::max(kSmallestMark, std::max(half_x, half_y)) / std::max(away, 1.0f);
  if (from < 1)
    line(brush.list, {source.x + (corner.x - source.x) * from, source.y + (corner.y - source.y) * from}, corner,
         Stroke::kSolid, with_alpha(p.muted, 0.7f), 1);
  if (std::max(half_x, half_y) > kSmallestMark)
    brush.list->AddRect({source.x - half_x, source.y - half_y}, {source.x + half_x, source.y + half_y}, p.muted, 2, 0,
                        brush.stroke(0.7f));
  else ring(brush.list, source, kSmallestMark, p.muted, brush.stroke(0.7f));
  brush.list->AddRectFilled(low, high, p.panel, 8);
  brush.list->AddRectFilled({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height}, p.ground,
                            7, ImDrawFlags_RoundCornersBottom);
  std::string words = times_text(close_up.times) + " times larger";
  if (brush.rect.width < kNarrow || measure(look, Face::kSemiBold, 12, words).x > panel.width - 16)
    words = "×" + times_text(close_up.times);
  text(brush.list, look, Face::kSemiBold, 12, {panel.x + 8, middle_of(panel.y + head_of(look) / 2, look.px(12))},
       p.muted, words);
}

void draw_close_up_scale(const Brush& brush, const CloseUp& close_up) {
  const Palette& p = brush.p;
  const Look& look = brush.look;
  const Rect& panel = close_up.panel;
  const double pixels = panel.width / close_up.size;  // a scene unit
  const double length = nice_at_least(16 / pixels);
  const std::string words = scale_text(length);
  const float right = panel.x + panel.width - 10, left = right - static_cast<float>(length * pixels);
  const float y = panel.y + panel.height - 12;
  const float words_from = left - 6 - measure(look, Face::kMono, 11, words).x;
  brush.list->AddRectFilled({words_from - 6, y - 9}, {panel.x + panel.width - 2, panel.y + panel.height - 2},
                            with_alpha(p.ground, 0.85f), 6);
  text_right(brush.list, look, Face::kMono, 11, {left - 6, middle_of(y, look.px(11))}, p.ink, words);
  line(brush.list, {left, y}, {right, y}, Stroke::kSolid, p.ink, 1.5f);
  for (const float x : {left, right}) line(brush.list, {x, y - 3}, {x, y + 3}, Stroke::kSolid, p.ink, 1.5f);
  brush.list->AddRect({panel.x, panel.y}, {panel.x + panel.width, panel.y + panel.height}, p.muted, 8, 0, 1);
}

}  // namespace snug::app
