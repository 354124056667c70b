#include "lesson/subjects/update/update_figures.hpp"

#include <cmath>

namespace snug::lesson {
namespace {

constexpr double kShownLooseness = 0.0005;  // less looseness is shown as 0.0 %
constexpr double kFewTimes = 1,
                 kManyTimes = 99;  // above, a factor is clearer than per cent; and its tenths mean nothing

Figure update_row(std::string name, std::string key, std::string text, double value, std::string unit, bool known) {
  known = known && std::isfinite(value);
  return {std::move(name), std::move(key), known ? std::move(text) : "—", value, std::move(unit), known};
}

}  // namespace

bool is_tight(double slack) { return slack < kShownLooseness; }

std::string looseness_words(double slack) {
  const std::string loose = looseness_text(slack);
  if (slack < kFewTimes) return "it is " + without_plus(loose) + " larger than the tightest";
  return "it is " + decimal_text(1 + slack, slack < kManyTimes ? 1 : 0) + " times the tightest (" + loose + ")";
}

std::vector<Figure> update_figures(const UpdateRun& run, int step, double degrees) {
  const fit::UpdatedFrame& frame = run.recording().frame;
  const bool done = step == run.steps();
  const bool plane = run.dim() == 2;
  const auto cost = frame.counts[static_cast<std::size_t>(Operation::kPointsTouched)];
  const double slack = fit::slack(frame.measure, frame.tightest), over = fit::over_hull(frame.measure, frame.hull);
  std::vector<Figure> figures;
  if (plane)
    figures.push_back(update_row("Rotated by", "turn", decimal_text(degrees, 1) + "°", degrees, "degrees", true));
  figures.push_back(update_row("Points examined", "cost", count_text(cost) + (cost == 1 ? " point" : " points"),
                               static_cast<double>(cost), "points", done));
  figures.push_back(update_row(plane ? "Area" : "Volume", "measure",
                               number_text(frame.measure) + (plane ? " units²" : " units³"), frame.measure,
                               plane ? "units²" : "units³", done));
  figures.push_back(update_row("Looseness", std::string(kUpdateSlack), looseness_text(slack), 100 * slack, "%", done));
  figures.push_back(update_row(plane ? "Area over the hull’s" : "Volume over the hull’s", "over_hull",
                               number_text(over) + " times", over, "times", done));
  return figures;
}

}  // namespace snug::lesson
