// The separating-axis test of many pairs of boxes at once: one pair in each lane of the machine's vectors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/obb.hpp"

namespace snug::query {

/// Boxes in 3-D as a structure of arrays: coordinate by coordinate, so that neighbours lie side by side.
template <class Scalar>
class ObbArray {
 public:
  /// Where a box's numbers are among the arrays: centre, axes one after the other, half extents.
  static constexpr std::size_t kCenter = 0, kAxes = 3, kHalfExtents = 12, kFields = 15;
  /// Arrays are padded to a whole number of the widest vectors that any machine here has.
  static constexpr std::size_t kPadding = 64 / sizeof(Scalar);

  explicit ObbArray(std::span<const Obb<Scalar, 3>> boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Scalar* field(std::size_t field) const { return fields_[field].data(); }
  [[nodiscard]] Obb<Scalar, 3> operator[](std::size_t i) const;
  void set(std::size_t i, const Obb<Scalar, 3>& box);

 private:
  std::size_t size_;
  std::array<std::vector<Scalar>, kFields> fields_;
};

/// overlap[k] = 1 where boxes a[k] and b[k] share a point, else 0: the verdicts of obb_sat, exact as it is.
/// a, b, overlap: of the same size.
template <class Scalar>
void obbs_overlap(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::span<std::uint8_t> overlap);

}  // namespace snug::query
