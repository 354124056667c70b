#include "desktop/cli/exercise_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>

#include "desktop/cli/words.hpp"
#include "lesson/prose_figures.hpp"
#include "query/support_function.hpp"

namespace snug::desktop {
namespace {

using lesson::Point3;

// Millimetres on A4.
constexpr double kMargin = 20, kPageWidth = 210, kPageHeight = 297, kMostFigure = 120, kLeastFigure = 60, kLine = 5.2,
                 kBetween = 1.5;
constexpr std::size_t kLetters = 92;  // on a line of text
constexpr int kDirections = 180;      // of the points on a volume's outline

/// "12.34"
std::string mm(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

class Page {
 public:
  void text(double x, double y, std::string_view words, double size = 3.9, const char* more = "") {
    svg_ += "<text x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" font-size=\"" + mm(size) + "\" " + more + '>' +
            xml_text(std::string(words)) + "</text>\n";
  }
  void line(double x1, double y1, double x2, double y2) {
    svg_ += "<path d=\"M" + mm(x1) + ' ' + mm(y1) + 'L' + mm(x2) + ' ' + mm(y2) +
            "\" stroke=\"#777\" stroke-width=\".2\"/>\n";
  }
  void polygon(const std::vector<std::array<double, 2>>& corners, bool dashed) {
    svg_ += "<path d=\"";
    for (std::size_t i = 0; i < corners.size(); ++i)
      svg_ += (i == 0 ? "M" : "L") + mm(corners[i][0]) + ' ' + mm(corners[i][1]);
    svg_ += std::string("Z\" fill=\"none\" stroke=\"#000\" stroke-width=\".35\"") +
            (dashed ? " stroke-dasharray=\"2 1\"" : "") + "/>\n";
  }
  void dot(double x, double y) { svg_ += "<circle cx=\"" + mm(x) + "\" cy=\"" + mm(y) + "\" r=\".8\"/>\n"; }
  /// A square beside each choice, to be marked or numbered. Returns where the next line would be.
  double choices(double x, double y, std::span<const std::string> all) {
    constexpr double kSquare = 3.4, kLetter = 1.95, kGap = 6;
    double at = x;
    for (const std::string& choice : all) {
      const double width = kSquare + 2 + kLetter * static_cast<double>(choice.size());
      if (at > x && at + width > kPageWidth - kMargin) at = x, y += kLine;
      polygon({{{at, y - kSquare + .4}, {at + kSquare, y - kSquare + .4}, {at + kSquare, y + .4}, {at, y + .4}}},
              false);
      text(at + kSquare + 2, y, choice);
      at += width + kGap;
    }
    return y + kLine;
  }
  /// Breaks words into lines. Returns where the next line would be.
  double paragraph(double x, double y, std::string_view words, const char* more = "") {
    while (!words.empty()) {
      std::size_t end = words.size() <= kLetters ? words.size() : words.rfind(' ', kLetters);
      if (end == std::string_view::npos) end = kLetters;
      text(x, y, words.substr(0, end), 3.9, more);
      words.remove_prefix(std::min(end + 1, words.size()));
      y += kLine;
    }
    return y;
  }
  [[nodiscard]] std::string finished() const {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\" "
           "font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<rect width=\"210\" height=\"297\" "
           "fill=\"#fff\"/>\n" +
           svg_ + "</svg>\n";
  }

 private:
  std::string svg_;
};

using Outline = std::vector<Point3>;

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

/// What is drawn: outlines, of which the dashed ones are the frustum's, and named points and sides.
struct Figure {
  std::vector<Outline> solid, dashed;
  std::vector<std::pair<std::string, Point3>> points, sides;
  Point3 least = Point3::Constant(1e300), greatest = Point3::Constant(-1e300);
  void hold(const Point3& p) { least = least.cwiseMin(p), greatest = greatest.cwiseMax(p); }
};

/// What the questions call a frustum's planes, in their order: each is asked about as it is tested.
std::vector<std::string> planes_asked(const lesson::Session& session) {
  std::vector<std::string> names;
  for (const lesson::Asked& asked : session.questions())
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

tl::expected<Figure, InputError> figure_of(const lesson::Session& session) {
  Figure figure;
  const lesson::Subject& subject = session.subject();
  if (subject.dim() == 3) return tl::unexpected(InputError{.what = "it is in space, and paper is flat"});
  for (const fit::Volume3& volume : subject.volumes()) figure.solid.push_back(outline_of(volume));
  const auto things = subject.things();
  if (!subject.planes().empty()) {
    figure.dashed.push_back(ring_of(subject, things.back()));
    figure.sides = sides_of(subject.planes(), figure.dashed.back(), planes_asked(session));
  }
  if (figure.solid.empty() && subject.points() == nullptr)
    for (const auto& handles : things)
      if (things.size() > 1) figure.solid.push_back(ring_of(subject, handles));
  if (figure.solid.empty() && subject.points() == nullptr)
    return tl::unexpected(InputError{.what = "what stands on its stage is not drawn on paper yet"});
  for (Index i = 0; i < subject.size(); ++i) {
    const std::string name = subject.name_of(i);
    const bool corner = name.find("turn") == std::string::npos && name.find(' ') == std::string::npos;
    if (corner) figure.points.emplace_back(name, subject.at(i));
  }
  for (const auto* outlines : {&figure.solid, &figure.dashed})
    for (const Outline& outline : *outlines)
      for (const Point3& p : outline) figure.hold(p);
  for (const auto& [name, p] : figure.points) figure.hold(p);
  return figure;
}

void draw(Page& page, const Figure& figure, double top, double room) {
  const Point3 size = figure.greatest - figure.least;
  const double width = kPageWidth - 2 * kMargin - 16, height = room - 12;
  const double scale = std::min(width / std::max(size[0], 1e-9), height / std::max(size[1], 1e-9));
  const Point3 middle = (figure.greatest + figure.least) / 2;
  const auto place = [&](const Point3& p) {
    return std::array{kPageWidth / 2 + (p[0] - middle[0]) * scale, top + room / 2 - (p[1] - middle[1]) * scale};
  };
  for (const auto* outlines : {&figure.solid, &figure.dashed})
    for (const Outline& outline : *outlines) {
      std::vector<std::array<double, 2>> corners;
      for (const Point3& p : outline) corners.push_back(place(p));
      page.polygon(corners, outlines == &figure.dashed);
    }
  for (const auto& [name, p] : figure.sides) {
    const auto [x, y] = place(p);
    page.text(x + 2, y - 1.2, name, 3.6, "font-style=\"italic\"");
  }
  for (const auto& [name, p] : figure.points) {
    const auto [x, y] = place(p);
    page.dot(x, y);
    page.text(x + 1.4, y - 1.2, name, 3.2);
  }
}

}  // namespace

tl::expected<std::string, InputError> sheet_of(const lesson::Exercise& exercise, const lesson::Session& session,
                                               std::uint64_t seed, bool solved) {
  if (exercise.build)
    return tl::unexpected(InputError{.what = exercise.id + ": what is built takes a stage that answers, and no paper"});
  const auto figure = figure_of(session);
  if (!figure) return tl::unexpected(InputError{.what = exercise.id + ": " + figure.error().what});
  Page page;
  page.text(kMargin, kMargin + 4, exercise.stage.title, 6.5, "font-weight=\"600\"");
  page.text(kPageWidth - kMargin, kMargin + 4, "Instance " + std::to_string(seed), 3.9, "text-anchor=\"end\"");
  double y = page.paragraph(kMargin, kMargin + 12, exercise.stage.summary);
  if (solved) page.text(kMargin, y, "Solution", 3.9, "font-weight=\"600\"");
  else page.text(kMargin, y, "Name: ________________________________", 3.9);
  y += 4;
  lesson::ProseFigures figures(session);
  double below = 6;  // the figure leaves room for the questions
  for (const lesson::Asked& asked : session.questions())
    below += kLine * (static_cast<double>(plain_now(asked.prompt, figures).size() / kLetters) + 2) + kBetween;
  const double room = std::clamp(kPageHeight - kMargin / 2 - y - below, kLeastFigure, kMostFigure);
  draw(page, *figure, y, room);
  y += room + 6;
  int number = 0;
  for (const lesson::Asked& asked : session.questions()) {
    y = page.paragraph(kMargin, y, std::to_string(++number) + ". " + plain_now(asked.prompt, figures));
    const lesson::Truth truth = asked.asking->truth(asked, session.run(0));
    if (solved) y = page.paragraph(kMargin + 6, y, truth.happened + ". " + truth.sentence, "font-style=\"italic\"");
    else if (!asked.choices.empty() && !asked.on_stage) y = page.choices(kMargin + 6, y, asked.choices);
    else page.line(kMargin + 6, y + 1, kPageWidth - kMargin, y + 1), y += kLine;
    y += kBetween;
  }
  return page.finished();
}

}  // namespace snug::desktop
