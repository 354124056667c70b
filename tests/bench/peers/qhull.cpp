// Links qhull_r (Debian's libqhull-dev).
#include "bench/peers/qhull.hpp"

#include <string>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace snug::bench {

int qhull_vertices(PointSpan<double, 3> points, const char* options) {
  qhT qhull;
  qh_zero(&qhull, stderr);
  std::string command = std::string("qhull ") + options;
  // It only reads the points, but takes them as its own.
  auto* coordinates = const_cast<coordT*>(points.begin()->data());
  const int failed = qh_new_qhull(&qhull, 3, points.size(), coordinates, 0, command.data(), nullptr, stderr);
  const int vertices = failed != 0 ? -1 : qhull.num_vertices;
  qh_freeqhull(&qhull, !qh_ALL);
  int current = 0, total = 0;
  qh_memfreeshort(&qhull, &current, &total);
  return vertices;
}

}  // namespace snug::bench
