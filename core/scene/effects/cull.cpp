// cull: tests each body's AABB against a camera's view frustum.
#include "query/cull/classify.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Cull final : public Effect {
 public:
  explicit Cull(const Frustum<double, 3>& frustum) : frustum_(frustum) {}

  void run(World& world) override {
    State& state = world.state;
    std::vector<std::uint8_t> seen;
    for (const auto& box : state.volumes)
      seen.push_back(static_cast<std::uint8_t>(query::classify(frustum_, box).verdict));
    if (seen == state.visibility) return;
    state.visibility = std::move(seen);
    state.changed(Slot::kVisibility);
  }

 private:
  Frustum<double, 3> frustum_;
};

/// The axes of a camera that looks in a direction, as columns: right, up and back, with y as far up as possible.
Matrix<double, 3> axes_looking(const V3& way) {
  Matrix<double, 3> axes;
  axes.col(2) = -way / way.norm();
  const V3 right = V3::UnitY().cross(axes.col(2));
  axes.col(0) = right == V3::Zero() ? V3(V3::UnitX()) : V3(right / right.norm());
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

}  // namespace

MadeEffect make_cull(const EffectCall& call, World& world) {
  Settings settings(call, world);
  FrustumCamera<double, 3> camera;
  camera.position = settings.vector("from", V3(0, 2, 8));
  const V3 way = settings.vector("at", V3::Zero()) - camera.position;
  camera.half_tangents = Vector<double, 2>::Constant(settings.number("half_tangent", 0.5, 1e-3, 1e3));
  camera.near = settings.number("near", 0.1, 1e-9, 1e9);
  camera.far = settings.number("far", 100, 1e-9, 1e9);
  if (way == V3::Zero()) settings.refuse("\"at\" is the camera's own position");
  else camera.axes = axes_looking(way);
  const auto frustum = frustum_of_camera(camera);
  if (!frustum) settings.refuse(frustum.error().what);
  else world.camera = *frustum;
  return settings.make<Cull>(frustum ? *frustum : Frustum<double, 3>());
}

}  // namespace snug::scene
