#include "geometry/generate.hpp"

#include <array>
#include <cmath>

#include "geometry/random.hpp"

namespace snug {
namespace {

using Point = Vector<double, 3>;
using Make = Point (*)(Random&, int index, int n, int dim);

Point in_cube(Random& random, int, int, int dim) {
  Point p = Point::Zero();
  for (int i = 0; i < dim; ++i) p[i] = random.between(-1, 1);
  return p;
}

Point in_ball(Random& random, int index, int n, int dim) {
  for (;;) {
    const Point p = in_cube(random, index, n, dim);
    if (p.squaredNorm() <= 1) return p;
  }
}

Point on_sphere(Random& random, int index, int n, int dim) {
  for (;;) {
    const Point p = in_ball(random, index, n, dim);
    if (p.squaredNorm() > 0.01) return p / p.norm();
  }
}

Point gaussian(Random& random, int, int, int dim) {
  Point p = Point::Zero();
  for (int i = 0; i < dim; ++i) p[i] = random.normal() / 2;
  return p;
}

/// A direction of unit length; both dimensions use the same tilt in the plane.
Point tilted(int dim) { return dim == 2 ? Point(0.8, 0.6, 0) : Point(0.64, 0.48, 0.6); }

Point stick(Random& random, int index, int n, int dim) {
  const double along = random.normal() / 2;
  return along * tilted(dim) + gaussian(random, index, n, dim) / 10;
}

Point clusters(Random& random, int index, int n, int dim) {
  const Point p = gaussian(random, index, n, dim);
  switch (index % 5) {
    case 0: return p * 0.15 + 1.2 * tilted(dim);
    case 1: return p * 0.15 - 0.9 * Point(-0.6, 0.8, 0);
    default: return p * 0.5;
  }
}

/// The least number of blocks a side of a square, or a cube, that holds n.
int blocks_a_side(int n, int dim) {
  int side = 1;
  while ((dim == 2 ? side * side : side * side * side) < n) ++side;
  return side;
}

Point lattice(Random&, int index, int n, int dim) {
  const int side = blocks_a_side(n, dim);
  Point p = Point::Zero();
  for (int i = 0; i < dim; ++i, index /= side) p[i] = index % side;
  const double middle = (side - 1) / 2.0;
  for (int i = 0; i < dim; ++i) p[i] = side == 1 ? 0 : (p[i] - middle) / middle;
  return p;
}

Point on_line(Random& random, int, int, int dim) { return random.between(-1, 1) * tilted(dim); }

/// One node of each block of three in a grid of whole numbers, so that many distances are equal, without rounding.
Point in_blocks(Random& random, int index, int n, int dim) {
  const int blocks = blocks_a_side(n, dim);
  Point p = Point::Zero();
  for (int i = 0; i < dim; ++i, index /= blocks) p[i] = index % blocks * 3 + static_cast<int>(random.below(3));
  double half = 1;
  while (half < 1.5 * blocks) half *= 2;
  for (int i = 0; i < dim; ++i) p[i] = (p[i] - (3 * blocks - 1) / 2.0) / half;
  return p;
}

constexpr std::array<std::string_view, 9> kKinds{"cube",     "ball",    "sphere", "gaussian", "stick",
                                                 "clusters", "lattice", "line",   "blocks"};
constexpr std::array<Make, 9> kMakers{in_cube,  in_ball, on_sphere, gaussian, stick,
                                      clusters, lattice, on_line,   in_blocks};

}  // namespace

std::span<const std::string_view> generator_kinds() { return kKinds; }

std::optional<PointStream> generate_stream(std::string_view kind, int n, int dim, std::uint64_t seed) {
  for (std::size_t k = 0; k < kKinds.size(); ++k)
    if (kKinds[k] == kind && n >= 1)
      return [make = kMakers[k], random = Random(seed), i = 0, n, dim]() mutable { return make(random, i++, n, dim); };
  return std::nullopt;
}

std::optional<std::vector<Point>> generate(std::string_view kind, int n, int dim, std::uint64_t seed) {
  const auto next = generate_stream(kind, n, dim, seed);
  if (!next) return std::nullopt;
  std::vector<Point> points;
  points.reserve(n);
  for (int i = 0; i < n; ++i) points.push_back((*next)());
  return points;
}

}  // namespace snug
