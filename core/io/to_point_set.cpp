// Turns a file's points into a set of the scalar and dimension that was asked for.
#include <cmath>

#include "io/point_file.hpp"

namespace snug::io {
namespace {

/// Checks before rounding, because beyond the range of float the result would be an infinity that is not in the file.
template <class Scalar>
std::optional<InputError> beyond_range(const std::vector<Vector<double, 3>>& points) {
  constexpr double kLargest = static_cast<double>(PointSet<Scalar, 3>::kLargest);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(points[i].cwiseAbs().maxCoeff() <= kLargest))
      return InputError{.what = "point " + std::to_string(i) + " is too far out for " +
                                (sizeof(Scalar) == 4 ? "float: coordinates reach to 2^60, about 1.15e18"
                                                     : "double: coordinates reach to 2^508, about 8.3e152")};
  return std::nullopt;
}

template <class Scalar, int Dim>
tl::expected<AnyPointSet, InputError> make(const PointFile& file) {
  if (auto error = beyond_range<Scalar>(file.points)) return tl::unexpected(std::move(*error));
  std::vector<Vector<Scalar, Dim>> points;
  points.reserve(file.points.size());
  for (const auto& point : file.points) points.push_back(point.head<Dim>().template cast<Scalar>());
  return PointSet<Scalar, Dim>::make(std::move(points)).map([](PointSet<Scalar, Dim>&& set) {
    return AnyPointSet(std::move(set));
  });
}

tl::expected<AnyPointSet, InputError> make_any(const PointFile& file, int dim, bool single) {
  if (dim == 0) dim = file.dim;
  if (dim != 2 && dim != 3) return tl::unexpected(InputError{.what = "the dimension must be 2 or 3"});
  if (dim < file.dim) return tl::unexpected(InputError{.what = "the points are 3-D, and 2-D was asked for"});
  if (single) return dim == 2 ? make<float, 2>(file) : make<float, 3>(file);
  return dim == 2 ? make<double, 2>(file) : make<double, 3>(file);
}

}  // namespace

tl::expected<AnyPointSet, InputError> to_point_set(const PointFile& file, std::string_view name, int dim, bool single) {
  auto set = make_any(file, dim, single);
  if (!set) set.error().file = name;
  return set;
}

}  // namespace snug::io
