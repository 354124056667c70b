#include "desktop/cli/sheet_figure.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "desktop/cli/words.hpp"
#include "fit/catalogue.hpp"
#include "lesson/figures.hpp"
#include "lesson/point_subject.hpp"
#include "query/distance/support_function.hpp"

namespace snug::desktop {
namespace {

using lesson::Point3;

constexpr int kDirections = 180;  // of the points on a volume's outline
constexpr std::size_t kCornersInSpace = 8;
constexpr double kTurned = 0.5, kTilted = 0.35;  // of what is seen in space, radians
constexpr double kSmall = 3;                     // the size of numbers

/// Whether a handle is a place, and no knob that something is turned by.
bool is_place(const lesson::Subject& subject, Index i) { return subject.name_of(i).find(' ') == std::string::npos; }

/// "−0.120"
std::string coordinate(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f", std::abs(value));
  return (value <= -0.0005 ? "−" : "") + std::string(text.data());
}

/// Corners in the order of their angles about their middle.
Outline ring_about_middle(Outline ring) {
  Point3 middle = Point3::Zero();
  for (const Point3& corner : ring) middle += corner / static_cast<double>(ring.size());
  const auto angle = [&](const Point3& p) { return std::atan2(p[1] - middle[1], p[0] - middle[0]); };
  std::sort(ring.begin(), ring.end(), [&](const Point3& a, const Point3& b) { return angle(a) < angle(b); });
  return ring;
}

Outline ring_of(const lesson::Subject& subject, const std::vector<Index>& handles) {
  Outline ring;
  for (const Index i : handles) ring.push_back(subject.at(i));
  return ring_about_middle(std::move(ring));
}

Outline outline_of(const fit::Volume3& volume) {
  Outline outline;
  if (const auto* kdop = std::get_if<Kdop<double, 3>>(&volume)) {
    Kdop<double, 2> flat;
    flat.k = kdop->k;
    std::copy_n(kdop->min.begin(), flat.min.size(), flat.min.begin());
    std::copy_n(kdop->max.begin(), flat.max.size(), flat.max.begin());
    for (const Vector<double, 2>& corner : kdop_vertices(flat)) outline.emplace_back(corner[0], corner[1], 0);
    return ring_about_middle(std::move(outline));
  }
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * i / kDirections;
    const Point3 along(std::cos(angle), std::sin(angle), 0);
    outline.push_back(std::visit([&](const auto& kind) { return Point3(query::support(kind, along)); }, volume));
  }
  return outline;
}

/// The corners of a box or a frustum in space, of which one bit each says the side along an axis.
void add_edges(SheetFigure& figure, const lesson::Subject& subject, const std::vector<Index>& corners) {
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = a + 1; b < corners.size(); ++b)
      if (std::popcount(a ^ b) == 1) figure.edges.push_back({subject.at(corners[a]), subject.at(corners[b])});
}

/// What the questions call a frustum's planes, in their order: each is asked about as it is tested.
std::vector<std::string> planes_asked(const lesson::Session& session) {
  std::vector<std::string> names;
  for (const lesson::Asked& asked : session.conversation().questions())
    if (asked.question->gate.fact == "plane_tested" && (names.empty() || names.back() != asked.of))
      names.push_back(asked.of);
  return names;
}

/// The names of planes, each in the middle of the side that lies in it.
std::vector<std::pair<std::string, Point3>> sides_of(const lesson::Rows& planes, const Outline& ring,
                                                     const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, Point3>> sides;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point3 middle = (ring[i] + ring[(i + 1) % ring.size()]) / 2;
    const auto off = [&](const auto& row) { return std::abs(row[0] * middle[0] + row[1] * middle[1] + row[2]); };
    const auto nearest =
        std::min_element(planes.begin(), planes.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
    const auto plane = static_cast<std::size_t>(nearest - planes.begin());
    if (plane < names.size()) sides.emplace_back(names[plane], middle);
  }
  return sides;
}

bool has_fact(const lesson::Session& session, std::string_view fact) {
  const lesson::Run& run = session.player().run(0);
  for (int i = 0; i < run.steps(); ++i)
    if (run.fact(i) == fact) return true;
  return false;
}

/// The main axis through the mean, of which a run along it begins.
Outline main_axis(const std::vector<Point3>& points) {
  const auto n = static_cast<double>(points.size());
  Point3 mean = Point3::Zero();
  for (const Point3& p : points) mean += p / n;
  double xx = 0, xy = 0, yy = 0, reach = 0;
  for (const Point3& p : points) {
    const Point3 d = p - mean;
    xx += d[0] * d[0], xy += d[0] * d[1], yy += d[1] * d[1], reach = std::max(reach, d.norm());
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  const Point3 along = reach * Point3(std::cos(angle), std::sin(angle), 0);
  return {mean - along, mean + along};
}

/// What a run on points goes by, which the student sees on the stage: their hull, or their main axis.
void add_given(SheetFigure& figure, const lesson::Session& session) {
  const lesson::Subject& subject = session.stage().subject();
  if (subject.points() == nullptr || figure.dim != 2) return;
  std::vector<Point3> points;
  for (Index i = 0; i < fit::count_of(*subject.points()); ++i) points.push_back(subject.at(i));
  if (has_fact(session, "pair_chosen") && has_fact(session, "axes_found")) figure.dashed.push_back(main_axis(points));
  if (!has_fact(session, "neighbors_compared") && !has_fact(session, "box_tried")) return;
  const auto set = lesson::to_set(points, 2);
  if (set) figure.solid.push_back(outline_of(fit::find_algorithm("hull", "quickhull")->fit(*set, {}).volume));
}

/// The longest of 1, 2, 5, 10 … that is no longer than that.
double round_step(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return power * (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1);
}

struct Placed {
  double scale = 1;
  Point3 middle = Point3::Zero();
  double y = 0;  // of the middle on the page
  [[nodiscard]] std::array<double, 2> operator()(const Point3& p) const {
    return {kPageWidth / 2 + (p[0] - middle[0]) * scale, y - (p[1] - middle[1]) * scale};
  }
};

Point3 seen(const SheetFigure& figure, const Point3& p) {
  if (figure.dim == 2) return p;
  const double right = std::cos(kTurned) * p[0] - std::sin(kTurned) * p[2];
  const double back = std::sin(kTurned) * p[0] + std::cos(kTurned) * p[2];
  return {right, std::cos(kTilted) * p[1] - std::sin(kTilted) * back, 0};
}

/// Squared paper with the coordinates at its border.
void draw_squares(SheetPage& page, const Placed& place, double width, double height) {
  constexpr double kSquares = 12, kNumber = 2.6;
  const double step = round_step(width / place.scale / kSquares);
  const auto lines = [&](int axis, double half, double other) {
    const double from = place.middle[axis] - half / place.scale, to = place.middle[axis] + half / place.scale;
    for (double at = std::ceil(from / step) * step; at <= to; at += step) {
      Point3 p = place.middle;
      p[axis] = at;
      const auto [x, y] = place(p);
      if (axis == 0) page.line(x, place.y - other, x, place.y + other, "#ccc");
      else page.line(kPageWidth / 2 - other, y, kPageWidth / 2 + other, y, "#ccc");
      const std::string number = lesson::plain_number(std::abs(at) < step / 2 ? 0 : at);
      if (axis == 0) page.text(x, place.y + other + 3, number, kNumber, "text-anchor=\"middle\" fill=\"#555\"");
      else page.text(kPageWidth / 2 - other - 1, y + 0.9, number, kNumber, "text-anchor=\"end\" fill=\"#555\"");
    }
  };
  lines(0, width / 2, height / 2), lines(1, height / 2, width / 2);
}

/// The axes of space, at the side.
void draw_tripod(SheetPage& page, const SheetFigure& figure, double y) {
  constexpr double kLength = 9;
  const double x = kMargin + kLength;
  for (int axis = 0; axis < 3; ++axis) {
    const Point3 to = kLength * seen(figure, Point3::Unit(axis));
    page.line(x, y, x + to[0], y - to[1]);
    page.text(x + 1.2 * to[0] - 1, y - 1.2 * to[1] + 1, std::string(1, "xyz"[axis]), kSmall);
  }
}

std::string point_text(const Point3& p, int dim) {
  std::string text = "(" + coordinate(p[0]) + ", " + coordinate(p[1]);
  return text + (dim == 3 ? ", " + coordinate(p[2]) : "") + ")";
}

std::string lower(std::string_view words) {
  std::string text(words);
  if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

std::string group_text(const lesson::NumberGroup& group) {
  std::string text(group.heading);
  for (const lesson::NumberRow& row : group.rows) {
    text += (&row == &group.rows.front() ? ": " : "; ") + lower(row.words) + (row.values.size() > 1 ? " (" : " ");
    for (std::size_t i = 0; i < row.values.size(); ++i) text += (i == 0 ? "" : ", ") + coordinate(row.values[i]);
    text += (row.values.size() > 1 ? ")" : "") + (row.unit.empty() ? "" : " " + std::string(row.unit));
  }
  return text;
}

}  // namespace

tl::expected<SheetFigure, InputError> figure_of(const lesson::Session& session) {
  SheetFigure figure;
  const lesson::Subject& subject = session.stage().subject();
  figure.dim = subject.dim();
  const auto things = subject.things();
  const bool points = subject.points() != nullptr;
  if (figure.dim == 3) {
    for (const auto& corners : things)
      if (corners.size() == kCornersInSpace && !points) add_edges(figure, subject, corners);
    if (figure.edges.empty() && !points)
      return tl::unexpected(InputError{.what = "what stands on its stage in space is not drawn on paper"});
  } else {
    if (const lesson::HasVolumes* const own = subject.with_volumes()) {
      for (const fit::Volume3& volume : own->on_paper()) figure.solid.push_back(outline_of(volume));
      if (const lesson::Rows planes = own->planes(); !planes.empty()) {
        figure.dashed.push_back(ring_of(subject, things.back()));
        figure.sides = sides_of(planes, figure.dashed.back(), planes_asked(session));
      }
    }
    if (figure.solid.empty() && !points)
      for (const auto& handles : things)
        if (things.size() > 1) figure.solid.push_back(ring_of(subject, handles));
    if (figure.solid.empty() && !points)
      return tl::unexpected(InputError{.what = "what stands on its stage is not drawn on paper"});
    add_given(figure, session);
  }
  for (Index i = 0; i < subject.size(); ++i) {
    if (is_place(subject, i)) figure.points.emplace_back(subject.name_of(i), subject.at(i));
  }
  return figure;
}

void draw(SheetPage& page, const SheetFigure& figure, double top, double room, double around) {
  Point3 least = Point3::Constant(1e300), greatest = -least;
  const auto hold = [&](const Point3& p) {
    least = least.cwiseMin(seen(figure, p)), greatest = greatest.cwiseMax(seen(figure, p));
  };
  for (const auto* outlines : {&figure.solid, &figure.dashed})
    for (const Outline& outline : *outlines) std::for_each(outline.begin(), outline.end(), hold);
  for (const auto& edge : figure.edges) std::for_each(edge.begin(), edge.end(), hold);
  for (const auto& [name, p] : figure.points) hold(p);
  const double width = kPageWidth - 2 * kMargin - 10, height = room - 8, inner = 10;
  const Point3 size = around * (greatest - least);
  const Placed place{std::min((width - inner) / std::max(size[0], 1e-9), (height - inner) / std::max(size[1], 1e-9)),
                     (greatest + least) / 2, top + height / 2};
  if (figure.dim == 2) draw_squares(page, place, width, height);
  else draw_tripod(page, figure, top + height - 4);
  const auto at = [&](const Point3& p) { return place(seen(figure, p)); };
  for (const auto* outlines : {&figure.solid, &figure.dashed})
    for (const Outline& outline : *outlines) {
      std::vector<std::array<double, 2>> corners;
      for (const Point3& p : outline) corners.push_back(at(p));
      page.polygon(corners, outlines == &figure.dashed);
    }
  for (const auto& [a, b] : figure.edges) page.polygon({at(a), at(b)}, false);
  for (const auto& [name, p] : figure.sides) {
    const auto [x, y] = at(p);
    page.text(x + 2, y - 1.2, name, 3.6, "font-style=\"italic\"");
  }
  for (const auto& [name, p] : figure.points) {
    const auto [x, y] = at(p);
    page.dot(x, y);
    page.text(x + 1.4, y - 1.2, name, kSmall);
  }
}

std::vector<std::string> numbers_of(const lesson::Session& session) {
  std::vector<std::string> all;
  const lesson::Subject& subject = session.stage().subject();
  if (subject.dim() == 2)
    for (const lesson::NumberGroup& group : subject.numbers()) all.push_back(group_text(group));
  if (!all.empty()) return all;
  for (Index i = 0; i < subject.size(); ++i)
    if (is_place(subject, i)) all.push_back(subject.name_of(i) + ' ' + point_text(subject.at(i), subject.dim()));
  return all;
}

double columns(SheetPage& page, double y, const std::vector<std::string>& texts) {
  constexpr double kLetter = 1.45, kRow = 4.2, kWidth = kPageWidth - 2 * kMargin;
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, letters_of(text));
  const auto side_by_side =
      std::max<std::size_t>(static_cast<std::size_t>(kWidth / (kLetter * static_cast<double>(longest) + 3)), 1);
  const std::size_t rows = (texts.size() + side_by_side - 1) / side_by_side;
  for (std::size_t i = 0; i < texts.size(); ++i)
    page.text(kMargin + static_cast<double>(i / rows) * kWidth / static_cast<double>(side_by_side),
              y + static_cast<double>(i % rows) * kRow, texts[i], kSmall);
  return y + static_cast<double>(rows) * kRow;
}

}  // namespace snug::desktop
