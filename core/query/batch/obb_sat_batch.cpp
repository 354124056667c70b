#include "query/batch/obb_sat_batch.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <type_traits>

#include "geometry/tolerance.hpp"
#include "query/batch/lanes.hpp"
#include "query/obb_sat.hpp"

// Nothing here passes a vector between functions that are not inlined, so no calling convention for it matters.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define SNUG_INLINE [[gnu::always_inline]] inline

namespace snug::query {
namespace {

/// The test of kCount pairs, lane by lane that of ObbFrames (obb_sat.hpp).
template <class Scalar, std::size_t kBytes>
class Group {
 public:
  using Vec = typename Lanes<Scalar, kBytes>::Vector;
  using Mask = typename Lanes<Scalar, kBytes>::Mask;
  using Block = typename ObbArray<Scalar>::Block;

  /// first: the place of the first lane in the blocks.
  SNUG_INLINE Group(const Block& a, const Block& b, std::size_t first) {
    Vec size{};
    for (std::size_t k = 0; k < 3; ++k) {
      offset_[k] = load(b, kCenter + k, first) - load(a, kCenter + k, first);
      half_a_[k] = load(a, kHalf + k, first);
      half_b_[k] = load(b, kHalf + k, first);
      size += magnitude(offset_[k]) + half_a_[k] + half_b_[k];
    }
    doubt_ = size * tolerance::kSatGap<Scalar> + std::numeric_limits<Scalar>::min();
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec x = load(a, kAxes + 3 * i, first), y = load(a, kAxes + 3 * i + 1, first),
                z = load(a, kAxes + 3 * i + 2, first);
      translation_[i] = x * offset_[0] + y * offset_[1] + z * offset_[2];
      for (std::size_t j = 0; j < 3; ++j) {
        rotation_[i][j] = x * load(b, kAxes + 3 * j, first) + y * load(b, kAxes + 3 * j + 1, first) +
                          z * load(b, kAxes + 3 * j + 2, first);
        size_[i][j] = magnitude(rotation_[i][j]);
      }
    }
  }

  /// The widest of the gaps along the faces' axes.
  [[nodiscard]] SNUG_INLINE Vec faces() const {
    Vec widest = gap(translation_[0], half_a_[0], radius_b(0));
    for (std::size_t i = 1; i < 3; ++i) widest = larger(widest, gap(translation_[i], half_a_[i], radius_b(i)));
    for (std::size_t j = 0; j < 3; ++j)
      widest = larger(
          widest,
          gap(translation_[0] * rotation_[0][j] + translation_[1] * rotation_[1][j] + translation_[2] * rotation_[2][j],
              half_a_[0] * size_[0][j] + half_a_[1] * size_[1][j] + half_a_[2] * size_[2][j], half_b_[j]));
    return widest;
  }

  /// The same along the edges' axes, or below.
  [[nodiscard]] SNUG_INLINE Vec edges(Vec widest) const {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) widest = larger(widest, edges_gap(i, j));
    return widest;
  }

  /// The same without the axes of parallel edges, which are all that hides the verdict of most boxes with axes in
  /// common.
  [[nodiscard]] SNUG_INLINE Vec edges_but_parallel(Vec widest) const {
    constexpr Scalar kSquare = tolerance::kParallelInFrame<Scalar> * tolerance::kParallelInFrame<Scalar>;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const Vec x = rotation_[(i + 1) % 3][j], y = rotation_[(i + 2) % 3][j];
        widest = x * x + y * y > kSquare ? larger(widest, edges_gap(i, j)) : widest;
      }
    return widest;
  }

  [[nodiscard]] SNUG_INLINE Mask apart(const Vec& widest) const { return widest > doubt_; }
  [[nodiscard]] SNUG_INLINE Mask overlapping(const Vec& widest) const { return widest < -doubt_; }
  [[nodiscard]] SNUG_INLINE static bool any(const Mask& mask) {
    std::array<std::uint64_t, kBytes / 8> words;
    std::memcpy(words.data(), &mask, sizeof mask);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words) all |= word;
    return all != 0;
  }

 private:
  static constexpr std::size_t kCenter = ObbArray<Scalar>::kCenter, kAxes = ObbArray<Scalar>::kAxes,
                               kHalf = ObbArray<Scalar>::kHalfExtents;

  SNUG_INLINE static Vec load(const Block& block, std::size_t field, std::size_t first) {
    Vec vector;
    std::memcpy(&vector, block.fields[field] + first, sizeof vector);
    return vector;
  }
  /// Without the sign bit.
  SNUG_INLINE static Vec magnitude(const Vec& v) {
    using Bits = std::remove_cvref_t<decltype(Mask{}[0])>;
    return reinterpret_cast<Vec>(reinterpret_cast<const Mask&>(v) & std::numeric_limits<Bits>::max());
  }
  SNUG_INLINE static Vec larger(const Vec& a, const Vec& b) { return a > b ? a : b; }
  SNUG_INLINE static Vec gap(const Vec& offset, const Vec& radius_a, const Vec& radius_b) {
    return magnitude(offset) - (radius_a + radius_b);
  }

  [[nodiscard]] SNUG_INLINE Vec radius_b(std::size_t i) const {
    return half_b_[0] * size_[i][0] + half_b_[1] * size_[i][1] + half_b_[2] * size_[i][2];
  }
  [[nodiscard]] SNUG_INLINE Vec edges_gap(std::size_t i, std::size_t j) const {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return gap(translation_[i2] * rotation_[i1][j] - translation_[i1] * rotation_[i2][j],
               half_a_[i1] * size_[i2][j] + half_a_[i2] * size_[i1][j],
               half_b_[j1] * size_[i][j2] + half_b_[j2] * size_[i][j1]);
  }

  Vec offset_[3], half_a_[3], half_b_[3];
  Vec translation_[3], rotation_[3][3], size_[3][3];
  Vec doubt_;
};

enum class Known : std::uint8_t { kApart, kOverlap, kOpen };

/// What rounding cannot change, of the pairs in a block from first on.
template <class Scalar, std::size_t kBytes>
SNUG_INLINE void decide(const typename ObbArray<Scalar>::Block& a, const typename ObbArray<Scalar>::Block& b,
                        std::size_t first, Known* known) {
  const Group<Scalar, kBytes> group(a, b, first);
  const auto faces = group.faces();
  auto widest = faces;
  if (group.any(~group.apart(faces))) {
    widest = group.edges(faces);
    if (group.any(group.overlapping(faces) & ~group.overlapping(widest) & ~group.apart(widest)))
      widest = group.edges_but_parallel(faces);
  }
  const auto apart = group.apart(widest), open = ~(apart | group.overlapping(widest));
  for (std::size_t lane = 0; lane < Lanes<Scalar, kBytes>::kCount; ++lane)
    known[lane] = static_cast<Known>(1 + (apart[lane] != 0 ? -1 : 0) + (open[lane] != 0 ? 1 : 0));
}

template <class Scalar, std::size_t kBytes>
SNUG_INLINE void decide(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::span<std::uint8_t> overlap) {
  constexpr std::size_t kBlock = ObbArray<Scalar>::kBlock;
  std::array<Known, kBlock> known;
  for (std::size_t block = 0; block < a.blocks().size(); ++block) {
    for (std::size_t first = 0; first < kBlock; first += Lanes<Scalar, kBytes>::kCount)
      decide<Scalar, kBytes>(a.blocks()[block], b.blocks()[block], first, known.data() + first);
    const std::size_t begin = block * kBlock, count = std::min(kBlock, overlap.size() - begin);
    for (std::size_t i = 0; i < count; ++i)
      overlap[begin + i] =
          known[i] == Known::kOpen ? obbs_overlap(a[begin + i], b[begin + i]) : known[i] == Known::kOverlap;
  }
}

#if defined(__x86_64__)
// Lane by lane the same operations, so the same bits: this target has no fused multiply-add.
template <class Scalar>
[[gnu::target("avx2")]] void decide_in_32_bytes(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b,
                                                std::span<std::uint8_t> overlap) {
  decide<Scalar, 32>(a, b, overlap);
}
#endif

}  // namespace

template <class Scalar>
Obb<Scalar, 3> ObbArray<Scalar>::operator[](std::size_t i) const {
  Obb<Scalar, 3> box;
  const auto field = [&](std::size_t k) { return blocks_[i / kBlock].fields[k][i % kBlock]; };
  for (std::size_t k = 0; k < 3; ++k) box.center[static_cast<int>(k)] = field(kCenter + k);
  for (std::size_t k = 0; k < 9; ++k) box.axes(static_cast<int>(k % 3), static_cast<int>(k / 3)) = field(kAxes + k);
  for (std::size_t k = 0; k < 3; ++k) box.half_extents[static_cast<int>(k)] = field(kHalfExtents + k);
  return box;
}

template <class Scalar>
void ObbArray<Scalar>::set(std::size_t i, const Obb<Scalar, 3>& box) {
  const auto field = [&](std::size_t k) -> Scalar& { return blocks_[i / kBlock].fields[k][i % kBlock]; };
  for (std::size_t k = 0; k < 3; ++k) field(kCenter + k) = box.center[static_cast<int>(k)];
  for (std::size_t k = 0; k < 9; ++k) field(kAxes + k) = box.axes(static_cast<int>(k % 3), static_cast<int>(k / 3));
  for (std::size_t k = 0; k < 3; ++k) field(kHalfExtents + k) = box.half_extents[static_cast<int>(k)];
}

template <class Scalar>
void obbs_overlap(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::span<std::uint8_t> overlap) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return decide_in_32_bytes(a, b, overlap);
#endif
  decide<Scalar, 16>(a, b, overlap);
}

template class ObbArray<float>;
template class ObbArray<double>;
template void obbs_overlap(const ObbArray<float>&, const ObbArray<float>&, std::span<std::uint8_t>);
template void obbs_overlap(const ObbArray<double>&, const ObbArray<double>&, std::span<std::uint8_t>);

}  // namespace snug::query
