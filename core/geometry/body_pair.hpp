// Two bodies of a list.
#pragma once

#include <algorithm>

#include "geometry/vector.hpp"

namespace snug {

/// Two bodies by index, a < b.
struct BodyPair {
  Index a = 0, b = 0;

  /// The pair of two different bodies, in either order.
  [[nodiscard]] static BodyPair of(Index i, Index j) { return {std::min(i, j), std::max(i, j)}; }
  friend bool operator==(const BodyPair&, const BodyPair&) = default;
  friend bool operator<(const BodyPair& x, const BodyPair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; }
};

}  // namespace snug
