// The steps of the box fitters.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The points that reach farthest to either side along each of the box's axes; lengths: the extents between them, scene
/// units.
template <class Scalar, int Dim>
struct ExtentsFound {
  static constexpr std::string_view kName = "extents_found";
  std::vector<Index> least, greatest;
  Vector<Scalar, Dim> lengths;
  SNUG_FIELDS(least, greatest, lengths);
};

/// The smallest ball around the points or, in 3-D, the smallest circle around their projection along axis.
template <class Scalar, int Dim>
struct BallFound {
  static constexpr std::string_view kName = "ball_found";
  Sphere<Scalar, Dim> ball;
  std::vector<Index> support;
  SNUG_FIELDS(ball, support);
};

/// The vertices of the convex hull, and how many facets it has.
struct HullFound {
  static constexpr std::string_view kName = "hull_found";
  std::vector<Index> vertices;
  Index facets = 0;
  SNUG_FIELDS(vertices, facets);
};

/// The hull's surface as a sum of its facets: area (2-D: length) in scene units, and its centroid.
template <class Scalar, int Dim>
struct SurfaceFound {
  static constexpr std::string_view kName = "surface_found";
  double area = 0;
  Vector<Scalar, Dim> centroid;
  SNUG_FIELDS(area, centroid);
};

/// The products of a point's offset were added to the sums that become a covariance. offset: of the point from the
/// mean, or from the origin if the mean is not known yet; sum: so far, scene units squared.
template <class Scalar, int Dim>
struct ProductsAdded {
  static constexpr std::string_view kName = "products_added";
  Index point = kNoIndex;
  bool from_mean = true;
  Vector<Scalar, Dim> offset;
  Matrix<Scalar, Dim> sum;
  SNUG_FIELDS(point, from_mean, offset, sum);
};

/// The points that were chosen: extremes along fixed directions, a base triangle, apexes, or the ends of an
/// edge.
struct PointsChosen {
  static constexpr std::string_view kName = "points_chosen";
  std::vector<Index> points;
  SNUG_FIELDS(points);
};

/// A box was tried on the named points, which determined its axes; better: whether it became the best so far.
template <class Scalar, int Dim>
struct BoxTried {
  static constexpr std::string_view kName = "box_tried";
  std::vector<Index> on;
  Obb<Scalar, Dim> box;
  double measure = 0;  // scene units squared or cubed
  bool better = false;
  SNUG_FIELDS(on, box, measure, better);
};

/// The box along a rotation that was fixed before is the smallest so far. number: of the rotation, 0 for the world's
/// axes; passed: how many before it brought no smaller box; of: how many there are besides the world's axes.
template <class Scalar, int Dim>
struct RotationTried {
  static constexpr std::string_view kName = "rotation_tried";
  Index number = 0, passed = 0, of = 0;
  Obb<Scalar, Dim> box;
  double measure = 0;  // scene units squared or cubed
  SNUG_FIELDS(number, passed, of, box, measure);
};

/// The smallest rectangle around the points' projection along a direction, with a side on the hull's edge from edge_a
/// to edge_b, and the box on that rectangle.
template <class Scalar, int Dim>
struct RectangleFound {
  static constexpr std::string_view kName = "rectangle_found";
  Vector<Scalar, Dim> along;
  Index edge_a = kNoIndex, edge_b = kNoIndex;
  Obb<Scalar, Dim> box;
  double measure = 0;
  bool better = false;
  SNUG_FIELDS(along, edge_a, edge_b, box, measure, better);
};

/// The calipers stand on an edge of the points' projection along a direction: the rectangle with a side on that edge,
/// its other sides on the named points, and the box on it. touching: begins with the edge's ends; area: the
/// rectangle's, least: that of the smallest on this projection so far, scene units squared; better: whether it is this
/// one.
template <class Scalar, int Dim>
struct CalipersTurned {
  static constexpr std::string_view kName = "calipers_turned";
  Vector<Scalar, Dim> along;
  std::vector<Index> touching;
  Obb<Scalar, Dim> box;
  double area = 0, least = 0;
  bool better = false;
  SNUG_FIELDS(along, touching, box, area, least, better);
};

/// All boxes with one face flush with the hull's edge from a to b and an adjacent face flush with a later edge were
/// searched. pairs: how many such later edges there are; ruled_out: for how many of them one bound showed that no box
/// is smaller; halvings: how often the curves of the others were halved to show it, or to find a smaller box.
struct EdgeSearched {
  static constexpr std::string_view kName = "edge_searched";
  Index a = kNoIndex, b = kNoIndex;
  Index pairs = 0, ruled_out = 0, halvings = 0;
  SNUG_FIELDS(a, b, pairs, ruled_out, halvings);
};

template <class Scalar, int Dim>
using ObbStep =
    Step<Obb<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>, AxesFound<Scalar, Dim>, PairChosen,
         ExtentsFound<Scalar, Dim>, BallFound<Scalar, Dim>, HullFound, SurfaceFound<Scalar, Dim>,
         ProductsAdded<Scalar, Dim>, PointsChosen, BoxTried<Scalar, Dim>, RectangleFound<Scalar, Dim>,
         CalipersTurned<Scalar, Dim>, EdgeSearched, Finished, RotationTried<Scalar, Dim>>;

/// What fits oriented boxes.
[[nodiscard]] std::span<const Algorithm> rows_of(const Obb<double, 3>*);

}  // namespace snug::fit
