// The separating-axis test of many pairs of boxes at once: one pair in each lane of the machine's vectors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/obb.hpp"

namespace snug::query {

/// Boxes in 3-D as structures of arrays: in blocks, each with an array of every coordinate, so that neighbours lie side
/// by side and all that belongs to them in a few successive lines of the cache.
template <class Scalar>
class ObbArray {
 public:
  /// Where a box's numbers are among the arrays of its block: centre, axes one after the other, half extents.
  static constexpr std::size_t kCenter = 0, kAxes = 3, kHalfExtents = 12, kFields = 15;
  /// As many boxes as fill a line of the cache with one coordinate.
  static constexpr std::size_t kBlock = 64 / sizeof(Scalar);
  struct alignas(64) Block {
    Scalar fields[kFields][kBlock]{};
  };

  explicit ObbArray(std::span<const Obb<Scalar, 3>> boxes)
      : size_(boxes.size()), blocks_((size_ + kBlock - 1) / kBlock) {
    for (std::size_t i = 0; i < size_; ++i) set(i, boxes[i]);
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The last one is filled up with boxes that are points at the origin.
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  [[nodiscard]] Obb<Scalar, 3> operator[](std::size_t i) const;
  void set(std::size_t i, const Obb<Scalar, 3>& box);

 private:
  std::size_t size_;
  std::vector<Block> blocks_;
};

/// overlap[k] = 1 where boxes a[k] and b[k] share a point, else 0: the verdicts of obb_sat, exact as it is.
/// a, b, overlap: of the same size.
template <class Scalar>
void obbs_overlap(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::span<std::uint8_t> overlap);

}  // namespace snug::query
