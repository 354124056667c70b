// A wrong test, kept for those who might invent it: boxes overlap if a vertex of one lies in the other.
// It never calls boxes overlapping that are apart, but calls boxes apart that cross with all vertices outside.
#pragma once

#include <array>
#include <string_view>

#include "query/contain/contains.hpp"
#include "query/exhibits/wrong_steps.hpp"
#include "trace/observer.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 4> kCornersOnlyPseudocode{
    "for each vertex of A and of B",
    "  is it in the other box?",
    "  if so: overlap",
    "apart (wrong if the boxes cross)",
};

/// The answer of the wrong test. a, b: as for obb_sat.
template <class Scalar, int Dim, StepObserver<WrongStep> Observer = Ignore>
bool corners_only(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b, Observer&& observe = {}) {
  for (int box = 0; box < 2; ++box) {
    const Obb<Scalar, Dim>& own = box == 0 ? a : b;
    for (int bits = 0; bits < 1 << Dim; ++bits) {
      Vector<Scalar, Dim> corner = own.center;
      for (int axis = 0; axis < Dim; ++axis)
        corner += own.axes.col(axis) * ((bits >> axis & 1) != 0 ? own.half_extents[axis] : -own.half_extents[axis]);
      const bool inside = contains(box == 0 ? b : a, corner);
      observe.count(Operation::kDotProducts, Dim);
      if constexpr (kWatched<Observer>) observe(WrongStep{1, CornerTried{box, bits, inside}});
      if (!inside) continue;
      observe(WrongStep{2, Claimed{true}});
      return true;
    }
  }
  observe(WrongStep{3, Claimed{false}});
  return false;
}

}  // namespace snug::query
