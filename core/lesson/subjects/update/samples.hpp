// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr StageSample kUpdateSamples[] = {
    {"update", "", kPointsInPlane},
    {"update", "", kPointsInSpace},
};

}  // namespace snug::lesson
