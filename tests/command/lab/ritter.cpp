#include "ritter.hpp"

snug::Sphere<double, 3> grow(const snug::Sphere<double, 3>& sphere, const snug::Vector<double, 3>& point) {
  const snug::Vector<double, 3> to = point - sphere.center;
  const double distance = to.norm();
  if (distance <= sphere.radius) return sphere;
  const double radius = (sphere.radius + distance) / 2;
  return {sphere.center + to * ((radius - sphere.radius) / distance), radius};
}
