// Which effects a scene needs, and in which order: from what each reads and writes, and nothing else.
#pragma once

#include <span>
#include <vector>

#include "scene/effect.hpp"

namespace snug::scene {

/// An effect with its place in the frame.
struct Planned {
  const EffectKind* kind = nullptr;
  EffectCall call;  // of what came along: its name alone, with the line of what called for it
};

/// The calls and those that come along with them, in the order in which a frame runs them: what writes a slot, what
/// revises it, what reads it; and where that leaves a choice, in the order of kinds, then of calls. kinds: catalogue(),
/// but for tests. Errors, with the call's line: an unknown name, an effect twice that may stand once, one that reads
/// what nobody makes, and effects that wait for each other.
[[nodiscard]] tl::expected<std::vector<Planned>, InputError> plan(std::span<const EffectCall> calls,
                                                                  std::span<const EffectKind> kinds);

}  // namespace snug::scene
