#include "measure/hard_cloud.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/generate.hpp"
#include "geometry/random.hpp"
#include "measure/rounding.hpp"

namespace snug::cost {
namespace {

using Cloud = std::vector<Vector<double, 3>>;

constexpr std::array<std::string_view, 6> kKinds{"cube", "ball", "sphere", "gaussian", "stick", "clusters"};
constexpr std::array kSizes{6, 12, 40, 200};
constexpr int kSeeds = 5;
constexpr int kHardPoints = 8, kTries = 1500;
/// The fractions of the cloud's size by which tries move a point.
constexpr std::array kMoves{0.5, 0.1, 0.02};

AnyPointSet set_of(Cloud cloud) { return *PointSet<double, 3>::make(std::move(cloud)); }  // finite, of about unit size

}  // namespace

double excess_on(const fit::Algorithm& algorithm, const AnyPointSet& points, std::uint64_t seed) {
  const int dim = fit::dim_of(points);
  const fit::Options options{.seed = seed};
  const double least = fit::size_of(fit::exact_algorithm(algorithm.volume)->fit(points, options).volume, dim);
  const int lengths = lengths_of_size(algorithm.volume, dim);
  return rounding_of(points)
             .ratio(fit::size_of(algorithm.fit(points, options).volume, dim), least, lengths)
             .value_or(1) -
         1;
}

Excess excess_of(const fit::Algorithm& algorithm, std::uint64_t seed) {
  std::vector<double> all;
  for (const std::string_view kind : kKinds)
    for (const int size : kSizes)
      for (int i = 0; i < kSeeds; ++i)
        all.push_back(
            excess_on(algorithm, set_of(*generate(kind, size, 3, seed + static_cast<std::uint64_t>(i))), seed));
  std::sort(all.begin(), all.end());
  Excess excess{
      .median = all[all.size() / 2], .most = all.back(), .clouds = static_cast<int>(all.size()), .tried = kTries};

  Random random(seed);
  Cloud hardest = *generate("cube", kHardPoints, 3, seed);
  for (int i = 0; i < kTries; ++i) {
    Cloud cloud = hardest;
    const double move = kMoves[random.below(kMoves.size())];
    auto& point = cloud[random.below(kHardPoints)];
    for (int axis = 0; axis < 3; ++axis) point[axis] = std::clamp(point[axis] + random.between(-move, move), -1.0, 1.0);
    const double here = excess_on(algorithm, set_of(cloud), seed);
    if (!(here >= excess.found)) continue;
    excess.found = here;
    hardest = std::move(cloud);
  }
  return excess;
}

}  // namespace snug::cost
