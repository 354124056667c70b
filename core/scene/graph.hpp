// The graph of a schedule's effects: from each effect that writes a slot, an edge to each that reads it.
#pragma once

#include <span>
#include <vector>

#include "scene/effect.hpp"

namespace snug::scene {

/// The edges of one slot, as a bundle: from every writer to every reader. Effects are named by their places in the
/// schedule, in rising order. One that revises the slot reads and writes it.
struct Rail {
  Slot slot = Slot::kTime;
  std::vector<int> writers;
  std::vector<int> readers;
  std::vector<int> late;  // readers of what the last frame left
  /// The place of the first writer; -1 if the scene itself has it from the start.
  [[nodiscard]] int begin() const { return writers.empty() ? -1 : writers.front(); }
  /// The first and the last place that it reaches.
  [[nodiscard]] int first() const;
  [[nodiscard]] int last() const;
};

/// A rail for each slot that any effect reads or writes, by where they begin. order: a schedule's, as of Scene::kinds.
[[nodiscard]] std::vector<Rail> rails_of(std::span<const EffectKind* const> order);

}  // namespace snug::scene
