// "skipped": which effects are skipped in a frame. The choices are the effects of the scene, and none.
#include <algorithm>

#include "lesson/decide.hpp"
#include "lesson/subjects/scene/effect_words.hpp"
#include "lesson/subjects/scene/entries.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostEffects = 10;  // more choices are not read
constexpr const char* kNoEffect = "none of them";

}  // namespace

const char* offer_effects(Asked& asked, const Run& run) {
  const SceneRecording& recording = scene_run(run).recording(0);
  asked.many = true;
  for (const scene::EffectTally& tally : recording.tallies) asked.add_choice(effect_words(tally.effect));
  asked.add_choice(kNoEffect);
  return recording.tallies.size() > kMostEffects ? "the scene has more than 10 effects" : nullptr;
}

Truth skipped_truth(const Asked& asked, const Run& run) {
  const SceneRecording& recording = scene_run(run).recording(asked.fact + 1);
  Truth truth;
  std::string why;
  for (std::size_t i = 0; i < recording.tallies.size(); ++i) {
    const scene::Deed deed = deed_of(recording, asked.fact + 1, i);
    if (deed.kind != scene::Deed::Kind::kSkipped) continue;
    truth.choices.push_back(static_cast<int>(i));
    why += (why.empty() ? " " : "; ") + asked.choices[i] + " is " + deed_words(*recording.kinds[i], deed);
  }
  if (truth.choices.empty()) return {{static_cast<int>(recording.tallies.size())}, {}, kNoEffect, "Every effect runs."};
  truth.happened = choice_words(asked, truth.choices);
  const bool all = truth.choices.size() == recording.tallies.size();
  if (all) truth.happened = "all of them";
  truth.sentence = all ? "Every effect is skipped." : "Skipped: " + truth.happened + ".";
  if (truth.choices.size() == 1) truth.sentence = "Here" + why + ".";
  return truth;
}

}  // namespace snug::lesson
