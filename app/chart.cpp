#include "app/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "app/chart_pen.hpp"
#include "app/labels.hpp"
#include "app/numbers.hpp"

namespace snug::app {
namespace {

constexpr float kSize = 12, kTitle = 15, kMark = 5, kReach = 14;
constexpr float kMostLegend = 0.35f;  // of the height; beyond that, fewer names
constexpr float kLeastSize = 9;       // pixels of a picture
constexpr float kNoteLeading = 1.5f, kNearName = 10, kOffLine = 3;
constexpr double kPadding = 0.06;
constexpr double kNothing = 1e-7;  // a fraction below this is only rounding
// A line chart lower than the first has no note, and any chart lower than the second; its file has the note as well.
constexpr float kLittleRoom = 360, kLeastNoted = 220;
constexpr std::size_t kMostMarks = 20;  // on a line, roughly
/// A log axis of fewer decades has ticks between its powers of ten; of a smaller factor, even steps.
constexpr double kFewDecades = 2, kNoDecade = 3;
constexpr std::size_t kFewTicks = 3;

template <class... Values>
std::string said(const char* format, Values... values) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string grouped(double value) {
  std::string digits = said("%.0f", value);
  for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(i, ",");
  return digits;
}

std::string time_figure(double ns) {
  if (ns < 999.5) return said("%.3g ns", ns);
  if (ns < 999.5e3) return said("%.3g µs", ns / 1e3);
  if (ns < 999.5e6) return said("%.3g ms", ns / 1e6);
  return said("%.3g s", ns / 1e9);
}

/// Maps a range of numbers to a range of pixels.
struct Scale {
  bool log = false;
  double from = 0, to = 1;
  float begin = 0, end = 1;

  [[nodiscard]] double shape(double value) const { return log ? std::log10(value) : value; }
  [[nodiscard]] float at(double value) const {
    const double share = (shape(value) - shape(from)) / (shape(to) - shape(from));
    return begin + static_cast<float>(share) * (end - begin);
  }
};

/// The range of an axis of an empty chart.
std::pair<double, double> usual_range(const ChartAxis& axis) {
  switch (axis.unit) {
    case ChartUnit::kTime: return {1e3, 1e9};
    case ChartUnit::kCount: return {10, 1e6};
    case ChartUnit::kPercent: return {0, 1};
    case ChartUnit::kDegrees: return {0, 360};
    case ChartUnit::kRatio: break;
  }
  return {1, 2};
}

/// The scale of an axis, with room at both ends, so that no mark lies on the frame.
Scale scale_of(const Chart& chart, bool is_x) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const ChartSeries& series : chart.series)
    for (const ChartPoint& p : series.points) {
      least = std::min(least, is_x ? std::min(p.x, p.x_low) : p.y);
      most = std::max(most, is_x ? std::max(p.x, p.x_high) : p.y);
    }
  if (!is_x && chart.limit && least <= most) least = std::min(least, *chart.limit), most = std::max(most, *chart.limit);
  const ChartAxis& axis = is_x ? chart.x : chart.y;
  Scale scale{.log = axis.log};
  if (!(least <= most)) std::tie(least, most) = usual_range(axis);
  if (least == most) most = least + (least == 0 ? 1 : std::abs(least) * 0.1);
  if (scale.log) {
    const double pad = std::pow(most / least, kPadding);
    scale.from = least / pad, scale.to = most * pad;
  } else {
    scale.from = least - kPadding * (most - least), scale.to = most + kPadding * (most - least);
  }
  return scale;
}

Color mark_color(const Look& look, ChartRole role) {
  switch (role) {
    case ChartRole::kChosen: return look->current;
    case ChartRole::kExact: return look->optimum;
    default: return look->previous;
  }
}
Color word_color(const Look& look, ChartRole role) {
  switch (role) {
    case ChartRole::kChosen: return look->current_text;
    case ChartRole::kExact: return look->optimum_text;
    default: return look->previous_text;
  }
}

/// Words on one line. before: how much of them lies left of the place: none, half, all.
void words_at(ChartPen& pen, const Look& look, float before, Face face, float size, ImVec2 at, Color color,
              std::string_view words) {
  pen.words(look, face, size, {at.x - before * measure(look, face, size, words).x, at.y}, color, words);
}

/// Draws words in as many lines as they need. leading: of the size. Returns how much higher they are than one line.
float draw_lines(ChartPen& pen, const Look& look, Face face, float size, float leading, ImVec2 at, float width,
                 Color color, std::string_view words) {
  const auto lines = lines_of(look, face, size, words, width);
  float y = at.y;
  for (const std::string_view line : lines) {
    pen.words(look, face, size, {at.x, y}, color, line);
    y += look.px(size * leading);
  }
  return lines.empty() ? 0 : y - at.y - look.px(size * leading);
}

void draw_rim(ChartPen& pen, const Look& look, ImVec2 at, ChartRim rim, Color color) {
  const float r = 1.7f * kMark * look->mark, width = look->stroke * 0.7f;
  if (rim == ChartRim::kRing) pen.disc(at, r, kNoColor, color, width);
  if (rim == ChartRim::kBar || rim == ChartRim::kBars)
    pen.line({at.x - r, at.y + r}, {at.x + r, at.y + r}, color, width);
  if (rim == ChartRim::kBars) pen.line({at.x - r, at.y - r}, {at.x + r, at.y - r}, color, width);
}

Stroke stroke_of(const ChartSeries& series) {
  constexpr std::array kOfRim{Stroke::kSolid, Stroke::kDashed, Stroke::kLongDashed, Stroke::kDashed};
  return series.role == ChartRole::kThen ? Stroke::kDotted : kOfRim[static_cast<std::size_t>(series.rim)];
}

void draw_mark(ChartPen& pen, const Look& look, ImVec2 at, const ChartSeries& series) {
  const float r = kMark * look->mark;
  const Color color = mark_color(look, series.role);
  draw_rim(pen, look, at, series.rim, color);
  const Color inside = series.hollow || series.role == ChartRole::kThen ? look->ground : color;
  const auto polygon = [&](std::initializer_list<ImVec2> corners) {
    pen.polygon({corners.begin(), corners.size()}, inside, color, look->stroke * 0.7f);
  };
  const auto lines = [&](float reach, ImVec2 first, ImVec2 second) {
    for (const ImVec2 way : {first, second})
      pen.line({at.x - reach * way.x, at.y - reach * way.y}, {at.x + reach * way.x, at.y + reach * way.y}, color,
               look->stroke);
  };
  switch (series.shape) {
    case ChartShape::kDisc: return pen.disc(at, r, inside, color, look->stroke * 0.7f);
    case ChartShape::kDiamond:
      return polygon(
          {{at.x, at.y - r * 1.3f}, {at.x + r * 1.3f, at.y}, {at.x, at.y + r * 1.3f}, {at.x - r * 1.3f, at.y}});
    case ChartShape::kSquare:
      return polygon({{at.x - r, at.y - r}, {at.x + r, at.y - r}, {at.x + r, at.y + r}, {at.x - r, at.y + r}});
    case ChartShape::kTriangle:
      return polygon({{at.x, at.y - r * 1.2f}, {at.x + r * 1.2f, at.y + r}, {at.x - r * 1.2f, at.y + r}});
    case ChartShape::kTriangleDown:
      return polygon({{at.x, at.y + r * 1.2f}, {at.x - r * 1.2f, at.y - r}, {at.x + r * 1.2f, at.y - r}});
    case ChartShape::kPlus: return lines(r * 1.3f, {1, 0}, {0, 1});
    case ChartShape::kCross: return lines(r, {1, 1}, {1, -1});
  }
}

/// What stands beside a series, or in the legend: its name and result, and with room for it what that is compared with.
std::string words_of(const ChartSeries& series, bool whole) {
  return whole ? full_name(series) : series.figure.empty() ? series.name : series.name + ": " + series.figure;
}

bool has_lines(const Chart& chart) {
  return std::any_of(chart.series.begin(), chart.series.end(), [](const ChartSeries& one) { return one.line; });
}

/// A name and its place.
struct PlacedName {
  const ChartSeries* series;
  ImVec2 mark;
  Rect place;
  std::string words;
};

/// Draws names, each with a thin line to its mark if it stands away from that. The lines lie below all words.
void draw_names(ChartPen& pen, const Look& look, std::span<const PlacedName> names) {
  for (const auto& [series, mark, place, words] : names) {
    const ImVec2 near{std::clamp(mark.x, place.x, place.x + place.width),
                      std::clamp(mark.y, place.y, place.y + place.height)};
    if (std::hypot(near.x - mark.x, near.y - mark.y) > kMark * look->mark + kNearName)
      pen.line(mark, near, with_alpha(mark_color(look, series->role), 0.5f));
  }
  for (const auto& [series, mark, place, words] : names)
    pen.halo_words(look, Face::kRegular, kSize, {place.x, place.y}, word_color(look, series->role), look->ground,
                   words);
}

/// The names of lines at their right ends, one below the other, each with a thin line to its end. A line that ends
/// earlier has its name beside that.
class EndNames {
 public:
  EndNames(const Look& look, const Chart& chart) : look_(look), chart_(chart) {}

  /// How much of the width they take; 0 where that or the frame's height is too small for them, or where many lines end
  /// early: their names would crowd. frame, at: without a margin.
  template <class At>
  [[nodiscard]] float margin(float width, const Rect& frame, const At& at) {
    const std::vector<const ChartSeries*> all = names();
    if (!has_lines(chart_) || static_cast<float>(all.size()) * row() > frame.height) return 0;
    const auto early = std::count_if(all.begin(), all.end(),
                                     [&](const ChartSeries* one) { return ends_early(at(one->points.back()), frame); });
    if (kFewEarly * early > std::ssize(all)) return 0;
    for (const bool whole : {true, false}) {
      whole_ = whole;
      float widest = 0;
      for (const ChartSeries* one : all)
        widest = std::max(widest, measure(look_, Face::kRegular, kSize, words_of(*one, whole)).x);
      if (widest + kLeader <= kMostMargin * width) return widest + kLeader;
    }
    return 0;
  }

  /// at: a point's place. frame: within the axes, without the margin.
  template <class At>
  void draw(ChartPen& pen, const Rect& frame, const At& at) const {
    const float right = frame.x + frame.width;
    std::vector<End> far;
    std::vector<LabelRequest> early;
    std::vector<const ChartSeries*> early_series;
    for (const ChartSeries* one : names()) {
      const ImVec2 end = at(one->points.back());
      if (!ends_early(end, frame)) {
        far.push_back({one, end});
      } else {
        const ImVec2 size = measure(look_, Face::kRegular, kSize, words_of(*one, whole_));
        early.push_back({end.x, end.y, kMark * look_->mark + 4, size.x, size.y, 1, 0, false, true});
        early_series.push_back(one);
      }
    }
    std::sort(far.begin(), far.end(), [](const End& a, const End& b) { return a.at.y < b.at.y; });
    const std::vector<float> heights = spread(far, frame.y, frame.y + frame.height);
    for (std::size_t i = 0; i < far.size(); ++i) {
      const auto& [series, end] = far[i];
      pen.line({end.x + kMark * look_->mark + 2, end.y}, {right + kLeader - 4, heights[i]},
               with_alpha(mark_color(look_, series->role), 0.5f));
      pen.words(look_, Face::kRegular, kSize, {right + kLeader, middle_of(heights[i], look_.px(kSize))},
                word_color(look_, series->role), words_of(*series, whole_));
    }
    const auto places = place_labels(early, obstacles(at), frame);
    std::vector<PlacedName> beside;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (places[i])
        beside.push_back({early_series[i], {early[i].x, early[i].y}, *places[i], words_of(*early_series[i], whole_)});
    draw_names(pen, look_, beside);
  }

 private:
  struct End {
    const ChartSeries* series;
    ImVec2 at;
  };
  static constexpr float kLeader = 28, kMostMargin = 0.3f, kEarly = 0.12f;
  static constexpr std::ptrdiff_t kFewEarly = 4;  // one in so many lines may end early
  [[nodiscard]] static bool ends_early(ImVec2 end, const Rect& frame) {
    return end.x <= frame.x + (1 - kEarly) * frame.width;
  }
  [[nodiscard]] float row() const { return look_.px(1.3f * kSize); }

  [[nodiscard]] std::vector<const ChartSeries*> names() const {
    std::vector<const ChartSeries*> named;
    for (const ChartSeries& one : chart_.series)
      if (!one.name.empty() && !one.points.empty()) named.push_back(&one);
    return named;
  }

  /// Heights a row apart, as near to the ends as that allows: runs that would overlap share their mean.
  [[nodiscard]] std::vector<float> spread(const std::vector<End>& ends, float top, float bottom) const {
    struct Run {
      float sum;
      int count;
      [[nodiscard]] float mean() const { return sum / static_cast<float>(count); }
    };
    std::vector<Run> runs;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      runs.push_back({ends[i].at.y - static_cast<float>(i) * row(), 1});
      while (runs.size() > 1 && runs.back().mean() < runs[runs.size() - 2].mean()) {
        runs[runs.size() - 2].sum += runs.back().sum, runs[runs.size() - 2].count += runs.back().count;
        runs.pop_back();
      }
    }
    std::vector<float> heights;
    const float last = static_cast<float>(ends.size()) - 1;
    for (const Run& run : runs)
      for (int i = 0; i < run.count; ++i) {
        const float first = std::clamp(run.mean(), top, std::max(top, bottom - last * row()));
        heights.push_back(first + static_cast<float>(heights.size()) * row());
      }
    return heights;
  }

  template <class At>
  [[nodiscard]] Obstacles obstacles(const At& at) const {
    Obstacles all;
    for (const ChartSeries& one : chart_.series)
      for (std::size_t i = 0; i < one.points.size(); ++i) {
        const ImVec2 to = at(one.points[i]);
        all.discs.push_back({to.x, to.y, kMark * look_->mark + 2});
        if (i == 0) continue;
        const ImVec2 from = at(one.points[i - 1]);
        all.segments.push_back({from.x, from.y, to.x, to.y});
      }
    return all;
  }

  const Look& look_;
  const Chart& chart_;
  bool whole_ = true;
};

/// The legend below the axes, where names find no room beside their marks.
class Legend {
 public:
  /// Shows the whole names if they take few rows, otherwise without the comparison.
  Legend(const Look& look, const Chart& chart, float width) : look_(look), chart_(chart) {
    rimmed_ = std::any_of(chart.series.begin(), chart.series.end(),
                          [](const ChartSeries& one) { return one.rim != ChartRim::kNone; });
    place(width, true);
    if (rows_ > kMostRows) place(width, false);
  }
  [[nodiscard]] float height() const { return rows_ == 0 ? 0 : static_cast<float>(rows_) * row() + 8; }
  void draw(ChartPen& pen, ImVec2 from) const {
    for (const Entry& entry : entries_) {
      const ImVec2 at{from.x + entry.x, from.y + static_cast<float>(entry.row) * row() + row() / 2};
      draw_mark(pen, look_, {at.x + 2 * kMark, at.y}, *entry.series);
      pen.words(look_, Face::kRegular, kSize, {at.x + kIndent, middle_of(at.y, look_.px(kSize))}, look_->ink,
                entry.words);
    }
  }

 private:
  struct Entry {
    const ChartSeries* series;
    std::string words;
    float x;
    int row;
  };
  static constexpr int kMostRows = 3;
  static constexpr float kIndent = 24, kGap = 20;
  [[nodiscard]] float row() const { return look_.px(rimmed_ ? 24 : 18); }

  void place(float width, bool whole) {
    entries_.clear();
    float x = 0;
    int row = 0;
    for (const ChartSeries& one : chart_.series) {
      if (one.name.empty()) continue;
      const std::string words = words_of(one, whole);
      const float wanted = kIndent + measure(look_, Face::kRegular, kSize, words).x;
      if (x > 0 && x + wanted > width) x = 0, ++row;
      entries_.push_back({&one, shortened(look_, Face::kRegular, kSize, words, width - kIndent), x, row});
      x += wanted + kGap;
    }
    rows_ = entries_.empty() ? 0 : row + 1;
  }

  const Look& look_;
  const Chart& chart_;
  std::vector<Entry> entries_;
  int rows_ = 0;
  bool rimmed_ = false;  // rims need room between the rows
};

bool hides_one(const Rect& box, std::span<const ImVec2> marks) {
  return std::any_of(marks.begin(), marks.end(), [&](ImVec2 mark) {
    return mark.x > box.x && mark.x < box.x + box.width && mark.y > box.y && mark.y < box.y + box.height;
  });
}

/// Draws a chart.
struct Plot {
  ChartPen& pen;
  const Look& look;
  const Chart& chart;
  Rect frame;  // within the axes
  Scale x, y;

  [[nodiscard]] ImVec2 at(const ChartPoint& p) const { return {x.at(p.x), y.at(p.y)}; }

  void axes() const {
    const float height = look.px(kSize), bottom = frame.y + frame.height;
    const int most_x = std::max(2, static_cast<int>(frame.width / look.px(76))),
              most_y = std::max(2, static_cast<int>(frame.height / look.px(44)));
    for (const ChartTick& tick : chart_ticks(chart.x, x.from, x.to, most_x)) {
      const float place = x.at(tick.at);
      pen.line({place, frame.y}, {place, bottom}, look->grid);
      pen.line({place, bottom}, {place, bottom + 4}, look->muted);
      words_at(pen, look, 0.5f, Face::kMono, kSize, {place, bottom + 8}, look->muted, tick.label);
    }
    float lowest = bottom + height;  // of the names that stand already
    for (const ChartTick& tick : chart_ticks(chart.y, y.from, y.to, most_y)) {
      const float place = y.at(tick.at);
      if (place > lowest - height) continue;  // it would stand over the one below
      lowest = place;
      pen.line({frame.x, place}, {frame.x + frame.width, place}, look->grid);
      words_at(pen, look, 1, Face::kMono, kSize, {frame.x - 8, middle_of(place, height)}, look->muted, tick.label);
    }
    pen.line({frame.x, bottom}, {frame.x + frame.width, bottom}, look->line, 1);
    pen.line({frame.x, frame.y}, {frame.x, bottom}, look->line, 1);
    words_at(pen, look, 1, Face::kRegular, kSize, {frame.x + frame.width, bottom + 12 + height}, look->muted,
             chart.x.title);
  }

  /// Draws the front as steps: between the times of two offers, nothing smaller is available.
  void front() const {
    std::vector<ImVec2> way;
    for (const ChartPoint& p : chart.front) {
      if (!way.empty()) way.push_back({at(p).x, way.back().y});
      way.push_back(at(p));
    }
    if (way.size() > 1) pen.path(way, Stroke::kSolid, with_alpha(look->current, 0.6f), look->stroke * 0.7f);
  }

  /// Draws the value that the chart's points are compared with.
  void limit() const {
    if (!has_limit()) return;
    const float height = y.at(*chart.limit);
    const std::array way{ImVec2(frame.x, height), ImVec2(frame.x + frame.width, height)};
    pen.path(way, Stroke::kDashed, look->optimum, look->stroke * 0.7f);
  }
  /// Names it where rising lines leave room: at its left end, or where it is at the chart's foot, farther in; and above
  /// it, or where it is at the chart's top, below.
  void name_limit() const {
    if (!has_limit()) return;
    const float height = y.at(*chart.limit), size = look.px(kSize), clear = kMark * look->mark + 6;
    const bool at_foot = frame.y + frame.height - height < 0.15f * frame.height;
    const float above = height - clear - size;
    pen.halo_words(look, Face::kSemiBold, kSize,
                   {frame.x + (at_foot ? 0.25f * frame.width : 8), above < frame.y ? height + 6 : above},
                   look->optimum_text, look->ground, chart.limit_name);
  }
  [[nodiscard]] bool has_limit() const { return chart.limit && !chart.series.empty(); }

  void series() const {
    for (const ChartSeries& one : chart.series) {
      const Color color = mark_color(look, one.role);
      std::vector<ImVec2> way;
      for (const ChartPoint& p : one.points) way.push_back(at(p));
      if (one.line && way.size() > 1) pen.path(way, stroke_of(one), with_alpha(color, 0.7f), look->stroke * 0.7f);
      for (const ChartPoint& p : one.points)
        if (p.x_low < p.x_high) {
          const float left = x.at(p.x_low), right = x.at(p.x_high), height = at(p).y;
          pen.line({left, height}, {right, height}, color, look->stroke * 0.7f);
          for (const float end : {left, right})
            pen.line({end, height - 4}, {end, height + 4}, color, look->stroke * 0.7f);
        }
      const std::size_t every = one.line ? 1 + one.points.size() / kMostMarks : 1;
      for (std::size_t i = 0; i < one.points.size(); i += every) draw_mark(pen, look, at(one.points[i]), one);
    }
  }

  /// Each series' name beside its last point, clear of the bars of spread. None if one finds no place, unless fewer are
  /// wanted: then those on the front choose first, and those without a place are left out.
  [[nodiscard]] std::optional<std::vector<PlacedName>> names(bool fewer) const {
    std::vector<const ChartSeries*> named;
    Obstacles obstacles;
    for (const ChartSeries& one : chart.series) {
      if (!one.points.empty() && !one.name.empty()) named.push_back(&one);
      for (const ChartPoint& p : one.points) {
        obstacles.discs.push_back({at(p).x, at(p).y, kMark * look->mark + 2});
        if (p.x_low < p.x_high) obstacles.segments.push_back({x.at(p.x_low), at(p).y, x.at(p.x_high), at(p).y});
      }
    }
    if (fewer)
      std::stable_partition(named.begin(), named.end(),
                            [](const ChartSeries* one) { return one->role != ChartRole::kPlain; });
    for (std::size_t i = 1; i < chart.front.size(); ++i) {
      const ImVec2 from = at(chart.front[i - 1]), to = at(chart.front[i]);
      obstacles.segments.push_back({from.x, from.y, to.x, from.y});
      obstacles.segments.push_back({to.x, from.y, to.x, to.y});
    }
    std::vector<LabelRequest> requests;
    for (const ChartSeries* one : named) {
      const ImVec2 end = at(one->points.back()), size = measure(look, Face::kRegular, kSize, one->name);
      requests.push_back(
          {end.x, end.y, kMark * look->mark + 5, size.x, size.y + 2 * kOffLine, 0.7f, -0.7f, fewer, true});
    }
    const auto places = place_labels(requests, obstacles, frame);
    std::vector<PlacedName> found;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i] && !fewer) return std::nullopt;
      if (!places[i]) continue;
      const auto& [left, top, width, height] = *places[i];
      found.push_back({named[i],
                       at(named[i]->points.back()),
                       {left, top + kOffLine, width, height - 2 * kOffLine},
                       named[i]->name});
    }
    return found;
  }

  [[nodiscard]] std::optional<ChartHit> under_pointer() const {
    const auto pointer = pen.pointer();
    if (!pointer) return std::nullopt;
    std::optional<ChartHit> hit;
    float nearest = kReach;
    for (std::size_t i = 0; i < chart.series.size(); ++i)
      for (std::size_t j = 0; j < chart.series[i].points.size(); ++j) {
        const ImVec2 place = at(chart.series[i].points[j]);
        const float distance = std::hypot(place.x - pointer->x, place.y - pointer->y);
        if (distance < nearest) nearest = distance, hit = ChartHit{i, j};
      }
    return hit;
  }

  /// Draws the power that a line is compared with, from the line's start to its end.
  void slope(const ChartSeries& one) const {
    const ChartPoint& last = one.points.back();
    const double first = one.points.front().x;
    pen.clip(&frame);
    const std::array way{at({first, last.y * std::pow(first / last.x, *one.slope)}), at(last)};
    pen.path(way, Stroke::kDashed, look->optimum, look->stroke);
    pen.clip(nullptr);
  }

  /// asked_for: by a pointer. Otherwise they give way to the marks, and the sentence below the chart tells them.
  void figures(const ChartHit& hit, bool asked_for) const {
    const ChartSeries& one = chart.series[hit.series];
    if (one.slope) slope(one);
    const ChartPoint& p = one.points[hit.point];
    const ImVec2 place = at(p);
    pen.disc(place, kMark * look->mark + 4, kNoColor, look->support, 2);
    const std::string name = full_name(one) + (one.slope ? " (dashed)" : "");
    const std::string x_words =
        chart_figure(chart.x.unit, p.x) + (chart.x.unit == ChartUnit::kCount ? " " + chart.x.title : "");
    const std::string words =
        (one.names.empty() ? x_words : one.names[hit.point]) + ", " + chart_figure(chart.y.unit, p.y);
    const float width =
        std::max(measure(look, Face::kSemiBold, kSize, name).x, measure(look, Face::kMono, kSize, words).x) + 24;
    const float height = 2 * look.px(kSize) + 24;
    std::vector<ImVec2> marks;
    for (const ChartSeries& other : chart.series)
      for (const ChartPoint& point : other.points) marks.push_back(at(point));
    const Rect box = clear_place({width, height}, frame, place, marks);
    if (!asked_for && hides_one(box, marks)) return;
    pen.box(box, look->panel, look->line);
    pen.words(look, Face::kSemiBold, kSize, {box.x + 12, box.y + 8}, look->ink, name);
    pen.words(look, Face::kMono, kSize, {box.x + 12, box.y + 14 + look.px(kSize)}, look->ink, words);
  }
};

}  // namespace

std::string full_name(const ChartSeries& series) {
  std::string name = series.name;
  for (const std::string* more : {&series.figure, &series.beside})
    if (!more->empty()) name += (name == series.name ? ": " : ", ") + *more;
  return name;
}

Rect clear_place(ImVec2 size, const Rect& frame, ImVec2 about, std::span<const ImVec2> marks) {
  constexpr float kBeside = 12, kMargin = 8, kClear = kMark + 2;
  const float left = frame.x + kMargin, right = std::max(left, frame.x + frame.width - size.x - kMargin);
  const float top = frame.y + kMargin, bottom = std::max(top, frame.y + frame.height - size.y - kMargin);
  const float beside = std::clamp(about.x + kBeside, frame.x, std::max(frame.x, frame.x + frame.width - size.x));
  const bool above = about.y - size.y - kBeside >= frame.y;  // below it where there is no room
  const std::array<ImVec2, 5> places{
      {{beside, above ? about.y - size.y - kBeside : std::min(about.y + 16, frame.y + frame.height - size.y)},
       {left, top},
       {right, top},
       {left, bottom},
       {right, bottom}}};
  const auto hides = [&](ImVec2 at, ImVec2 mark) {
    return mark.x > at.x - kClear && mark.x < at.x + size.x + kClear && mark.y > at.y - kClear &&
           mark.y < at.y + size.y + kClear;
  };
  const auto hidden = [&](ImVec2 at) {
    if (hides(at, about)) return static_cast<std::ptrdiff_t>(marks.size()) + 1;
    return std::count_if(marks.begin(), marks.end(), [&](ImVec2 mark) { return hides(at, mark); });
  };
  const ImVec2 best =
      *std::min_element(places.begin(), places.end(), [&](ImVec2 a, ImVec2 b) { return hidden(a) < hidden(b); });
  return {best.x, best.y, size.x, size.y};
}

float picture_scale(float width, float height) {
  return std::max(kLeastSize / kSize, std::min(width / 1280, height / 800));
}

std::string chart_figure(ChartUnit unit, double value) {
  switch (unit) {
    case ChartUnit::kTime: return time_figure(value);
    case ChartUnit::kCount: return grouped(value);
    case ChartUnit::kPercent:
      if (std::abs(value) < kNothing) return "0 %";
      return value < 9.995 ? said("%.3g %%", 100 * value) : grouped(100 * value) + " %";
    case ChartUnit::kDegrees: return said("%.3g°", value);
    case ChartUnit::kRatio: break;
  }
  return said("%.4g", value);
}

namespace {

/// The least step that suits the unit: degrees are divided as a clock face is.
double step_at_least(ChartUnit unit, double least) {
  if (unit == ChartUnit::kDegrees)
    for (const double step : {1, 5, 15, 30, 45, 90, 180, 360})
      if (step >= least) return step;
  return nice_at_least(least);
}

std::vector<double> even_places(ChartUnit unit, double from, double to, int most) {
  std::vector<double> places;
  const double step = step_at_least(unit, (to - from) / most);
  for (double i = std::ceil(from / step); i * step <= to; ++i) places.push_back(i * step + 0.0);  // not -0
  return places;
}

constexpr double kPowers[] = {1}, kUsual[] = {1, 2, 5}, kFine[] = {1, 1.5, 2, 3, 4, 5, 7};

/// The multiples, by the factors, of every so many powers of ten, as far as they lie between.
std::vector<double> between(double from, double to, int every, std::span<const double> factors) {
  std::vector<double> places;
  const int first = static_cast<int>(std::floor(std::log10(from))), last = static_cast<int>(std::ceil(std::log10(to)));
  for (int power = first; power <= last; power += every)
    for (const double factor : factors) {
      const double place = factor * std::pow(10.0, power);
      if (place >= from && place <= to) places.push_back(place);
    }
  return places;
}

/// Three at least, where there is room for them.
std::vector<double> log_places(double from, double to, int most) {
  const double decades = std::log10(to / from);
  int every = std::max(1, static_cast<int>(std::ceil(decades / most)));
  std::vector<double> places = decades < kFewDecades && 3 * decades + 1 <= most ? between(from, to, 1, kUsual)
                                                                                : between(from, to, every, kPowers);
  while (places.size() < 2 && every > 1) places = between(from, to, --every, kPowers);
  for (const std::span<const double> factors : {std::span<const double>(kUsual), std::span<const double>(kFine)}) {
    if (places.size() >= kFewTicks) break;
    const std::vector<double> finer = between(from, to, 1, factors);
    if (finer.size() > places.size() && static_cast<int>(finer.size()) <= most) places = finer;
  }
  return places;
}

}  // namespace

std::vector<ChartTick> chart_ticks(const ChartAxis& axis, double from, double to, int most) {
  std::vector<double> places;
  if (axis.log && to >= from * kNoDecade) places = log_places(from, to, most);
  if (places.size() < 2) places = even_places(axis.unit, from, to, most);
  std::vector<ChartTick> ticks;
  for (const double place : places)
    if (place >= from && place <= to && (axis.unit != ChartUnit::kCount || place == std::round(place)))
      ticks.push_back({place, chart_figure(axis.unit, place)});
  return ticks;
}

namespace {

/// Draws the title, the note and the vertical axis's title. Returns how far down they reach.
float draw_heading(ChartPen& pen, const Look& look, const Rect& rect, const Chart& chart, float taken) {
  const float left = rect.x + 16, top = rect.y + 16, width = rect.width - 32;
  const float title =
      draw_lines(pen, look, Face::kSemiBold, kTitle, 1.3f, {left, top}, width - taken, look->ink, chart.title);
  const float under = top + title + look.px(kTitle) + 8;
  const bool noted = rect.height >= (has_lines(chart) ? kLittleRoom : kLeastNoted);
  float note = noted ? 0 : -8;
  if (noted && !chart.note.empty()) {
    const float first = look.px(kSize * kNoteLeading) - look.px(kSize);  // the room above and below a line, together
    note = first + look.px(kSize) +
           draw_lines(pen, look, Face::kRegular, kSize, kNoteLeading, {left, under + first / 2}, width, look->muted,
                      chart.note);
  }
  note +=
      draw_lines(pen, look, Face::kRegular, kSize, 1.3f, {left, under + note + 8}, width, look->muted, chart.y.title);
  return under + note;
}

/// Fits the frame between the heading, the axes' names and what lies to the right of it and below.
void fit_frame(Plot& plot, const Rect& rect, float heading, float right, float below) {
  const float line = plot.look.px(kSize);
  float widest = 0;
  for (const ChartTick& tick : chart_ticks(plot.chart.y, plot.y.from, plot.y.to, 12))
    widest = std::max(widest, measure(plot.look, Face::kMono, kSize, tick.label).x);
  const float top = heading + 16 + line;
  plot.frame = {rect.x + 24 + widest, top, rect.width - widest - 48 - right,
                rect.y + rect.height - top - 2 * line - (below > 0 ? 20 : 32) - below};
  plot.x.begin = plot.frame.x, plot.x.end = plot.frame.x + plot.frame.width;
  plot.y.begin = plot.frame.y + plot.frame.height, plot.y.end = plot.frame.y;
}

}  // namespace

std::optional<ChartHit> draw_chart(ChartPen& pen, const Look& look, const Rect& rect, const Chart& chart,
                                   std::optional<ChartHit> focus, std::vector<ChartPlace>* places, float taken) {
  const float left = rect.x + 16, heading = draw_heading(pen, look, rect, chart, taken);
  Plot plot{pen, look, chart, {}, scale_of(chart, true), scale_of(chart, false)};
  fit_frame(plot, rect, heading, 0, 0);
  const auto at = [&](const ChartPoint& p) { return plot.at(p); };
  EndNames ends(look, chart);
  const float margin = ends.margin(rect.width, plot.frame, at);
  if (margin > 0) fit_frame(plot, rect, heading, margin, 0);
  auto beside = has_lines(chart) ? std::nullopt : plot.names(false);
  std::optional<Legend> legend;
  if (margin == 0 && !beside) {
    legend.emplace(look, chart, rect.width - 32);
    if (has_lines(chart) || legend->height() <= kMostLegend * rect.height) {
      fit_frame(plot, rect, heading, 0, legend->height());
    } else {
      legend.reset();
      beside = plot.names(true);
    }
  }
  if (plot.frame.width < 1 || plot.frame.height < 1) return std::nullopt;
  if (places != nullptr)
    for (const ChartSeries& one : chart.series) {
      const ImVec2 end = one.points.empty() ? ImVec2(left, heading) : plot.at(one.points.back());
      places->push_back({end.x, end.y});
    }
  plot.axes();
  plot.front();
  plot.limit();
  plot.series();
  plot.name_limit();
  if (legend) legend->draw(pen, {left, rect.y + rect.height - legend->height()});
  else if (beside) draw_names(pen, look, *beside);
  else ends.draw(pen, plot.frame, at);
  const auto hit = plot.under_pointer();
  const auto shown = hit ? hit : focus;
  if (shown) plot.figures(*shown, hit.has_value());
  return shown;
}

}  // namespace snug::app
