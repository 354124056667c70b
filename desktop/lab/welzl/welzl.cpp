#include "welzl.hpp"

snug::Sphere<double, 3> smallest(std::vector<snug::Vector<double, 3>> points) {
  // Up to four points support the smallest sphere. Points may be equal, lie on a line, or on one sphere.
  return {points.front(), 0};
}
