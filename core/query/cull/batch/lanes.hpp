// Several scalars at once, in the compilers' vector types.
#pragma once

#include <cstddef>

namespace snug::query {

/// A register of as many scalars as fit in kBytes. Comparisons give all ones or all zeros in each lane.
template <class Scalar, std::size_t kBytes>
struct Lanes {
  typedef Scalar Vector __attribute__((vector_size(kBytes)));
  using Mask = decltype(Vector{} < Vector{});
  static constexpr std::size_t kCount = kBytes / sizeof(Scalar);
};

}  // namespace snug::query
