// What a volume costs whoever fitted it: its bytes, and its overlap test against copies of itself, half of which just
// overlap it and half are just apart.
#pragma once

#include <cstdint>
#include <functional>

#include "fit/any_step.hpp"

namespace snug::cost {

struct OverlapWork {
  /// One test with each copy; how many overlap.
  std::function<int()> run;
  int pairs = 0;
};

/// Copies are moved in random directions, by a little less or a little more than what brings them to touch, the hardest
/// that a test has to decide; those of volumes that turn with their body are turned at random, too.
/// volume: lifted, of that dimension; single: whether it is tested in float. Nothing to run where the page has no such
/// volume.
[[nodiscard]] OverlapWork overlap_work(const fit::Volume3& volume, int dim, bool single, std::uint64_t seed);

/// Bytes in the scalar and dimension it was fitted in (geometry/volume_bytes.hpp).
[[nodiscard]] std::int64_t bytes_of(const fit::Volume3& volume, int dim, bool single);

}  // namespace snug::cost
