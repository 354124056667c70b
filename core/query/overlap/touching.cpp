#include "query/overlap/touching.hpp"

#include "geometry/aabb_forms.hpp"
#include "number/dyadic.hpp"
#include "query/overlap/exact_gap.hpp"
#include "query/overlap/overlaps_spheres.hpp"

namespace snug::query {
namespace {

Dyadic exact(auto value) { return static_cast<double>(value); }

template <class Scalar, int Dim>
bool touching(const Sphere<Scalar, Dim>& a, const Sphere<Scalar, Dim>& b) {
  const Dyadic radii = exact(a.radius) + exact(b.radius);
  Dyadic square = -(radii * radii);
  for (int i = 0; i < Dim; ++i) {
    const Dyadic between = exact(b.center[i]) - exact(a.center[i]);
    square += between * between;
  }
  return square.sign() == 0;
}

/// The box's point nearest to the centre has the coordinates of both: it does not round.
template <class Scalar, int Dim>
bool touching(const Sphere<Scalar, Dim>& sphere, const Aabb<Scalar, Dim>& box) {
  const Vector<Scalar, Dim>& center = sphere.center;
  const bool deep = (box.min.array() < center.array()).all() && (center.array() < box.max.array()).all();
  return !deep && touching(sphere, Sphere<Scalar, Dim>{nearest_of(box, center), 0});
}

template <class Scalar, int Dim>
bool touching(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  bool touch = false;
  for (int i = 0; i < Dim; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
    touch = touch || a.max[i] == b.min[i] || b.max[i] == a.min[i];
  }
  return touch;
}

template <class Scalar, int Dim>
bool touching(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  return touch_exactly(a, b);
}

/// The box by its centre and half extents, if neither rounds.
template <class Scalar, int Dim>
std::optional<Obb<Scalar, Dim>> as_obb(const Aabb<Scalar, Dim>& box) {
  const auto [middle, extents] = center_extents_of(box);
  const Obb<Scalar, Dim> result{middle, Matrix<Scalar, Dim>::Identity(), extents};
  for (int i = 0; i < Dim; ++i) {
    const Dyadic center = exact(result.center[i]), half = exact(result.half_extents[i]);
    if (!(center - half == exact(box.min[i]) && center + half == exact(box.max[i]))) return std::nullopt;
  }
  return result;
}

template <class Scalar, int Dim>
std::optional<bool> touching(const Aabb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  const auto box = as_obb(a);
  return box ? std::optional(touch_exactly(*box, b)) : std::nullopt;
}

}  // namespace

template <class Scalar, int Dim>
std::optional<bool> touch(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit(
      [](const auto& x, const auto& y) -> std::optional<bool> {
        if constexpr (requires { touching(x, y); }) return touching(x, y);
        else if constexpr (requires { touching(y, x); }) return touching(y, x);
        else return std::nullopt;
      },
      a, b);
}

template std::optional<bool> touch(const Volume<float, 2>&, const Volume<float, 2>&);
template std::optional<bool> touch(const Volume<float, 3>&, const Volume<float, 3>&);
template std::optional<bool> touch(const Volume<double, 2>&, const Volume<double, 2>&);
template std::optional<bool> touch(const Volume<double, 3>&, const Volume<double, 3>&);

}  // namespace snug::query
