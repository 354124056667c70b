// What the tests of pairs tell of themselves.
#include <doctest/doctest.h>

#include "core/query/volume_pairs.hpp"
#include "fit/field_hash.hpp"
#include "query/overlap/overlaps_any.hpp"

namespace snug::query {
namespace {

/// Keeps the steps of intervals and distances, and counts all.
struct Steps {
  std::vector<OverlapStep> kept;
  int others = 0;
  OperationCounts counts{};
  void operator()(const OverlapStep& step) { kept.push_back(step); }
  void operator()(const auto&) { ++others; }
  void count(Operation operation, std::int64_t n) { counts[static_cast<std::size_t>(operation)] += n; }
};

template <class Fact>
const Fact& fact_of(const OverlapStep& step) {
  const Fact* fact = std::get_if<Fact>(&step.fact);
  REQUIRE(fact != nullptr);
  return *fact;
}

TEST_CASE_TEMPLATE("slabs tell both intervals in scene units along a unit direction", Scalar, float, double) {
  const Aabb<Scalar, 3> a{{0, 0, 0}, {1, 1, 1}};
  // Apart along the diagonal alone, the seventh of a 14-DOP's slabs or one of those before it.
  Kdop<Scalar, 3> b{.k = 14};
  const Aabb<Scalar, 3> around{{Scalar(0.5), Scalar(0.5), Scalar(0.5)}, {3, 3, 3}};
  const auto axes = kdop_axes<3>(14);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Interval interval = interval_along<Scalar, 3>(around, axes[i]);
    b.min[i] = static_cast<Scalar>(interval.min.value()), b.max[i] = static_cast<Scalar>(interval.max.value());
  }
  b.min[3] = 4;  // of x + y + z, where a reaches to 3
  REQUIRE(axes[3] == KdopAxis<3>{1, 1, 1});
  Steps steps;
  const auto result = test_overlap(a, b, steps);
  CHECK_FALSE(result.overlap);
  REQUIRE(steps.kept.size() == 4);
  CHECK(steps.others == 0);
  CHECK(result.tests == 4);
  for (std::size_t i = 0; i < 3; ++i) CHECK_FALSE(fact_of<SlabTested>(steps.kept[i]).separates);
  const auto& last = fact_of<SlabTested>(steps.kept[3]);
  CHECK(last.separates);
  const double length = std::sqrt(3.0);
  CHECK(last.direction.norm() == doctest::Approx(1));
  CHECK(last.greatest_a == doctest::Approx(3 / length));
  CHECK(last.least_b == doctest::Approx(4 / length));
  CHECK(static_cast<double>(result.separating_axis->gap) == doctest::Approx(1 / length));
}

TEST_CASE_TEMPLATE("cores tell their nearest points where they stand in the scene", Scalar, float, double) {
  const Sphere<Scalar, 3> ball{{10, 1, 0}, 1};
  const Aabb<Scalar, 3> box{{0, 0, 0}, {4, 4, 4}};
  const Capsule<Scalar, 3> capsule{{0, 0, 0}, {8, 0, 0}, Scalar(0.5)};
  const Lozenge<Scalar, 3> lozenge{{0, 5, 0}, {Vector<Scalar, 3>(20, 0, 0), Vector<Scalar, 3>(0, 0, 20)}, 1};
  const auto told = [](const auto& a, const auto& b) {
    Steps steps;
    const auto result = test_overlap(a, b, steps);
    REQUIRE(steps.kept.size() == 1);
    const CoresCompared fact = fact_of<CoresCompared>(steps.kept[0]);
    CHECK(fact.apart == !result.overlap);
    CHECK((fact.on_b - fact.on_a).norm() == doctest::Approx(fact.distance));
    CHECK(steps.counts[static_cast<std::size_t>(Operation::kDistanceTests)] == result.tests);
    if (!result.overlap) CHECK(fact.distance - fact.radii == doctest::Approx(static_cast<double>(*result.distance)));
    return fact;
  };
  const CoresCompared with_box = told(ball, box);
  CHECK(with_box.on_a == Vector<double, 3>(10, 1, 0));
  CHECK(with_box.on_b == Vector<double, 3>(4, 1, 0));
  CHECK(with_box.radii == 1);
  const CoresCompared with_capsule = told(ball, capsule);
  CHECK(with_capsule.on_b == Vector<double, 3>(8, 0, 0));
  const CoresCompared of_both = told(capsule, lozenge);
  CHECK(of_both.distance == doctest::Approx(5));
  CHECK(of_both.radii == doctest::Approx(1.5));
  CHECK(of_both.on_a.y() == doctest::Approx(0));
  CHECK(of_both.on_b.y() == doctest::Approx(5));
}

TEST_CASE("who watches changes nothing, and boxes and hulls tell the steps of their own tests") {
  const Obb<double, 3> a{{0, 0, 0}, Matrix<double, 3>::Identity(), {1, 2, 3}};
  const Obb<double, 3> b{{1.5, 0.5, 0}, Matrix<double, 3>::Identity(), {1, 1, 1}};
  const Capsule<double, 3> capsule{{3, 0, 0}, {3, 4, 0}, 1};
  const auto same = [](const auto& x, const auto& y) {
    Steps steps;
    const auto watched = test_overlap(x, y, steps), alone = test_overlap(x, y);
    CHECK(watched.overlap == alone.overlap);
    CHECK(watched.distance == alone.distance);
    CHECK(watched.tests == alone.tests);
    CHECK(steps.others > 1);
    CHECK(steps.kept.empty());
  };
  same(a, b);
  same(a, capsule);
}

/// Every number of every step.
struct Hash {
  fit::FieldHash hash;
  void operator()(const auto& step) {
    hash.add(step.line);
    std::visit([&](const auto& fact) { see_fields(fact, hash); }, step.fact);
  }
  void count(Operation, std::int64_t n) { hash.add(n); }
};

TEST_CASE_TEMPLATE("a test is the same whether the volumes' kinds are known beforehand or not", Scalar, float, double) {
  const auto each_pair = [&]<int Dim>(std::integral_constant<int, Dim>) {
    test::VolumeMaker<Scalar, Dim> make(9);
    int apart = 0;
    for (std::size_t i = 0; i < 7; ++i)
      for (std::size_t j = 0; j < 7; ++j)
        for (int round = 0; round < 6; ++round) {
          CAPTURE(kVolumeNames[i]);
          CAPTURE(kVolumeNames[j]);
          const auto how = round < 4 ? test::Make::kSolid : test::Make::kFlat;
          const Volume<Scalar, Dim> a = make.make(i, how);
          const Volume<Scalar, Dim> b =
              test::moved<Scalar, Dim>(make.make(j, how), make.direction() * (1.0 + 0.5 * round));
          Hash known, any;
          const auto one = std::visit([&](const auto& x, const auto& y) { return test_overlap(x, y, known); }, a, b);
          const auto other = test_any_overlap(a, b, any);
          CHECK(one.overlap == other.overlap);
          CHECK(one.distance == other.distance);
          CHECK(one.tests == other.tests);
          CHECK(known.hash.value() == any.hash.value());
          REQUIRE(one.separating_axis.has_value() == other.separating_axis.has_value());
          if (!one.separating_axis) continue;
          ++apart;
          CHECK(one.separating_axis->kind == other.separating_axis->kind);
          CHECK(one.separating_axis->direction == other.separating_axis->direction);
          CHECK(one.separating_axis->gap == other.separating_axis->gap);
        }
    CHECK(apart > 100);
  };
  each_pair(std::integral_constant<int, 2>());
  each_pair(std::integral_constant<int, 3>());
}

}  // namespace
}  // namespace snug::query
