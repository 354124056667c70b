// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kLoadedSample = R"([points]
list = [[-2, 0], [2, 0.3], [0.1, 1], [0, -1], [0.5, 2.5], [0.7, 0.2]]
[load]
)";

inline constexpr StageSample kCriteriaSamples[] = {
    {"sphere", kOneOfEachVolume, kLoadedSample},
};

}  // namespace snug::lesson
