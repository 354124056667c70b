// Draws how the sums of a covariance grow: each product x y as the area of a rectangle, with its sign; and the table of
// all products so far, beside the stage.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "app/subjects/cloud/draw.hpp"
#include "app/subjects/cloud/products_panel.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::app {
namespace {

using Added = fit::ProductsAdded<double, 3>;

constexpr int kColumns = 6;
constexpr std::size_t kMostRows = 8;
using Row = std::array<std::string, kColumns>;

/// A number of at most five signs, for the columns are narrow: "−0.25", "12.5", "1e18".
std::string cell_text(double value) {
  const double size = std::abs(value);
  const int exponent = size >= 1000 && std::isfinite(size) ? static_cast<int>(std::floor(std::log10(size))) : 0;
  std::array<char, 32> text{};
  if (exponent > 0) std::snprintf(text.data(), text.size(), "%.0fe%d", size / std::pow(10, exponent), exponent);
  else std::snprintf(text.data(), text.size(), "%.*f", size < 9.995 ? 2 : size < 99.95 ? 1 : 0, size);
  return (value < 0 && size >= 0.005 ? "−" : "") + std::string(text.data());
}

Row row_of(const Added& fact, const std::string& name) {
  const double x = fact.offset[0], y = fact.offset[1];
  return {name, cell_text(x), cell_text(y), cell_text(x * x), cell_text(x * y), cell_text(y * y)};
}

/// The last rows of the table, and the sums.
std::vector<Row> rows_at(const lesson::Session& session) {
  std::vector<Row> rows;
  const Added* last = nullptr;
  const lesson::FitTrace steps = lesson::fit_run(session.player().run(0)).trace().first(session.player().step());
  for (const auto& entry : steps)
    if (const auto* added = std::get_if<Added>(&entry.step.fact)) {
      rows.push_back(row_of(*added, session.stage().subject().name_of(added->point)));
      last = added;
    }
  if (last == nullptr) return rows;
  if (rows.size() > kMostRows) {
    rows.erase(rows.begin(), rows.end() - kMostRows);
    rows.front() = {"…", "", "", "", "", ""};
  }
  rows.push_back({"sum", "", "", cell_text(last->sum(0, 0)), cell_text(last->sum(0, 1)), cell_text(last->sum(1, 1))});
  return rows;
}

}  // namespace

void draw_products(Brush& brush, const CloudShown& shown) {
  if (!shown.products || brush.dim() != 2) return;
  const Palette& p = brush.p;
  const Point3 from = shown.products->from, to = brush.session.stage().subject().at(shown.products->point);
  const Point3 offset = to - from;
  const double product = offset[0] * offset[1];
  const bool lowers = product < 0;
  const Color color = lowers ? p.wrong : p.current, words = lowers ? p.wrong_text : p.current_text;
  const std::array<ImVec2, 4> corners{brush.at(from), brush.at(Point3(to[0], from[1], 0)), brush.at(to),
                                      brush.at(Point3(from[0], to[1], 0))};
  brush.list->AddConvexPolyFilled(corners.data(), 4, with_alpha(color, 0.16f));
  path(brush.list, corners, true, lowers ? Stroke::kDashed : Stroke::kSolid, color, brush.stroke(0.8f));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ImVec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
  const ImVec2 middle{(corners[0].x + corners[2].x) / 2, (corners[0].y + corners[2].y) / 2};
  const std::string says = product == 0 ? "0" : (product > 0 ? "+" : "") + lesson::number_text(product);
  brush.label(middle, 2, {0, -1}, says, words);
  if (shown.mean) return;
  plus(brush.list, corners[0], 6 * p.mark, p.muted, brush.stroke(0.9f));
  brush.label(corners[0], 8, {-0.7f, 0.7f}, "origin", p.muted, Face::kRegular, 13);
}

float draw_products_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  if (session.stage().subject().dim() != 2) return 0;
  const std::vector<Row> rows = rows_at(session);
  if (rows.empty()) return 0;
  constexpr float kSize = 11, kHigh = 20;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto* first = last_fact<Added>(lesson::fit_run(session.player().run(0)).trace().first(session.player().step()));
  const bool from_mean = first->from_mean;
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted, "Products, added up");
  float y = at.y + look.px(28);
  const float first_column = look.px(28), column = (width - first_column) / (kColumns - 1);
  const Row head = from_mean ? Row{"", "dx", "dy", "xx", "xy", "yy"} : Row{"", "x", "y", "xx", "xy", "yy"};
  const auto line_of = [&](const Row& row, Face face, Color ink) {
    for (int i = 0; i < kColumns; ++i) {
      const std::string& cell = row[i];
      const float baseline = y + look.px(3);
      if (i == 0) text(list, look, face, kSize, {at.x, baseline}, ink, cell);
      else
        text_right(list, look, face, kSize, {at.x + first_column + static_cast<float>(i) * column, baseline}, ink,
                   shortened(look, face, kSize, cell, column - 1));
    }
    y += look.px(kHigh);
  };
  line_of(head, Face::kRegular, look->muted);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool sum = i + 1 == rows.size(), now = i + 2 == rows.size();
    if (sum) list->AddLine({at.x, y}, {at.x + width, y}, look->line, 1);
    line_of(rows[i], sum || now ? Face::kMonoBold : Face::kMono, sum || now ? look->ink : look->muted);
  }
  return y - at.y + look.px(8);
}

}  // namespace snug::app
