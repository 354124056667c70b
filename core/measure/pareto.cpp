#include "measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/sort.hpp"

namespace snug::cost {
namespace {

bool is_finite(const Offer& offer) { return std::isfinite(offer.time) && std::isfinite(offer.size); }

/// Whether a is surely less than b: by more than either's doubt, as faster() compares times, to the last bit.
bool less_time(const Offer& a, const Offer& b) { return b.time - a.time > std::max(a.doubt, b.doubt); }
bool less_size(const Offer& a, const Offer& b) { return b.size - a.size > std::max(a.rounding, b.rounding); }

bool undercuts(const Offer& a, const Offer& b) {
  return !less_time(b, a) && !less_size(b, a) && (less_time(a, b) || less_size(a, b));
}

}  // namespace

bool are_equal(const Offer& a, const Offer& b) {
  return !less_time(a, b) && !less_time(b, a) && !less_size(a, b) && !less_size(b, a);
}

std::vector<std::size_t> pareto_front(std::span<const Offer> offers) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < offers.size(); ++i) {
    const auto beats = [&](const Offer& other) { return is_finite(other) && undercuts(other, offers[i]); };
    if (is_finite(offers[i]) && std::none_of(offers.begin(), offers.end(), beats)) front.push_back(i);
  }
  sort_stably(front, [&](std::size_t a, std::size_t b) {
    return std::tie(offers[a].time, offers[a].size, a) < std::tie(offers[b].time, offers[b].size, b);
  });
  return front;
}

}  // namespace snug::cost
