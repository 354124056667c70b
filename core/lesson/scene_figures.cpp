#include "lesson/scene_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "lesson/scene_runs.hpp"

namespace snug::lesson {
namespace {

std::string fixed_text(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

}  // namespace

std::string scene_figure_text(std::string_view figure, double value) {
  if (figure == "slack") return fixed_text(value, 1) + " %";
  if (figure == "energy") return number_text(value);
  const std::string count = fixed_text(value, 0);
  if (figure == "cost") return count + (value == 1 ? " point" : " points");
  return count + (value == 1 ? " pair" : " pairs");
}

std::string effect_time_text(const scene::Tally& tally, double clock_step) {
  if (tally.run == 0) return {};
  const auto runs = static_cast<double>(tally.run);
  const double mean = tally.nanoseconds / runs / 1000, doubt = 2 * clock_step / std::sqrt(runs) / 1000;
  if (mean >= doubt) return fixed_text(mean, mean < 1 ? 2 : mean < 10 ? 1 : 0);
  const double places = std::floor(std::log10(doubt)), unit = std::pow(10, places);
  return "< " + fixed_text(std::ceil(doubt / unit) * unit, std::max(0, static_cast<int>(-places)));
}

std::vector<Figure> scene_figures(const RunView& run) {
  if (run.step == 0) return {};
  const auto* frame = std::get_if<fit::FrameTaken>(&run.recording->steps[run.step - 1].step.fact);
  if (frame == nullptr) return {};
  std::vector<Figure> figures{{"Frame", "frame", std::to_string(frame->frame), static_cast<double>(frame->frame), ""}};
  const auto add = [&](const char* name, std::string_view key, const char* unit) {
    const double value = figure_of(*frame, key);
    figures.push_back({name, std::string(key), scene_figure_text(key, value), value, unit});
  };
  if (frame->all_pairs > 0) {
    add("All pairs", "all_pairs", "pairs");
    add("Boxes compared", "compared", "pairs");
    add("Boxes overlap", "after_broad", "pairs");
    add("Loose spheres overlap", "after_loose", "pairs");
    add("Touching", "touching", "pairs");
  } else {
    add("Slack of the volume", "slack", "%");
    add("Points looked at", "cost", "points");
  }
  if (frame->energy != 0) add("Energy", "energy", "");
  return figures;
}

}  // namespace snug::lesson
