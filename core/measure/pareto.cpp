#include "measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/sort.hpp"

namespace snug::cost {
namespace {

bool is_finite(const Offer& offer) { return std::isfinite(offer.time) && std::isfinite(offer.size); }

bool undercuts(const Offer& a, const Offer& b) {
  const double rounding = std::max(a.rounding, b.rounding), doubt = std::max(a.doubt, b.doubt);
  const double later = b.time - a.time, larger = b.size - a.size;  // as faster() compares them, to the last bit
  return later >= -doubt && larger >= -rounding && (later > doubt || larger > rounding);
}

}  // namespace

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
