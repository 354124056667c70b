// Point sets that tests share: each named by what is hard about it.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "geometry/generate.hpp"
#include "geometry/point_set.hpp"
#include "geometry/random.hpp"

namespace snug::test {

template <class Scalar, int Dim>
using Cloud = std::vector<Vector<Scalar, Dim>>;

template <class Scalar, int Dim>
struct NamedCloud {
  std::string name;
  Cloud<Scalar, Dim> points;
};

template <class Scalar, int Dim>
PointSet<Scalar, Dim> set_of(Cloud<Scalar, Dim> points) {
  return *PointSet<Scalar, Dim>::make(std::move(points));
}

template <class Scalar, int Dim>
Cloud<Scalar, Dim> generated(const char* kind, int n, std::uint64_t seed, double scale = 1, double offset = 0) {
  Cloud<Scalar, Dim> cloud;
  const auto points = *generate(kind, n, Dim, seed);
  for (const auto& p : points) {
    Vector<Scalar, Dim> q;
    for (int i = 0; i < Dim; ++i) q[i] = static_cast<Scalar>(p[i] * scale + offset);
    cloud.push_back(q);
  }
  return cloud;
}

/// Degenerate sets of at most max_points points.
template <class Scalar, int Dim>
std::vector<NamedCloud<Scalar, Dim>> degenerate_clouds(std::uint64_t seed, int max_points) {
  using Point = Vector<Scalar, Dim>;
  Random random(seed);
  const auto coordinate = [&] { return static_cast<Scalar>(random.between(-1, 1)); };
  const auto any = [&] {
    Point p;
    for (int i = 0; i < Dim; ++i) p[i] = coordinate();
    return p;
  };
  const auto small = [&](int most) {
    return static_cast<Scalar>(static_cast<int>(random.below(2u * unsigned(most) + 1)) - most);
  };
  std::vector<NamedCloud<Scalar, Dim>> clouds;
  const auto make = [&](const char* name, auto&& point) {
    Cloud<Scalar, Dim> cloud;
    for (int i = 0; i < max_points; ++i) cloud.push_back(point());
    clouds.push_back({name, cloud});
  };
  clouds.push_back({"one point", {any()}});
  clouds.push_back({"two points", {any(), any()}});
  const Point same = any();
  make("all the same", [&] { return same; });
  const Point other = any();
  make("two places, many times", [&] { return random.below(2) == 0 ? same : other; });
  const Point direction = any();
  make("on a line", [&]() -> Point { return direction * coordinate(); });
  make("whole numbers on a line", [&] {
    Point p = Point::Zero();
    p[0] = small(5);
    p[1] = 2 * p[0];
    return p;
  });
  make("a lattice", [&] {
    Point p;
    for (int i = 0; i < Dim; ++i) p[i] = small(2);
    return p;
  });
  make("corners of a cube", [&] {
    Point p;
    for (int i = 0; i < Dim; ++i) p[i] = random.below(2) == 0 ? Scalar(-1) : Scalar(1);
    return p;
  });
  make("in a plane", [&] {
    Point p = any();
    p[Dim - 1] = p[0];
    return p;
  });
  make("near a sphere", [&] {
    Point p = any();
    while (p.squaredNorm() > 1 || p.squaredNorm() < Scalar(0.01)) p = any();
    return Point(p / p.norm());
  });
  const Point ends = any();
  make("pairs a few ulps apart", [&] {
    Point p = random.below(2) == 0 ? ends : Point(-ends);
    for (int i = 0; i < Dim; ++i)
      for (unsigned k = random.below(4); k > 0; --k) p[i] = std::nextafter(p[i], Scalar(2));
    return p;
  });
  make("support points 1e-10 apart", [&] {
    Point p = random.below(2) == 0 ? ends : same;
    p[0] += static_cast<Scalar>(1e-10) * coordinate();
    p[1] += static_cast<Scalar>(1e-10) * coordinate();
    return p;
  });
  make("a sliver", [&] {
    Point p = any() * static_cast<Scalar>(1e-7);
    p[0] = coordinate();
    return p;
  });
  make("far from the origin", [&] {
    Point p = any();
    for (int i = 0; i < Dim; ++i) p[i] += sizeof(Scalar) == 8 ? Scalar(1e8) : Scalar(1e4);
    return p;
  });
  const Scalar tiny = sizeof(Scalar) == 8 ? Scalar(1e-150) : Scalar(1e-18f);
  make("tiny", [&]() -> Point { return any() * tiny; });
  const Scalar huge = sizeof(Scalar) == 8 ? Scalar(1e150) : Scalar(1e17f);
  make("huge", [&]() -> Point { return any() * huge; });
  make("sizes from 1e-12 to 1", [&] {
    Point p;
    for (int i = 0; i < Dim; ++i)
      p[i] = coordinate() * static_cast<Scalar>(std::pow(10.0, -static_cast<int>(random.below(13))));
    return p;
  });
  return clouds;
}

}  // namespace snug::test
