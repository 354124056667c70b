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

}  // namespace

bool PairSubject::reaches(std::string_view goal) const {
  if (goal == "only_edges") return only_from(boxes(), kFaceAxes);
  if (goal == "last_axis") return only_from(boxes(), kLastAxis);
  return says_overlap(goal, boxes()) != overlap_exactly(goal, boxes());
}

std::string PairSubject::goal_says(std::string_view goal) const {
  const bool now = reaches(goal);
  if (goal == "only_edges")
    return now ? "No face axis separates these boxes, only an edge axis does."
               : "Still to find: boxes that only an edge axis separates.";
  if (goal == "last_axis")
    return now ? "Only the last axis, A z × B z, separates these boxes."
               : "Still to find: boxes that only the last axis, A z × B z, separates.";
  const Method& test = *find_method(box_tests(), goal);
  const std::string title =
      "“" + std::string(test.title.substr(0, test.title.find(" ("))) + "”";  // without "(wrong)", which is said below
  if (!now) return "Still to find: boxes on which " + title + " is wrong.";
  return title + " is wrong here: it says that the boxes " + (says_overlap(goal, boxes()) ? "overlap" : "are apart") +
         ".";
}

}  // namespace snug::lesson
