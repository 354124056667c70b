// Merges the vertices that STL repeats for every triangle.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "io/point_file.hpp"
#include "number/bits.hpp"
#include "number/fnv.hpp"

namespace snug::io {

/// Collects vertices, three for each triangle; those with equal bits become one point.
class CornerMerger {
 public:
  void add(const Vector<double, 3>& corner) {
    const auto next = static_cast<Index>(file_.points.size());
    const auto [known, is_new] = points_.try_emplace(bits_of(corner), next);
    if (is_new) file_.points.push_back(corner);
    triangle_[corners_++] = known->second;
    if (corners_ < 3) return;
    file_.triangles.push_back(triangle_);
    corners_ = 0;
  }
  /// Whether one more vertex could be one point too many.
  [[nodiscard]] bool full() const { return file_.points.size() == static_cast<std::size_t>(INT32_MAX); }
  [[nodiscard]] PointFile take() { return std::move(file_); }

 private:
  using Bits = std::array<std::uint64_t, 3>;
  static Bits bits_of(const Vector<double, 3>& corner) {
    return {snug::bits_of(corner[0]), snug::bits_of(corner[1]), snug::bits_of(corner[2])};
  }
  struct Hash {
    std::size_t operator()(const Bits& bits) const {
      Fnv1a hash;
      for (const std::uint64_t word : bits) hash.add_bits(word);
      return static_cast<std::size_t>(hash.value());
    }
  };

  PointFile file_;
  std::unordered_map<Bits, Index, Hash> points_;
  std::array<Index, 3> triangle_{};
  std::size_t corners_ = 0;
};

}  // namespace snug::io
