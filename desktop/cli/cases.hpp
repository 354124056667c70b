// What stands on the stage of a named case, for the commands that take one with --case in place of a file.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "fit/catalogue.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// A case of points.
struct PointCase {
  AnyPointSet points;                    // in the case's own scalar
  std::vector<Vector<double, 3>> given;  // before they were rounded to it
  std::string volume, algorithm;         // the first that it offers
};

/// Errors: there is no such case; those of its file; it is not about points.
[[nodiscard]] tl::expected<PointCase, InputError> point_case(const std::string& name);

/// A case of two volumes, or of a volume and a frustum, as a line that `snug overlap` or `snug cull` reads. Errors: as
/// of point_case.
[[nodiscard]] tl::expected<std::string, InputError> overlap_case(const std::string& name);
[[nodiscard]] tl::expected<std::string, InputError> cull_case(const std::string& name);

}  // namespace snug::desktop
