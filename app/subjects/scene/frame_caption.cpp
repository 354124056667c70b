#include "app/subjects/scene/frame_caption.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lesson/scene_figures.hpp"

namespace snug::app {
namespace {

/// Where an effect that makes the figures is off: which of them are still those of an earlier frame.
std::string still_words(const lesson::Session& session, bool pairs) {
  const std::array<std::pair<const char*, const char*>, 3> makers{
      {{"refit", pairs ? "the AABBs are still those" : "the volume is still that"},
       {"broad_phase", "the pairs are still those"},
       {"narrow_phase", "the touching pairs are still those"}}};
  for (const auto& [effect, what] : makers)
    if (const int since = session.off_since(effect); since >= 0)
      return effect_words(effect) + " is off, so " + what + " of frame " + std::to_string(since) + ".";
  return {};
}

/// "the update examines 80 points; the volume is 35.0 % larger than the tightest AABB, and 3.421 times the hull’s."
std::string update_words(const fit::FrameTaken& fact, double over_hull, bool slack, bool cost) {
  constexpr double kShown = 0.0005;  // what is less is 0.0 %
  std::string words;
  if (cost)
    words += "the update examines " + (fact.cost == 0 ? "no point" : lesson::scene_figure_text("cost", fact.cost));
  if (!slack) return words + ".";
  if (cost) words += "; ";
  if (!std::isfinite(over_hull)) return words + "all points lie in one plane, so the hull has no volume.";
  words += "the volume is ";
  if (fact.slack >= kShown)
    words += lesson::scene_figure_text("slack", 100 * fact.slack) + " larger than the tightest of its kind, and ";
  return words + lesson::scene_figure_text(lesson::kOverHull, over_hull) + " the hull’s.";
}

}  // namespace

std::string effect_words(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

std::string frame_caption(const fit::FrameTaken& fact, const lesson::Session* session) {
  const auto hidden = [&](std::string_view figure) { return session != nullptr && session->is_hidden(figure); };
  std::string words = "Frame " + std::to_string(fact.frame) + ": ";
  const bool slack = !hidden("slack"), cost = !hidden("cost");
  // Beside a question the sentence would tell nearly what is asked of a later frame.
  const bool asked = session != nullptr && !session->asked_figure().empty();
  if (asked || (fact.all_pairs == 0 && !slack && !cost)) return words + "predict what comes next.";
  if (const std::string still = session != nullptr ? still_words(*session, fact.all_pairs > 0) : ""; !still.empty())
    return words + still;
  if (fact.resting) return words + "all bodies are at rest, so no effect runs.";
  const auto count = [](double n) { return std::to_string(static_cast<long long>(n)); };
  if (fact.all_pairs == 0) {
    const fit::Step3* step = session != nullptr ? &session->current(0)->step : nullptr;
    return step == nullptr || !step->has_volume
               ? words + "the bodies have moved."  // no volume is measured
               : words + update_words(fact, lesson::over_hull(step->volume, session->points()), slack, cost);
  }
  words += "of " + count(fact.all_pairs) + (fact.all_pairs == 1 ? " pair" : " pairs");
  if (hidden("after_broad")) return words + ", how many do the AABBs leave?";
  words += ", the AABBs leave " + count(fact.after_broad);
  if (hidden("after_loose")) return words + ".";
  words += " and the bounding spheres " + count(fact.after_loose);
  return words +
         (hidden("touching") ? "." : "; " + count(fact.touching) + (fact.touching == 1 ? " touches." : " touch."));
}

}  // namespace snug::app
