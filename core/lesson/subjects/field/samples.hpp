// Stages of this kind of lesson; see stage_sample.hpp.
#pragma once

#include "lesson/stage_sample.hpp"

namespace snug::lesson {

inline constexpr std::string_view kFieldSample = R"([field]
objects = 64
camera = [-42, 12, 14]
aim = [0, 8, 0]
)";

inline constexpr StageSample kFieldSamples[] = {
    {"frustum_field", "", kFieldSample},
};

}  // namespace snug::lesson
