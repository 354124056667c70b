#include "lesson/box_tests.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "fit/lift.hpp"
#include "lesson/frustum_tests.hpp"
#include "query/obb_sat.hpp"
#include "query/wrong_corners_only.hpp"
#include "query/wrong_extents_only.hpp"

namespace snug::lesson {
namespace {

using query::AxisKind;

/// Keeps the steps of a test of two boxes, lifted.
struct Record {
  fit::Recording recording;
  template <class Step>
  void operator()(const Step& step) {
    recording.steps.push_back({fit::lift(step), recording.counts});
  }
  void count(Operation operation, std::int64_t n) { recording.counts[static_cast<std::size_t>(operation)] += n; }
};

constexpr fit::Algorithm row(std::string_view name, std::string_view title, std::string_view source,
                             std::span<const std::string_view> pseudocode,
                             std::span<const std::string_view> plane = {}) {
  return {kBoxPair, name,       title, false,   true,   true, std::numeric_limits<Index>::max(),
          source,   pseudocode, plane, nullptr, nullptr};
}

constexpr std::string_view kSource = "S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, 1996";
constexpr std::string_view kWrong = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::array kTests{
    row("sat", "Separating axes", kSource, query::kSatPseudocode3, query::kSatPseudocode2),
    row("sat_all", "All axes", kSource, query::kSatPseudocode3, query::kSatPseudocode2),
    row("extents_only", "AABBs only (wrong)", kWrong, query::kExtentsOnlyPseudocode),
    row("corners_only", "Vertices only (wrong)", kWrong, query::kCornersOnlyPseudocode),
};

/// Calls with both boxes in their own dimension.
template <class Call>
auto in_dimension(const BoxPair& pair, Call call) {
  return pair.dim == 2 ? call(flat(pair.boxes[0]), flat(pair.boxes[1])) : call(pair.boxes[0], pair.boxes[1]);
}

template <class Observer>
bool run(const fit::Algorithm& test, const BoxPair& pair, Observer& observe) {
  return in_dimension(pair, [&](const auto& a, const auto& b) {
    if (test.name == "extents_only") return query::extents_only(a, b, observe);
    if (test.name == "corners_only") return query::corners_only(a, b, observe);
    const auto extent = test.name == "sat_all" ? query::SatExtent::kAll : query::SatExtent::kFirst;
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

std::span<const fit::Algorithm> box_tests() { return kTests; }

fit::Recording record(const fit::Algorithm& test, const BoxPair& pair) {
  if (test.volume == kFrustumBox) return record_frustum(test, pair);
  Record observe;
  run(test, pair, observe);
  return std::move(observe.recording);
}

bool says_overlap(const fit::Algorithm& test, const BoxPair& pair) {
  Ignore ignore;
  return run(test, pair, ignore);
}

std::span<const AxisName> axis_names(int dim) {
  static const std::vector<AxisName> plane = names_of(2), space = names_of(3);
  return dim == 2 ? plane : space;
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
