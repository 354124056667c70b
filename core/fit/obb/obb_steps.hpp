// The steps of the box fitters.
#pragma once

#include <string_view>
#include <vector>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/obb.hpp"
#include "geometry/sphere.hpp"

namespace snug::fit {

/// The points that reach farthest to either side along each of the box's axes; lengths: from one to the other, scene
/// units.
template <class Scalar, int Dim>
struct ExtentsFound {
  static constexpr std::string_view kName = "extents_found";
  std::vector<Index> least, greatest;
  Vector<Scalar, Dim> lengths;
  void fields(auto&& see) const { see("least", least), see("greatest", greatest), see("lengths", lengths); }
};

/// The smallest ball around the points, or in 3-D also the smallest circle around what they cast along axis.
template <class Scalar, int Dim>
struct BallFound {
  static constexpr std::string_view kName = "ball_found";
  Sphere<Scalar, Dim> ball;
  std::vector<Index> support;
  void fields(auto&& see) const { see("ball", ball), see("support", support); }
};

/// The vertices of the convex hull, and how many facets it has.
struct HullFound {
  static constexpr std::string_view kName = "hull_found";
  std::vector<Index> vertices;
  Index facets = 0;
  void fields(auto&& see) const { see("vertices", vertices), see("facets", facets); }
};

/// The hull's surface as a sum of its facets: area (2-D: length) in scene units, and its centroid.
template <class Scalar, int Dim>
struct SurfaceFound {
  static constexpr std::string_view kName = "surface_found";
  double area = 0;
  Vector<Scalar, Dim> centroid;
  void fields(auto&& see) const { see("area", area), see("centroid", centroid); }
};

/// The points of the set that a step is about: extreme along fixed directions, a base triangle, apexes, ends of an
/// edge.
struct PointsChosen {
  static constexpr std::string_view kName = "points_chosen";
  std::vector<Index> points;
  void fields(auto&& see) const { see("points", points); }
};

/// A box was tried on the points named, which gave it its axes; better: whether it became the best so far.
template <class Scalar, int Dim>
struct BoxTried {
  static constexpr std::string_view kName = "box_tried";
  std::vector<Index> on;
  Obb<Scalar, Dim> box;
  double measure = 0;  // scene units squared or cubed
  bool better = false;
  void fields(auto&& see) const { see("on", on), see("box", box), see("measure", measure), see("better", better); }
};

/// The smallest rectangle around what the points cast along a direction, with a side on the hull's edge from edge_a to
/// edge_b, and the box on it.
template <class Scalar, int Dim>
struct RectangleFound {
  static constexpr std::string_view kName = "rectangle_found";
  Vector<Scalar, Dim> along;
  Index edge_a = kNoIndex, edge_b = kNoIndex;
  Obb<Scalar, Dim> box;
  double measure = 0;
  bool better = false;
  void fields(auto&& see) const {
    see("along", along), see("edge_a", edge_a), see("edge_b", edge_b), see("box", box), see("measure", measure),
        see("better", better);
  }
};

/// All boxes with one face on the hull's edge from a to b and an adjacent face on a later edge were gone through.
/// pairs: how many such edges there are; ruled_out: for how many one bound showed that no box is smaller; halvings: how
/// often the others' turns were halved to show it, or to find a smaller box.
struct EdgeSearched {
  static constexpr std::string_view kName = "edge_searched";
  Index a = kNoIndex, b = kNoIndex;
  Index pairs = 0, ruled_out = 0, halvings = 0;
  void fields(auto&& see) const {
    see("a", a), see("b", b), see("pairs", pairs), see("ruled_out", ruled_out), see("halvings", halvings);
  }
};

template <class Scalar, int Dim>
using ObbStep =
    Step<Obb<Scalar, Dim>, MeanFound<Scalar, Dim>, CovarianceFound<Scalar, Dim>, AxesFound<Scalar, Dim>, PairChosen,
         ExtentsFound<Scalar, Dim>, BallFound<Scalar, Dim>, HullFound, SurfaceFound<Scalar, Dim>, PointsChosen,
         BoxTried<Scalar, Dim>, RectangleFound<Scalar, Dim>, EdgeSearched, Finished>;

}  // namespace snug::fit
