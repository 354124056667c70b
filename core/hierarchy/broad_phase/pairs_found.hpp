// What a broad phase returns.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/body_pair.hpp"

namespace snug::hierarchy {

struct PairsFound {
  std::vector<BodyPair> pairs;  // whose boxes overlap
  std::int64_t compared = 0;    // how many pairs of boxes were compared, including a tree's nodes
  int axis = -1;                // the axis along which boxes were sorted; -1: none
  std::int64_t swaps = 0;       // how many neighbours changed places while they were sorted
};

}  // namespace snug::hierarchy
