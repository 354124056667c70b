#include "measure/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace snug::cost {

std::vector<std::size_t> pareto_front(std::span<const Offer> offers) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < offers.size(); ++i)
    if (std::isfinite(offers[i].time) && std::isfinite(offers[i].size)) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(offers[a].time, offers[a].size, a) < std::tie(offers[b].time, offers[b].size, b);
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    const bool first = front.empty() || offers[i].size < offers[front.back()].size;
    const bool equal =
        !first && offers[i].size == offers[front.back()].size && offers[i].time == offers[front.back()].time;
    if (first || equal) front.push_back(i);
  }
  return front;
}

}  // namespace snug::cost
