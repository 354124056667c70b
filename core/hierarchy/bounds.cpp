#include "hierarchy/bounds.hpp"

namespace snug::hierarchy {

void normalize(Layout& layout) {
  if (layout.boxes.empty()) return;
  Box scene = layout.boxes.front();
  for (const Box& box : layout.boxes) scene = united(scene, box);
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, scene.high[i] - scene.low[i]);
  const int exponent = largest > 0 ? std::max(std::ilogb(largest), -1000) : 0;  // so that the inverse is finite
  layout.origin = scene.low;
  layout.unit = std::ldexp(1.0, exponent);
  const double inverse = std::ldexp(1.0, -exponent);
  for (Box& box : layout.boxes)
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = (box.low[i] - scene.low[i]) * inverse;
      box.high[i] = (box.high[i] - scene.low[i]) * inverse;
    }
}

}  // namespace snug::hierarchy
