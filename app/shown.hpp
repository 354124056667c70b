// What the stage shows at a step, of any subject, in geometric words: the picture before it has colours. No screen is
// needed for it. What only one subject shows is added in its folder.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "lesson/session.hpp"

namespace snug::app {

using Point3 = Vector<double, 3>;

struct Shown {
  std::optional<fit::Volume3> volume;   // as it stands
  std::optional<fit::Volume3> rival;    // of slot 1, at the same share of its trace
  std::optional<fit::Volume3> optimum;  // where it is known and wanted, or at the end
  bool finished = false;

  std::vector<Index> support;  // what holds the volume, in this trace so far
  /// The handles that the step speaks of, and the one that it examines.
  std::vector<Index> spoken_of;
  Index examined = kNoIndex;

  /// The handles of a guess that was wrong, at its first try too; and those that are right, once that is told.
  std::vector<Index> guessed_wrong, right;
};

/// At the session's step, without the handles, which are the subject's to choose.
[[nodiscard]] Shown shown_at(const lesson::Session& session);

/// The last fact of a kind among steps; null where there is none.
template <class Fact, class Entry>
[[nodiscard]] const Fact* last_fact(std::span<const Entry> steps) {
  for (auto entry = steps.rbegin(); entry != steps.rend(); ++entry)
    if (const auto* fact = std::get_if<Fact>(&entry->step.fact)) return fact;
  return nullptr;
}

/// The handles that the step names: what is marked of a fact that has no picture of its own.
[[nodiscard]] std::vector<Index> named_now(const lesson::Session& session);

/// The ball that a volume is; null where it is none.
[[nodiscard]] inline const fit::Sphere3* ball_in(const std::optional<fit::Volume3>& volume) {
  return volume ? std::get_if<fit::Sphere3>(&*volume) : nullptr;
}

}  // namespace snug::app
