// The grading of a task on two boxes: a counter-example is found, and then another.
#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/grade.hpp"
#include "lesson/methods.hpp"

namespace snug::lesson {
namespace {

/// Apart along the product of two edges, and along no face's normal.
bool only_edges(const BoxPair& pair) {
  bool edges = false;
  for (const auto& entry : record(*find_method(kBoxPair, "sat_all"), pair).steps) {
    const auto* axis = std::get_if<query::AxisTested<double, 3>>(&entry.step.fact);
    if (axis == nullptr || !axis->separates) continue;
    if (axis->axis.kind != query::AxisKind::kEdgeEdge) return false;
    edges = true;
  }
  return edges;
}

std::string verdict(bool overlap) { return overlap ? "overlap" : "are apart"; }

/// The wrong test calls the box outside, and it is not.
bool loses_box(const BoxPair& pair) {
  return says_of_box(*find_method(kFrustumBox, "corners_outside"), pair) == query::Culling::kOutside &&
         share_a_point(pair).value_or(false);
}

std::string frustum_sentence(const BoxPair& pair, bool now, bool found) {
  if (now) return "This box is lost: “all corners outside” says outside, and it reaches into the frustum.";
  if (found) return "A box that is lost: found.";
  if (says_of_box(*find_method(kFrustumBox, "corners_outside"), pair) != query::Culling::kOutside)
    return "The wrong test keeps this box: a corner of it is inside the frustum.";
  return "The wrong test says outside, and is right here: the box does not touch the frustum.";
}

std::string sentence(std::string_view goal, const BoxPair& pair, bool now, bool found) {
  if (has_frustum(pair)) return frustum_sentence(pair, now, found);
  if (goal == "only_edges") {
    if (now) return "Only edges separate these boxes.";
    return found ? "Boxes that only edges separate: found."
                 : "Still to find: boxes that only an axis of two edges separates.";
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
  if (goal == "only_edges") return only_edges(pair);
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
