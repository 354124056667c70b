#include <algorithm>
#include <numeric>

#include "lesson/names.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "query/overlap/overlaps_aabb_forms.hpp"
#include "query/overlap/overlaps_any.hpp"

namespace snug::lesson {
namespace {

using query::name_of;
using query::PairTest;
using query::source_of;

/// GJK's lines follow those of the slabs and replace the last one.
constexpr int kSlabLines = 3;
constexpr auto kSlabsThenGjkPseudocode = [] {
  std::array<std::string_view, kSlabLines + query::kGjkPseudocode.size()> all;
  std::copy_n(query::kSlabsPseudocode.begin(), kSlabLines, all.begin());
  std::copy(query::kGjkPseudocode.begin(), query::kGjkPseudocode.end(), all.begin() + kSlabLines);
  return all;
}();

constexpr Method row(PairTest test, std::string_view title, std::span<const std::string_view> pseudocode,
                     std::span<const std::string_view> in_plane = {}) {
  return {kVolumePair, name_of(test), title, source_of(test), pseudocode, in_plane};
}

/// The tests of two axis-aligned boxes in each of their representations.
constexpr std::string_view kMinMax = "min_max", kMinWidths = "min_widths", kCenterRadius = "center_radius";
constexpr std::array kBoxForms{kMinMax, kMinWidths, kCenterRadius};
/// The same without the line for z.
constexpr auto in_plane(const std::array<std::string_view, 4>& lines) {
  return std::array{lines[0], lines[1], lines[3]};
}
constexpr auto kMinMaxPlane = in_plane(query::kMinMaxPseudocode),
               kMinWidthsPlane = in_plane(query::kMinWidthsPseudocode),
               kCenterRadiusPlane = in_plane(query::kCenterRadiusPseudocode);

constexpr std::array kVolumeTests{
    row(PairTest::kSpheres, "Squared distance", query::kSpheresPseudocode),
    row(PairTest::kSphereBox, "Nearest point of the box", query::kDistancePseudocode),
    row(PairTest::kSweptSpheres, "Distance between the cores", query::kDistancePseudocode),
    row(PairTest::kSlabs, "Intervals", query::kSlabsPseudocode),
    row(PairTest::kSlabsThenGjk, "Intervals, then GJK", kSlabsThenGjkPseudocode),
    row(PairTest::kSeparatingAxes, "Separating axes", query::kSatPseudocode3, query::kSatPseudocode2),
    row(PairTest::kGjk, "GJK", query::kGjkPseudocode),
    Method{kVolumePair, kMinMax, "Min-max", source_of(PairTest::kSpheres), query::kMinMaxPseudocode, kMinMaxPlane},
    Method{kVolumePair, kMinWidths, "Min-widths", source_of(PairTest::kSpheres), query::kMinWidthsPseudocode,
           kMinWidthsPlane},
    Method{kVolumePair, kCenterRadius, "Centre-radius", source_of(PairTest::kSpheres), query::kCenterRadiusPseudocode,
           kCenterRadiusPlane},
};

/// Calls a function with both volumes in their own dimension, and in a scalar that holds them exactly.
template <class Scalar, class Call>
auto in_dimension(const VolumePair& pair, Call call) {
  const auto own = [&]<int Dim>(std::integral_constant<int, Dim>) {
    const auto volume = [&](int side) {
      return std::visit([](const auto& kind) { return Volume<Scalar, Dim>(converted<Scalar, Dim>(kind)); },
                        pair.held[side].volume);
    };
    return call(volume(0), volume(1));
  };
  return pair.dim == 2 ? own(std::integral_constant<int, 2>()) : own(std::integral_constant<int, 3>());
}

/// The line of the pseudocode that the test ends on.
int last_line(PairTest test, const RecordPair& steps, bool overlap) {
  if (test == PairTest::kSlabs) return overlap ? 3 : 2;
  return steps.trace.empty() ? 0 : steps.trace.back().step.line;
}

/// Keeps the end of a test. line: of its pseudocode.
template <class Scalar, int Dim>
void keep_end(const query::OverlapResult<Scalar, Dim>& result, int line, RecordPair& observe) {
  OverlapDecided end{.overlap = result.overlap, .distance = result.distance ? *result.distance : -1};
  if (result.separating_axis) {
    end.gap = result.separating_axis->gap;
    convert_into(end.direction, result.separating_axis->direction);
  }
  observe.keep(line, std::variant<OverlapDecided>(end));
}

/// test: the pair's own, or one of those that it has besides.
template <class Scalar, int Dim>
void decide(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, PairTest test, RecordPair& observe) {
  const auto result = test == PairTest::kGjk ? query::any_pair::by_gjk<Scalar, Dim>(a, b, observe)
                      : test == PairTest::kSlabsThenGjk
                          ? query::any_pair::by_slabs_then_gjk<Scalar, Dim>(a, b, observe)
                          : query::any_pair::test_any_in_order<Scalar, Dim>(a, b, observe);
  if (test == PairTest::kSeparatingAxes) return;  // it has its own end
  keep_end<Scalar, Dim>(result, last_line(test, observe, result.overlap), observe);
}

/// Tests two axis-aligned boxes as they are in a representation; it ends on the line of the axis that separates them.
template <class Scalar, int Dim>
void decide_boxes(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b, std::string_view form, RecordPair& observe) {
  const auto result = form == kMinMax ? query::test_axis_by_axis(a, b, observe)
                      : form == kMinWidths
                          ? query::test_axis_by_axis(min_widths_of(a), min_widths_of(b), observe)
                          : query::test_axis_by_axis(center_extents_of(a), center_extents_of(b), observe);
  keep_end<Scalar, Dim>(result, result.overlap ? Dim : result.tests - 1, observe);
}

/// Records a test in one scalar.
template <class Scalar>
PairTrace record_volumes_in(std::string_view test, const VolumePair& pair) {
  RecordPair observe;
  if (is_of_boxes(test)) {
    in_dimension<Scalar>(pair, [&]<int Dim>(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
      decide_boxes<Scalar, Dim>(*std::get_if<Aabb<Scalar, Dim>>(&a), *std::get_if<Aabb<Scalar, Dim>>(&b), test,
                                observe);
    });
    return std::move(observe.trace);
  }
  const PairTest chosen = test == name_of(PairTest::kGjk)            ? PairTest::kGjk
                          : test == name_of(PairTest::kSlabsThenGjk) ? PairTest::kSlabsThenGjk
                                                                     : test_of(pair);
  if (chosen == PairTest::kSlabsThenGjk) observe.gjk_line = kSlabLines;
  in_dimension<Scalar>(pair, [&]<int Dim>(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
    decide<Scalar, Dim>(a, b, chosen, observe);
  });
  return std::move(observe.trace);
}

}  // namespace

std::span<const Method> volume_tests() { return kVolumeTests; }

bool is_of_boxes(std::string_view test) { return is_among(kBoxForms, test); }

std::vector<std::string_view> tests_of(const VolumePair& pair) {
  const PairTest own = test_of(pair);
  std::vector<std::string_view> tests{name_of(own)};
  const auto is_box = [](const HeldVolume& held) { return std::holds_alternative<Aabb<double, 3>>(held.volume); };
  if (is_box(pair.held[0]) && is_box(pair.held[1])) tests.insert(tests.end(), kBoxForms.begin(), kBoxForms.end());
  if (query::is_conservative(pair.held[0].volume.index(), pair.held[1].volume.index()))
    tests.push_back(name_of(PairTest::kSlabsThenGjk));
  if (own != PairTest::kGjk) tests.push_back(name_of(PairTest::kGjk));
  return tests;
}

PairTrace record(std::string_view test, const VolumePair& pair) {
  return pair.in_float ? record_volumes_in<float>(test, pair) : record_volumes_in<double>(test, pair);
}

std::int64_t operations_in(PairSteps steps) {
  if (steps.empty()) return 0;
  const OperationCounts& counts = steps.back().counts;
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

std::vector<Point3> core_of(const HeldVolume& held) {
  std::vector<Point3> core;
  const auto list = [&]<int Dim>(std::integral_constant<int, Dim>) {
    std::visit(
        [&](const auto& kind) {
          const auto own = converted<double, Dim>(kind);
          const Vector<double, Dim> origin = Vector<double, Dim>::Zero();
          if constexpr (query::HasCorners<decltype(own)>)
            for (const auto& vertex : core_corners(own, origin)) convert_into(core.emplace_back(), vertex);
        },
        held.volume);
  };
  if (held.dim == 2) list(std::integral_constant<int, 2>());
  else list(std::integral_constant<int, 3>());
  return core;
}

double radius_of(const HeldVolume& held) {
  return std::visit([](const auto& volume) { return query::radius_of(volume); }, held.volume);
}

double reach_along(const HeldVolume& held, const Point3& way) {
  const auto reach = [&]<int Dim>(std::integral_constant<int, Dim>) {
    const Vector<double, Dim> direction = way.head<Dim>();
    return std::visit(
        [&](const auto& kind) {
          const auto own = converted<double, Dim>(kind);
          const Vector<double, Dim> origin = anchor(own);
          const Vector<double, Dim> farthest = query::farthest_of_core(own, origin, direction);
          return origin.dot(direction) + farthest.dot(direction) + query::radius_of(own);
        },
        held.volume);
  };
  return held.dim == 2 ? reach(std::integral_constant<int, 2>()) : reach(std::integral_constant<int, 3>());
}

namespace {

/// The nearest points of both as GJK finds them in their own dimension; none where they overlap.
template <int Dim>
std::optional<query::Separation<double, 3>> lifted(const std::optional<query::Separation<double, Dim>>& found) {
  if (!found || found->overlap) return std::nullopt;
  query::Separation<double, 3> lifted{.distance = found->distance, .gap = found->gap, .turns = found->turns};
  convert_into(lifted.direction, found->direction);
  convert_into(lifted.on_a, found->on_a), convert_into(lifted.on_b, found->on_b);
  return lifted;
}

}  // namespace

std::optional<query::Separation<double, 3>> separation_of(const VolumePair& pair) {
  return in_dimension<double>(pair, []<int Dim>(const Volume<double, Dim>& a, const Volume<double, Dim>& b) {
    return lifted<Dim>(query::gjk(a, b));
  });
}

std::optional<query::Separation<double, 3>> core_separation_of(const VolumePair& pair) {
  return in_dimension<double>(pair, []<int Dim>(const Volume<double, Dim>& a, const Volume<double, Dim>& b) {
    const Vector<double, Dim> origin = Vector<double, Dim>::Zero();
    const auto core_of = [&](const Volume<double, Dim>& volume) {
      auto core = std::visit([&](const auto& own) { return query::grown_core(own, origin); }, volume);
      core.radius = 0;
      return core;
    };
    Ignore ignore;
    return lifted<Dim>(query::separation_of<double, Dim>(core_of(a), core_of(b), origin, false, ignore));
  });
}

}  // namespace snug::lesson
