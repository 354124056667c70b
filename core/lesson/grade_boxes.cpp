// The grading of a task on two boxes: a counter-example is found, and then another.
#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/grade.hpp"
#include "lesson/methods.hpp"

namespace snug::lesson {
namespace {

/// Apart, and along no axis before that one in the test's order.
bool only_from(const BoxPair& pair, int first) {
  bool apart = false;
  for (const auto& entry : record(*find_method(kBoxPair, "sat_all"), pair).steps) {
    const auto* axis = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact);
    if (axis == nullptr || !axis->separates) continue;
    if (axis_index(pair.dim, axis->axis) < first) return false;
    apart = true;
  }
  return apart;
}

constexpr int kFaceAxes = 6, kLastAxis = 14;

std::string verdict(bool overlap) { return overlap ? "overlap" : "are apart"; }

/// The wrong test calls the box outside, and it is not.
bool loses_box(const BoxPair& pair) {
  return says_of_box(*find_method(kFrustumBox, "corners_outside"), pair) == query::Culling::kOutside &&
         share_a_point(pair).value_or(false);
}

std::string frustum_sentence(const BoxPair& pair, bool now, bool found) {
  if (now) return "This box is lost: the wrong test says outside, yet the box reaches into the frustum.";
  if (found) return "A box that is lost: found.";
  if (says_of_box(*find_method(kFrustumBox, "corners_outside"), pair) != query::Culling::kOutside)
    return "The wrong test keeps this box: a vertex of it lies in the frustum.";
  return "The wrong test says outside, and it is right here: the box does not touch the frustum.";
}

std::string sentence(std::string_view goal, const BoxPair& pair, bool now, bool found) {
  if (has_frustum(pair)) return frustum_sentence(pair, now, found);
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
  const fit::Algorithm& test = *find_method(kBoxPair, goal);
  const std::string title =
      "“" + std::string(test.title.substr(0, test.title.find(" ("))) + "”";  // that it is wrong is to be said
  if (now) return title + " is wrong here: it says that the boxes " + verdict(says_overlap(test, pair)) + ".";
  return found ? title + ": found." : "Still to find: a place where " + title + " is wrong.";
}

}  // namespace

bool reaches(std::string_view goal, const BoxPair& pair) {
  if (has_frustum(pair)) return loses_box(pair);
  if (goal == "only_edges") return only_from(pair, kFaceAxes);
  if (goal == "last_axis") return only_from(pair, kLastAxis);
  return says_overlap(*find_method(kBoxPair, goal), pair) != says_overlap(*find_method(kBoxPair, "sat"), pair);
}

Grade grade_boxes(const Task& task, const BoxPair& pair, std::vector<bool>& found) {
  found.resize(task.goals.size());
  Grade grade;
  grade.done = true;
  for (std::size_t i = 0; i < task.goals.size(); ++i) {
    const bool now = reaches(task.goals[i], pair);
    found[i] = found[i] || now;
    grade.done = grade.done && found[i];
    grade.points += found[i] ? 1 : 0;
    grade.says += (grade.says.empty() ? "" : " ") + sentence(task.goals[i], pair, now, found[i]);
  }
  if (grade.done) grade.says += " Done.";
  return grade;
}

}  // namespace snug::lesson
