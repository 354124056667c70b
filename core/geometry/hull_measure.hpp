// A hull's volume and surface area; in 2-D its area and perimeter.
#pragma once

#include <vector>

#include "geometry/hull.hpp"

namespace snug {

/// A piece of a hull's surface: an edge (2-D), a triangle (3-D).
template <int Dim>
struct SurfacePiece {
  double measure = 0;  // length or area, scene units or squared
  Vector<double, Dim> centroid = Vector<double, Dim>::Zero();
};

/// The hull's area (2-D) or volume (3-D), in scene units squared or cubed; 0 if it is flat. A sum of simplices at one
/// vertex, none of them negative, in plain double: good enough to rank and to display.
template <class Scalar, int Dim>
[[nodiscard]] double measure(const ConvexHull<Scalar, Dim>& hull);

/// The facets one by one. A flat hull has two sides: in 2-D a segment there and back, in 3-D a polygon twice, cut into
/// triangles at its first vertex. A segment in 3-D and a point have no pieces.
template <class Scalar, int Dim>
[[nodiscard]] std::vector<SurfacePiece<Dim>> surface_pieces(const ConvexHull<Scalar, Dim>& hull);

/// The sum of their measures: the perimeter (2-D) or the surface area (3-D).
template <class Scalar, int Dim>
[[nodiscard]] double surface_measure(const ConvexHull<Scalar, Dim>& hull);

}  // namespace snug
