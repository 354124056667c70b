// Pairs of oriented boxes that tests share, in families named by what is hard about them.
#pragma once

#include "geometry/obb.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"

namespace snug::test {

template <class Scalar, int Dim>
struct BoxPair {
  Obb<Scalar, Dim> a, b;
};

template <int Dim>
Vector<double, Dim> any_vector(Random& random, double size = 1) {
  Vector<double, Dim> v;
  for (int i = 0; i < Dim; ++i) v[i] = random.between(-size, size);
  return v;
}

template <int Dim>
Matrix<double, Dim> any_turn(Random& random, double most = 3.2) {
  if constexpr (Dim == 2) return turn(random.between(-most, most));
  else {
    const Vector<double, 3> axis = any_vector<3>(random);
    return turn(axis, random.between(-most, most));
  }
}

template <class Scalar, int Dim>
Obb<Scalar, Dim> any_box(Random& random, double spread, double least = 0.2, double most = 1) {
  Obb<Scalar, Dim> box;
  for (int i = 0; i < Dim; ++i) {
    box.center[i] = static_cast<Scalar>(random.between(-spread, spread));
    box.half_extents[i] = static_cast<Scalar>(random.between(least, most));
  }
  box.axes = any_turn<Dim>(random).template cast<Scalar>();
  return box;
}

/// What may be hard about a pair's orientations.
enum class Orientation { kAny, kSharedAxis, kPermuted, kTilted, kSame, kCrooked };
inline constexpr int kOrientations = 6;
/// And about its extents.
enum class Extents { kAny, kMixed, kSlivers, kFlats, kLines, kPoints };
inline constexpr int kExtents = 6;

/// One pair of a family. gap: between the places brought together; none: the centres are anywhere.
template <class Scalar, int Dim>
BoxPair<Scalar, Dim> pair_of(Orientation orientation, Extents extents, double gap, double offset, Random& random);

}  // namespace snug::test
