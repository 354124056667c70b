// Every pair of volumes, at distances that are known.
#include "query/overlap/overlaps.hpp"

#include <doctest/doctest.h>

#include "core/exact.hpp"
#include "core/query/volume_pairs.hpp"
#include "geometry/point_set.hpp"
#include "query/contain/contains.hpp"
#include "query/overlap/overlaps_any.hpp"
#include "trace/fields.hpp"

using namespace snug;
using exact::Rational;
using query::OverlapResult;
using test::Make;
using test::VolumeMaker;

namespace {

template <class Scalar>
constexpr double kUnit = static_cast<double>(tolerance::kRoundoff<Scalar>);

/// That a result fits together, and is the same when turned around.
template <class Scalar, int Dim>
OverlapResult<Scalar, Dim> consistent(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  const OverlapResult<Scalar, Dim> result = query::test_overlap<Scalar, Dim>(a, b);
  const OverlapResult<Scalar, Dim> turned = query::test_overlap<Scalar, Dim>(b, a);
  CHECK(turned.overlap == result.overlap);
  CHECK(turned.distance == result.distance);
  CHECK(query::overlaps<Scalar, Dim>(a, b) == result.overlap);
  CHECK(query::overlaps<Scalar, Dim>(b, a) == result.overlap);
  CHECK(result.tests >= 1);
  const query::PairTest test = query::kPairTests[a.index()][b.index()];  // these two only find an axis
  CHECK(result.distance.has_value() == (test != query::PairTest::kSlabs && test != query::PairTest::kSeparatingAxes));
  if (result.distance) CHECK((*result.distance == 0) == result.overlap);
  REQUIRE(result.separating_axis.has_value() == !result.overlap);
  if (result.overlap) return result;
  const auto& axis = *result.separating_axis;
  CHECK(axis.gap > 0);
  CHECK(std::abs(static_cast<double>(axis.direction.norm()) - 1) <= 8 * kUnit<Scalar>);
  REQUIRE(turned.separating_axis.has_value());
  CHECK(turned.separating_axis->direction == -axis.direction);
  CHECK(turned.separating_axis->gap == axis.gap);
  if (result.distance) CHECK(axis.gap <= *result.distance);
  return result;
}

/// That the axis separates by its gap, within roundings of the size.
template <class Scalar, int Dim>
void check_axis(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, const OverlapResult<Scalar, Dim>& result,
                double size) {
  const Vector<double, Dim> n = result.separating_axis->direction.template cast<double>();
  const double gap = n.dot(test::support_of<Scalar, Dim>(b, -n)) - n.dot(test::support_of<Scalar, Dim>(a, n));
  CHECK(std::abs(gap - static_cast<double>(result.separating_axis->gap)) <= 32 * kUnit<Scalar> * size);
}

constexpr std::size_t kKinds = kVolumeNames.size();

/// The result of the pair's exact test. A conservative one of its own calls nothing apart that is not.
template <class Scalar, int Dim>
OverlapResult<Scalar, Dim> exactly(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  const OverlapResult<Scalar, Dim> own = consistent<Scalar, Dim>(a, b);
  if (!query::is_conservative(a.index(), b.index())) return own;
  Ignore ignore;
  const OverlapResult<Scalar, Dim> exact = query::test_slabs_then_gjk(a, b, ignore);
  CHECK(query::test_slabs_then_gjk(b, a, ignore).overlap == exact.overlap);
  if (!own.overlap) CHECK_FALSE(exact.overlap);
  return exact;
}

struct Setting {
  double gap;
  double offset = 0;
  int exponent = 0;
  Make a = Make::kSolid, b = Make::kSolid;
};

/// Every pair in that setting, a few times.
template <class Scalar, int Dim>
void check_setting(VolumeMaker<Scalar, Dim>& make, const Setting& setting, int rounds) {
  for (std::size_t i = 0; i < kKinds; ++i)
    for (std::size_t j = 0; j < kKinds; ++j)
      for (int round = 0; round < rounds; ++round) {
        INFO(kVolumeNames[i] << " " << kVolumeNames[j] << ", gap " << setting.gap << ", offset " << setting.offset
                             << ", exponent " << setting.exponent << ", dim " << Dim << ", round " << round);
        const Scalar scale = std::ldexp(Scalar(1), setting.exponent);
        const Vector<double, Dim> far = make.direction() * setting.offset;
        const auto near_a = test::moved<Scalar, Dim>(make.make(i, setting.a), far);
        const auto near_b = test::put_at<Scalar, Dim>(near_a, make.make(j, setting.b), make.direction(), setting.gap);
        const auto a = test::scaled<Scalar, Dim>(near_a, scale), b = test::scaled<Scalar, Dim>(near_b, scale);
        const OverlapResult<Scalar, Dim> result = exactly<Scalar, Dim>(a, b);
        const double size = test::reach<Scalar, Dim>(near_a) + test::reach<Scalar, Dim>(near_b);
        const double doubt = 32 * kUnit<Scalar> * size;
        CHECK(std::abs(setting.gap) > (setting.gap == 0 ? -1 : 2 * doubt));  // else the setting asks for nothing
        if (setting.gap != 0) CHECK(result.overlap == (setting.gap < 0));
        if (!result.overlap) check_axis<Scalar, Dim>(a, b, result, size * static_cast<double>(scale));
        if (!result.distance) continue;
        const double distance = static_cast<double>(*result.distance) / static_cast<double>(scale);
        CHECK(std::abs(distance - std::max(0.0, setting.gap)) <= doubt);
      }
}

}  // namespace

TEST_CASE_TEMPLATE("volumes without size overlap just where they meet", Scalar, float, double) {
  VolumeMaker<Scalar, 3> make(1);
  const Vector<double, 3> away(3, 0, 0);
  for (std::size_t i = 0; i < kKinds; ++i)
    for (std::size_t j = 0; j < kKinds; ++j) {
      INFO(kVolumeNames[i] << " " << kVolumeNames[j]);
      const auto at_origin = [&](std::size_t kind) -> Volume<Scalar, 3> {
        if (kind == 5) return Kdop<Scalar, 3>{.k = make.any_k()};
        const auto volume = make.make(kind, Make::kPoint);
        const Vector<double, 3> place = test::support_of<Scalar, 3>(volume, {1, 0, 0});
        return test::moved<Scalar, 3>(volume, -place);
      };
      const auto a = at_origin(i), b = at_origin(j);
      CHECK(consistent<Scalar, 3>(a, b).overlap);
      CHECK(consistent<Scalar, 3>(a, a).overlap);
      const auto result = consistent<Scalar, 3>(a, test::moved<Scalar, 3>(b, away));
      CHECK_FALSE(result.overlap);
      const auto& axis = *result.separating_axis;
      if (kVolumeNames[i] == "obb" && kVolumeNames[j] == "obb") {  // the first of their own axes that separates them
        CHECK(axis.gap > 0);
        CHECK(static_cast<double>(axis.gap) <= 3 * (1 + 1e-6));
        continue;
      }
      CHECK(static_cast<double>(axis.gap) == doctest::Approx(3).epsilon(1e-6));
      CHECK(static_cast<double>(axis.direction[0]) == doctest::Approx(1).epsilon(1e-6));
    }
}

TEST_CASE_TEMPLATE_DEFINE("volumes put at a known gap are told apart from it on", Scalar, known_gap) {
  constexpr bool kDouble = sizeof(Scalar) == 8;
  const double least = kDouble ? 1e-9 : 1e-4;
  const double far = kDouble ? 1e8 : 1e4;
  const int scale = kDouble ? 332 : 40;  // 1e100; 1e12
  std::vector<Setting> settings{{1e-3}, {-1e-3}, {least}, {-least}, {0}, {1}};
  settings.push_back({kDouble ? 1e-5 : 0.5, far});
  settings.push_back({kDouble ? -1e-5 : -0.1, far});
  for (const int exponent : {-scale, scale})
    for (const double gap : {least, -least, 0.0}) settings.push_back({gap, 0, exponent});
  for (const Make how : {Make::kFlat, Make::kPoint, Make::kLoose})
    for (const double gap : {1e-3, least, 0.0}) {
      settings.push_back({gap, 0, 0, how, Make::kSolid});
      settings.push_back({gap, 0, 0, how, how});
    }
  VolumeMaker<Scalar, 2> plane(2);
  VolumeMaker<Scalar, 3> space(3);
  for (const Setting& setting : settings) {
    check_setting<Scalar, 2>(plane, setting, 1);
    check_setting<Scalar, 3>(space, setting, 2);
  }
}
TEST_CASE_TEMPLATE_INVOKE(known_gap, float, double);

TEST_CASE_TEMPLATE("what is written by hand agrees with GJK", Scalar, float, double) {
  const auto compare = []<int Dim>(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, int& apart) {
    const auto result = exactly<Scalar, Dim>(a, b);
    const auto by_gjk = *query::gjk<Scalar, Dim>(a, b);
    const double doubt = 64 * kUnit<Scalar> * (test::reach<Scalar, Dim>(a) + test::reach<Scalar, Dim>(b));
    if (result.distance) CHECK(std::abs(static_cast<double>(*result.distance - by_gjk.distance)) <= doubt);
    if (static_cast<double>(by_gjk.distance) > doubt) CHECK_FALSE(result.overlap);
    if (!result.overlap) CHECK(static_cast<double>(result.separating_axis->gap - by_gjk.distance) <= doubt);
    apart += result.overlap ? 0 : 1;
  };
  const auto run = [&]<int Dim>(std::integral_constant<int, Dim>) {
    VolumeMaker<Scalar, Dim> make(5);
    for (std::size_t i = 0; i < kKinds; ++i)
      for (std::size_t j = 0; j < kKinds; ++j) {
        if (query::kPairTests[i][j] == query::PairTest::kGjk) continue;
        INFO(kVolumeNames[i] << " " << kVolumeNames[j] << ", dim " << Dim);
        int apart = 0;
        for (int round = 0; round < 40; ++round) {
          const Make how = round % 4 == 0 ? Make::kFlat : round % 4 == 1 ? Make::kLoose : Make::kSolid;
          const auto a = make.make(i, how);
          const auto b = test::moved<Scalar, Dim>(make.make(j, how), make.direction() * make.random.between(0, 3));
          compare.template operator()<Dim>(a, b, apart);
        }
        CHECK(apart >= 4);
        CHECK(apart <= 36);
      }
  };
  run(std::integral_constant<int, 2>{});
  run(std::integral_constant<int, 3>{});
}

TEST_CASE_TEMPLATE("spheres and axis-aligned boxes are decided exactly", Scalar, float, double) {
  Random random(7);
  // Whole numbers, at most a few ulps off: touching, or as little apart or inside as numbers can say.
  const auto nudged = [&](int whole) {
    Scalar value = static_cast<Scalar>(whole);
    for (unsigned i = random.below(3); i > 0; --i)
      value = std::nextafter(value,
                             std::numeric_limits<Scalar>::max() * static_cast<Scalar>(random.below(2) == 0 ? -1 : 1));
    return value;
  };
  const auto any = [&](int most) { return nudged(static_cast<int>(random.below(unsigned(2 * most + 1))) - most); };
  const auto rational = [](Scalar value) { return Rational(static_cast<double>(value)); };
  std::array<int, 2> counts{};
  for (int round = 0; round < 3000; ++round) {
    const Sphere<Scalar, 3> a{{any(3), any(3), any(3)}, nudged(1 + static_cast<int>(random.below(3)))};
    const Sphere<Scalar, 3> b{{any(4), any(4), any(4)}, random.below(4) == 0 ? Scalar(0) : nudged(2)};
    const Rational radii = rational(a.radius) + rational(b.radius);
    const bool meet = exact::squared_distance<Scalar, 3>(a.center, b.center) <= radii * radii;
    CHECK(query::test_overlap(a, b).overlap == meet);
    ++counts[meet ? 1 : 0];

    Aabb<Scalar, 3> box{{any(4), any(4), any(4)}, Vector<Scalar, 3>::Zero()};
    for (int i = 0; i < 3; ++i) box.max[i] = std::max(box.min[i], any(4));
    Rational square = 0;
    for (int i = 0; i < 3; ++i) {
      const Rational below = rational(box.min[i]) - rational(a.center[i]);
      const Rational above = rational(a.center[i]) - rational(box.max[i]);
      const Rational outside = std::max({Rational(0), below, above});
      square += outside * outside;
    }
    CHECK(query::test_overlap(a, box).overlap == (square <= rational(a.radius) * rational(a.radius)));
    const Aabb<Scalar, 3> other{a.center.cwiseMin(b.center), a.center.cwiseMax(b.center)};
    bool boxes_meet = true;
    for (int i = 0; i < 3; ++i) boxes_meet = boxes_meet && box.min[i] <= other.max[i] && other.min[i] <= box.max[i];
    CHECK(query::test_overlap(box, other).overlap == boxes_meet);
  }
  CHECK(counts[0] > 200);
  CHECK(counts[1] > 200);
}

namespace {

/// A k-DOP of small whole numbers as half-spaces n . p <= bound, of which none may be left out.
struct HalfSpace {
  std::array<int, 3> normal;
  int bound;
};

std::vector<HalfSpace> half_spaces(const Kdop<double, 3>& kdop) {
  std::vector<HalfSpace> result;
  const auto axes = kdop_axes<3>(kdop.k);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& n = axes[i];
    result.push_back({n, static_cast<int>(kdop.max[i])});
    result.push_back({{-n[0], -n[1], -n[2]}, -static_cast<int>(kdop.min[i])});
  }
  return result;
}

/// Whether they have a point in common: then also one where three of their planes meet, for they are bounded. In whole
/// numbers, by Cramer's rule.
bool have_common_point(const std::vector<HalfSpace>& spaces) {
  const auto det = [](const std::array<int, 3>& a, const std::array<int, 3>& b, const std::array<int, 3>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  for (std::size_t i = 0; i < spaces.size(); ++i)
    for (std::size_t j = i + 1; j < spaces.size(); ++j)
      for (std::size_t k = j + 1; k < spaces.size(); ++k) {
        const HalfSpace& a = spaces[i];
        const HalfSpace& b = spaces[j];
        const HalfSpace& c = spaces[k];
        const int scale = det(a.normal, b.normal, c.normal);
        if (scale == 0) continue;
        std::array<int, 3> point{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<std::array<int, 3>, 3> rows{a.normal, b.normal, c.normal};
          rows[0][axis] = a.bound, rows[1][axis] = b.bound, rows[2][axis] = c.bound;
          point[axis] = scale > 0 ? det(rows[0], rows[1], rows[2]) : -det(rows[0], rows[1], rows[2]);
        }
        bool in_all = true;
        for (const HalfSpace& space : spaces)
          in_all = in_all && space.normal[0] * point[0] + space.normal[1] * point[1] + space.normal[2] * point[2] <=
                                 space.bound * std::abs(scale);
        if (in_all) return true;
      }
  return false;
}

/// A k-DOP around some points of a small lattice, a slab of it perhaps looser or tighter than they are, or beside them.
Kdop<double, 3> lattice_kdop(VolumeMaker<double, 3>& make, int k) {
  std::vector<Vector<double, 3>> cloud;
  const Vector<double, 3> shift = make.any(3);
  for (unsigned i = 1 + make.random.below(5); i > 0; --i)
    cloud.push_back((make.any(2.5) + shift).array().round().matrix());
  Kdop<double, 3> kdop = make.kdop_of(k, cloud);
  const std::size_t slab = make.random.below(static_cast<std::uint32_t>(k / 2));
  switch (make.random.below(6)) {
    case 0: kdop.max[slab] += 1; break;
    case 1: kdop.min[slab] = kdop.max[slab]; break;
    case 2: kdop.min[slab] += 3, kdop.max[slab] += 3; break;
    default: break;
  }
  return kdop;
}

}  // namespace

TEST_CASE("k-DOPs and boxes on a lattice overlap just where whole numbers say") {
  VolumeMaker<double, 3> make(11);
  int overlapping = 0, apart = 0, missed_by_slabs = 0, empty = 0;
  for (int round = 0; round < 400; ++round) {
    CAPTURE(round);
    const int k = std::array{14, 18, 26}[make.random.below(3)];
    const Kdop<double, 3> a = lattice_kdop(make, k);
    const Kdop<double, 3> b = lattice_kdop(make, make.random.below(2) == 0 ? k : make.any_k());
    auto spaces = half_spaces(a);
    if (!have_common_point(spaces)) {
      CHECK(kdop_vertices(a).empty());
      CHECK_FALSE(exactly<double, 3>(a, b).overlap);
      ++empty;
      continue;
    }
    const auto more = half_spaces(b);
    spaces.insert(spaces.end(), more.begin(), more.end());
    const bool meet = have_common_point(spaces);
    const auto result = exactly<double, 3>(a, b);
    CHECK(result.overlap == meet);
    (meet ? overlapping : apart) += 1;
    if (!meet && result.separating_axis) missed_by_slabs += result.separating_axis->kind == "closest_points" ? 1 : 0;
    if (b.k != 6) continue;
    const Aabb<double, 3> box{{b.min[0], b.min[1], b.min[2]}, {b.max[0], b.max[1], b.max[2]}};
    CHECK(exactly<double, 3>(a, box).overlap == meet);
  }
  CHECK(overlapping > 40);
  CHECK(apart > 40);
  CHECK(missed_by_slabs > 0);
  CHECK(empty > 0);
}

TEST_CASE("two k-DOPs' own test is that of their intervals, and calls some pairs overlapping that are apart") {
  VolumeMaker<double, 3> make(17);
  int passed = 0, apart = 0;
  for (int round = 0; round < 6000; ++round) {
    const int k = make.any_k();
    const Vector<double, 3> aside = make.any(1);
    const Kdop<double, 3> a = make.kdop_of(k, {make.any(), make.any(), make.any()});
    const Kdop<double, 3> b = moved(make.kdop_of(k, {make.any(), make.any(), make.any()}), aside);
    bool intervals = true;
    for (std::size_t i = 0; i < static_cast<std::size_t>(k / 2); ++i)
      intervals = intervals && a.min[i] <= b.max[i] && b.min[i] <= a.max[i];
    CHECK(query::overlaps(a, b) == intervals);
    const bool overlap = exactly<double, 3>(a, b).overlap;
    if (overlap) CHECK(intervals);
    else ++apart, passed += intervals ? 1 : 0;
  }
  CHECK(apart > 800);
  CHECK(passed > 10);
}

TEST_CASE_TEMPLATE(
    "the filter's verdict is that of the whole test, however near the volumes are and whatever their size", Scalar,
    float, double) {
  const auto check = [&]<int Dim>(std::integral_constant<int, Dim>) {
    VolumeMaker<Scalar, Dim> make(19);
    for (std::size_t i = 0; i < kKinds; ++i)
      for (std::size_t j = i; j < kKinds; ++j)
        for (const int exponent : sizeof(Scalar) == 8 ? std::array{-1060, -530, -400, -260, 0, 250, 500}
                                                      : std::array{-140, -65, -50, -33, 0, 30, 58})
          for (int round = 0; round < 24; ++round) {
            INFO(kVolumeNames[i] << " " << kVolumeNames[j] << ", exponent " << exponent << ", dim " << Dim);
            const Make how = round % 6 == 0 ? Make::kFlat : round % 6 == 1 ? Make::kPoint : Make::kSolid;
            const double gap = std::array{0.0, 1e-2, 2e-3, 1.0, 30.0, 300.0}[round % 6] *
                               (round % 6 < 3 ? 1 : kUnit<Scalar>)*(round % 4 < 2 ? 1 : -1);
            const auto near_a = make.make(i, Make::kSolid);
            const auto near_b = test::put_at<Scalar, Dim>(near_a, make.make(j, how), make.direction(), gap);
            const Scalar scale = std::ldexp(Scalar(1), exponent);
            const auto a = test::scaled<Scalar, Dim>(near_a, scale), b = test::scaled<Scalar, Dim>(near_b, scale);
            const bool overlap = query::test_overlap<Scalar, Dim>(a, b).overlap;
            CHECK(query::overlaps<Scalar, Dim>(a, b) == overlap);
            CHECK(query::overlaps<Scalar, Dim>(b, a) == overlap);
            const auto typed = [](const auto& x, const auto& y) { return query::overlaps(x, y); };
            CHECK(std::visit(typed, a, b) == overlap);
            CHECK(std::visit(typed, b, a) == overlap);
          }
  };
  check(std::integral_constant<int, 2>{});
  check(std::integral_constant<int, 3>{});
}

TEST_CASE_TEMPLATE("a k-DOP's corners lie in all of its slabs", Scalar, float, double) {
  const auto check = [&]<int Dim>(std::integral_constant<int, Dim>) {
    VolumeMaker<Scalar, Dim> make(13);
    for (int round = 0; round < 100; ++round) {
      const double offset = round % 2 == 0 ? 0 : 1e6;
      const auto volume =
          test::moved<Scalar, Dim>(make.make(5, round % 4 < 2 ? Make::kLoose : Make::kFlat), make.direction() * offset);
      const auto& kdop = std::get<Kdop<Scalar, Dim>>(volume);
      const Vector<Scalar, Dim> origin = anchor(kdop);
      const auto corners = kdop_vertices(kdop, origin);
      if (corners.empty()) continue;  // moved far away, a flat one may lose its meeting point to rounding
      const auto axes = kdop_axes<Dim>(kdop.k);
      for (const auto& corner : corners)
        for (std::size_t i = 0; i < axes.size(); ++i) {
          double along = 0, size = 0;
          for (std::size_t j = 0; j < Dim; ++j) {
            along += axes[i][j] * (static_cast<double>(origin[static_cast<int>(j)]) + corner[static_cast<int>(j)]);
            size += std::abs(origin[static_cast<int>(j)]) + std::abs(corner[static_cast<int>(j)]) + 9;
          }
          CHECK(along >= static_cast<double>(kdop.min[i]) - 64 * kUnit<double> * size);
          CHECK(along <= static_cast<double>(kdop.max[i]) + 64 * kUnit<double> * size);
        }
    }
  };
  check(std::integral_constant<int, 2>{});
  check(std::integral_constant<int, 3>{});
}

TEST_CASE("a k-DOP of a box has its corners, and a truncated one those of its faces") {
  const auto count = [](const Kdop<double, 3>& kdop) { return kdop_vertices(kdop).size(); };
  CHECK(count({6, {0, 0, 0}, {1, 2, 3}}) == 8);
  CHECK(count({6, {0, 0, 0}, {0, 2, 3}}) == 4);
  CHECK(count({6, {0, 0, 0}, {0, 0, 0}}) == 1);
  // A cube whose corners are cut off as far as the edges' midpoints: a cuboctahedron; half as far: eight triangles.
  CHECK(count({14, {-1, -1, -1, -2, -2, -2, -2}, {1, 1, 1, 2, 2, 2, 2}}) == 12);
  CHECK(count({14, {-1, -1, -1, -2.5, -2.5, -2.5, -2.5}, {1, 1, 1, 2.5, 2.5, 2.5, 2.5}}) == 24);
  CHECK(count({14, {-1, -1, -1, -3, -3, -3, -3}, {1, 1, 1, 3, 3, 3, 3}}) == 8);
  CHECK(count({14, {-1, -1, -1, 4, -3, -3, -3}, {1, 1, 1, 5, 3, 3, 3}}) == 0);
  const auto count_2 = [](const Kdop<double, 2>& kdop) { return kdop_vertices(kdop).size(); };
  CHECK(count_2({4, {0, 0}, {1, 2}}) == 4);
  CHECK(count_2({6, {0, 0, 0.5}, {1, 1, 1.5}}) == 6);
  CHECK(count_2({8, {-1, -1, -1, -1}, {1, 1, 1, 1}}) == 4);
  CHECK(count_2({8, {0, 0, 3, -1}, {1, 1, 4, 1}}) == 0);
}

TEST_CASE("what is empty overlaps nothing") {
  const Kdop<double, 2> nowhere{8, {0, 0, 3, -1}, {1, 1, 4, 1}};
  const ConvexHull<double, 2> none;
  const Sphere<double, 2> sphere{{0.5, 0.5}, 5};
  for (const auto& result :
       {query::test_overlap(nowhere, sphere), query::test_overlap(sphere, none), query::test_overlap(none, nowhere)}) {
    CHECK_FALSE(result.overlap);
    CHECK_FALSE(result.distance.has_value());
    CHECK_FALSE(result.separating_axis.has_value());
  }
}

TEST_CASE("a supporting point is the farthest of its volume") {
  using V = Vector<double, 3>;
  CHECK(query::support(Sphere<double, 3>{{1, 2, 3}, 2}, V(0, 5, 0)) == V(1, 4, 3));
  CHECK(query::support(Aabb<double, 3>{{0, 0, 0}, {1, 2, 3}}, V(1, -1, 1e-9)) == V(1, 0, 3));
  CHECK(query::support(Obb<double, 3>{{1, 1, 1}, Matrix<double, 3>::Identity(), {1, 2, 3}}, V(-1, 1, 1)) == V(0, 3, 4));
  CHECK(query::support(Capsule<double, 3>{{0, 0, 0}, {4, 0, 0}, 1}, V(1, 0, 0)) == V(5, 0, 0));
  CHECK(query::support(Lozenge<double, 3>{{0, 0, 0}, {V(2, 0, 0), V(0, 2, 0)}, 1}, V(0, 0, -3))[2] == -1);
  CHECK(query::support(Kdop<double, 3>{6, {0, 0, 0}, {1, 2, 3}}, V(1, 1, 1)) == V(1, 2, 3));
  CHECK(query::support(ConvexHull<double, 3>{.vertices = {V(0, 0, 0), V(0, 7, 0)}}, V(0, 1, 0)) == V(0, 7, 0));
}

TEST_CASE("boxes may be apart although they share a point, by the rounding of their axes and no more") {
  // Found by fuzzing (tests/corpus/fuzz/query). A box contains what is within its slabs; two boxes are tested as the
  // sums of their edges, and edges that are not quite unit end short of the slabs.
  const Vector<double, 3> p(-0x1.ep+2, 0x1.ep+2, 0x1.dffffffffffffp+2);
  const Obb<double, 3> point{p};
  Obb<double, 3> box{{0x1p-50, 0x1p-50, 0x1.c000000000004p+0},
                     Matrix<double, 3>::Identity(),
                     {0x1.d521e650fc41bp-50, 0x1.08dc6e12a2942p-49, 0x1.8213e4f575a6bp+3}};
  box.axes << 0x1.7a01ab9c616a2p-1, 0x1.0bfca8c73d2bep-2, -0x1.3e4723dabb57cp-1,  //
      0x1.0bfca8c73d2b9p-2, 0x1.7a01ab9c616a2p-1, 0x1.3e4723dabb57ep-1,           //
      0x1.3e4723dabb57dp-1, -0x1.3e4723dabb57cp-1, 0x1.e806ae7185a89p-2;
  CHECK(query::contains(box, p));
  CHECK(query::contains(point, p));
  const auto result = consistent<double, 3>(point, box);
  CHECK_FALSE(result.overlap);
  CHECK(result.separating_axis->gap <= 2 * tolerance::kObbAxes<double> * box.half_extents.sum());
}
