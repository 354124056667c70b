#include "quickhull.hpp"

int farthest(const std::vector<snug::Vector<double, 2>>& points, int a, int b) {
  const snug::Vector<double, 2> from = points[a];
  const snug::Vector<double, 2> edge = points[b] - from;
  int best = -1;
  double most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const snug::Vector<double, 2> to = points[i] - from;
    const double left = edge[0] * to[1] - edge[1] * to[0];
    if (left > most) best = static_cast<int>(i), most = left;
  }
  return best;
}
