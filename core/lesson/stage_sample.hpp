// A stage of a kind of lesson, small and fixed, on which `snug lesson table` looks up what results have.
#pragma once

#include <string_view>

namespace snug::lesson {

/// The part of a lesson's file that says what stands on its stage.
struct StageSample {
  std::string_view volume;
  std::string_view algorithms;  // as the file lists them; empty: all of the volume
  std::string_view tables;
};

inline constexpr std::string_view kPointsInPlane = R"([points]
list = [[-2, 0], [2, 0.3], [0.1, 1], [0, -1], [0.5, 2.5], [0.7, 0.2]]
)";
inline constexpr std::string_view kPointsInSpace = R"([points]
dim = 3
list = [[-2, 0, 0.2], [2, 0.3, 0], [0.1, 1, 1.5], [0, -1, -1.2], [0.5, 2.5, 0.4], [0.7, 0.2, 0.3]]
)";
inline constexpr std::string_view kOneOfEachVolume =
    "\"sphere/welzl\", \"aabb/min_max\", \"obb/exact\", \"kdop/k8\", \"hull/quickhull\"";

}  // namespace snug::lesson
