// Links LinearMath (Debian's libbullet-dev).
#include "bench/peers/bullet_hull.hpp"

#include <bullet/LinearMath/btConvexHullComputer.h>

namespace snug::bench {

int bullet_vertices(PointSpan<double, 3> points) {
  btConvexHullComputer hull;
  hull.compute(points.begin()->data(), sizeof(double) * 3, points.size(), 0, 0);
  return hull.vertices.size();
}

}  // namespace snug::bench
