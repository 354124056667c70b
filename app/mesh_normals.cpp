#include "app/mesh_normals.hpp"

#include <Eigen/Geometry>

namespace snug::app {

std::vector<Vector<float, 3>> mesh_normals(std::span<const Vector<float, 3>> points,
                                           std::span<const std::array<Index, 3>> triangles) {
  using V3f = Vector<float, 3>;
  std::vector<V3f> normals(points.size(), V3f::Zero());
  const auto point = [&](Index i) { return points[i]; };
  for (const auto& [a, b, c] : triangles) {
    const V3f normal = (point(b) - point(a)).cross(point(c) - point(a));
    for (const Index i : {a, b, c}) normals[i] += normal;
  }
  for (V3f& normal : normals) {
    const float length = normal.norm();
    if (length > 0) normal /= length;
  }
  return normals;
}

}  // namespace snug::app
