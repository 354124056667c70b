// A mesh of the build's assets, for benchmarks.
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "geometry/point_set.hpp"
#include "io/point_file.hpp"

namespace snug::bench {

/// name: "bunny". Ends the program where there is none.
inline PointSet<double, 3> mesh(const std::string& name) {
  std::ifstream file(SNUG_ASSETS_DIR "/meshes/" + name + ".ply", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto read = io::read_points(bytes, name);
  if (!read) std::abort();
  return *PointSet<double, 3>::make(read->points);
}

}  // namespace snug::bench
