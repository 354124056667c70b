// Files as a broken download or a bad disk leaves them: nothing crashes, and what is read keeps its promises.
#include <doctest/doctest.h>

#include "core/io/samples.hpp"
#include "geometry/random.hpp"
#include "io/point_file.hpp"

using namespace snug;

namespace {

/// What read_points promises of whatever it accepts.
bool is_sound(const io::PointFile& file) {
  if (file.points.empty() || (file.dim != 2 && file.dim != 3)) return false;
  for (const auto& point : file.points)
    if (!point.allFinite() || (file.dim == 2 && point[2] != 0)) return false;
  for (const auto& triangle : file.triangles)
    for (const Index i : triangle)
      if (i < 0 || i >= static_cast<Index>(file.points.size())) return false;
  return true;
}

/// Whether the points are the tetrahedron's first ones; of the last, the digits may have been cut.
bool is_start_of_tetra(const io::PointFile& file) {
  if (file.points.size() > samples::kTetra.size()) return false;
  for (std::size_t i = 0; i + 1 < file.points.size(); ++i)
    if (file.dim == 3 && file.points[i] != samples::kTetra[i]) return false;
  return true;
}

}  // namespace

TEST_CASE("a file cut off at any byte is refused or read as far as it goes") {
  for (const auto& sample : samples::all()) {
    CAPTURE(sample.name);
    int refused = 0;
    int read_in_part = 0;
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      CAPTURE(size);
      const auto file = io::read_points(std::string_view(sample.bytes).substr(0, size), sample.name);
      if (file) {
        ++read_in_part;
        CHECK(is_sound(*file));
        CHECK(is_start_of_tetra(*file));
      } else {
        ++refused;
        CHECK(file.error().file == sample.name);
        CHECK(!file.error().what.empty());
      }
    }
    CHECK(refused > 0);
    if (sample.binary) CHECK(read_in_part == 0);  // its header says how long it is
  }
}

TEST_CASE("files with bytes changed, doubled or lost are refused or read as something sound") {
  Random random(2);
  int refused = 0;
  int read = 0;
  for (const auto& sample : samples::all())
    for (int round = 0; round < 500; ++round) {
      std::string bytes = sample.bytes;
      for (std::uint32_t change = 0; change <= random.below(3); ++change) {
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        switch (random.below(4)) {
          case 0: bytes[at] = static_cast<char>(random.below(256)); break;
          case 1: bytes[at] = "0123456789 -.e\n#/"[random.below(17)]; break;
          case 2: bytes.erase(at, 1 + random.below(20)); break;
          default: bytes.insert(at, bytes.substr(at, 1 + random.below(20)));
        }
        if (bytes.empty()) bytes = "\n";
      }
      const auto file = io::read_points(bytes, sample.name);
      const auto points = io::read_points(bytes, sample.name, {.skip_nan = true, .faces = false});
      if (points) CHECK(is_sound(*points));
      if (file) CHECK((points && points->points == file->points));  // whoever wants less is refused no more
      if (!file) {
        ++refused;
        continue;
      }
      ++read;
      CAPTURE(sample.name);
      CAPTURE(bytes);
      CHECK(is_sound(*file));
    }
  CHECK(refused > 1000);  // of 6500
  CHECK(read > 500);
}
