// What a fitter's step shows besides its volume.
#pragma once

#include <array>

#include "app/shown.hpp"
#include "lesson/subjects/cloud/certificate_lines.hpp"
#include "lesson/subjects/cloud/hull_growth.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"

namespace snug::app {

struct CloudShown : Shown {
  std::optional<fit::Volume3> before;     // the volume that this step replaced
  std::optional<fit::Volume3> candidate;  // a volume that this step tried, if it is not the current one
  bool candidate_fails = false;
  Index left_outside = kNoIndex;  // the point that the candidate leaves outside

  fit::Support forced;  // the part of the support set that Welzl's recursion has forced onto the boundary
  int depth = 0;

  bool examined_outside = false;
  double outside_by = 0;  // for the examined point; < 0 inside, scene units

  struct Extremes {
    std::array<Index, 3> least, greatest;
  };
  std::optional<Extremes> extremes;
  struct Box {
    Point3 least, greatest, midpoint;
  };
  std::optional<Box> box;
  struct Slab {
    int number = 0;                         // counted from 1
    Point3 direction;                       // across it, unit
    double least = 0, greatest = 0;         // its planes' places along that, scene units
    Index low = kNoIndex, high = kNoIndex;  // the points on them
    std::string axis;                       // "x+y"
  };
  std::optional<Slab> slab;
  std::optional<fit::PairChosen> pair;  // the first diameter
  std::optional<Point3> mean;
  struct Spread {
    Matrix<double, 3> axes;  // columns, by rising sigma
    Point3 sigma;            // standard deviations, scene units
    bool named = false;      // whether the axes have been found
    bool ends = false;       // whether the extreme points along the main axis have been found
  };
  std::optional<Spread> spread;
  std::vector<Index> hull;                     // its vertices, if a box fitter has computed them
  std::optional<fit::Volume3> hull_solid;      // the same hull, in space
  std::vector<std::array<Index, 2>> built_on;  // its edges that a box was built on
  struct Products {
    Index point = kNoIndex;
    Point3 from;  // the mean or the origin
  };
  std::optional<Products> products;  // the point whose products a step adds to the sums
  std::optional<Point3> along;       // in space, the direction along which the points were projected for a rectangle
  std::vector<Index> calipers;       // on that projection, the points that the calipers touch
  std::optional<Obb<double, 3>> smallest;  // on the smallest rectangle of that projection so far, if it is not this one
  std::optional<fit::BallGrown<double, 3>> grown;       // how this step let a sphere grow
  std::optional<lesson::GrowingHull> growing;           // the hull that Quickhull has so far
  std::optional<lesson::LeftOutside> left;              // what a finished sphere leaves outside, if anything
  std::vector<Index> wrong;                             // the points that this step's rounded tests are wrong about
  std::optional<lesson::CertificateLines> certificate;  // of a finished sphere, where a naive method is offered
  std::vector<std::pair<Index, Index>> flat;            // the edges between its coplanar facets, where they are merged
};

/// want_optimum: as for shown_at.
[[nodiscard]] CloudShown cloud_shown_at(const lesson::Session& session, bool want_optimum);
/// Whether what the lesson compares with is the method on the stage itself, and not proven to be the best: then there
/// is nothing to show beside it.
[[nodiscard]] bool is_itself(const lesson::Method& reference, const lesson::Session& session);

}  // namespace snug::app
