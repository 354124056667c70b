// What a volume costs, whichever algorithm fitted it: its bytes, and its overlap test against copies of itself, half of
// which just overlap it while the other half are just apart.
#pragma once

#include <cstdint>
#include <functional>

#include "fit/any_step.hpp"

namespace snug::cost {

struct OverlapWork {
  /// Tests each copy once. Returns how many overlap.
  std::function<int()> run;
  int pairs = 0;
};

/// Copies are moved in random directions, by a little less or a little more than the distance at which
/// they touch, which are the hardest cases for a test; copies of volumes that rotate with their body
/// are rotated at random too. volume: lifted, of that dimension; single: whether it is tested in
/// float.
[[nodiscard]] OverlapWork overlap_work(const fit::Volume3& volume, int dim, bool single, std::uint64_t seed);

/// The operations of the overlap test, all kinds together, on average over such copies, in double. They are counted,
/// and so the same on every machine.
[[nodiscard]] double operations_of_test(const fit::Volume3& volume, int dim, std::uint64_t seed);

/// Bytes in the scalar and dimension it was fitted in (geometry/volume_bytes.hpp).
[[nodiscard]] std::int64_t bytes_of(const fit::Volume3& volume, int dim, bool single);

}  // namespace snug::cost
