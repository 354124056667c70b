// Reads volumes from JSON; desktop/cli/json.hpp writes them.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <tl/expected.hpp>
#include <variant>

#include "desktop/cli/json.hpp"
#include "geometry/point_set.hpp"
#include "geometry/volume.hpp"

namespace snug::desktop {

/// A volume of either dimension.
using AnyVolume = std::variant<Volume<double, 2>, Volume<double, 3>>;

[[nodiscard]] inline int dim_of(const AnyVolume& volume) { return volume.index() == 0 ? 2 : 3; }

/// Axes rougher than float makes them, but as good as four digits are: counted, and then made unit and perpendicular.
struct RoughAxes {
  std::int64_t count = 0;
  std::string first;  // the field of the first
  std::int64_t line = 0;
};

/// How a volume is read.
struct VolumeWanted {
  std::string name;  // the volume's name in errors, as "a" in "a.sphere.radius is missing"; may be empty
  int dim = 0;       // 2 or 3; 0: that of the volume itself (3-D for a 6-DOP, which exists in both)
  double largest = PointSet<double, 3>::kLargest;  // absolute value of any number
  const char* largest_said = "8.3e152";
  RoughAxes* rough = nullptr;  // null: rough axes are refused
};

/// scalar: "double" or "float", whose range is smaller.
[[nodiscard]] VolumeWanted volume_wanted(std::string name, int dim, const std::string& scalar, RoughAxes* rough);

/// Reads a volume, {"sphere":{"center":[x,y,z],"radius":r}} and so on: an AABB in any of its three forms (which never
/// shrink it), a hull by its points, of which only the vertices are kept. Axes and a lozenge's edges may be as
/// imprecise as float makes them (kAxesAsGiven), or four digits (kAxesRough) if that may be counted, and are then made
/// unit and perpendicular within rounding.
/// Errors, each a sentence fragment that names the field: unknown, missing and superfluous fields, values that are not
/// numbers or are too large, the wrong number of numbers, negative radii and extents, min above max, axes that are not
/// unit, perpendicular and right-handed, slabs that do not meet.
[[nodiscard]] tl::expected<AnyVolume, std::string> read_volume(const Json& json, const VolumeWanted& wanted = {});

/// Whether a volume could be of either dimension: a 6-DOP, which has three slabs in both.
[[nodiscard]] bool may_have_either_dim(const Json& json);

/// What --help says of volumes in JSON.
[[nodiscard]] std::string volumes_in_json();

}  // namespace snug::desktop
