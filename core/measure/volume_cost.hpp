// What a volume costs, whichever algorithm fitted it: its bytes, and its overlap test against copies of itself. The
// verdicts are timed in a loop that is compiled for its kind, so that no dispatch is timed.
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

/// Where the copies lie. kNear: half of them overlap the volume by a tenth of the distance at which they would touch,
/// half are as far apart: the hardest cases for a test, as a broad phase leaves them. kScene: anywhere in a space
/// around it, so that most are apart, and a test that can end early does.
enum class Copies : std::uint8_t { kNear, kScene };

/// Copies are moved in random directions; those of volumes that rotate with their body are rotated at random too.
/// volume: lifted, of that dimension; single: whether it is tested in float.
[[nodiscard]] OverlapWork overlap_work(const fit::Volume3& volume, int dim, bool single, Copies where,
                                       std::uint64_t seed);

/// The operations of the overlap test, all kinds together, on average over copies that are near, in double. They are
/// counted, and so the same on every machine.
[[nodiscard]] double operations_of_test(const fit::Volume3& volume, int dim, std::uint64_t seed);

/// Bytes in the scalar and dimension it was fitted in (geometry/volume_bytes.hpp).
[[nodiscard]] std::int64_t bytes_of(const fit::Volume3& volume, int dim, bool single);

}  // namespace snug::cost
