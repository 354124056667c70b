// Many boxes or spheres against one frustum at once: one in each lane of the machine's vectors.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/aabb.hpp"
#include "geometry/frustum.hpp"
#include "geometry/sphere.hpp"
#include "query/classify_steps.hpp"

namespace snug::query {

/// A structure of arrays, in blocks: each block has an array for every field, so that neighbours are adjacent in memory
/// and all their fields lie in a few successive cache lines.
template <class Scalar, std::size_t kFields>
class FieldArray {
 public:
  /// The number of items in a block: one field of theirs fills a cache line.
  static constexpr std::size_t kBlock = 64 / sizeof(Scalar);
  struct alignas(64) Block {
    Scalar fields[kFields][kBlock]{};
  };

  explicit FieldArray(std::size_t size)
      : size_(size), blocks_((size + kBlock - 1) / kBlock), reach_(blocks_.size(), Scalar(0)) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  /// The blocks, the last of them padded with zeros.
  [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }
  /// For each block a bound that no coordinate in it exceeds or ever exceeded.
  [[nodiscard]] std::span<const Scalar> reach() const { return reach_; }

 protected:
  [[nodiscard]] const Scalar& at(std::size_t i, std::size_t field) const {
    return blocks_[i / kBlock].fields[field][i % kBlock];
  }
  [[nodiscard]] Scalar& at(std::size_t i, std::size_t field) { return blocks_[i / kBlock].fields[field][i % kBlock]; }
  void reaches(std::size_t i, Scalar coordinate) { reach_[i / kBlock] = std::max(reach_[i / kBlock], coordinate); }

 private:
  std::size_t size_;
  std::vector<Block> blocks_;
  std::vector<Scalar> reach_;
};

/// Boxes in space, by min and max. Fields: min x, y, z, max x, y, z.
template <class Scalar>
class AabbArray : public FieldArray<Scalar, 6> {
 public:
  explicit AabbArray(std::span<const Aabb<Scalar, 3>> boxes) : FieldArray<Scalar, 6>(boxes.size()) {
    for (std::size_t i = 0; i < boxes.size(); ++i) set(i, boxes[i]);
  }
  [[nodiscard]] Aabb<Scalar, 3> operator[](std::size_t i) const;
  void set(std::size_t i, const Aabb<Scalar, 3>& box);
};

/// Spheres. Fields: centre x, y, z, radius.
template <class Scalar>
class SphereArray : public FieldArray<Scalar, 4> {
 public:
  explicit SphereArray(std::span<const Sphere<Scalar, 3>> spheres) : FieldArray<Scalar, 4>(spheres.size()) {
    for (std::size_t i = 0; i < spheres.size(); ++i) set(i, spheres[i]);
  }
  [[nodiscard]] Sphere<Scalar, 3> operator[](std::size_t i) const;
  void set(std::size_t i, const Sphere<Scalar, 3>& sphere);
};

/// Writes to verdicts[k] what classify says of item k, just as exactly. verdicts: as long as the array.
template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& boxes, std::span<Culling> verdicts);
template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const SphereArray<Scalar>& spheres, std::span<Culling> verdicts);

}  // namespace snug::query
