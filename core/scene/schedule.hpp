// Decides which effects a scene needs, and their order, only from what each reads and writes.
#pragma once

#include <span>
#include <vector>

#include "scene/effect.hpp"

namespace snug::scene {

/// An effect in the order of the frame.
struct Planned {
  const EffectKind* kind = nullptr;
  EffectCall call;  // for an added effect: only its name, with the line of the call that added it
};

/// The called effects and those added with them, in the order in which a frame runs them: those that write a slot, that
/// revise it, that read it. Where that leaves a choice, the order is that of kinds, then of calls. kinds: catalogue(),
/// except in tests. Errors, with the call's line: an unknown name, a repeated effect that may occur only once, an
/// effect that reads what no effect writes, and effects that wait for each other.
[[nodiscard]] tl::expected<std::vector<Planned>, InputError> plan(std::span<const EffectCall> calls,
                                                                  std::span<const EffectKind> kinds);

/// The called effects of these kinds and those added with them, in the order of kinds.
[[nodiscard]] std::vector<Planned> known_calls(std::span<const EffectCall> calls, std::span<const EffectKind> kinds);
/// All that is wrong with the calls: each unknown or repeated one; without any, each that reads what no effect writes.
[[nodiscard]] std::vector<InputError> plan_faults(std::span<const EffectCall> calls, std::span<const EffectKind> kinds);

/// What an effect reads that neither the scene has from the start nor any of the called effects writes.
[[nodiscard]] SlotSet missing_for(const EffectKind& kind, std::span<const EffectCall> calls,
                                  std::span<const EffectKind> kinds);

}  // namespace snug::scene
