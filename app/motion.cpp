#include "app/motion.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace snug::app {
namespace {

constexpr double kMotionSeconds = 0.18;

double ease_out(double t) { return 1 - std::pow(1 - t, 3); }

bool same(const fit::Sphere3& a, const fit::Sphere3& b) { return a.center == b.center && a.radius == b.radius; }
bool same(const Obb<double, 3>& a, const Obb<double, 3>& b) {
  return a.center == b.center && a.axes == b.axes && a.half_extents == b.half_extents;
}

fit::Volume3 between(const fit::Sphere3& a, const fit::Sphere3& b, double share) {
  return fit::Sphere3{a.center + (b.center - a.center) * share, a.radius + (b.radius - a.radius) * share};
}
/// Interpolates a box; the axes rotate the short way.
fit::Volume3 between(const Obb<double, 3>& a, const Obb<double, 3>& b, double share) {
  const Eigen::Quaterniond from(Eigen::Matrix3d(a.axes)), to(Eigen::Matrix3d(b.axes));
  return Obb<double, 3>{a.center + (b.center - a.center) * share, from.slerp(share, to).toRotationMatrix(),
                        a.half_extents + (b.half_extents - a.half_extents) * share};
}

/// Interpolates volumes of a kind that can be interpolated; other volumes jump.
template <class Kind>
constexpr bool kMoves = std::is_same_v<Kind, fit::Sphere3> || std::is_same_v<Kind, Obb<double, 3>>;
bool moves(const fit::Volume3& volume) {
  return std::visit([]<class Kind>(const Kind&) { return kMoves<Kind>; }, volume);
}

bool same(const fit::Volume3& a, const fit::Volume3& b) {
  return std::visit(
      [&]<class Kind>(const Kind& one) {
        const auto* other = std::get_if<Kind>(&b);
        if constexpr (kMoves<Kind>) return other != nullptr && same(one, *other);
        else return false;
      },
      a);
}

fit::Volume3 between(const fit::Volume3& a, const fit::Volume3& b, double share) {
  return std::visit(
      [&]<class Kind>(const Kind& to) -> fit::Volume3 {
        const auto* from = std::get_if<Kind>(&a);
        if constexpr (kMoves<Kind>)
          if (from != nullptr) return between(*from, to, share);
        return to;
      },
      b);
}

}  // namespace

std::optional<fit::Volume3> Motion::at(const std::optional<fit::Volume3>& target, bool jump, double now) {
  if (!target || !drawn_ || jump || !moves(*target)) {
    moving_ = false;
    to_ = drawn_ = target;
    return drawn_;
  }
  if (!to_ || !same(*target, *to_)) from_ = drawn_, to_ = target, since_ = now, moving_ = true;
  if (moving_) {
    const double t = std::clamp((now - since_) / kMotionSeconds, 0.0, 1.0);
    const double share = ease_out(t);
    drawn_ = between(*from_, *to_, share);
    if (t >= 1) moving_ = false, drawn_ = to_;
  }
  return drawn_;
}

}  // namespace snug::app
