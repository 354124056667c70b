#include "hierarchy/sah.hpp"

#include <algorithm>

namespace snug::hierarchy::sah {
namespace {

int bin_of(const Layout& layout, Index body, const Box& centers, int axis) {
  const double share = (layout.center(body, axis) - centers.low[axis]) / (centers.high[axis] - centers.low[axis]);
  return std::min(kBins - 1, static_cast<int>(kBins * share));
}

}  // namespace

Bins fill_bins(const Layout& layout, std::span<const Index> bodies, const Box& centers, int axis) {
  Bins bins;
  for (const Index body : bodies) bins[bin_of(layout, body, centers, axis)].take({layout.boxes[body], 1});
  return bins;
}

BinSplit best_split(const Layout& layout, std::span<const Index> bodies, const Box& all, const Box& centers,
                    std::vector<double>* costs) {
  const bool by_length = half_surface_of(all, layout.dim).area == 0;  // for boxes without area, and in the plane
  const auto size = [&](const Box& box) { return by_length ? half_surface_of(box).length : half_surface_of(box).area; };
  const auto cost_of = [&](const Bin& bin) { return size(bin.box) * bin.count; };
  BinSplit best;
  for (int axis = 0; axis < layout.dim; ++axis) {
    if (!(centers.low[axis] < centers.high[axis])) continue;
    const Bins bins = fill_bins(layout, bodies, centers, axis);
    // Sums up the bins right of each border, from the right, and then those left of it, from the left.
    std::array<double, kBins> right;
    Bin sum;
    for (int border = kBins - 1; border > 0; --border) {
      sum.take(bins[border]);
      right[border] = cost_of(sum);
    }
    sum = {};
    for (int border = 1; border < kBins; ++border) {
      sum.take(bins[border - 1]);
      const double cost = 2 + (cost_of(sum) + right[border]) / size(all);
      if (costs != nullptr) (*costs)[axis * kBorders + border - 1] = cost;
      if (cost >= best.cost) continue;
      const double width = (centers.high[axis] - centers.low[axis]) / kBins;
      best = {axis, border, centers.low[axis] + border * width, sum.count, cost};
    }
  }
  return best;
}

void reorder(const Layout& layout, std::span<Index> bodies, const Box& centers, const BinSplit& split) {
  std::partition(bodies.begin(), bodies.end(),
                 [&](Index body) { return bin_of(layout, body, centers, split.axis) < split.border; });
}

}  // namespace snug::hierarchy::sah
