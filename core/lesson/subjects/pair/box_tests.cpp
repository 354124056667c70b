#include "lesson/subjects/pair/box_tests.hpp"

#include <algorithm>
#include <array>

#include "lesson/subjects/pair/naive_tests.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "query/exhibits/wrong_corners_only.hpp"
#include "query/exhibits/wrong_extents_only.hpp"
#include "query/overlap/obb_sat.hpp"

namespace snug::lesson {
namespace {

using query::AxisKind;

constexpr std::string_view kSource = "S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, 1996";
constexpr std::string_view kWrong = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::array kTests{
    Method{kBoxPair, "sat", "Separating axes", kSource, query::kSatPseudocode3, query::kSatPseudocode2},
    Method{kBoxPair, "sat_all", "All axes", kSource, query::kSatPseudocode3, query::kSatPseudocode2},
    Method{kBoxPair, "extents_only", "AABBs only (wrong)", kWrong, query::kExtentsOnlyPseudocode},
    Method{kBoxPair, "corners_only", "Vertices only (wrong)", kWrong, query::kCornersOnlyPseudocode},
};

/// Calls a function with both boxes in their own dimension and scalar.
template <class Call>
auto in_dimension(const BoxPair& pair, Call call) {
  const auto in = [&]<class Scalar>(Scalar) {
    const auto of = [&]<int Dim>(std::integral_constant<int, Dim>, int i) {
      return converted<Scalar, Dim>(pair.boxes[i]);
    };
    if (pair.dim == 3) return call(of(std::integral_constant<int, 3>(), 0), of(std::integral_constant<int, 3>(), 1));
    return call(of(std::integral_constant<int, 2>(), 0), of(std::integral_constant<int, 2>(), 1));
  };
  return pair.in_float ? in(float()) : in(double());
}

bool run_test(std::string_view test, const BoxPair& pair, RecordPair& observe) {
  if (is_naive(test)) return run_naive(test, pair, observe);
  return in_dimension(pair, [&](const auto& a, const auto& b) {
    if (test == "extents_only") return query::extents_only(a, b, observe);
    if (test == "corners_only") return query::corners_only(a, b, observe);
    const auto extent = test == "sat_all" ? query::SatExtent::kAll : query::SatExtent::kFirst;
    return query::obb_sat(a, b, extent, observe).overlap;
  });
}

std::vector<AxisName> names_of(int dim) {
  std::vector<AxisName> names;
  const auto letter = [](int axis) { return std::string(1, "xyz"[axis]); };
  for (int i = 0; i < dim; ++i) names.push_back({"A " + letter(i), AxisKind::kFaceA, i, -1});
  for (int j = 0; j < dim; ++j) names.push_back({"B " + letter(j), AxisKind::kFaceB, -1, j});
  for (int i = 0; dim == 3 && i < 3; ++i)
    for (int j = 0; j < 3; ++j) names.push_back({"A " + letter(i) + " × B " + letter(j), AxisKind::kEdgeEdge, i, j});
  return names;
}

}  // namespace

std::span<const Method> box_tests() {
  static const std::vector<Method> all = [] {
    std::vector<Method> tests(kTests.begin(), kTests.end());
    tests.insert(tests.end(), naive_tests().begin(), naive_tests().end());
    return tests;
  }();
  return all;
}

PairTrace record(std::string_view test, const BoxPair& pair) {
  RecordPair observe;
  run_test(test, pair, observe);
  return std::move(observe.trace);
}

bool says_overlap(std::string_view test, const BoxPair& pair) {
  RecordPair ignored;
  return run_test(test, pair, ignored);
}

std::span<const AxisName> axis_names(int dim) {
  static const std::vector<AxisName> plane = names_of(2), space = names_of(3);
  return dim == 2 ? plane : space;
}

std::string length_along(const query::AxisTested<double, 3>& axis, double length) {
  return length_text(length, decimals_showing(axis.axis.gap));
}

int axis_index(int dim, const query::SatAxis<double, 3>& axis) {
  const auto names = axis_names(dim);
  const auto found = std::find_if(names.begin(), names.end(), [&](const AxisName& name) {
    return name.kind == axis.kind && name.i == axis.i && name.j == axis.j;
  });
  return found == names.end() ? -1 : static_cast<int>(found - names.begin());
}

std::string axis_text(int dim, const query::SatAxis<double, 3>& axis) {
  const int at = axis_index(dim, axis);
  return at < 0 ? "" : axis_names(dim)[at].text;
}

}  // namespace snug::lesson
