#include "query/classify_batch.hpp"

#include <array>
#include <cstring>
#include <limits>

#include "geometry/tolerance.hpp"
#include "query/classify.hpp"

// Nothing here passes a vector between functions that are not inlined, so no calling convention for it matters.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

#define SNUG_INLINE [[gnu::always_inline]] inline

namespace snug::query {
namespace {

/// As many scalars as kBytes hold, and what comparisons of them give: all ones or all zeros in each lane.
template <class Scalar, std::size_t kBytes>
struct Lanes {
  typedef Scalar Vector __attribute__((vector_size(kBytes)));
  using Mask = decltype(Vector{} < Vector{});
  static constexpr std::size_t kCount = kBytes / sizeof(Scalar);
};

/// The planes with unit normals, each number in all lanes.
template <class Scalar, std::size_t kBytes>
struct UnitPlanes {
  using Vec = typename Lanes<Scalar, kBytes>::Vector;
  Vec normal[6][3], d[6];
  bool towards_max[6][3];  // whether a box's p-vertex has its max there
  Scalar largest_d = 0;

  explicit UnitPlanes(const Frustum<Scalar, 3>& frustum) {
    const Frustum<Scalar, 3> unit = frustum.normalized();
    for (int p = 0; p < 6; ++p) {
      for (int i = 0; i < 3; ++i) normal[p][i] = Vec{} + unit[p].normal[i], towards_max[p][i] = unit[p].normal[i] >= 0;
      d[p] = Vec{} + unit[p].d;
      largest_d = std::max(largest_d, std::abs(unit[p].d));
    }
  }

  /// Within what the values of the true planes, divided by their normals' lengths, are known where no coordinate is larger.
  [[nodiscard]] SNUG_INLINE Scalar doubt(Scalar reach) const {
    return tolerance::kUnitPlaneReach<Scalar> * (2 * reach + largest_d) + std::numeric_limits<Scalar>::min();
  }
};

/// The least and the greatest distance of what is in each lane, each of the plane where it is largest.
template <class Vec>
struct Farthest {
  Vec low, high;
};

template <class Vec>
SNUG_INLINE Vec larger(const Vec& a, const Vec& b) { return a > b ? a : b; }

template <class Vec, class Scalar>
SNUG_INLINE Vec load(const Scalar* from) {
  Vec vector;
  std::memcpy(&vector, from, sizeof vector);
  return vector;
}

template <class Scalar, std::size_t kBytes, class Vec = typename Lanes<Scalar, kBytes>::Vector>
SNUG_INLINE Farthest<Vec> farthest(const UnitPlanes<Scalar, kBytes>& planes, const typename AabbArray<Scalar>::Block& block, std::size_t first) {
  Farthest<Vec> all;
  for (std::size_t p = 0; p < 6; ++p) {
    Vec low = planes.d[p], high = low;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t up = planes.towards_max[p][i] ? 3 : 0;
      low += planes.normal[p][i] * load<Vec>(block.fields[i + 3 - up] + first);
      high += planes.normal[p][i] * load<Vec>(block.fields[i + up] + first);
    }
    all.low = p == 0 ? low : larger(all.low, low);
    all.high = p == 0 ? high : larger(all.high, high);
  }
  return all;
}

template <class Scalar, std::size_t kBytes, class Vec = typename Lanes<Scalar, kBytes>::Vector>
SNUG_INLINE Farthest<Vec> farthest(const UnitPlanes<Scalar, kBytes>& planes, const typename SphereArray<Scalar>::Block& block, std::size_t first) {
  const Vec x = load<Vec>(block.fields[0] + first), y = load<Vec>(block.fields[1] + first), z = load<Vec>(block.fields[2] + first);
  Vec most{};
  for (std::size_t p = 0; p < 6; ++p) {
    const Vec distance = planes.normal[p][0] * x + planes.normal[p][1] * y + planes.normal[p][2] * z + planes.d[p];
    most = p == 0 ? distance : larger(most, distance);
  }
  const Vec radius = load<Vec>(block.fields[3] + first);
  return {most - radius, most + radius};
}

/// The verdicts of kCount items as whole numbers of Culling. Returns whether rounding hides any of them.
template <class Scalar, std::size_t kBytes, class Vec, class Code>
SNUG_INLINE bool judge(const Farthest<Vec>& all, Scalar doubt, Code* codes) {
  const auto outside = all.low > doubt, inside = all.high < -doubt;
  const auto crossing = (all.low < -doubt) & (all.high > doubt);
  const auto code = 1 + inside - outside;  // true is -1
  std::memcpy(codes, &code, kBytes);
  const auto known = outside | inside | crossing;
  std::array<std::uint64_t, kBytes / 8> words;
  std::memcpy(words.data(), &known, kBytes);
  std::uint64_t all_known = ~std::uint64_t{0};
  for (const std::uint64_t word : words) all_known &= word;
  return all_known != ~std::uint64_t{0};
}

template <class Scalar, std::size_t kBytes, class Array>
SNUG_INLINE void classify_in(const Frustum<Scalar, 3>& frustum, const Array& array, std::span<Culling> verdicts) {
  using Code = std::remove_cvref_t<decltype(typename Lanes<Scalar, kBytes>::Mask{}[0])>;
  constexpr std::size_t kBlock = Array::kBlock;
  const UnitPlanes<Scalar, kBytes> planes(frustum);
  for (std::size_t block = 0; block < array.blocks().size(); ++block) {
    const Scalar doubt = planes.doubt(array.reach()[block]);
    std::array<Code, kBlock> codes;
    bool in_doubt = false;
    for (std::size_t first = 0; first < kBlock; first += Lanes<Scalar, kBytes>::kCount)
      in_doubt |= judge<Scalar, kBytes>(farthest<Scalar, kBytes>(planes, array.blocks()[block], first), doubt, codes.data() + first);
    std::array<Culling, kBlock> all;
    for (std::size_t i = 0; i < kBlock; ++i) all[i] = static_cast<Culling>(codes[i]);
    const std::size_t begin = block * kBlock, count = std::min(kBlock, verdicts.size() - begin);
    if (in_doubt) [[unlikely]]  // of a block's neighbours too: they are known, and come out the same
      for (std::size_t i = 0; i < count; ++i) all[i] = classify(frustum, array[begin + i]).verdict;
    if (count == kBlock) std::memcpy(verdicts.data() + begin, all.data(), kBlock);
    else std::memcpy(verdicts.data() + begin, all.data(), count);
  }
}

#if defined(__x86_64__)
// Lane by lane the same operations, so the same bits: this target has no fused multiply-add.
template <class Scalar, class Array>
[[gnu::target("avx2")]] void classify_in_32_bytes(const Frustum<Scalar, 3>& frustum, const Array& array, std::span<Culling> verdicts) {
  classify_in<Scalar, 32>(frustum, array, verdicts);
}
#endif

template <class Scalar, class Array>
void classify_array(const Frustum<Scalar, 3>& frustum, const Array& array, std::span<Culling> verdicts) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return classify_in_32_bytes(frustum, array, verdicts);
#endif
  classify_in<Scalar, 16>(frustum, array, verdicts);
}

}  // namespace

template <class Scalar>
Aabb<Scalar, 3> AabbArray<Scalar>::operator[](std::size_t i) const {
  return {{this->at(i, 0), this->at(i, 1), this->at(i, 2)}, {this->at(i, 3), this->at(i, 4), this->at(i, 5)}};
}
template <class Scalar>
void AabbArray<Scalar>::set(std::size_t i, const Aabb<Scalar, 3>& box) {
  for (int k = 0; k < 3; ++k) {
    this->at(i, static_cast<std::size_t>(k)) = box.min[k];
    this->at(i, static_cast<std::size_t>(k + 3)) = box.max[k];
  }
  this->reaches(i, size_of(box));
}

template <class Scalar>
Sphere<Scalar, 3> SphereArray<Scalar>::operator[](std::size_t i) const {
  return {{this->at(i, 0), this->at(i, 1), this->at(i, 2)}, this->at(i, 3)};
}
template <class Scalar>
void SphereArray<Scalar>::set(std::size_t i, const Sphere<Scalar, 3>& sphere) {
  for (int k = 0; k < 3; ++k) this->at(i, static_cast<std::size_t>(k)) = sphere.center[k];
  this->at(i, 3) = sphere.radius;
  this->reaches(i, size_of(sphere));
}

template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const AabbArray<Scalar>& boxes, std::span<Culling> verdicts) {
  classify_array(frustum, boxes, verdicts);
}
template <class Scalar>
void classify_all(const Frustum<Scalar, 3>& frustum, const SphereArray<Scalar>& spheres, std::span<Culling> verdicts) {
  classify_array(frustum, spheres, verdicts);
}

#define SNUG_INSTANTIATE(Scalar)                                                                        \
  template class AabbArray<Scalar>;                                                                     \
  template class SphereArray<Scalar>;                                                                   \
  template void classify_all(const Frustum<Scalar, 3>&, const AabbArray<Scalar>&, std::span<Culling>);  \
  template void classify_all(const Frustum<Scalar, 3>&, const SphereArray<Scalar>&, std::span<Culling>);
SNUG_INSTANTIATE(float)
SNUG_INSTANTIATE(double)
#undef SNUG_INSTANTIATE

}  // namespace snug::query
