// What tasks on two boxes ask for: counter-examples.
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/pair.hpp"

namespace snug::lesson {
namespace {

/// Whether the boxes are apart, but no axis before `first` in the test's order separates them.
bool only_from(const BoxPair& pair, int first) {
  bool apart = false;
  for (const auto& entry : record("sat_all", pair)) {
    const auto* axis = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact);
    if (axis == nullptr || !axis->separates) continue;
    if (axis_index(pair.dim, axis->axis) < first) return false;
    apart = true;
  }
  return apart;
}

constexpr int kFaceAxes = 6, kLastAxis = 14;

bool is_wrong_test(std::string_view test, const BoxPair& pair) {
  return says_overlap(test, pair) != overlap_exactly(test, pair);
}

/// "“No epsilon”", without "(wrong)" or "(naive)".
std::string quoted_title(std::string_view test) {
  const std::string_view title = find_method(box_tests(), test)->title;
  return "“" + std::string(title.substr(0, title.find(" ("))) + "”";
}

std::string verdict_words(std::string_view test, const BoxPair& pair) {
  return std::string(says_overlap(test, pair) ? "overlap" : "are apart") +
         (is_wrong_test(test, pair) ? ", which is wrong" : ", which is right");
}

/// A naive test in both scalars, each on the boxes as it stores them. pair: in double.
struct BothScalars {
  std::string_view in_double;
  std::string in_float;
  BothScalars(std::string_view goal)  // NOLINT: of the goal alone
      : in_double(goal.substr(0, goal.size() - kInFloatAlone.size())), in_float(std::string(in_double) + "_float") {}
  [[nodiscard]] bool breaks(const BoxPair& pair) const {
    return is_wrong_test(in_float, pair) && !is_wrong_test(in_double, pair);
  }
  [[nodiscard]] std::string says(const BoxPair& pair) const {
    return quoted_title(in_double) + " says in float that the boxes " + verdict_words(in_float, pair) +
           "; in double that they " + verdict_words(in_double, pair) + ".";
  }
};

}  // namespace

bool PairSubject::reaches(std::string_view goal) const {
  if (goal == "only_edges") return only_from(boxes(), kFaceAxes);
  if (goal == "last_axis") return only_from(boxes(), kLastAxis);
  if (goal.ends_with(kInFloatAlone)) return BothScalars(goal).breaks(unrounded());
  return is_wrong_test(goal, boxes());
}

std::string PairSubject::goal_says(std::string_view goal) const {
  if (goal.ends_with(kInFloatAlone)) return BothScalars(goal).says(unrounded());
  const bool now = reaches(goal);
  if (goal == "only_edges")
    return now ? "No face axis separates these boxes, only an edge axis does."
               : "Still to find: boxes that only an edge axis separates.";
  if (goal == "last_axis")
    return now ? "Only the last axis, A z × B z, separates these boxes."
               : "Still to find: boxes that only the last axis, A z × B z, separates.";
  if (!now) return "Still to find: boxes on which " + quoted_title(goal) + " is wrong.";
  return quoted_title(goal) + " is wrong here: it says that the boxes " +
         (says_overlap(goal, boxes()) ? "overlap" : "are apart") + ".";
}

}  // namespace snug::lesson
