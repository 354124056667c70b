// The proof of a box, from the returned numbers and the points alone; and what it touches.
#pragma once

#include <vector>

#include "fit/certify.hpp"
#include "geometry/obb.hpp"

namespace snug::fit {

/// on_boundary: the axes are unit, perpendicular and right-handed, every support point lies on a face and every face
/// has one, all within rounding. lower_bound: no box of a smaller measure holds the points, scene units squared or
/// cubed; worked out (in 3-D by going through all pairs of the hull's edges, as long as the fit took) where
/// claims_optimal, else 0. Where the measure over- or underflows so does it; excess, then measure / lower_bound
/// - 1, does not.
template <class Scalar, int Dim>
[[nodiscard]] Certificate certify(const Fit<Obb<Scalar, Dim>>& fit, PointSpan<Scalar, Dim> points, bool claims_optimal);

/// The points on one face of a box, within rounding.
struct FaceContact {
  int axis = 0;
  bool upper = false;         // on the side that the axis points to
  std::vector<Index> points;  // by rising index
  int affine_dim = kNoIndex;  // 0: in one place, 1: on a line, 2: neither, -1: there is none

  /// Whether the hull has an edge or a face there.
  [[nodiscard]] bool has_edge() const { return affine_dim >= 1; }
};

/// For each axis the lower, then the upper face.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<FaceContact> contacts(const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points);

/// What is necessary of a smallest box: two adjacent faces with an edge of the hull each; in 2-D one side with an edge.
/// Sources: J. O'Rourke, "Finding minimal enclosing boxes", 1985; H. Freeman, R. Shapira, 1975.
template <int Dim>
[[nodiscard]] bool on_edges(const std::vector<FaceContact>& contacts);

}  // namespace snug::fit
