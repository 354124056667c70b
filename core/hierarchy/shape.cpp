#include "hierarchy/shape.hpp"

namespace snug::hierarchy {

Shape shape_of(const std::vector<std::array<Index, 2>>& pairs, Index bodies, Index root) {
  Shape shape;
  if (root == kNoIndex) return shape;
  struct Place {
    Index group, node;
  };
  shape.nodes.reserve(2 * static_cast<std::size_t>(bodies) - 1);
  shape.bodies.reserve(bodies);
  shape.nodes.emplace_back();
  std::vector<Place> open{{root, 0}};
  while (!open.empty()) {
    const Place place = open.back();
    open.pop_back();
    ShapeNode& node = shape.nodes[place.node];
    if (place.group < bodies) {
      node = {static_cast<Index>(shape.bodies.size()), 1};
      shape.bodies.push_back(place.group);
      continue;
    }
    const auto left = static_cast<Index>(shape.nodes.size());
    node.first = left;
    const auto& [first, second] = pairs[place.group - bodies];
    open.push_back({second, left + 1});
    open.push_back({first, left});
    shape.nodes.resize(shape.nodes.size() + 2);
  }
  return shape;
}

}  // namespace snug::hierarchy
