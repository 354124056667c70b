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
  std::int64_t swaps = 0;       // how many neighbours insertion makes change places to sort the boxes
  std::int64_t cells = 0;       // how many cells of a grid the boxes were put into, each counted for each of its boxes
};

}  // namespace snug::hierarchy
