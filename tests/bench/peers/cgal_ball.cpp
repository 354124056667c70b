#include "bench/peers/cgal_ball.hpp"

#include <CGAL/Min_sphere_of_spheres_d.h>

namespace snug::bench {
namespace {

/// Our points as spheres of radius 0, read in place.
struct Traits {
  using Sphere = Vector<double, 3>;
  static const int D = 3;
  using FT = double;
  using Use_square_roots = CGAL::Tag_true;
  using Algorithm = CGAL::Default_algorithm;
  using Cartesian_const_iterator = const double*;

  FT radius(const Sphere&) const { return 0; }
  Cartesian_const_iterator center_cartesian_begin(const Sphere& sphere) const { return sphere.data(); }
};

}  // namespace

double cgal_ball_radius(PointSpan<double, 3> points) {
  return CGAL::Min_sphere_of_spheres_d<Traits>(points.begin(), points.end()).radius();
}

}  // namespace snug::bench
