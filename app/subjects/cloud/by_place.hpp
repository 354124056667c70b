// Points in the same place bear one name on the stage.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::app {

struct Placed {
  Index first = kNoIndex;
  int more = 0;  // points in the same place
};

/// The points by their places, in their order; of the worst one's place it is the first. place_of: of a point's index.
template <class PlaceOf>
[[nodiscard]] std::vector<Placed> by_place(const std::vector<Index>& points, Index worst, PlaceOf place_of) {
  std::map<std::array<double, 3>, std::size_t> at;
  std::vector<Placed> placed;
  for (const Index i : points) {
    const auto place = place_of(i);
    const auto [found, fresh] = at.try_emplace(std::array<double, 3>{place[0], place[1], place[2]}, placed.size());
    if (fresh) {
      placed.push_back({i});
      continue;
    }
    Placed& own = placed[found->second];
    ++own.more;
    if (i == worst) own.first = i;
  }
  return placed;
}

}  // namespace snug::app
