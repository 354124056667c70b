// What the effects of a scene did in a frame, in words.
#pragma once

#include <string>

#include "lesson/subjects/scene/scene_run.hpp"

namespace snug::lesson {

/// The name of a call as students see it, which is that of its tally: "path crane".
[[nodiscard]] std::string name_of(const scene::EffectCall& call);

/// "poses and contacts"; empty for none.
[[nodiscard]] std::string slot_words(scene::SlotSet slots);

/// What an effect did, and why: "runs: new poses", "skipped: its inputs are unchanged".
[[nodiscard]] std::string deed_words(const scene::EffectKind& kind, const scene::Deed& deed);

/// What an effect did in a frame. frame: 0 for the start, when none has run yet.
[[nodiscard]] scene::Deed deed_of(const SceneRecording& run, int frame, std::size_t effect);

/// How many effects run in a frame, how many are skipped, and how many bodies are awake: "6 of 8 effects run; 1 of 8
/// bodies is awake."
[[nodiscard]] std::string counts_words(const SceneRecording& run, int frame);

}  // namespace snug::lesson
