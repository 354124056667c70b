#include "query/cull/batch/classify_batch.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "geometry/tolerance.hpp"
#include "query/cull/batch/lanes.hpp"
#include "query/cull/classify.hpp"

// No vector is passed between functions that are not inlined, so its calling convention does not matter.
#if defined(__x86_64__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define SNUG_INLINE [[gnu::always_inline]] inline

namespace snug::query {
namespace {

/// The planes with unit normals.
template <class Scalar>
struct UnitPlanes {
  struct Unit {
    Scalar normal[3], d;
    std::size_t n_vertex[3], p_vertex[3];  // the fields of a box that hold their coordinates
  };
  Unit planes[6];
  Scalar largest_d = 0;

  explicit UnitPlanes(const Frustum<Scalar, 3>& frustum) {
    const Frustum<Scalar, 3> unit = frustum.normalized();
    for (int p = 0; p < 6; ++p) {
      planes[p].d = unit[p].d;
      largest_d = std::max(largest_d, std::abs(unit[p].d));
      for (int i = 0; i < 3; ++i) {
        const bool towards_max = unit[p].normal[i] >= 0;
        planes[p].normal[i] = unit[p].normal[i];
        planes[p].n_vertex[i] = static_cast<std::size_t>(towards_max ? i : i + 3);
        planes[p].p_vertex[i] = static_cast<std::size_t>(towards_max ? i + 3 : i);
      }
    }
  }

  /// The error bound on the distances from the true planes. reach: no coordinate is
  /// larger.
  [[nodiscard]] SNUG_INLINE Scalar error_bound(Scalar reach) const {
    return tolerance::kUnitPlaneReach<Scalar> * (2 * reach + largest_d) + std::numeric_limits<Scalar>::min();
  }
};

template <class Vec>
SNUG_INLINE Vec larger(const Vec& a, const Vec& b) {
  return a > b ? a : b;
}

template <class Vec, class Scalar>
SNUG_INLINE Vec load(const Scalar* from) {
  Vec vector;
  std::memcpy(&vector, from, sizeof vector);
  return vector;
}

template <class Vec>
SNUG_INLINE Vec smaller(const Vec& a, const Vec& b) {
  return a < b ? a : b;
}
/// The absolute value.
template <class Vec>
SNUG_INLINE Vec size_of_each(const Vec& v) {
  return larger(v, -v);
}

/// One block, in as many groups of lanes as it takes, so that each plane's numbers are read once for all of them.
template <class Scalar, std::size_t kBytes>
struct Blocks {
  using Vec = typename Lanes<Scalar, kBytes>::Vector;
  using Mask = typename Lanes<Scalar, kBytes>::Mask;
  static constexpr std::size_t kLanes = Lanes<Scalar, kBytes>::kCount, kBlock = 64 / sizeof(Scalar),
                               kGroups = kBlock / kLanes;
  using Groups = Vec[kGroups];
  typedef std::uint8_t Bytes __attribute__((vector_size(kLanes)));
  using Verdicts = std::array<Culling, kBlock>;
  using Block = typename AabbArray<Scalar>::Block;

  /// The greatest distance, over all planes, of the point in three fields.
  template <class Fields>
  SNUG_INLINE static void farthest(const UnitPlanes<Scalar>& all, const Block& block, Fields fields, Groups& most) {
    for (std::size_t p = 0; p < 6; ++p) {
      const auto& plane = all.planes[p];
      const Scalar *x = block.fields[fields(plane, 0)], *y = block.fields[fields(plane, 1)],
                   *z = block.fields[fields(plane, 2)];
      for (std::size_t g = 0; g < kGroups; ++g) {
        const std::size_t at = g * kLanes;
        const Vec value = plane.normal[0] * load<Vec>(x + at) + plane.normal[1] * load<Vec>(y + at) +
                          plane.normal[2] * load<Vec>(z + at) + plane.d;
        most[g] = p == 0 ? value : larger(most[g], value);
      }
    }
  }

  /// Judges boxes: most need no more than their n-vertices.
  SNUG_INLINE static bool judge(const UnitPlanes<Scalar>& planes, const Block& block, Scalar error_bound,
                                Verdicts& verdicts) {
    Groups low, high;
    farthest(
        planes, block, [](const auto& plane, std::size_t i) { return plane.n_vertex[i]; }, low);
    Vec least = low[0];
    for (std::size_t g = 1; g < kGroups; ++g) least = smaller(least, low[g]);
    if (all_above(least, error_bound)) {
      verdicts.fill(Culling::kOutside);
      return true;
    }
    farthest(
        planes, block, [](const auto& plane, std::size_t i) { return plane.p_vertex[i]; }, high);
    return write_verdicts(low, high, error_bound, verdicts);
  }

  /// Whether all lanes are greater. Selects instead of masking, because GCC 12 splits masks of 64 bytes into lanes.
  SNUG_INLINE static bool all_above(const Vec& v, Scalar bound) {
    const Mask below = v > bound ? Mask{} : Mask{} + 1;
    std::array<std::uint64_t, kBytes / 8> words;
    std::memcpy(words.data(), &below, kBytes);
    std::uint64_t any = 0;
    for (const std::uint64_t word : words) any |= word;
    return any == 0;
  }

  /// Writes the verdicts, which are 0, 1 and 2. Returns whether all of them are certain despite rounding.
  SNUG_INLINE static bool write_verdicts(const Groups& low, const Groups& high, Scalar error_bound,
                                         Verdicts& verdicts) {
    Vec nearest{};  // the distances that are nearest to 0
    for (std::size_t g = 0; g < kGroups; ++g) {
      const Vec near = smaller(size_of_each(low[g]), size_of_each(high[g]));
      nearest = g == 0 ? near : smaller(nearest, near);
      const Mask not_outside = high[g] > 0 ? Mask{} + 1 : Mask{};
      const Bytes code = __builtin_convertvector(low[g] > 0 ? Mask{} + 2 : not_outside, Bytes);
      std::memcpy(verdicts.data() + g * kLanes, &code, kLanes);
    }
    return all_above(nearest, error_bound);
  }
};

template <class Scalar, std::size_t kBytes>
SNUG_INLINE void classify_in(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& array,
                             std::span<Culling> verdicts) {
  using Own = Blocks<Scalar, kBytes>;
  const UnitPlanes<Scalar> planes(frustum);
  for (std::size_t block = 0; block < array.blocks().size(); ++block) {
    typename Own::Verdicts own;
    const bool known = Own::judge(planes, array.blocks()[block], planes.error_bound(array.reach()[block]), own);
    const std::size_t begin = block * Own::kBlock, count = std::min(Own::kBlock, verdicts.size() - begin);
    if (!known) [[unlikely]]  // the certain ones come out the same
      for (std::size_t i = 0; i < count; ++i) own[i] = classify(frustum, array[begin + i]).verdict;
    if (count == Own::kBlock) [[likely]]
      std::memcpy(verdicts.data() + begin, own.data(), Own::kBlock);
    else std::copy_n(own.data(), count, verdicts.data() + begin);
  }
}

#if defined(__x86_64__)
#if defined(__clang__)  // it has no such target, and may choose half the width
#define SNUG_FULL_WIDTH
#else
#define SNUG_FULL_WIDTH ",prefer-vector-width=512"
#endif
// Each lane does the same operations, so the bits are the same: this target has no fused multiply-add.
template <class Scalar>
[[gnu::target("avx2")]] void classify_in_32_bytes(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& array,
                                                  std::span<Culling> verdicts) {
  classify_in<Scalar, 32>(frustum, array, verdicts);
}
template <class Scalar>
[[gnu::target("avx512f,avx512bw,avx512dq,avx512vl" SNUG_FULL_WIDTH)]] void
classify_in_64_bytes(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& array, std::span<Culling> verdicts) {
  classify_in<Scalar, 64>(frustum, array, verdicts);
}
#endif

}  // namespace

template <class Scalar>
AabbArray<Scalar>::AabbArray(std::span<const Aabb<Scalar, 3>> boxes)
    : size_(boxes.size()), blocks_((boxes.size() + kBlock - 1) / kBlock), reach_(blocks_.size(), Scalar(0)) {
  for (std::size_t i = 0; i < size_; ++i) set(i, boxes[i]);
}
template <class Scalar>
Aabb<Scalar, 3> AabbArray<Scalar>::operator[](std::size_t i) const {
  const auto at = [&](std::size_t field) { return blocks_[i / kBlock].fields[field][i % kBlock]; };
  return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
}
template <class Scalar>
void AabbArray<Scalar>::set(std::size_t i, const Aabb<Scalar, 3>& box) {
  auto& fields = blocks_[i / kBlock].fields;
  for (int k = 0; k < 3; ++k) {
    fields[k][i % kBlock] = box.min[k];
    fields[k + 3][i % kBlock] = box.max[k];
  }
  reach_[i / kBlock] = std::max(reach_[i / kBlock], magnitude_of(box));
}

template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& boxes, std::span<Culling> verdicts) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return classify_in_64_bytes(frustum, boxes, verdicts);
  if (__builtin_cpu_supports("avx2")) return classify_in_32_bytes(frustum, boxes, verdicts);
#endif
  classify_in<Scalar, 16>(frustum, boxes, verdicts);
}

#define SNUG_INSTANTIATE(Scalar)                                                                                       \
  template class AabbArray<Scalar>;                                                                                    \
  template void classify_all(const Frustum<Scalar, 3>&, const AabbArray<Scalar>&, std::span<Culling>);
SNUG_INSTANTIATE(float)
SNUG_INSTANTIATE(double)
#undef SNUG_INSTANTIATE

}  // namespace snug::query
