#include "lesson/subjects/scene/scene_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fit/catalogue.hpp"
#include "fit/update/update.hpp"
#include "lesson/subjects/scene/scene_run.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kTitles{
    {{"all_pairs", "All pairs"},
     {"compared", "AABBs compared"},
     {"after_broad", "AABBs overlap"},
     {"after_loose", "Bounding spheres overlap"},
     {"touching", "Touching"},
     {"swaps", "Swaps while sorting"},
     {"slack", "Looseness"},
     {kOverHull, "Volume over the hull’s"},
     {"cost", "Points examined"},
     {"energy", "Energy"}}};

/// What a figure counts; "" if it is not a count.
std::string counted_thing(std::string_view figure, bool one) {
  if (figure == "slack" || figure == kOverHull || figure == "energy") return {};
  if (figure == "swaps") return one ? "swap" : "swaps";
  return figure == "cost" ? (one ? "point" : "points") : (one ? "pair" : "pairs");
}

/// Its unit: "pairs", "%".
std::string_view unit_of(std::string_view figure) {
  if (figure == "slack") return "%";
  if (figure == kOverHull) return "times";
  return figure == "energy" ? "kg units²/s²" : figure == "cost" ? "points" : figure == "swaps" ? "swaps" : "pairs";
}

}  // namespace

double over_hull(const fit::Volume3& volume, const AnyPointSet& points) {
  const fit::Result hull = fit::find_algorithm("hull", "quickhull")->fit(points, {});
  return fit::over_hull(fit::measure_of(volume, 3), fit::measure_of(hull.volume, 3));
}

double value_of(const FrameStep& step, std::string_view key, const AnyPointSet& points) {
  if (key == kOverHull) return over_hull(step.volume, points);
  return figure_of(*std::get_if<FrameTaken>(&step.fact), key);
}

std::string scene_figure_text(std::string_view figure, double value) {
  if (!std::isfinite(value)) return "—";
  if (figure == "slack") return looseness_text(value / 100);
  if (figure == kOverHull) return number_text(value) + " times";
  if (figure == "energy") return number_text(value) + " " + std::string(unit_of(figure));
  return count_text(std::llround(value)) + " " + counted_thing(figure, value == 1);
}

std::string looser_words(double slack, std::string_view than) {
  constexpr double kFew = 1, kMany = 99;  // above, a factor is clearer than per cent; and its tenths mean nothing
  const std::string loose = looseness_text(slack), tightest(than);
  if (slack < kFew) return without_plus(loose) + " larger than " + tightest;
  return decimal_text(1 + slack, slack < kMany ? 1 : 0) + " times " + tightest + " (" + loose + ")";
}

std::string_view scene_figure_title(std::string_view figure) {
  const auto found = std::find_if(kTitles.begin(), kTitles.end(), [&](const auto& one) { return one.first == figure; });
  return found == kTitles.end() ? figure : found->second;
}

std::string effect_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string effect_time_text(const scene::EffectTally& tally, double clock_step) {
  if (tally.run == 0) return {};
  const auto runs = static_cast<double>(tally.run);
  const double mean = tally.nanoseconds / runs / 1000, doubt = 2 * clock_step / std::sqrt(runs) / 1000;
  if (mean >= doubt) return decimal_text(mean, mean < 1 ? 2 : mean < 10 ? 1 : 0);
  const double places = std::floor(std::log10(doubt)), unit = std::pow(10, places);
  return "< " + decimal_text(std::ceil(doubt / unit) * unit, std::max(0, static_cast<int>(-places)));
}

Figure scene_figure(std::string_view key, double value) {
  return {std::string(scene_figure_title(key)),
          std::string(key),
          scene_figure_text(key, value),
          value,
          std::string(unit_of(key)),
          std::isfinite(value)};
}

std::vector<Figure> scene_figures(const FrameStep& step, const AnyPointSet& points, bool sorts) {
  const auto* frame = std::get_if<FrameTaken>(&step.fact);
  std::vector<Figure> figures{{"Frame", "frame", std::to_string(frame->frame), static_cast<double>(frame->frame), ""}};
  const auto add = [&](std::string_view key) { figures.push_back(scene_figure(key, value_of(step, key, points))); };
  if (frame->all_pairs > 0) {
    for (const std::string_view key : {"all_pairs", "compared", "after_broad", "after_loose", "touching"}) add(key);
    if (sorts) add("swaps");
  } else if (step.has_volume) {
    add("slack");
    add(kOverHull);
    add("cost");
  }
  if (frame->energy != 0) add("energy");
  return figures;
}

}  // namespace snug::lesson
