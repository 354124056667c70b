// Who is worth its time: what no other beats in both.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace snug::cost {

struct Offer {
  double time = 0;
  double size = 0;      // smaller is better, as with the time
  double rounding = 0;  // sizes that are no farther apart than this are equal
};

/// The places of those that no other offer undercuts: none is as good in both and better in one. Ordered by time; of
/// equal ones all: of those whose sizes differ by rounding alone, the fastest. Offers that are not finite are left out.
/// O(n^2) time of n offers.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Offer> offers);

}  // namespace snug::cost
