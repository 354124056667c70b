// What a student decided in an exercise, as it is handed in, kept and replayed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/exercise/exercise.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// A decision that was made, or begun: the hints that were taken, and the answers that were given, of which two are
/// a first one that was wrong and another; or the best stage that was built.
struct Made {
  int hints = 0;
  std::vector<Answer> tries;
  Rows built;
  double seconds = 0;  // when the last of them was given, since the beginning
};

struct Attempt {
  std::string exercise;    // its id
  std::uint64_t hash = 0;  // of its file
  std::uint64_t seed = 0;
  int level = 0;
  std::vector<Made> made;

  /// How many hints were taken.
  [[nodiscard]] int hints() const;
  /// When the last answer was given, since the beginning.
  [[nodiscard]] double seconds() const;
};

/// A decision in a few characters: "p8@3.4", "?c0>c2@10.1". A ? for each hint, then the tries: p a handle, c a choice
/// or the bits of several, l handles, o an order, n a number, b the numbers of what was built: "b1.5,2;3,4@61.5".
[[nodiscard]] std::string text_of(const Made& made);
/// Errors: it is no such text.
[[nodiscard]] tl::expected<Made, InputError> made_of(std::string_view text);

}  // namespace snug::lesson
