#include "query/overlap/obb_sat.hpp"

#include <doctest/doctest.h>

#include <variant>

#include "core/exact.hpp"
#include "core/query/box_pairs.hpp"
#include "core/query/exact_boxes.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using query::AxisKind;
using query::SatExtent;

namespace {

template <class Scalar, int Dim>
using Recorded = Recorder<query::SatStep<Scalar, Dim>>;

struct SatTally {
  int overlapping = 0, apart = 0, parallel = 0, exact = 0, edge_edge = 0;
};

/// All forms of the test say what the oracle says, and an axis that separates does.
template <class Scalar, int Dim>
void check_pair(const test::BoxPair<Scalar, Dim>& pair, bool right, SatTally& tally) {
  Recorded<Scalar, Dim> steps;
  const auto first = query::obb_sat(pair.a, pair.b, SatExtent::kFirst, steps);
  const auto all = query::obb_sat(pair.a, pair.b, SatExtent::kAll);
  REQUIRE(first.overlap == right);
  REQUIRE(all.overlap == right);
  REQUIRE(query::obbs_overlap(pair.a, pair.b) == right);
  REQUIRE(query::obbs_overlap(pair.b, pair.a) == right);
  CHECK((first.axis.kind == AxisKind::kNone) == right);
  CHECK(all.axis.kind != AxisKind::kNone);
  CHECK((all.axis.gap > 0) == !right);
  CHECK(std::abs(all.axis.direction.norm() - 1) < 16 * std::numeric_limits<Scalar>::epsilon());
  (right ? tally.overlapping : tally.apart)++;
  if (!right && first.axis.kind == AxisKind::kEdgeEdge) ++tally.edge_edge;
  for (const auto& entry : steps.entries) {
    if (const auto* axis = std::get_if<query::AxisTested<Scalar, Dim>>(&entry.step.fact))
      tally.parallel += axis->skipped;
    tally.exact += std::holds_alternative<query::LookedCloser>(entry.step.fact);
  }
}

template <class Scalar, int Dim>
void check_families(int rounds, const auto& oracle, SatTally& tally, auto&& wanted) {
  Random random(1);
  for (int o = 0; o < test::kOrientations; ++o)
    for (int e = 0; e < test::kExtents; ++e)
      for (const double gap : {0.0, 1e-5, -1e-5, 1e-3, -1e-3, 0.3, -0.3})
        for (const double offset : {0.0, 1e5})  // of the centres from the origin
          for (int round = 0; round < rounds; ++round) {
            const auto orientation = static_cast<test::Orientation>(o);
            const auto extents = static_cast<test::Extents>(e);
            const auto pair = test::pair_of<Scalar, Dim>(orientation, extents, gap, offset, random);
            if (!wanted(pair)) continue;
            INFO("orientation " << o << ", extents " << e << ", gap " << gap << ", offset " << offset << ", round "
                                << round);
            check_pair(pair, oracle(pair.a, pair.b), tally);
          }
}

template <class Scalar, int Dim>
bool is_flat(const Obb<Scalar, Dim>& box) {
  return box.half_extents.minCoeff() == 0;
}

/// The gap along the normal of two edges, in rationals and times the normal's length: what the test computes, but of
/// the true normals.
template <class Scalar, int Dim>
exact::Rational true_gap(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b,
                         const query::SatAxis<Scalar, Dim>& axis) {
  using Exact = std::array<exact::Rational, Dim>;
  const auto column = [](const Obb<Scalar, Dim>& box, int k) {
    Exact v;
    for (int i = 0; i < Dim; ++i) v[i] = exact::Rational(static_cast<double>(box.axes(i, k)));
    return v;
  };
  const auto normal = [](const Exact& u, const Exact& v) -> Exact {
    if constexpr (Dim == 2) return {-u[1], u[0]};
    else return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  };
  const auto face = [&](const Obb<Scalar, Dim>& box, int k) {
    return normal(column(box, (k + 1) % Dim), column(box, (k + 2) % Dim));
  };
  const Exact n = axis.kind == AxisKind::kFaceA   ? face(a, axis.i)
                  : axis.kind == AxisKind::kFaceB ? face(b, axis.j)
                                                  : normal(column(a, axis.i), column(b, axis.j));
  const auto along = [&](const Exact& v) {
    exact::Rational sum = 0;
    for (std::size_t i = 0; i < Dim; ++i) sum += v[i] * n[i];
    return sum;
  };
  Exact offset;
  for (int i = 0; i < Dim; ++i)
    offset[i] = exact::Rational(static_cast<double>(b.center[i])) - exact::Rational(static_cast<double>(a.center[i]));
  exact::Rational gap = abs(along(offset));
  for (const auto* box : {&a, &b})
    for (int k = 0; k < Dim; ++k)
      gap -= exact::Rational(static_cast<double>(box->half_extents[k])) * abs(along(column(*box, k)));
  return gap;
}

template <class Number>
struct InSpace {
  using Scalar = Number;
  static constexpr int kDim = 3;
};
template <class Number>
struct InPlane {
  using Scalar = Number;
  static constexpr int kDim = 2;
};

}  // namespace

#define SNUG_EVERY_SPACE InSpace<float>, InSpace<double>, InPlane<float>, InPlane<double>

TEST_CASE_TEMPLATE("points, segments and squares on top of each other", Scalar, float, double) {
  using Box = Obb<Scalar, 2>;
  const auto overlap = [](const Box& a, const Box& b) { return query::obb_sat(a, b).overlap; };
  const Box point{.center = {3, 4}};
  Box beside = point;
  beside.center[0] = std::nextafter(Scalar(3), Scalar(4));
  CHECK(overlap(point, point));
  CHECK_FALSE(overlap(point, beside));

  const Box level{.center = {0, 4}, .half_extents = {3, 0}};  // its end is the point
  CHECK(overlap(level, point));
  CHECK_FALSE(overlap(level, beside));
  const Box onwards{.center = {5, 4}, .half_extents = {2, 0}};  // on the same line, from the point on
  CHECK(overlap(level, onwards));
  CHECK(overlap(onwards, beside));
  const Box above{.center = {0, std::nextafter(Scalar(4), Scalar(5))}, .half_extents = {3, 0}};
  CHECK_FALSE(overlap(level, above));
  const Box square{.center = {5, 2}, .half_extents = {2, 2}};  // the point is its corner
  CHECK(overlap(square, point));
  CHECK(overlap(square, beside));
  CHECK(overlap(square, level));
}

TEST_CASE_TEMPLATE("cubes that touch overlap, and a gap of the last digit keeps them apart", Scalar, float, double) {
  const Obb<Scalar, 3> cube{.half_extents = {1, 1, 1}};
  for (int axis = 0; axis < 3; ++axis)
    for (const Scalar side : {Scalar(-2), Scalar(2)}) {
      Obb<Scalar, 3> other = cube;
      other.center = {Scalar(0.25), Scalar(-0.5), Scalar(0.75)};
      other.center[axis] = side;
      CHECK(query::obb_sat(cube, other).overlap);
      CHECK(query::obb_sat(cube, other, SatExtent::kAll).axis.gap == 0);
      other.center[axis] = std::nextafter(side, 2 * side);
      const auto apart = query::obb_sat(cube, other);
      CHECK_FALSE(apart.overlap);
      CHECK(apart.axis.gap == std::abs(other.center[axis]) - 2);
      CHECK(apart.axis.direction[axis] * side == 2);
    }
}

TEST_CASE("two crossed edges are apart along their common normal alone") {
  // A cube stands on its edge below, another hangs with its edge across it above.
  const double h = std::sqrt(0.5);
  Obb<double, 3> below{.half_extents = {1, 1, 1}}, above = below;
  below.axes << 1, 0, 0, 0, h, -h, 0, h, h;
  above.axes << h, 0, -h, 0, 1, 0, h, 0, h;
  above.center = {0, 0, 2.9};
  const auto apart = query::obb_sat(below, above);
  CHECK_FALSE(apart.overlap);
  CHECK(apart.axis.kind == AxisKind::kEdgeEdge);
  CHECK(apart.axis.i == 0);
  CHECK(apart.axis.j == 1);
  CHECK(apart.tests == 6 + 2);
  CHECK(apart.axis.gap == doctest::Approx(2.9 - 2 * std::sqrt(2.0)));
  CHECK(apart.axis.direction[2] == doctest::Approx(1));
  above.center = {0, 0, 2.8};
  CHECK(query::obb_sat(below, above).overlap);
}

TEST_CASE_TEMPLATE("the verdict is that of exact arithmetic, for full boxes", Kind, SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  constexpr int kDim = Kind::kDim;
  SatTally tally;
  const auto oracle = [](const auto& a, const auto& b) { return exact::overlap_by_corners(a, b); };
  check_families<Scalar, kDim>(4, oracle, tally, [](const auto& pair) { return !is_flat(pair.a) && !is_flat(pair.b); });
  CHECK(tally.overlapping > 200);
  CHECK(tally.apart > 300);
  CHECK(tally.exact > 50);  // otherwise nothing was near enough to be hard
  if (kDim == 3) CHECK(tally.edge_edge > 10);
  if (kDim == 3) CHECK(tally.parallel > 300);
}

TEST_CASE_TEMPLATE("the verdict is that of exact arithmetic, for flat boxes, segments and points", Kind,
                   SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  SatTally tally;
  const auto oracle = [](const auto& a, const auto& b) { return exact::overlap_by_simplex(a, b); };
  check_families<Scalar, Kind::kDim>(1, oracle, tally,
                                     [](const auto& pair) { return is_flat(pair.a) || is_flat(pair.b); });
  CHECK(tally.overlapping > 50);
  CHECK(tally.apart > 100);
  CHECK(tally.exact > 30);
}

TEST_CASE_TEMPLATE("boxes moved to touch along their last axis are judged to the last digit", Kind, SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  constexpr int kDim = Kind::kDim;
  Random random(3);
  SatTally tally;
  for (int round = 0; round < 400; ++round) {
    test::BoxPair<Scalar, kDim> pair{test::any_box<Scalar, kDim>(random, 1), test::any_box<Scalar, kDim>(random, 1)};
    for (int turn = 0; turn < 3; ++turn) {
      const auto widest = query::obb_sat(pair.a, pair.b, SatExtent::kAll).axis;
      pair.b.center -= widest.gap * widest.direction;
    }
    const int axis = static_cast<int>(random.below(kDim));
    pair.b.center[axis] = std::nextafter(pair.b.center[axis], Scalar(static_cast<int>(random.below(5)) - 2));
    // Both oracles, which must agree.
    const bool right = exact::overlap_by_corners(pair.a, pair.b);
    if (round % 20 == 0) REQUIRE(exact::overlap_by_simplex(pair.a, pair.b) == right);
    check_pair(pair, right, tally);
  }
  CHECK(tally.exact > 350);
  CHECK(tally.overlapping > 100);
  CHECK(tally.apart > 100);
}

TEST_CASE_TEMPLATE("the size of the scene changes no verdict", Scalar, float, double) {
  Random random(4);
  const Scalar huge = sizeof(Scalar) == 8 ? Scalar(0x1p490) : Scalar(0x1p50f);
  int overlapping = 0;
  for (int round = 0; round < 300; ++round) {
    const auto gap = round % 3 == 0 ? 0 : random.between(-0.2, 0.2);
    const auto pair = test::pair_of<Scalar, 3>(static_cast<test::Orientation>(round % test::kOrientations),
                                               test::Extents::kAny, gap, 0, random);
    const bool overlap = query::obb_sat(pair.a, pair.b).overlap;
    overlapping += overlap;
    for (const Scalar scale : {huge, 1 / huge}) {
      auto scaled = pair;
      for (auto* box : {&scaled.a, &scaled.b}) box->center *= scale, box->half_extents *= scale;
      const auto result = query::obb_sat(scaled.a, scaled.b, SatExtent::kAll);
      CHECK(result.overlap == overlap);
      CHECK(std::isfinite(result.axis.gap));
      CHECK(query::obbs_overlap(scaled.a, scaled.b) == overlap);
    }
  }
  CHECK(overlapping > 100);
  CHECK(overlapping < 200);
}

TEST_CASE_TEMPLATE("every gap is known within its doubt", Kind, SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  constexpr int kDim = Kind::kDim;
  Random random(5);
  double worst = 0;
  for (int round = 0; round < 72; ++round) {
    const auto pair = test::pair_of<Scalar, kDim>(static_cast<test::Orientation>(round % test::kOrientations),
                                                  static_cast<test::Extents>(round / 6 % test::kExtents),
                                                  random.between(-1, 1), 0, random);
    Recorded<Scalar, kDim> steps;
    query::obb_sat(pair.a, pair.b, SatExtent::kAll, steps);
    for (const auto& entry : steps.entries) {
      const auto* tested = std::get_if<query::AxisTested<Scalar, kDim>>(&entry.step.fact);
      if (tested == nullptr || tested->skipped) continue;
      const auto doubt = static_cast<double>(tested->doubt * tested->length);
      const double error = exact::Rational(true_gap(pair.a, pair.b, tested->axis) -
                                           exact::Rational(static_cast<double>(tested->axis.gap)) *
                                               exact::Rational(static_cast<double>(tested->length)))
                               .template convert_to<double>();
      CHECK(std::abs(error) <= doubt);
      worst = std::max(worst, std::abs(error) / doubt);
    }
  }
  CHECK(worst > 1e-3);  // and the doubt is not out of all proportion
}

TEST_CASE_TEMPLATE("overlapping boxes come apart when moved by the least penetration, and by less they do not", Kind,
                   SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  constexpr int kDim = Kind::kDim;
  Random random(6);
  int edges = 0;
  for (int round = 0; round < 300; ++round) {
    auto pair =
        test::BoxPair<Scalar, kDim>{test::any_box<Scalar, kDim>(random, 0.6), test::any_box<Scalar, kDim>(random, 0.6)};
    const auto result = query::obb_sat(pair.a, pair.b, SatExtent::kAll);
    if (!result.overlap) continue;
    edges += result.axis.kind == AxisKind::kEdgeEdge;
    const Vector<Scalar, kDim> center = pair.b.center;
    for (const Scalar share : {Scalar(0.99), Scalar(1.01)}) {
      pair.b.center = center - share * result.axis.gap * result.axis.direction;
      CHECK(query::obb_sat(pair.a, pair.b).overlap == (share < 1));
    }
  }
  if (kDim == 3) CHECK(edges > 10);
}

TEST_CASE_TEMPLATE("the steps are those of Ericson's table 4.1, in its order", Kind, SNUG_EVERY_SPACE) {
  using Scalar = typename Kind::Scalar;
  constexpr int kDim = Kind::kDim;
  using Frames = query::FramesRelated<Scalar, kDim>;
  using Tested = query::AxisTested<Scalar, kDim>;
  Random random(7);
  int early = 0, late = 0;
  for (int round = 0; round < 200; ++round) {
    const auto orientation = static_cast<test::Orientation>(round % test::kOrientations);
    const auto pair =
        test::pair_of<Scalar, kDim>(orientation, test::Extents::kAny, random.between(-0.5, 0.5), 0, random);
    for (const SatExtent extent : {SatExtent::kFirst, SatExtent::kAll}) {
      Recorded<Scalar, kDim> steps;
      const auto result = query::obb_sat(pair.a, pair.b, extent, steps);
      const auto unwatched = query::obb_sat(pair.a, pair.b, extent);
      CHECK(unwatched.overlap == result.overlap);
      CHECK(unwatched.tests == result.tests);
      CHECK(unwatched.axis.kind == result.axis.kind);
      CHECK(unwatched.axis.direction == result.axis.direction);
      CHECK(unwatched.axis.gap == result.axis.gap);

      REQUIRE(steps.entries.size() >= static_cast<std::size_t>(result.tests) + 2);
      CHECK(steps.entries.front().step.line == 0);
      const auto& frames = std::get<Frames>(steps.entries.front().step.fact);
      const Vector<Scalar, kDim> back = pair.a.axes * frames.translation + pair.a.center;
      CHECK((back - pair.b.center).norm() <= 1e-5 * (1 + pair.b.center.norm()));
      CHECK((pair.a.axes * frames.rotation - pair.b.axes).norm() < 1e-5);
      const bool settled =
          std::holds_alternative<query::LookedCloser>(steps.entries[steps.entries.size() - 2].step.fact);
      for (int k = 0; k < result.tests; ++k) {
        const auto& step = steps.entries[k + 1].step;
        const auto& tested = std::get<Tested>(step.fact);
        const auto expected = query::axis_at<kDim>(k);
        CHECK(tested.axis.kind == expected.kind);
        CHECK(tested.axis.i == expected.i);
        CHECK(tested.axis.j == expected.j);
        CHECK(step.line == (k < kDim ? 2 : k < 2 * kDim ? 4 : tested.skipped ? 6 : 7));
        if (tested.skipped) continue;
        CHECK(tested.axis.direction.dot(pair.b.center - pair.a.center) >= -1e-5 * tested.distance);
        CHECK(tested.axis.gap == doctest::Approx(tested.distance - tested.radius_a - tested.radius_b).epsilon(1e-4));
        if (extent == SatExtent::kFirst)
          CHECK(tested.separates == (k + 1 == result.tests && !result.overlap && !settled));
      }
      const auto& verdict = std::get<query::Verdict<Scalar, kDim>>(steps.entries.back().step.fact);
      using Line = query::SatLine<kDim>;
      const int said_by = result.overlap      ? Line::kVerdict
                          : settled           ? Line::kExactly
                          : result.axis.j < 0 ? Line::kFaceA
                          : result.axis.i < 0 ? Line::kFaceB
                                              : Line::kEdges;
      CHECK(steps.entries.back().step.line == said_by);
      CHECK(verdict.result.overlap == result.overlap);
      if (extent == SatExtent::kAll) CHECK(result.tests == query::kSatAxes<kDim>);
      if (extent == SatExtent::kFirst) (result.tests < query::kSatAxes<kDim> ? early : late)++;
    }
  }
  CHECK(early > 60);
  CHECK(late > 60);
}

TEST_CASE("a verdict that rounding hides is a step of its own") {
  const Obb<double, 3> cube{.half_extents = {1, 1, 1}};
  Obb<double, 3> other = cube;
  other.center = {2, 0, 0};
  Recorded<double, 3> steps;
  CHECK(query::obb_sat(cube, other, SatExtent::kFirst, steps).overlap);
  const auto& step = steps.entries[steps.entries.size() - 2].step;
  REQUIRE(std::holds_alternative<query::LookedCloser>(step.fact));
  CHECK(step.line == query::SatLine<3>::kExactly);
  CHECK(std::get<query::LookedCloser>(step.fact).overlap);
}

TEST_CASE_TEMPLATE("boxes with parallel edges are decided by the filter, and rightly", Scalar, float, double) {
  constexpr double u = tolerance::kRoundoff<Scalar>;
  using test::Orientation;
  Random random(8);
  int near = 0, open = 0;
  for (const Orientation orientation : {Orientation::kSharedAxis, Orientation::kPermuted, Orientation::kSame})
    for (int round = 0; round < 120; ++round) {
      INFO("orientation " << static_cast<int>(orientation) << ", round " << round);
      const auto pair_at = [&](double gap) {
        return test::pair_of<Scalar, 3>(orientation, test::Extents::kAny, gap, 0, random);
      };
      auto deep = pair_at(0);
      deep.b.center = deep.a.center + test::any_vector<3>(random, 0.05).template cast<Scalar>();
      CHECK(query::apart_filter(deep.a, deep.b) == false);
      CHECK(query::apart_filter(deep.b, deep.a) == false);
      // Near enough for rounding to matter, with edges that are parallel but for some roundings.
      for (const double gap : {-20000 * u, -8000 * u, -5000 * u, -3000 * u, -1000 * u, 0.0, 1000 * u}) {
        auto pair = pair_at(gap);
        const auto tilt = test::any_turn<3>(random, (round % 8) * 12 * u);
        pair.b.axes = (tilt * pair.b.axes.template cast<double>()).template cast<Scalar>();
        const auto apart = query::apart_filter(pair.a, pair.b);
        if (apart) REQUIRE(*apart != exact::overlap_by_corners(pair.a, pair.b));
        near += apart == false ? 1 : 0;
        open += apart ? 0 : 1;
      }
    }
  CHECK(near > 50);
  CHECK(open > 50);
}
