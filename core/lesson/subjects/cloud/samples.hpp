// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr StageSample kCloudSamples[] = {
    {"sphere", "", kPointsInPlane},
    {"sphere", "\"sphere/welzl\", \"aabb/min_max\"", kPointsInPlane},
    {"sphere", "\"welzl\", \"ritter\", \"pca\", \"aabb_center\", \"ritter_iterative\", \"pivot\", \"brute_force\"",
     kPointsInPlane},
    {"aabb", "", kPointsInPlane},
    {"aabb", "", kPointsInSpace},
    {"obb", "", kPointsInPlane},
    {"obb", "", kPointsInSpace},
    {"capsule", "", kPointsInPlane},
    {"lozenge", "", kPointsInPlane},
    {"lozenge", "", kPointsInSpace},
    {"kdop", "", kPointsInPlane},
    {"kdop", "", kPointsInSpace},
    {"hull", "\"quickhull\"", kPointsInPlane},
    {"hull", "", kPointsInPlane},
    {"hull", "", kPointsInSpace},
};

}  // namespace snug::lesson
