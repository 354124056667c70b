// libFuzzer: any bytes as a file of points. They are refused, or read as something sound.
#include <array>

#include "fuzz/bytes.hpp"
#include "io/point_file.hpp"

namespace {

using namespace snug;
using fuzz::require;

/// The formats that an extension can ask for; the size stands for a choice that the bytes alone make repeatable.
constexpr std::array<std::string_view, 5> kNames{"a.xyz", "a.csv", "a.obj", "a.ply", "a.stl"};

void check(const io::PointFile& file, std::size_t size) {
  require(!file.points.empty() && (file.dim == 2 || file.dim == 3));
  require(file.points.size() <= size && file.triangles.size() <= size);
  for (const auto& point : file.points) require(point.allFinite() && (file.dim == 3 || point[2] == 0));
  for (const auto& triangle : file.triangles)
    for (const Index i : triangle) require(i >= 0 && i < static_cast<Index>(file.points.size()));
  require(io::to_point_set(file, "a", 0, false).has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string_view name = kNames[size % kNames.size()];
  const auto file = io::read_points(bytes, name),
             points = io::read_points(bytes, name, {.skip_nan = true, .faces = false});
  if (file) check(*file, size);
  else require(file.error().file == name && !file.error().what.empty());
  if (points) check(*points, size);
  if (file) require(points && points->points == file->points);  // whoever wants less is refused no more
  return 0;
}
