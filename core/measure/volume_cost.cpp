#include "measure/volume_cost.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>

#include "geometry/convert.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "geometry/volume_bytes.hpp"
#include "query/distance/support_function.hpp"
#include "query/overlap/overlaps.hpp"
#include "query/overlap/overlaps_any.hpp"

namespace snug::cost {
namespace {

/// More than a branch predictor remembers: it would learn the verdicts of a few pairs that come again and again.
constexpr int kPairs = 512;
/// Hulls get fewer pairs, because they have many points, and a test goes over them several times.
constexpr int kHullPairs = 16;
template <class VolumeType>
inline constexpr int kPairsOf = kPairs;
template <class Scalar, int Dim>
inline constexpr int kPairsOf<ConvexHull<Scalar, Dim>> = kHullPairs;

/// Halvings in the search for the distance at which two copies touch: to a millionth of it.
constexpr int kHalvings = 20;
/// The fractions of that distance by which copies that overlap, and copies that are apart, are moved.
constexpr double kTouching = 0.9, kApart = 1.1;
/// How far the copies of a scene lie at most, in sizes of the volume's box: about one in twenty overlaps.
constexpr double kSceneReach = 2;

template <class Scalar, int Dim>
Pose<Scalar, Dim> random_turn(Random& random) {
  const double radians = random.between(0, 6.25);
  Pose<Scalar, Dim> pose;
  if constexpr (Dim == 2) pose.rotation = turn(radians).template cast<Scalar>();
  else
    // Braces fix the order in which the random numbers are drawn, whatever the compiler.
    pose.rotation =
        turn(Vector<double, 3>{random.normal(), random.normal(), random.normal()}, radians).template cast<Scalar>();
  return pose;
}

template <class Scalar, int Dim>
Vector<Scalar, Dim> random_direction(Random& random) {
  for (;;) {
    Vector<double, Dim> v;
    for (int i = 0; i < Dim; ++i) v[i] = random.between(-1, 1);
    if (v.squaredNorm() > 0.01 && v.squaredNorm() < 1) return v.normalized().template cast<Scalar>();
  }
}

/// True for half of them, in an order that no branch predictor learns.
std::vector<bool> some_half(int count, Random& random) {
  std::vector<bool> chosen(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const std::size_t j = random.below(static_cast<std::uint32_t>(i + 1));
    chosen[i] = chosen[j];
    chosen[j] = i % 2 == 0;
  }
  return chosen;
}

/// Copies rotated if their kind can rotate. Without any motion they overlap, because a convex body and its copy share
/// their centre.
template <class Scalar, int Dim, class VolumeType>
std::vector<VolumeType> copies_of(const VolumeType& volume, Copies where, Random& random) {
  const Aabb<double, Dim> box = query::box_around(volume);
  const double size = (box.max - box.min).norm(), reach = 2 * size;  // more than any two points are apart
  std::vector<VolumeType> copies;
  for (const bool overlap : some_half(kPairsOf<VolumeType>, random)) {
    Pose<Scalar, Dim> pose = random_turn<Scalar, Dim>(random);
    const Vector<Scalar, Dim> direction = random_direction<Scalar, Dim>(random);
    const auto at = [&](double distance) {
      pose.translation = direction * static_cast<Scalar>(distance);
      return placed(volume, pose);
    };
    if (where == Copies::kScene) {
      // The share of a ball within a distance grows with its power: so they lie evenly.
      copies.push_back(at(kSceneReach * size * std::pow(random.between(0, 1), 1.0 / Dim)));
      continue;
    }
    double touching = 0, apart = reach;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double between = (touching + apart) / 2;
      (query::overlaps(volume, at(between)) ? touching : apart) = between;
    }
    copies.push_back(at(overlap ? kTouching * touching : kApart * apart));
  }
  return copies;
}

template <class Scalar, int Dim>
OverlapWork work_of(const fit::Volume3& lifted, Copies where, std::uint64_t seed) {
  return std::visit(
      [&](const auto& kind) -> OverlapWork {
        Random random(seed);
        const auto volume = converted<Scalar, Dim>(kind);
        using VolumeType = std::remove_const_t<decltype(volume)>;
        auto copies = std::make_shared<std::vector<VolumeType>>(copies_of<Scalar, Dim>(volume, where, random));
        return {[volume, copies] {
                  int overlapping = 0;
                  for (const VolumeType& copy : *copies) overlapping += query::overlaps(volume, copy) ? 1 : 0;
                  return overlapping;
                },
                kPairsOf<VolumeType>};
      },
      lifted);
}

template <int Dim>
double operations_in(const fit::Volume3& lifted, std::uint64_t seed) {
  return std::visit(
      [&](const auto& kind) {
        Random random(seed);
        const auto volume = converted<double, Dim>(kind);
        Counter counter;
        const auto copies = copies_of<double, Dim>(volume, Copies::kNear, random);
        for (const auto& copy : copies)
          static_cast<void>(query::test_any_overlap<double, Dim>(Volume<double, Dim>(volume), copy, counter));
        const std::int64_t all = std::accumulate(counter.counts.begin(), counter.counts.end(), std::int64_t{0});
        return static_cast<double>(all) / static_cast<double>(copies.size());
      },
      lifted);
}

}  // namespace

double operations_of_test(const fit::Volume3& volume, int dim, std::uint64_t seed) {
  return dim == 2 ? operations_in<2>(volume, seed) : operations_in<3>(volume, seed);
}

OverlapWork overlap_work(const fit::Volume3& volume, int dim, bool single, Copies where, std::uint64_t seed) {
  if (single) return dim == 2 ? work_of<float, 2>(volume, where, seed) : work_of<float, 3>(volume, where, seed);
  return dim == 2 ? work_of<double, 2>(volume, where, seed) : work_of<double, 3>(volume, where, seed);
}

std::int64_t bytes_of(const fit::Volume3& volume, int dim, bool single) {
  return std::visit(
      [&](const auto& kind) {
        const auto bytes = [](const auto& own) { return static_cast<std::int64_t>(snug::bytes_of(own)); };
        if (single) return dim == 2 ? bytes(converted<float, 2>(kind)) : bytes(converted<float, 3>(kind));
        return dim == 2 ? bytes(converted<double, 2>(kind)) : bytes(converted<double, 3>(kind));
      },
      volume);
}

}  // namespace snug::cost
