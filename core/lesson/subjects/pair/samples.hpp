// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kBoxesSample = R"([boxes]
random_pairs = 10
center = [[-1, 0], [1, 0.3]]
half_extents = [[0.9, 0.4], [0.8, 0.5]]
turn = [[20], [-35]]
)";
inline constexpr std::string_view kBoxesInSpaceSample = R"([boxes]
dim = 3
center = [[-1, 0, 0], [1, 0.3, 0.2]]
half_extents = [[0.9, 0.4, 0.5], [0.8, 0.5, 0.3]]
turn = [[20, 10, 0], [-35, 0, 15]]
)";
inline constexpr std::string_view kSpheresSample = R"([volumes]
a = { sphere = { center = [-1, 0], radius = 0.5 } }
b = { sphere = { center = [1, 0], radius = 0.5 } }
)";
inline constexpr std::string_view kUprightSample = R"([volumes]
a = { aabb = { min = [-1, 0], max = [0, 1] } }
b = { aabb = { min = [1, 0], max = [2, 1] } }
)";
inline constexpr std::string_view kSweptSample = R"([volumes]
dim = 3
a = { capsule = { a = [-2, 0, 0], b = [-1, 1, 0], radius = 0.3 } }
b = { lozenge = { origin = [0, 0, 0], edges = [[1, 0, 0], [0, 1, 0]], radius = 0.2 } }
)";
inline constexpr std::string_view kOrientedSample = R"([volumes]
a = { obb = { center = [-1, 0], half_extents = [0.6, 0.4], turn = [20] } }
b = { obb = { center = [1, 0], half_extents = [0.6, 0.4], turn = [50] } }
)";
inline constexpr std::string_view kDopsSample = R"([volumes]
a = { kdop = { k = 6, min = [-1, -1, -2], max = [0, 0, 0] } }
b = { kdop = { k = 8, min = [1, 0, 1, 0], max = [2, 1, 3, 2] } }
)";
inline constexpr std::string_view kHullsSample = R"([volumes]
a = { hull = { points = [[-2, 0], [-1, 0], [-1, 1]] } }
b = { hull = { points = [[0.5, -1], [2, 0], [0.8, 1.2]] } }
)";

inline constexpr StageSample kPairSamples[] = {
    {"box_pair", "", kBoxesSample},
    {"box_pair", "", kBoxesInSpaceSample},
};
inline constexpr StageSample kVolumesSamples[] = {
    {"volume_pair", "", kSpheresSample},  {"volume_pair", "", kUprightSample}, {"volume_pair", "", kSweptSample},
    {"volume_pair", "", kOrientedSample}, {"volume_pair", "", kDopsSample},    {"volume_pair", "", kHullsSample},
};

}  // namespace snug::lesson
