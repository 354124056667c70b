// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kPileSample = R"([points]
dim = 3
list = [[0, 2, 0], [0.1, 3, 0], [0, 4, 0.1]]
[scene]
frames = 3
graph = true
[[scene.body]]
shape = "box"
at_points = true
[[scene.body]]
shape = "box"
name = "floor"
half_extents = [5, 0.5, 5]
fixed = true
[[scene.effect]]
effect = "fall"
[[scene.effect]]
effect = "refit"
[[scene.effect]]
effect = "broad_phase"
[[scene.effect]]
effect = "narrow_phase"
[[scene.effect]]
effect = "bounce"
)";
inline constexpr std::string_view kTurningSample = R"([points]
dim = 3
list = [[-2, 0, 0.2], [2, 0.3, 0], [0.1, 1, 1.5], [0, -1, -1.2], [0.5, 2.5, 0.4], [0.7, 0.2, 0.3]]
[scene]
frames = 3
[[scene.body]]
shape = "points"
[[scene.effect]]
effect = "spin"
axis = [1, 2, 3]
turns_per_second = 0.3
[[scene.effect]]
effect = "refit"
)";

inline constexpr StageSample kSceneSamples[] = {
    {"scene", "\"sweep_and_prune\", \"tree\"", kPileSample},
    {"scene", "\"rebuild\", \"loose\", \"sphere\", \"k14\"", kTurningSample},
};

}  // namespace snug::lesson
