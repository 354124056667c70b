// The functions that a student writes: what each takes and gives, the cases that it is tried on, and what is right.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/random.hpp"

namespace snug::write {

/// What a function takes or gives, as numbers one after the other; its shape says what they are (shape.hpp).
using Numbers = std::vector<double>;

/// A kind of cases. Passing all of a kind earns one mark.
struct Kind {
  std::string_view name;  // in results: "touching"
  std::string_view says;  // after "fails on": "boxes that only touch, or almost"
};

struct Case {
  int kind = 0;  // in Function::kinds
  Numbers input;
};

/// Collects the cases of a function.
class Cases {
 public:
  explicit Cases(std::uint64_t seed) : random(seed) {}
  Random random;
  std::vector<Case> made;

  void add(int kind, Numbers input) { made.push_back({kind, std::move(input)}); }
  [[nodiscard]] bool coin() { return random.below(2) == 1; }
  /// A whole number from low to high.
  [[nodiscard]] double whole(int low, int high) {
    return low + static_cast<double>(random.below(static_cast<std::uint32_t>(high - low + 1)));
  }
};

/// The number of cases of the first kind, which is random, and of each other kind.
inline constexpr int kRandomCases = 400, kNamedCases = 40;
/// Each kind's number with the count of its cases.
template <class Make>
void each_kind(std::span<const Kind> kinds, Make&& make) {
  for (int kind = 0; kind < static_cast<int>(kinds.size()); ++kind)
    for (int i = 0; i < (kind == 0 ? kRandomCases : kNamedCases); ++i) make(kind, i);
}

struct Function {
  std::string_view id;            // "overlap-min-max"
  std::string_view name;          // in the student's code: "overlap"
  std::string_view takes, gives;  // shapes
  std::string_view stage;         // the method of a lesson whose stage shows a case: "sphere/welzl"
  std::span<const Kind> kinds;    // the random cases first
  void (*make)(Cases& cases);
  /// The right answer, from exact arithmetic or from the core's own algorithm. input: valid.
  Numbers (*right)(const Numbers& input);
  /// Whether an answer is right; null where it has to be `right`.
  bool (*accepts)(const Numbers& input, const Numbers& answer) = nullptr;
  /// Whether an input of this shape is one that the contract allows; null if each is.
  bool (*valid)(const Numbers& input) = nullptr;
};

// The rows, a file for those that are alike.
[[nodiscard]] std::span<const Function> box_functions();
[[nodiscard]] std::span<const Function> round_functions();
[[nodiscard]] std::span<const Function> turned_box_functions();
[[nodiscard]] std::span<const Function> plane_functions();
[[nodiscard]] std::span<const Function> point_functions();
[[nodiscard]] std::span<const Function> tree_functions();

[[nodiscard]] std::vector<const Function*> all_functions();
/// Null if there is none of that name.
[[nodiscard]] const Function* find_function(std::string_view id);

}  // namespace snug::write
