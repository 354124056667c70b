// Whether one volume holds all of another of its kind, in rationals and from what the volumes are said to be in their
// headers: the oracle of merging and of trees.
#pragma once

#include "geometry/volume.hpp"

namespace snug::exact {

/// Both: of one kind and not empty; of two k-DOPs the outer one's slabs are all among the inner one's.
template <int Dim>
bool holds(const Volume<double, Dim>& outer, const Volume<double, Dim>& inner);

/// The same numbers in double, which has them all.
template <class Scalar, int Dim>
Volume<double, Dim> in_double(const Volume<Scalar, Dim>& volume);

template <class Scalar, int Dim>
bool holds(const Volume<Scalar, Dim>& outer, const Volume<Scalar, Dim>& inner) {
  return holds<Dim>(in_double(outer), in_double(inner));
}

}  // namespace snug::exact
