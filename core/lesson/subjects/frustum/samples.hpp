// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kBoxAndFrustumSample = R"([boxes]
taper = 0.3
center = [[0.4, 0.7], [0.6, 0]]
half_extents = [[0.5, 0.25], [1.1, 1.2]]
turn = [[-24], [0]]
)";
inline constexpr std::string_view kBoxAndFrustumInSpaceSample = R"([boxes]
dim = 3
taper = 0.3
center = [[0.4, 0.7, 0.1], [0.6, 0, 0]]
half_extents = [[0.5, 0.25, 0.3], [1.1, 1.2, 0.8]]
turn = [[0, 0, -24], [0, 0, 0]]
)";
inline constexpr std::string_view kSphereAndFrustumSample = R"([boxes]
taper = 0.3
center = [[0.35, 0.95], [0.55, 0]]
radius = 0.3
half_extents = [[1.05, 1.15]]
turn = [[-4]]
)";
inline constexpr std::string_view kPointAndFrustumSample = R"([boxes]
taper = 0.3
center = [[0.35, 0.95], [0.55, 0]]
half_extents = [[1.05, 1.15]]
turn = [[-4]]
)";

inline constexpr StageSample kFrustumSamples[] = {
    {"frustum_box", "", kBoxAndFrustumSample},
    {"frustum_box", "", kBoxAndFrustumInSpaceSample},
    {"frustum_sphere", "", kSphereAndFrustumSample},
    {"frustum_point", "", kPointAndFrustumSample},
};

}  // namespace snug::lesson
