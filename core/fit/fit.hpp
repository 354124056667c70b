// What every fitter returns.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <variant>
#include <vector>

#include "geometry/point_set.hpp"
#include "geometry/sphere.hpp"
#include "geometry/vector.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// A few points of the set, by index, without memory of its own: at most Dim + 1 support a ball, and one may enter.
class Support {
 public:
  constexpr Support() = default;
  constexpr Support(std::initializer_list<Index> indices) {
    for (const Index i : indices) add(i);
  }
  constexpr void add(Index i) { indices_[size_++] = i; }
  [[nodiscard]] constexpr int size() const { return size_; }
  [[nodiscard]] constexpr Index operator[](int i) const { return indices_[i]; }
  [[nodiscard]] std::vector<Index> list() const { return {begin(), end()}; }
  [[nodiscard]] constexpr const Index* begin() const { return indices_.data(); }
  [[nodiscard]] constexpr const Index* end() const { return indices_.data() + size_; }
  [[nodiscard]] constexpr bool contains(Index i) const {
    for (const Index own : *this)
      if (own == i) return true;
    return false;
  }

 private:
  std::array<Index, 5> indices_{};
  int size_ = 0;
};

/// The number of points that support a volume is bounded for a ball alone.
template <class Volume>
struct SupportOf {
  using Type = std::vector<Index>;
};
template <class Scalar, int Dim>
struct SupportOf<Sphere<Scalar, Dim>> {
  using Type = Support;
};

/// A volume that contains every point, and the points that support it (that touch it). Nothing that can be recomputed.
template <class Volume>
struct Fit {
  Volume volume;
  typename SupportOf<Volume>::Type support;
};

/// One step of an algorithm that fits such volumes: what happened, and the volume as it then stands.
template <class VolumeType, class... Facts>
struct Step {
  using Volume = VolumeType;
  using Fact = std::variant<Facts...>;
  int line = 0;             // of the algorithm's pseudocode, counted from 0
  bool has_volume = false;  // whether there is a volume yet
  Volume volume;            // as it stands after this step
  Fact fact;
};

/// A row of the catalogue (fit/catalogue.hpp). Beside its step, each kind of volume declares rows_of, its own.
struct Algorithm;

/// What a caller may choose; each fitter takes what it knows.
struct Options {
  std::uint64_t seed = 1;  // of the random orders
};

}  // namespace snug::fit
