// shadow: each body's shadow on the ground, as a convex polygon. Vertices are exact; a radius is approximated by a
// number of points.
#include <numbers>

#include "fit/hull/quickhull.hpp"
#include "geometry/turn.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

constexpr int kOutline = 24;

/// The hull of points on the ground. Empty if the light projects them farther than numbers reach.
std::vector<V3> hull_on_ground(const std::vector<V3>& points) {
  std::vector<Vector<double, 2>> from_above;
  for (const V3& p : points) from_above.emplace_back(p[2], p[0]);
  const auto set = PointSet<double, 2>::make(std::move(from_above));
  std::vector<V3> hull;
  if (!set) return hull;
  for (const Index i : fit::quickhull<double, 2>(set->span()).volume.indices) hull.push_back(points[i]);
  return hull;
}

class Shadow final : public Effect {
 public:
  Shadow(std::vector<std::size_t> bodies, const V3& light, double ground)
      : bodies_(std::move(bodies)), light_(light), ground_(ground) {
    across_ = light_.cross(V3::Unit(std::abs(light_[0]) < std::abs(light_[1]) ? 0 : 1));
    across_ /= across_.norm();
  }

  void run(World& world) override {
    world.state.shadows.resize(world.size());
    for (const std::size_t i : bodies_) world.state.shadows[i] = of(world.members[i].shape, world.bodies[i]);
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
        points.push_back(on_ground(
            at + shape.radius * turned<double, 3>(turn(light_, 2 * std::numbers::pi * k / kOutline), across_)));
    }
    return hull_on_ground(points);
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
  if (!(light[1] <= -1e-12)) settings.refuse("the light does not come from above");
  return settings.make<Shadow>(std::move(bodies), light, ground);
}

}  // namespace snug::scene
