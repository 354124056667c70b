// Small lessons whose files say how the stage shows them, and lessons on what no lesson of the course is about yet.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>

#include "lesson/lesson.hpp"

namespace snug::test {

inline constexpr std::string_view kViewedHead = R"(version = 2
title = "Viewed"
summary = "A lesson for tests."
minutes = 1
)";

/// keys: of the head. tables: of what the lesson is about. view: the keys of [view]; empty for none.
inline lesson::Lesson viewed(std::string_view keys, std::string_view tables, std::string_view view = "") {
  std::string text(kViewedHead);
  text.append(keys).append("\n").append(tables);
  if (!view.empty()) text.append("\n[view]\n").append(view);
  text.append("\n[[section]]\ntitle = \"First\"\ntext = \"A **term**.\"\n");
  auto lesson = lesson::read_lesson(text, "viewed.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *std::move(lesson);
}

inline constexpr std::string_view kEightPoints =
    "[points]\nlist = [[-2, 0.3], [2, 0.2], [0, 1.4], [0.3, -1], [0.5, 1.2], [-1.2, -0.8], [1.4, 1.1], [1.6, -0.6]]";
inline lesson::Lesson flat_kdop(std::string_view view = "") {
  return viewed("volume = \"kdop\"\nalgorithms = [\"k8\"]", kEightPoints, view);
}
inline lesson::Lesson space_kdop(std::string_view view = "") {
  return viewed("volume = \"kdop\"\nalgorithms = [\"k14\"]", "[points]\ndim = 3\ngenerate = \"gaussian\"\ncount = 14",
                view);
}

/// Two boxes side by side, apart by so much.
inline lesson::Lesson boxes_apart(const std::string& gap, std::string_view view = "", int dim = 2) {
  const std::string third = dim == 3 ? ", 0.1" : "", turn = dim == 3 ? "[0, 0, 0]" : "[0]";
  return viewed("volume = \"box_pair\"\nalgorithms = [\"sat\", \"sat_all\"]",
                "[boxes]\ndim = " + std::to_string(dim) + "\ncenter = [[-1, 0" + third + "], [1, 0.1" + third +
                    "]]\nhalf_extents = [[1, 0.6" + third + "], [" + gap + ", 0.5" + third + "]]\nturn = [" + turn +
                    ", " + turn + "]",
                view);
}

/// Twelve boxes that fall on a floor, whose middle is elsewhere. body, floor: more keys of theirs.
inline lesson::Lesson falling(std::string_view view = "", const std::string& body = "", const std::string& floor = "") {
  return viewed("volume = \"scene\"\nalgorithms = [\"sweep_and_prune\"]\nseed = 3",
                "[points]\ndim = 3\ngenerate = \"cube\"\ncount = 12\n[scene]\nframes = 120\n"
                "[[scene.body]]\nshape = \"box\"\nhalf_extents = [0.25, 0.15, 0.2]\nat_points = true\nturn = [20, 30, "
                "40]\n" +
                    body +
                    "\n[[scene.body]]\nshape = \"box\"\nname = \"floor\"\nhalf_extents = [4, 0.2, 4]\nposition = [2.5, "
                    "-2, 2]\nfixed = true\n" +
                    floor +
                    "\n[[scene.effect]]\neffect = \"fall\"\n[[scene.effect]]\neffect = \"move\"\n[[scene.effect]]\n"
                    "effect = \"refit\"\nstrategy = \"rotated_box\"\n[[scene.effect]]\neffect = \"broad_phase\"\n"
                    "[[scene.effect]]\neffect = \"narrow_phase\"\n[[scene.effect]]\neffect = \"bounce\"",
                view);
}

}  // namespace snug::test
