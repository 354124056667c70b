// Many boxes against one frustum at once: one in each lane of the machine's vectors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/frustum.hpp"
#include "query/cull/classify_steps.hpp"

namespace snug::query {

/// Boxes in space by min and max, as a structure of arrays in blocks: each block has an array for every field, so that
/// neighbours are adjacent in memory and all their fields lie in a few successive cache lines.
template <class Scalar>
class AabbArray {
 public:
  static constexpr std::size_t kFields = 6;  // min x, y, z, max x, y, z
  /// The number of boxes in a block: one field of theirs fills a cache line.
  static constexpr std::size_t kBlock = 64 / sizeof(Scalar);
  struct alignas(64) Block {
    Scalar fields[kFields][kBlock]{};
  };

  explicit AabbArray(std::span<const Aabb<Scalar, 3>> boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The blocks, the last of them padded with zeros.
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  /// For each block a bound that no coordinate in it exceeds or ever exceeded.
  [[nodiscard]] std::span<const Scalar> reach() const { return reach_; }
  [[nodiscard]] Aabb<Scalar, 3> operator[](std::size_t i) const;
  void set(std::size_t i, const Aabb<Scalar, 3>& box);

 private:
  std::size_t size_;
  std::vector<Block> blocks_;
  std::vector<Scalar> reach_;
};

/// Writes to verdicts[k] what classify says of box k, just as exactly. verdicts: as long as the array.
template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& boxes, std::span<Culling> verdicts);

}  // namespace snug::query
