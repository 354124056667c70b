// Volumes of every kind, and pairs of them at a distance that is known.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "geometry/volume.hpp"
#include "query/distance/support_function.hpp"

namespace snug::test {

/// What a volume is made of: size of about 1, or flat, or a point; slabs that touch nothing.
enum class Make { kSolid, kFlat, kPoint, kLoose };

/// Volumes around the origin, of every kind.
template <class Scalar, int Dim>
class VolumeMaker {
 public:
  using Point = Vector<Scalar, Dim>;

  explicit VolumeMaker(std::uint64_t seed) : random(seed) {}

  Random random;

  Scalar between(double low, double high) { return static_cast<Scalar>(random.between(low, high)); }
  Point any(double size = 1) {
    Point p;
    for (int i = 0; i < Dim; ++i) p[i] = between(-size, size);
    return p;
  }
  Vector<double, Dim> direction() {
    for (;;) {
      const Vector<double, Dim> v = any().template cast<double>();
      if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
    }
  }
  Matrix<Scalar, Dim> axes() {
    if constexpr (Dim == 2) return turn(random.between(-4, 4)).template cast<Scalar>();
    else return turn(direction(), random.between(-4, 4)).template cast<Scalar>();
  }

  Volume<Scalar, Dim> make(std::size_t kind, Make how) {
    switch (kind) {
      case 0: return Sphere<Scalar, Dim>{any(), how == Make::kPoint ? Scalar(0) : between(0.2, 1)};
      case 1: return aabb(how);
      case 2: return Obb<Scalar, Dim>{any(), axes(), extents(how)};
      case 3: return capsule(how);
      case 4: return lozenge(how);
      case 5: return kdop(how);
      default: return ConvexHull<Scalar, Dim>{.vertices = points(how)};
    }
  }

  Kdop<Scalar, Dim> kdop_of(int k, const std::vector<Point>& cloud) {
    Kdop<Scalar, Dim> kdop{.k = k};
    const auto axes = kdop_axes<Dim>(k);
    for (std::size_t i = 0; i < axes.size(); ++i)
      for (const Point& p : cloud) {
        Scalar along = 0;
        for (std::size_t j = 0; j < Dim; ++j) along += static_cast<Scalar>(axes[i][j]) * p[static_cast<int>(j)];
        kdop.min[i] = &p == cloud.data() ? along : std::min(kdop.min[i], along);
        kdop.max[i] = &p == cloud.data() ? along : std::max(kdop.max[i], along);
      }
    return kdop;
  }
  int any_k() {
    if constexpr (Dim == 2) return std::array{4, 6, 8}[random.below(3)];
    else return std::array{6, 14, 18, 26}[random.below(4)];
  }

 private:
  Scalar extent(Make how, int i) {
    return how == Make::kPoint || (how == Make::kFlat && i == 0) ? Scalar(0) : between(0.2, 1);
  }
  Point extents(Make how) {
    Point e;
    for (int i = 0; i < Dim; ++i) e[i] = extent(how, i);
    return e;
  }
  Aabb<Scalar, Dim> aabb(Make how) {
    const Point center = any(), half = extents(how);
    return {center - half, center + half};
  }
  Capsule<Scalar, Dim> capsule(Make how) {
    const Point a = any();
    return {a, how == Make::kPoint ? a : any(),
            how == Make::kFlat || how == Make::kPoint ? Scalar(0) : between(0.2, 1)};
  }
  Lozenge<Scalar, Dim> lozenge(Make how) {
    const Matrix<Scalar, Dim> turned = axes();
    return {any(),
            {Point(turned.col(0) * extent(how, 0)), Point(turned.col(1) * extent(how, 1))},
            how == Make::kFlat || how == Make::kPoint ? Scalar(0) : between(0.2, 1)};
  }
  std::vector<Point> points(Make how) {
    std::vector<Point> cloud;
    const int count = how == Make::kPoint ? 1 : how == Make::kFlat ? Dim : 8;
    for (int i = 0; i < count; ++i) cloud.push_back(any());
    if (how == Make::kSolid || how == Make::kLoose)  // so that it is surely solid
      for (int i = 0; i < Dim; ++i)
        for (const Scalar side : {Scalar(-0.2), Scalar(0.2)}) cloud.push_back(Point::Unit(i) * side);
    return cloud;
  }
  Kdop<Scalar, Dim> kdop(Make how) {
    Kdop<Scalar, Dim> kdop = kdop_of(any_k(), points(how));
    if (how != Make::kLoose) return kdop;
    const std::size_t slab = random.below(static_cast<std::uint32_t>(kdop.k / 2));
    kdop.max[slab] += 9;
    if (random.below(2) == 0) kdop.min[slab] -= 9;
    return kdop;
  }
};

/// The volume, moved; each coordinate is rounded.
template <class Scalar, int Dim>
Volume<Scalar, Dim> moved(Volume<Scalar, Dim> volume, const Vector<double, Dim>& by) {
  using Point = Vector<Scalar, Dim>;
  const auto move = [&](Point& p) { p = (p.template cast<double>() + by).template cast<Scalar>(); };
  struct {
    const decltype(move)& to;
    const Vector<double, Dim>& by;
    void operator()(Sphere<Scalar, Dim>& v) const { to(v.center); }
    void operator()(Aabb<Scalar, Dim>& v) const { to(v.min), to(v.max); }
    void operator()(Obb<Scalar, Dim>& v) const { to(v.center); }
    void operator()(Capsule<Scalar, Dim>& v) const { to(v.a), to(v.b); }
    void operator()(Lozenge<Scalar, Dim>& v) const { to(v.origin); }
    void operator()(ConvexHull<Scalar, Dim>& v) const {
      for (auto& p : v.vertices) to(p);
    }
    void operator()(Kdop<Scalar, Dim>& v) const {
      const auto axes = kdop_axes<Dim>(v.k);
      for (std::size_t i = 0; i < axes.size(); ++i) {
        double along = 0;
        for (std::size_t j = 0; j < Dim; ++j) along += axes[i][j] * by[static_cast<int>(j)];
        v.min[i] = static_cast<Scalar>(static_cast<double>(v.min[i]) + along);
        v.max[i] = static_cast<Scalar>(static_cast<double>(v.max[i]) + along);
      }
    }
  } const mover{move, by};
  std::visit(mover, volume);
  return volume;
}

/// The volume with all lengths times a power of two.
template <class Scalar, int Dim>
Volume<Scalar, Dim> scaled(Volume<Scalar, Dim> volume, Scalar by) {
  struct {
    Scalar by;
    void operator()(Sphere<Scalar, Dim>& v) const { v.center *= by, v.radius *= by; }
    void operator()(Aabb<Scalar, Dim>& v) const { v.min *= by, v.max *= by; }
    void operator()(Obb<Scalar, Dim>& v) const { v.center *= by, v.half_extents *= by; }
    void operator()(Capsule<Scalar, Dim>& v) const { v.a *= by, v.b *= by, v.radius *= by; }
    void operator()(Lozenge<Scalar, Dim>& v) const {
      v.origin *= by, v.edges[0] *= by, v.edges[1] *= by, v.radius *= by;
    }
    void operator()(ConvexHull<Scalar, Dim>& v) const {
      for (auto& p : v.vertices) p *= by;
    }
    void operator()(Kdop<Scalar, Dim>& v) const {
      for (auto* bounds : {&v.min, &v.max})
        for (Scalar& bound : *bounds) bound *= by;
    }
  } const scaler{by};
  std::visit(scaler, volume);
  return volume;
}

template <class Scalar, int Dim>
Vector<double, Dim> support_of(const Volume<Scalar, Dim>& volume, const Vector<double, Dim>& direction) {
  return std::visit(
      [&](const auto& v) {
        return Vector<double, Dim>(query::support(v, direction.template cast<Scalar>().eval()).template cast<double>());
      },
      volume);
}

/// The largest coordinate of a volume near the origin or far from it.
template <class Scalar, int Dim>
double reach(const Volume<Scalar, Dim>& volume) {
  double most = 0;
  for (int i = 0; i < Dim; ++i)
    for (const double side : {-1.0, 1.0})
      most = std::max(most, std::abs(support_of<Scalar, Dim>(volume, side * Vector<double, Dim>::Unit(i))[i]));
  return most;
}

/// b moved so that it faces a along a direction across a gap: the plane between them proves the distance, and the two
/// supporting points attain it. Where the gap is negative, a supporting point of b lies as deep inside a, on the way to
/// its middle.
template <class Scalar, int Dim>
Volume<Scalar, Dim> put_at(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, const Vector<double, Dim>& n,
                           double gap) {
  const Vector<double, Dim> on_a = support_of<Scalar, Dim>(a, n);
  const Vector<double, Dim> on_b = support_of<Scalar, Dim>(b, -n);
  if (gap >= 0) return moved<Scalar, Dim>(b, on_a + gap * n - on_b);
  Vector<double, Dim> middle = Vector<double, Dim>::Zero();
  for (int i = 0; i < Dim; ++i)
    for (const double side : {-1.0, 1.0})
      middle += support_of<Scalar, Dim>(a, side * Vector<double, Dim>::Unit(i)) / (2 * Dim);
  return moved<Scalar, Dim>(b, on_a + (middle - on_a) * (-gap / (middle - on_a).norm()) - on_b);
}

}  // namespace snug::test
