// A chart: axes with units, a mark for each point told apart by shape and name, lines, bars of spread. It knows nothing
// about what it shows (app/subjects/cost/charts.hpp does).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/look.hpp"

namespace snug::app {

class ChartPen;

enum class ChartUnit : std::uint8_t { kTime, kRatio, kCount, kPercent, kDegrees };

struct ChartAxis {
  std::string title;
  ChartUnit unit = ChartUnit::kRatio;
  bool log = false;
};

enum class ChartShape : std::uint8_t { kDisc, kDiamond, kSquare, kTriangle, kTriangleDown, kPlus, kCross };
inline constexpr int kChartShapes = 7;
/// What is drawn around a shape, so that there can be more series than shapes. It also selects the line's dashes.
enum class ChartRim : std::uint8_t { kNone, kRing, kBar, kBars };
inline constexpr int kChartRims = 4;
/// How many series can have different looks.
inline constexpr int kChartLooks = kChartShapes * kChartRims;

/// The role of a series, which determines its colour and line.
enum class ChartRole : std::uint8_t {
  kPlain,   // a rival
  kChosen,  // on the front
  kExact,   // the smallest of its kind, proven
  kThen,    // from an earlier result
};

struct ChartPoint {
  double x = 0, y = 0;
  double x_low = 0, x_high = 0;  // the bar of spread; both are x if there is none
};

struct ChartSeries {
  std::string name;
  std::string figure, beside;  // of a line: its result and what that is compared with; may be empty
  std::optional<double>
      slope;  // of a line on log axes: the slope to compare with, drawn through its last point while it has the focus
  ChartShape shape = ChartShape::kDisc;
  ChartRim rim = ChartRim::kNone;
  ChartRole role = ChartRole::kPlain;
  bool line = false;               // whether its points are joined, in order of rising x
  bool hollow = false;             // measured on fewer points than the others, or not to be trusted
  std::vector<ChartPoint> points;  // finite; above 0 on a log axis
  std::vector<std::string> names;  // of its points, in place of their x; empty for none
  int row = -1;                    // its row in the current table, if it has one
};

/// A chart. Without series it shows its axes with a default range, and the note.
struct Chart {
  std::string title, note;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  int looks = 0;                  // how many different looks the series need; beyond kChartLooks they repeat
  std::vector<ChartPoint> front;  // the Pareto front, by rising x; empty for none
  std::optional<double> limit;    // a y that the points are compared with; none if there is none
  std::string limit_name;
};

struct ChartTick {
  double at = 0;
  std::string label;
};

/// The ticks between two ends, both included: on a log axis powers of ten, on a short one also their multiples by 2 and
/// 5, and by finer steps if those are fewer than three; otherwise equal steps of 1, 2 or 5; of degrees, steps that
/// divide a quarter turn. most: how many ticks there may be, at least 2.
[[nodiscard]] std::vector<ChartTick> chart_ticks(const ChartAxis& axis, double from, double to, int most);

/// A number with its unit: "1.5 ms", "1.24", "20,000", "35 %".
[[nodiscard]] std::string chart_figure(ChartUnit unit, double value);

/// How much larger words and marks are in a picture of that size, pixels, than on the screen: 1 at 1280x800, and so
/// much at least that words stay readable.
[[nodiscard]] float picture_scale(float width, float height);

/// A point, by the index of its series and its index in that.
struct ChartHit {
  std::size_t series = 0, point = 0;
};

/// "PCA: n^1.04, theory 1.00"
[[nodiscard]] std::string full_name(const ChartSeries& series);

/// Where a box of that size hides the fewest marks of a chart, and never the one that it is about: beside that, or in
/// the emptiest corner of the frame.
[[nodiscard]] Rect clear_place(ImVec2 size, const Rect& frame, ImVec2 about, std::span<const ImVec2> marks);

/// The place where a series' last point was drawn.
struct ChartPlace {
  float x = 0, y = 0;
};

/// Draws into the rectangle with a pen: on the screen, or into a file. focus: the point whose figures are shown; a
/// point near the pointer takes precedence. places: receives one for each series. taken: how much of the right end of
/// the title's line is not its own. Returns the point whose figures were shown.
std::optional<ChartHit> draw_chart(ChartPen& pen, const Look& look, const Rect& rect, const Chart& chart,
                                   std::optional<ChartHit> focus = {}, std::vector<ChartPlace>* places = nullptr,
                                   float taken = 0);

}  // namespace snug::app
