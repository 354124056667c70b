// A chart: axes with units, a mark for each point told apart by shape and name, lines, bars of spread. It knows nothing
// of what it shows (app/cost_charts.hpp does).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/look.hpp"

namespace snug::app {

enum class ChartUnit : std::uint8_t { kTime, kRatio, kCount, kPercent, kDegrees };

struct ChartAxis {
  std::string title;
  ChartUnit unit = ChartUnit::kRatio;
  bool log = false;
};

enum class ChartShape : std::uint8_t { kDisc, kDiamond, kSquare, kTriangle, kTriangleDown, kPlus, kCross };
inline constexpr int kChartShapes = 7;
/// What is drawn round a shape, so that more series than there are shapes are told apart. Lines are dashed with it.
enum class ChartRim : std::uint8_t { kNone, kRing, kBar, kBars };
inline constexpr int kChartRims = 4;
/// So many series have a look of their own.
inline constexpr int kChartLooks = kChartShapes * kChartRims;

/// What a series is, which says its colour and line.
enum class ChartRole : std::uint8_t {
  kPlain,   // a rival
  kChosen,  // of the front
  kExact,   // the smallest of its kind, proven
  kThen,    // of an earlier result
};

struct ChartPoint {
  double x = 0, y = 0;
  double x_low = 0, x_high = 0;  // a bar of spread; both x where there is none
};

struct ChartSeries {
  std::string name;
  std::string figure, beside;  // of a line: what is found of it and what it is held against; may be empty
  std::optional<double>
      slope;  // of a line between log axes: what it is held against, drawn through its last point where it is looked at
  ChartShape shape = ChartShape::kDisc;
  ChartRim rim = ChartRim::kNone;
  ChartRole role = ChartRole::kPlain;
  bool line = false;               // whether its points are joined, by rising x
  bool hollow = false;             // measured on fewer points than the others, or not to be trusted
  std::vector<ChartPoint> points;  // finite; above 0 on a log axis
  int row = -1;                    // of the present table, where it is one of its rows
};

/// Without a series it is its axes, over what stands for them until something is measured, and the note.
struct Chart {
  std::string title, note;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  int looks = 0;                  // different looks that the series want; more than kChartLooks repeat
  std::vector<ChartPoint> front;  // a staircase under which nothing lies, by rising x; empty for none
};

struct ChartTick {
  double at = 0;
  std::string label;
};

/// What stands between two ends, both included: on a log axis powers of ten, or of a short one 1, 2 and 5 of each, or
/// as on an even axis equal steps of 1, 2 or 5. most: that may be there, at least 2.
[[nodiscard]] std::vector<ChartTick> chart_ticks(const ChartAxis& axis, double from, double to, int most);

/// A figure with its unit: "1.5 ms", "1.24", "20,000", "35 %".
[[nodiscard]] std::string chart_figure(ChartUnit unit, double value);

/// A point by the place of its series and its own in it.
struct ChartHit {
  std::size_t series = 0, point = 0;
};

/// "PCA: n^1.04, theory 1.00"
[[nodiscard]] std::string full_name(const ChartSeries& series);

/// Where a series' last point was drawn.
struct ChartPlace {
  float x = 0, y = 0;
};

/// Draws into the rectangle. focus: whose figures are shown beside it, as where the pointer is near a point; the
/// pointer goes before. places: is given one for each series. Returns the point whose figures were shown.
std::optional<ChartHit> draw_chart(ImDrawList* list, const Look& look, const Rect& rect, const Chart& chart,
                                   std::optional<ChartHit> focus = {}, std::vector<ChartPlace>* places = nullptr);

}  // namespace snug::app
