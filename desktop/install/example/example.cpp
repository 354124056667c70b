#include <iostream>
#include <snug/fit/sphere/welzl.hpp>
#include <snug/query/overlap/overlaps.hpp>

int main() {
  const auto points = snug::PointSet<double, 3>::make({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  const auto smallest = snug::fit::welzl(points->span(), snug::fit::Options{.seed = 1});
  const snug::Sphere<double, 3> other{.center = {3, 0, 0}, .radius = 1};
  std::cout << "radius " << smallest.volume.radius << ", overlap " << snug::query::overlaps(smallest.volume, other)
            << '\n';
}
