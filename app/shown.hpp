// What the stage shows at a step of any subject, in geometric terms, without colours or a screen. What only one subject
// shows is added in its folder.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "lesson/session.hpp"

namespace snug::app {

using Point3 = Vector<double, 3>;

struct Shown {
  std::optional<fit::Volume3> volume;   // the current one
  std::optional<fit::Volume3> rival;    // that of slot 1, at the same fraction of its trace
  std::optional<fit::Volume3> optimum;  // if it is known and wanted, or at the end
  std::string optimum_word;             // "smallest circle"
  bool finished = false;

  std::vector<Index> support;  // what supports the volume so far
  /// The handles that the step is about, and the one that it examines.
  std::vector<Index> spoken_of;
  Index examined = kNoIndex;

  /// The handles of a wrong answer, even at the first try; and the right ones, once they are revealed.
  std::vector<Index> guessed_wrong, right;
};

/// What is shown at the session's step, without the handles, which the subject chooses.
[[nodiscard]] Shown shown_at(const lesson::Session& session);

/// The last fact of a kind among steps; null if there is none.
template <class Fact, class Entry>
[[nodiscard]] const Fact* last_fact(std::span<const Entry> steps) {
  for (auto entry = steps.rbegin(); entry != steps.rend(); ++entry)
    if (const auto* fact = std::get_if<Fact>(&entry->step.fact)) return fact;
  return nullptr;
}

/// The handles that the step names: they are marked if the fact has no picture of its own.
[[nodiscard]] std::vector<Index> named_now(const lesson::Session& session);

/// The volume as a ball; null if it is not one.
[[nodiscard]] inline const fit::Sphere3* ball_in(const std::optional<fit::Volume3>& volume) {
  return volume ? std::get_if<fit::Sphere3>(&*volume) : nullptr;
}

}  // namespace snug::app
