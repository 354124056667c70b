// The Pareto front: the offers that no other beats in both time and size.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace snug::cost {

struct Offer {
  double time = 0;
  double size = 0;      // smaller is better, as with the time
  double rounding = 0;  // sizes that differ by no more than this are equal
  double doubt = 0;     // and so are times that differ by no more than this
};

/// Whether neither time nor size tells them apart.
[[nodiscard]] bool are_equal(const Offer& a, const Offer& b);

/// The indices of the offers that no other beats, where beating means as good in both and better in one. Ordered by
/// time. All equal offers are included, and so are those that cannot be told apart: they are tied. Offers that are not
/// finite are left out. O(n^2) time for n offers.
[[nodiscard]] std::vector<std::size_t> pareto_front(std::span<const Offer> offers);

}  // namespace snug::cost
