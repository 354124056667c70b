// The lessons on single volumes: how much each asks, and that each has the student build something.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "core/lesson/lesson_files.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::array kVolumeLessons{
    "sphere-ritter",  "sphere-pca",         "sphere-welzl",  "welzl-recursion", "ritter-formula", "sphere-iterative",
    "sphere-overlap", "sphere-brute-force", "aabb",          "aabb-space",      "aabb-updates",   "scene-updates",
    "convex-hull",    "convex-hull-3d",     "obb-stored",    "covariance",      "obb-pca",        "obb-fitting",
    "swept-volumes",  "swept-fit",          "swept-overlap", "kdop-slabs",      "kdop-overlap",   "kdop-space",
    "kdop-update",    "which-volume"};

/// Whether the run has the answer, so that other points have another one.
bool is_computed(const Question& question) { return question.asks != "choice" && question.asks != "sequence"; }

}  // namespace

TEST_CASE("a lesson on a volume asks 3 to 6 questions, a third of them of the run, and has a task") {
  for (const char* id : kVolumeLessons) {
    CAPTURE(id);
    const Lesson lesson = test::lesson_of(id);
    const auto& questions = lesson.questions;
    CHECK(questions.size() >= 3);
    CHECK(questions.size() <= 6);
    CHECK(3 * std::count_if(questions.begin(), questions.end(), is_computed) >=
          static_cast<std::ptrdiff_t>(questions.size()));
    CHECK_FALSE(lesson.tasks.empty());
  }
}
