// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kObjectsSample = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
)";
inline constexpr std::string_view kQueriedSample = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
[query]
from = [-2.1, 0.9]
to = [1.3, -1]
)";
inline constexpr std::string_view kMovedObjectsSample = R"([objects]
center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7]]
half_extents = [[0.25, 0.2]]
built = [[-2, 0.8], [-1.2, -0.4], [0.6, 0.6], [-0.4, -0.7]]
)";

inline constexpr StageSample kTreeSamples[] = {
    {"bvh_build", "", kObjectsSample},
    {"bvh_query", "", kQueriedSample},
    {"bvh_update", "", kMovedObjectsSample},
};

}  // namespace snug::lesson
