// Proves an oriented box from the returned numbers and the points alone, and finds what it touches.
#pragma once

#include <vector>

#include "fit/certify.hpp"
#include "geometry/obb.hpp"

namespace snug::fit {

/// on_boundary: the axes are unit, perpendicular and right-handed, every support point lies on a face and every face
/// has one, all within rounding. lower_bound: no box of a smaller measure contains the points, scene units squared or
/// cubed. It is computed only if claims_optimal (in 3-D by going through all pairs of the hull's edges, which takes as
/// long as the fit did), and is 0 otherwise. If the measure over- or underflows, so does lower_bound; excess, which is
/// measure / lower_bound - 1, does not.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Obb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal);

/// The points on one face of a box, within rounding.
struct FaceContact {
  int axis = 0;
  bool upper = false;         // whether it is the face that the axis points to
  std::vector<Index> points;  // by rising index
  int affine_dim = kNoIndex;  // of these points. 0: all coincide, 1: they lie on a line, 2: neither, -1: there are none

  /// Whether an edge or a face of the hull is flush with this face.
  [[nodiscard]] bool has_edge() const { return affine_dim >= 1; }
};

/// The contacts of each axis's lower face, then of its upper face.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<FaceContact> contacts(const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points);

/// A necessary condition for a smallest box: two adjacent faces are each flush with an edge of the hull; in 2-D, one
/// side. Sources: J. O'Rourke, "Finding minimal enclosing boxes", 1985; H. Freeman, R. Shapira, 1975.
template <int Dim>
[[nodiscard]] bool on_edges(const std::vector<FaceContact>& contacts);

}  // namespace snug::fit
