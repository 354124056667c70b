#include "query/obb_sat_batch.hpp"

#include <cstring>
#include <limits>
#include <type_traits>

#include "geometry/tolerance.hpp"
#include "query/obb_sat.hpp"

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

/// The test of kCount pairs, lane by lane that of ObbFrames (obb_sat.hpp).
template <class Scalar, std::size_t kBytes>
class Group {
 public:
  using Vec = typename Lanes<Scalar, kBytes>::Vector;
  using Mask = typename Lanes<Scalar, kBytes>::Mask;
  static constexpr std::size_t kCount = Lanes<Scalar, kBytes>::kCount;

  SNUG_INLINE Group(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::size_t first) {
    Vec size{};
    for (std::size_t k = 0; k < 3; ++k) {
      offset_[k] = load(b, kCenter + k, first) - load(a, kCenter + k, first);
      half_a_[k] = load(a, kHalf + k, first);
      half_b_[k] = load(b, kHalf + k, first);
      size += magnitude(offset_[k]) + half_a_[k] + half_b_[k];
    }
    doubt_ = size * tolerance::kSatGap<Scalar> + std::numeric_limits<Scalar>::min();
    for (std::size_t i = 0; i < 3; ++i) {
      Vec axis_a[3];
      for (std::size_t k = 0; k < 3; ++k) axis_a[k] = load(a, kAxes + 3 * i + k, first);
      translation_[i] = axis_a[0] * offset_[0] + axis_a[1] * offset_[1] + axis_a[2] * offset_[2];
      for (std::size_t j = 0; j < 3; ++j) {
        rotation_[i][j] = axis_a[0] * load(b, kAxes + 3 * j, first) + axis_a[1] * load(b, kAxes + 3 * j + 1, first) +
                          axis_a[2] * load(b, kAxes + 3 * j + 2, first);
        size_[i][j] = magnitude(rotation_[i][j]);
      }
    }
  }

  SNUG_INLINE void faces() {
    for (std::size_t i = 0; i < 3; ++i)
      open_faces_ |= judge(translation_[i], half_a_[i],
                           half_b_[0] * size_[i][0] + half_b_[1] * size_[i][1] + half_b_[2] * size_[i][2]);
    for (std::size_t j = 0; j < 3; ++j)
      open_faces_ |= judge(
          translation_[0] * rotation_[0][j] + translation_[1] * rotation_[1][j] + translation_[2] * rotation_[2][j],
          half_a_[0] * size_[0][j] + half_a_[1] * size_[1][j] + half_a_[2] * size_[2][j], half_b_[j]);
  }

  SNUG_INLINE void edges() {
    for_each_edge_pair([this](std::size_t i, std::size_t j) { open_edges_ |= judge_edges(i, j); });
  }

  /// The same, without the axes of parallel edges: most that is open after edges() is boxes with axes in common.
  SNUG_INLINE void edges_but_parallel() {
    constexpr Scalar kSquare = tolerance::kParallelInFrame<Scalar> * tolerance::kParallelInFrame<Scalar>;
    open_edges_ = Mask{};
    for_each_edge_pair([this](std::size_t i, std::size_t j) {
      const Vec x = rotation_[(i + 1) % 3][j], y = rotation_[(i + 2) % 3][j];
      open_edges_ |= judge_edges(i, j) & (x * x + y * y > kSquare);
    });
  }

  [[nodiscard]] SNUG_INLINE bool all_apart() const { return !any(~apart_); }
  [[nodiscard]] SNUG_INLINE bool only_edges_open() const { return any(open_edges_ & ~apart_ & ~open_faces_); }
  [[nodiscard]] SNUG_INLINE bool is_apart(std::size_t lane) const { return apart_[lane] != 0; }
  [[nodiscard]] SNUG_INLINE bool is_open(std::size_t lane) const { return (open_faces_[lane] | open_edges_[lane]) != 0; }

 private:
  static constexpr std::size_t kCenter = ObbArray<Scalar>::kCenter, kAxes = ObbArray<Scalar>::kAxes,
                               kHalf = ObbArray<Scalar>::kHalfExtents;

  SNUG_INLINE static Vec load(const ObbArray<Scalar>& boxes, std::size_t field, std::size_t first) {
    Vec vector;
    std::memcpy(&vector, boxes.field(field) + first, sizeof vector);
    return vector;
  }
  /// Without the sign bit.
  SNUG_INLINE static Vec magnitude(const Vec& v) {
    using Bits = std::remove_cvref_t<decltype(Mask{}[0])>;
    return reinterpret_cast<Vec>(reinterpret_cast<const Mask&>(v) & std::numeric_limits<Bits>::max());
  }
  SNUG_INLINE static bool any(const Mask& mask) {
    std::array<std::uint64_t, kBytes / 8> words;
    std::memcpy(words.data(), &mask, sizeof mask);
    std::uint64_t all = 0;
    for (const std::uint64_t word : words) all |= word;
    return all != 0;
  }

  template <class Visit>
  SNUG_INLINE static void for_each_edge_pair(Visit&& visit) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) visit(i, j);
  }

  SNUG_INLINE Mask judge_edges(std::size_t i, std::size_t j) {
    const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return judge(translation_[i2] * rotation_[i1][j] - translation_[i1] * rotation_[i2][j],
                 half_a_[i1] * size_[i2][j] + half_a_[i2] * size_[i1][j],
                 half_b_[j1] * size_[i][j2] + half_b_[j2] * size_[i][j1]);
  }

  /// Where the axis separates the boxes they are apart; where it may, is returned.
  SNUG_INLINE Mask judge(const Vec& offset, const Vec& radius_a, const Vec& radius_b) {
    const Vec gap = magnitude(offset) - (radius_a + radius_b);
    apart_ |= gap > doubt_;
    return ~(gap < -doubt_);
  }

  Vec offset_[3], half_a_[3], half_b_[3];
  Vec translation_[3], rotation_[3][3], size_[3][3];
  Vec doubt_;
  Mask apart_{}, open_faces_{}, open_edges_{};
};

template <class Scalar, std::size_t kBytes>
SNUG_INLINE void decide(const ObbArray<Scalar>& a, const ObbArray<Scalar>& b, std::span<std::uint8_t> overlap) {
  constexpr std::size_t kCount = Lanes<Scalar, kBytes>::kCount;
  for (std::size_t first = 0; first < overlap.size(); first += kCount) {
    Group<Scalar, kBytes> group(a, b, first);
    group.faces();
    if (!group.all_apart()) group.edges();
    if (group.only_edges_open()) group.edges_but_parallel();
    for (std::size_t lane = 0; lane < kCount && first + lane < overlap.size(); ++lane) {
      const std::size_t k = first + lane;
      overlap[k] = !group.is_apart(lane) && (!group.is_open(lane) || obbs_overlap(a[k], b[k]));
    }
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
ObbArray<Scalar>::ObbArray(std::span<const Obb<Scalar, 3>> boxes) : size_(boxes.size()) {
  for (auto& field : fields_) field.resize((size_ + kPadding - 1) / kPadding * kPadding);
  for (std::size_t i = 0; i < size_; ++i) set(i, boxes[i]);
}

template <class Scalar>
Obb<Scalar, 3> ObbArray<Scalar>::operator[](std::size_t i) const {
  Obb<Scalar, 3> box;
  for (std::size_t k = 0; k < 3; ++k) box.center[static_cast<int>(k)] = fields_[kCenter + k][i];
  for (std::size_t k = 0; k < 9; ++k) box.axes(static_cast<int>(k % 3), static_cast<int>(k / 3)) = fields_[kAxes + k][i];
  for (std::size_t k = 0; k < 3; ++k) box.half_extents[static_cast<int>(k)] = fields_[kHalfExtents + k][i];
  return box;
}

template <class Scalar>
void ObbArray<Scalar>::set(std::size_t i, const Obb<Scalar, 3>& box) {
  for (std::size_t k = 0; k < 3; ++k) fields_[kCenter + k][i] = box.center[static_cast<int>(k)];
  for (std::size_t k = 0; k < 9; ++k) fields_[kAxes + k][i] = box.axes(static_cast<int>(k % 3), static_cast<int>(k / 3));
  for (std::size_t k = 0; k < 3; ++k) fields_[kHalfExtents + k][i] = box.half_extents[static_cast<int>(k)];
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
