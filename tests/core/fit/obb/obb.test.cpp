// What each box fitter is known to be worth. What all promise is in promises.test.cpp.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/at_random.hpp"
#include "core/fit/families.hpp"
#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "fit/obb/certify_obb.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/obb/obb_rotations.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

fit::Result fit_box(std::string_view name, const test::Cloud<double, 3>& points) {
  return fit::find_algorithm("obb", name)->fit(test::set_of<double, 3>(points), {});
}

double volume_of(std::string_view name, const test::Cloud<double, 3>& points) {
  return fit::measure_of(fit_box(name, points).volume, 3);
}

int rectangles_of(const fit::Recording& run) {
  return static_cast<int>(std::count_if(run.steps.begin(), run.steps.end(), [](const auto& entry) {
    return std::holds_alternative<fit::RectangleFound<double, 3>>(entry.step.fact);
  }));
}

/// The corners of a box, and points inside it.
test::Cloud<double, 3> in_box(const Matrix<double, 3>& turned, const Vector<double, 3>& half, int inside,
                              Random& random) {
  test::Cloud<double, 3> cloud;
  for (int corner = 0; corner < 8; ++corner)
    cloud.push_back(turned * Vector<double, 3>((corner & 1 ? 1 : -1) * half[0], (corner & 2 ? 1 : -1) * half[1],
                                               (corner & 4 ? 1 : -1) * half[2]));
  for (int i = 0; i < inside; ++i) cloud.push_back(turned * test::any_direction(random).cwiseProduct(half));
  return cloud;
}

test::Cloud<double, 3> scaled(test::Cloud<double, 3> cloud, double scale, double offset = 0) {
  for (auto& p : cloud) p = p * scale + Vector<double, 3>::Constant(offset);
  return cloud;
}

}  // namespace

TEST_CASE("a turned box of 1 x 2 x 3 has volume 6, wherever it stands and whatever its size") {
  Random random(1);
  for (int turned = 0; turned < 20; ++turned) {
    const auto cloud =
        in_box(turn(test::any_direction(random), random.between(-3, 3)), {0.5, 1, 1.5}, turned % 3 * 10, random);
    for (const std::string name : {"pca_hull", "pca_hull_area", "pca_rectangle", "face_aligned", "exact"}) {
      if (name == "pca_hull" && turned % 3 == 1) continue;  // points inside that rounding leaves on a face skew it
      CAPTURE(name);
      const auto volume = [&](double scale, double offset) {
        const fit::Result found = fit_box(name, scaled(cloud, scale, offset));
        return (2 / scale * std::get_if<Obb<double, 3>>(&found.volume)->half_extents).prod();
      };
      CHECK(volume(1, 0) == doctest::Approx(6).epsilon(1e-14));
      CHECK(volume(1, 1e3) == doctest::Approx(6).epsilon(1e-11));
      CHECK(volume(1e-160, 0) == doctest::Approx(6).epsilon(1e-14));
      CHECK(volume(0x1p500, 0) == doctest::Approx(6).epsilon(1e-14));
    }
  }
}

TEST_CASE("on a regular tetrahedron the best box with a face on a face is twice the smallest, which is a cube") {
  Random random(2);
  for (int turned = 0; turned < 20; ++turned) {
    const Matrix<double, 3> pose = turned == 0 ? Matrix<double, 3>(Matrix<double, 3>::Identity())
                                               : turn(test::any_direction(random), random.between(-3, 3));
    test::Cloud<double, 3> cloud;
    for (const Vector<double, 3>& p : test::Cloud<double, 3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
      cloud.push_back(pose * p);
    const AnyPointSet set = test::set_of<double, 3>(cloud);
    CHECK(volume_of("face_aligned", cloud) == doctest::Approx(16).epsilon(1e-14));
    const fit::Watched run = fit::find_algorithm("obb", "exact")->watch(set, {}, {});
    const auto& smallest = *std::get_if<Obb<double, 3>>(&run.result.volume);
    // On each curve of boxes the search ends as soon as none is smaller by more than kBoxProof of the size in each
    // length.
    CHECK(measure(smallest) == doctest::Approx(8).epsilon(1e-13));
    CHECK(smallest.half_extents.minCoeff() == doctest::Approx(1).epsilon(1e-13));
    CHECK(run.certificate.optimal == true);
    CHECK(fit::on_edges<3>(fit::contacts(smallest, std::get_if<PointSet<double, 3>>(&set)->span())));
    CHECK(run.steps < 1000);
  }
}

TEST_CASE("no rotation is more than 11 degrees from a fixed one, yet a thin stick gets a box many times too large") {
  std::vector<Matrix<double, 3>> fixed{Matrix<double, 3>::Identity()};
  for (fit::FixedRotations<3> all; fixed.size() <= static_cast<std::size_t>(fit::kRotations<3>);)
    fixed.push_back(all.next());
  /// The cosine of the least angle that turns one box's axes onto another's, whatever their order and signs.
  const auto nearness = [](const Matrix<double, 3>& a, const Matrix<double, 3>& b) {
    constexpr std::array<std::array<int, 3>, 6> kOrders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    const Matrix<double, 3> cosines = a.transpose() * b;
    double most = -1;
    for (std::size_t i = 0; i < kOrders.size(); ++i)
      for (const int x : {-1, 1})
        for (const int y : {-1, 1})
          most = std::max(most, x * cosines(0, kOrders[i][0]) + y * cosines(1, kOrders[i][1]) +
                                    (i < 3 ? 1 : -1) * x * y * cosines(2, kOrders[i][2]));
    return (most - 1) / 2;
  };
  Random random(5);
  double farthest = 1, worst = 1;
  for (int round = 0; round < 2000; ++round) {
    const Matrix<double, 3> pose = turn(test::any_direction(random), random.between(-3, 3));
    double nearest = -1;
    for (const Matrix<double, 3>& one : fixed) nearest = std::max(nearest, nearness(pose, one));
    farthest = std::min(farthest, nearest);
    if (round % 20 != 0) continue;
    const auto stick = in_box(pose, {1, 0.01, 0.01}, 0, random);
    worst = std::max(worst, volume_of("rotations", stick) / 8e-4);
    CHECK(volume_of("rotations", stick) <= volume_of("aabb", stick) * (1 + 1e-14));
  }
  CHECK(farthest > std::cos(11 * std::acos(-1) / 180));
  CHECK(farthest < std::cos(8 * std::acos(-1) / 180));
  CHECK(worst > 10);
}

TEST_CASE("rectangles that shrink a box by less and less come to an end") {
  // Around a tetrahedron each gains on the one before by a part that falls with the square of their number.
  int most = 0;
  Random random(2);
  for (int turned = 0; turned < 20; ++turned) {
    const Matrix<double, 3> pose = turn(test::any_direction(random), random.between(-3, 3));
    test::Cloud<double, 3> cloud;
    for (const Vector<double, 3>& p : test::Cloud<double, 3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
      cloud.push_back(pose * p);
    const int tried =
        rectangles_of(fit::find_algorithm("obb", "pca_rectangle")->record(test::set_of<double, 3>(cloud), {}));
    most = std::max(most, tried);
  }
  CHECK(most > 400);
  CHECK(most < fit::kMostRectangles);
}

TEST_CASE("however many rectangles would shrink a box, no more than stated are tried") {
  // Nine points in a plane but for float's rounding: 2,176 rectangles would each gain more than tolerance::kSameBox.
  const auto families = test::families();
  const auto circle = std::find_if(families.begin(), families.end(), [](auto& f) { return f.name == "on a circle"; });
  REQUIRE(circle != families.end());
  const auto cloud = test::member<float, 3>(circle - families.begin(), 4670);
  for (const std::string name : {"pca_rectangle", "exact"}) {
    CAPTURE(name);
    const auto run = fit::find_algorithm("obb", name)->record(test::set_of<float, 3>(cloud), {});
    CHECK(rectangles_of(run) == fit::kMostRectangles);
  }
}

TEST_CASE("the search for the smallest box tells at most one smaller box of each edge") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto run = fit::find_algorithm("obb", "exact")
                         ->record(test::set_of<double, 3>(test::generated<double, 3>("ball", 30, seed)), {});
    int boxes = -1, edges = 0, since = 0;  // the first box is the one to beat
    for (const auto& entry : run.steps) {
      if (std::holds_alternative<fit::BoxTried<double, 3>>(entry.step.fact)) ++boxes, ++since;
      if (!std::holds_alternative<fit::EdgeSearched>(entry.step.fact)) continue;
      CHECK(since - (edges == 0) <= 1);
      ++edges, since = 0;
    }
    CHECK(boxes > 0);
    CHECK(static_cast<int>(run.steps.size()) == 4 + rectangles_of(run) + boxes + edges);
  }
}

TEST_CASE("PCA of a solid cube's points can be more than four times too large, and that of its surface is not") {
  // All covariances of a cube are the same in all directions, so that a few points inside choose the axes: here those
  // whose every coordinate is 1/3 or 2/3, along each of which the cube's length is 5/3.
  Matrix<double, 3> worst;
  worst << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  worst /= 3;
  test::Cloud<double, 3> cloud = test::generated<double, 3>("lattice", 125, 1);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.2 * (axis + 1), 0.2 * (axis + 1)}) cloud.push_back(side * worst.col(axis));
  const double best = volume_of("exact", cloud);
  CHECK(best == doctest::Approx(8).epsilon(1e-14));
  CHECK(volume_of("pca", cloud) / best == doctest::Approx(125.0 / 27).epsilon(1e-9));
  CHECK(volume_of("pca_rectangle", cloud) == doctest::Approx(8).epsilon(1e-9));
}

TEST_CASE("PCA of the hull's surface is not skewed by how it was sampled") {
  // An ellipse along x with many points in one part of its rim.
  test::Cloud<double, 2> even, skewed;
  for (int i = 0; i < 2000; ++i) {
    const SineCosine at = sine_cosine(i * 2 * 3.141592653589793 / 2000);
    const Vector<double, 2> p(3 * at.cosine, 2 * at.sine);
    if (i % 10 == 0 || (i > 100 && i < 300)) skewed.push_back(p);
  }
  const auto tilt = [&](std::string_view name) {
    const fit::Result found = fit::find_algorithm("obb", name)->fit(test::set_of<double, 2>(skewed), {});
    return std::get_if<Obb<double, 3>>(&found.volume)->axes.topLeftCorner<2, 2>().cwiseAbs().minCoeff();
  };
  CHECK(tilt("pca") > 0.2);
  CHECK(tilt("pca_hull") > 0.2);
  CHECK(tilt("pca_hull_area") < 0.01);

  // A box whose faces carry points by the hundred in one corner: no vertices, but points.
  Random random(5);
  const Matrix<double, 3> pose = turn({1, 2, 3}, 0.5);
  test::Cloud<double, 3> box = in_box(Matrix<double, 3>::Identity(), {1, 2, 4}, 0, random);
  for (int i = 0; i < 500; ++i) box.push_back({1, random.between(1, 2), random.between(2, 4)});
  for (auto& p : box) p = pose * p;
  CHECK(volume_of("pca_hull_area", box) == doctest::Approx(64).epsilon(1e-12));
  CHECK(volume_of("pca", box) > 1.2 * 64);
}

TEST_CASE("rectangles shrink a box until none of them does") {
  int rounds = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto cloud = test::generated<double, 3>("cube", 40, seed);
    const auto run = fit::find_algorithm("obb", "pca_rectangle")->record(test::set_of<double, 3>(cloud), {});
    double measure_so_far = std::numeric_limits<double>::infinity();
    int kept = 0;
    for (const auto& entry : run.steps)
      if (const auto* rectangle = std::get_if<fit::RectangleFound<double, 3>>(&entry.step.fact)) {
        if (!rectangle->better) continue;
        CHECK(rectangle->measure < measure_so_far);
        measure_so_far = rectangle->measure;
        ++kept;
      }
    rounds += kept > 1;
    CHECK(fit::measure_of(run.result.volume, 3) == doctest::Approx(measure_so_far).epsilon(1e-12));
    CHECK(measure_so_far <= volume_of("pca_hull", cloud) * (1 + 1e-12));
    // Anew across the axes of the result, next to nothing is gained.
    Ignore ignore;
    const auto& box = *std::get_if<Obb<double, 3>>(&run.result.volume);
    for (int axis = 0; axis < 3; ++axis) {
      fit::ObbTrials<double, 3, Ignore> trials(cloud, ignore);
      trials.attempt(box.axes, std::array<Index, 0>{}, 0);
      const double before = trials.least();
      trials.attempt(fit::rectangle_along(box.axes.col(axis), trials.local().at).axes, std::array<Index, 0>{}, 0);
      CHECK(trials.least() >= before * (1 - 1e-3));
    }
  }
  CHECK(rounds > 5);
}

TEST_CASE("calipers turn around a projection edge by edge, and the smallest rectangle of the turn is the one found") {
  const auto cloud = test::generated<double, 3>("clusters", 14, 3);
  const auto run = fit::find_algorithm("obb", "pca_rectangle")->record(test::set_of<double, 3>(cloud), {});
  double least = std::numeric_limits<double>::infinity();
  std::array<Index, 2> best{kNoIndex, kNoIndex};
  int turns = 0, projections = 0;
  for (const auto& entry : run.steps) {
    if (const auto* turned = std::get_if<fit::CalipersTurned<double, 3>>(&entry.step.fact)) {
      ++turns;
      // A rectangle that lies on two edges is met twice, and measured with other rounding.
      if (!(std::abs(turned->area - least) <= 1e-12 * least)) CHECK(turned->better == (turned->area < least));
      if (turned->better) least = turned->area, best = {turned->touching[0], turned->touching[1]};
      CHECK(turned->least == least);
      const Obb<double, 3>& box = turned->box;
      CHECK(turned->area == doctest::Approx(4 * box.half_extents[1] * box.half_extents[2]));
      CHECK(std::abs(box.axes.col(0).dot(turned->along)) == doctest::Approx(1));
      for (const Index i : turned->touching) {  // on one of the sides
        const Vector<double, 3> at = box.axes.transpose() * (cloud[i] - box.center);
        const Vector<double, 3> beyond = at.cwiseAbs() - box.half_extents;
        CHECK(std::max(beyond[1], beyond[2]) == doctest::Approx(0).epsilon(1e-12));
      }
    } else if (const auto* found = std::get_if<fit::RectangleFound<double, 3>>(&entry.step.fact)) {
      CHECK(std::array<Index, 2>{found->edge_a, found->edge_b} == best);
      least = std::numeric_limits<double>::infinity();
      ++projections;
    }
  }
  CHECK(turns >= 3 * projections);
  CHECK(projections >= 3);
}

TEST_CASE("the calipers' edges are reported up to a bound, and a run without an observer finds the same box") {
  const AnyPointSet points = test::set_of<double, 3>(test::generated<double, 3>("ball", 2000, 1));
  const auto run = fit::find_algorithm("obb", "pca_rectangle")->record(points, {});
  const auto turned = std::count_if(run.steps.begin(), run.steps.end(), [](const auto& entry) {
    return std::holds_alternative<fit::CalipersTurned<double, 3>>(entry.step.fact);
  });
  CHECK(turned <= 240);
  const auto plain = fit::find_algorithm("obb", "pca_rectangle")->fit(points, {}).volume;
  CHECK(std::get<Obb<double, 3>>(run.result.volume).axes == std::get<Obb<double, 3>>(plain).axes);
}

TEST_CASE("DiTO's box is never larger than the AABB, and near the smallest on turned boxes") {
  Random random(9);
  for (int turned = 0; turned < 50; ++turned) {
    const auto cloud = in_box(turn(test::any_direction(random), random.between(-3, 3)), {0.3, 1, 2}, 200, random);
    const double dito = volume_of("dito", cloud);
    CHECK(dito <= volume_of("aabb", cloud) * (1 + 1e-14));
    CHECK(dito < 8 * 0.6 * 1.3);
  }
}

TEST_CASE("the box from watched sums is PCA's, to the last bit") {
  for (const char* kind : {"gaussian", "stick", "clusters", "line"})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto points = test::set_of<double, 3>(test::generated<double, 3>(kind, 30, seed, 1, 10));
      const auto plain = fit::find_algorithm("obb", "pca")->fit(points, {}).volume;
      const auto run = fit::find_algorithm("obb", "pca_sums")->record(points, {});
      CHECK(std::get<Obb<double, 3>>(run.result.volume).axes == std::get<Obb<double, 3>>(plain).axes);
      CHECK(std::get<Obb<double, 3>>(run.result.volume).half_extents == std::get<Obb<double, 3>>(plain).half_extents);
      CHECK(run.steps.size() == 30 + 5);
    }
}

TEST_CASE("the one-pass formula loses its digits far from the origin, and its box contains every point even so") {
  int looser = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto volume = [&](const char* name, double offset) {
      const auto points = test::set_of<double, 3>(test::generated<double, 3>("stick", 30, seed, 1, offset));
      const auto run = fit::find_algorithm("obb", name)->record(points, {});
      CHECK(run.certificate.contains);
      return fit::measure_of(run.result.volume, 3);
    };
    CHECK(volume("pca_one_pass", 0) == doctest::Approx(volume("pca", 0)).epsilon(1e-9));
    looser += volume("pca_one_pass", 1e9) > 2 * volume("pca", 1e9) ? 1 : 0;
  }
  CHECK(looser > 10);
}

TEST_CASE("sums that overflow leave a box with the world's axes") {
  constexpr double most = PointSet<double, 3>::kLargest;
  test::Cloud<double, 3> cloud;
  for (int i = 0; i < 600; ++i)
    cloud.push_back({i % 2 == 0 ? most : -most, i % 3 == 0 ? most : 0, i % 5 == 0 ? most : 0});
  const auto run = fit::find_algorithm("obb", "pca_one_pass")->record(test::set_of<double, 3>(cloud), {});
  CHECK(run.certificate.contains);
  CHECK(std::get<Obb<double, 3>>(run.result.volume).axes.isIdentity(1e-12));
}
