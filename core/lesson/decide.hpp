// What decisions of exercises share: how far what is right is ahead, and what a wrong rule picks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lesson/ask.hpp"

namespace snug::lesson {

/// The length of the diagonal of the box around all handles, scene units; 1 if they are all in one place.
[[nodiscard]] double extent_of(const Subject& subject);

/// The margin of what no other answer comes near to: lines in their order, a number within its tolerance.
[[nodiscard]] double no_tie(const Asked& asked, const Run& run);

/// A value for each handle or choice, of which the greatest is right.
struct Scores {
  std::vector<int> of;  // handles or choices
  std::vector<double> values;
  void add(int one, double value) { of.push_back(one), values.push_back(value); }
  [[nodiscard]] int greatest() const;
  [[nodiscard]] int least() const;
  /// All that are tied for the greatest.
  [[nodiscard]] std::vector<int> all_greatest() const;
  /// How far the greatest is ahead of the next; infinity if there is no other.
  [[nodiscard]] double lead() const;
};

[[nodiscard]] inline Answer by_handle(int handle) { return OneHandle{handle}; }
[[nodiscard]] inline Answer by_choice(int choice) { return OneChoice{choice}; }
/// All choices.
[[nodiscard]] SeveralChoices by_every_choice(const Asked& asked);
/// "x, y": the words of some choices.
[[nodiscard]] std::string choice_words(const Asked& asked, const std::vector<int>& choices);
/// Several handles, each once.
[[nodiscard]] SeveralHandles by_handles(std::vector<Index> handles);

}  // namespace snug::lesson
