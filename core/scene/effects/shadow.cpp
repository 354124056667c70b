// Shadows on the ground: what of each body the light does not let through, as a convex polygon. Corners are exact; around a
// radius stand so many points of the outline.
#include <algorithm>
#include <numbers>

#include "geometry/turn.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

constexpr int kOutline = 24;

/// Twice the area of a, b, c as seen from above: positive where they turn left.
double turn_of(const V3& a, const V3& b, const V3& c) { return (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]); }

/// Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
std::vector<V3> hull_on_ground(std::vector<V3> points) {
  std::sort(points.begin(), points.end(), [](const V3& a, const V3& b) { return a[0] != b[0] ? a[0] < b[0] : a[2] < b[2]; });
  std::vector<V3> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t least = hull.size() + 1;
    for (const V3& p : points) {
      while (hull.size() > least && turn_of(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.empty() ? std::vector<V3>{points.front()} : hull;
}

class Shadow final : public Effect {
 public:
  Shadow(std::vector<std::size_t> bodies, const V3& light, double ground) : bodies_(std::move(bodies)), light_(light), ground_(ground) {
    across_ = light_.cross(V3::Unit(std::abs(light_[0]) < std::abs(light_[1]) ? 0 : 1));
    across_ /= across_.norm();
  }

  void run(World& world) override {
    world.state.shadows.resize(world.size());
    for (const std::size_t i : bodies_) world.state.shadows[i] = of(world.members[i].shape, world.state.bodies[i]);
    world.state.changed(Slot::kShadows);
  }

 private:
  [[nodiscard]] V3 on_ground(const V3& p) const {
    V3 foot = p + light_ * ((ground_ - p[1]) / light_[1]);
    foot[1] = ground_;
    return foot;
  }

  [[nodiscard]] std::vector<V3> of(const Shape& shape, const Motion& motion) const {
    std::vector<V3> points;
    for (const V3& corner : shape.corners) {
      const V3 at = motion.position + turned<double, 3>(motion.rotation, corner);
      for (int k = 0; k < (shape.radius > 0 ? kOutline : 1); ++k)
        points.push_back(on_ground(at + shape.radius * turned<double, 3>(turn(light_, 2 * std::numbers::pi * k / kOutline), across_)));
    }
    return hull_on_ground(std::move(points));
  }

  std::vector<std::size_t> bodies_;
  V3 light_, across_;
  double ground_;
};

}  // namespace

MadeEffect make_shadow(const EffectCall& call, World& world) {
  Settings settings(call, world);
  auto bodies = settings.bodies();
  const V3 light = settings.vector("light", V3(0.4, -1, 0.3));
  const double ground = settings.number("ground", 0, -1e9, 1e9);
  if (!(light[1] < 0)) settings.refuse("the light does not come from above");
  return settings.make<Shadow>(std::move(bodies), light, ground);
}

}  // namespace snug::scene
