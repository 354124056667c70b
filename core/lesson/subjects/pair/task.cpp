// Tasks on two boxes: the student finds counter-examples, one after the other.
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

std::string sentence(std::string_view goal, const BoxPair& pair, bool now, bool found) {
  if (goal == "only_edges") {
    if (now) return "No face axis separates these boxes, only an edge axis does.";
    return found ? "Boxes that only an edge axis separates: found."
                 : "Still to find: boxes that only an edge axis separates.";
  }
  if (goal == "last_axis") {
    if (now) return "Only the last axis, A z × B z, separates these boxes.";
    return found ? "Boxes that only the last axis separates: found."
                 : "Still to find: boxes that only the last axis, A z × B z, separates.";
  }
  const Method& test = *find_method(box_tests(), goal);
  const std::string title =
      "“" + std::string(test.title.substr(0, test.title.find(" ("))) + "”";  // without "(wrong)", which is said below
  if (now)
    return title + " is wrong here: it says that the boxes " + (says_overlap(goal, pair) ? "overlap" : "are apart") +
           ".";
  return found ? title + ": found." : "Still to find: boxes on which " + title + " is wrong.";
}

bool reaches(std::string_view goal, const BoxPair& pair) {
  if (goal == "only_edges") return only_from(pair, kFaceAxes);
  if (goal == "last_axis") return only_from(pair, kLastAxis);
  return says_overlap(goal, pair) != says_overlap("sat", pair);
}

}  // namespace

const BoxGoals kReachPairGoals{&reaches, &sentence};

}  // namespace snug::lesson
