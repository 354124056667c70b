#include "measure/volume_cost.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <type_traits>
#include <utility>

#include "geometry/convert.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "geometry/volume_bytes.hpp"
#include "query/overlaps.hpp"
#include "query/overlaps_any.hpp"
#include "query/support_function.hpp"

namespace snug::cost {
namespace {

constexpr int kPairs = 64;
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

/// Copies just inside and just outside the distance at which they touch, rotated if their kind can rotate. Without any
/// motion they overlap, because a convex body and its copy share their centre.
template <class Scalar, int Dim, class VolumeType>
std::vector<VolumeType> copies_of(const VolumeType& volume, Random& random) {
  const Aabb<double, Dim> box = query::box_around(volume);
  const double reach = 2 * (box.max - box.min).norm();  // farther than any two points of the volume are apart
  std::vector<VolumeType> copies;
  for (int i = 0; i < kPairsOf<VolumeType>; ++i) {
    Pose<Scalar, Dim> pose = random_turn<Scalar, Dim>(random);
    const Vector<Scalar, Dim> direction = random_direction<Scalar, Dim>(random);
    const auto at = [&](double distance) {
      pose.translation = direction * static_cast<Scalar>(distance);
      return placed(volume, pose);
    };
    double touching = 0, apart = reach;
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double between = (touching + apart) / 2;
      (query::overlaps(volume, at(between)) ? touching : apart) = between;
    }
    copies.push_back(at(i % 2 == 0 ? kTouching * touching : kApart * apart));
  }
  return copies;
}

template <class Scalar, int Dim>
OverlapWork work_of(const fit::Volume3& lifted, std::uint64_t seed) {
  return std::visit(
      [&](const auto& kind) -> OverlapWork {
        Random random(seed);
        const auto volume = converted<Scalar, Dim>(kind);
        using VolumeType = std::remove_const_t<decltype(volume)>;
        auto copies = std::make_shared<std::vector<VolumeType>>(copies_of<Scalar, Dim>(volume, random));
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
        const auto copies = copies_of<double, Dim>(volume, random);
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

OverlapWork overlap_work(const fit::Volume3& volume, int dim, bool single, std::uint64_t seed) {
  if (single) return dim == 2 ? work_of<float, 2>(volume, seed) : work_of<float, 3>(volume, seed);
  return dim == 2 ? work_of<double, 2>(volume, seed) : work_of<double, 3>(volume, seed);
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
