// The steps of the pair tests that compare intervals or distances; the tests of oriented boxes and GJK have their own
// steps.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 4> kSlabsPseudocode{
    "for each axis along which both have slabs",
    "  take both intervals",
    "  apart if one ends before the other begins",
    "if there is no such axis: they overlap",
};
inline constexpr std::array<std::string_view, 3> kSpheresPseudocode{
    "d ← b.center - a.center",
    "R ← a.radius + b.radius",
    "apart if d · d > R · R",
};
inline constexpr std::array<std::string_view, 3> kDistancePseudocode{
    "p, q ← the cores' nearest points",
    "d ← |q - p|",
    "apart if d > the sum of the radii",
};

/// Both volumes' intervals along one axis. direction: unit, from low to high; all values are in scene units along it.
struct SlabTested {
  static constexpr std::string_view kName = "slab_tested";
  Vector<double, 3> direction = Vector<double, 3>::Zero();
  double least_a = 0, greatest_a = 0;
  double least_b = 0, greatest_b = 0;
  bool separates = false;
  SNUG_FIELDS(direction, least_a, greatest_a, least_b, greatest_b, separates);
};

/// The nearest points of two cores (a centre, a segment, a rectangle, a box), within rounding; their distance, and the
/// sum of the radii around both, in scene units. tests: how many pairs of features were compared for them.
struct CoresCompared {
  static constexpr std::string_view kName = "cores_compared";
  Vector<double, 3> on_a = Vector<double, 3>::Zero(), on_b = Vector<double, 3>::Zero();
  double distance = 0;
  double radii = 0;
  bool apart = false;
  int tests = 1;
  SNUG_FIELDS(on_a, on_b, distance, radii, apart, tests);
};

struct OverlapStep {
  using Fact = std::variant<SlabTested, CoresCompared>;
  int line = 0;  // of the test's pseudocode, counted from 0
  Fact fact;
};

/// A planar vector with z = 0.
template <class Scalar, int Dim>
[[nodiscard]] Vector<double, 3> in_space(const Vector<Scalar, Dim>& v) {
  Vector<double, 3> lifted = Vector<double, 3>::Zero();
  lifted.template head<Dim>() = v.template cast<double>();
  return lifted;
}

}  // namespace snug::query
