// What updates promise: every placed point is held exactly through full turns; what each is worth; and that hill
// climbing is rebuilding, bit for bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/point_clouds.hpp"
#include "fit/aabb/aabb_min_max.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/kdop/kdop_fit.hpp"
#include "fit/update/update_hill_climb.hpp"
#include "fit/update/update_kdop_climb.hpp"
#include "fit/update/update_loose.hpp"
#include "fit/update/update_obb.hpp"
#include "fit/update/update_rebuild.hpp"
#include "fit/update/update_rotated_box.hpp"
#include "fit/update/update_sphere.hpp"
#include "geometry/turn.hpp"
#include "query/contain/contains.hpp"

using namespace snug;

namespace {

constexpr std::array<int, 3> kEveryKPlane{4, 6, 8};
constexpr std::array<int, 4> kEveryKSpace{6, 14, 18, 26};

template <int Dim>
int most_slabs_k() {
  return Dim == 2 ? 8 : 26;
}

/// Turned by so much about an axis that is not one of the coordinates', and moved.
template <class Scalar, int Dim>
Pose<Scalar, Dim> pose_at(double radians, const Vector<double, 3>& axis, const Vector<double, 3>& moved) {
  Pose<Scalar, Dim> pose;
  if constexpr (Dim == 2) pose.rotation = turn(radians).template cast<Scalar>();
  else pose.rotation = turn(axis, radians).template cast<Scalar>();
  for (int i = 0; i < Dim; ++i) pose.translation[i] = static_cast<Scalar>(moved[i]);
  return pose;
}

template <class Scalar, int Dim>
PointSet<Scalar, Dim> placed_set(PointSpan<Scalar, Dim> points, const Pose<Scalar, Dim>& pose) {
  test::Cloud<Scalar, Dim> cloud;
  for (const auto& p : points) cloud.push_back(placed(pose, p));
  return test::set_of<Scalar, Dim>(std::move(cloud));
}

template <class VolumeType, class Scalar, int Dim>
bool holds_all(const VolumeType& volume, PointSpan<Scalar, Dim> points) {
  return std::all_of(points.begin(), points.end(), [&](const auto& p) { return query::contains(volume, p); });
}

/// A body, with every volume that an update starts from, and its hull to climb over.
template <class Scalar, int Dim>
struct Body {
  PointSet<Scalar, Dim> points;
  Aabb<Scalar, Dim> box;
  Sphere<Scalar, Dim> ball;
  Obb<Scalar, Dim> oriented;
  fit::LooseReach<Scalar> reach;
  ConvexHull<Scalar, Dim> hull;
  HullNeighbors neighbors;

  explicit Body(test::Cloud<Scalar, Dim> cloud) : points(test::set_of<Scalar, Dim>(std::move(cloud))) {
    box = fit::aabb_min_max(points.span()).volume;
    ball.center = box.min + (box.max - box.min) / 2;
    ball.radius = enclosing_radius(ball.center, points.span(), farthest_points(ball.center, points.span()));
    oriented.center = ball.center;
    oriented.axes = pose_at<Scalar, Dim>(0.7, {1, 2, 3}, {0, 0, 0}).rotation;
    for (int i = 0; i < Dim; ++i) {
      const Vector<Scalar, Dim> axis = oriented.axes.col(i);
      Scalar& half = oriented.half_extents[i];
      for (const auto& p : points.span())
        while (query::side_of_slab<Scalar, Dim>(p, oriented.center, axis, half) > 0) {
          const Vector<Scalar, Dim> from_center = p - oriented.center;
          const Scalar step = std::numeric_limits<Scalar>::epsilon() * from_center.cwiseAbs().maxCoeff();
          half = std::max(half, std::abs(axis.dot(from_center))) + step + std::numeric_limits<Scalar>::denorm_min();
        }
    }
    reach = fit::loose_reach(points.span());
    hull = fit::quickhull(points.span()).volume;
    neighbors = hull_neighbors(hull);
  }
  [[nodiscard]] fit::HillClimb<Scalar, Dim> climb(int directions) const {
    const bool all_points = hull.vertices.size() == static_cast<std::size_t>(points.size());
    return {std::span<const Vector<Scalar, Dim>>(hull.vertices), neighbors, directions, all_points};
  }
};

template <class Scalar, int Dim>
void check_one_turn(const std::string& name, const Body<Scalar, Dim>& body, int frames,
                    const Vector<double, 3>& moved) {
  auto climb = body.climb(2 * Dim);
  const int k = most_slabs_k<Dim>();
  auto climb_kdop = body.climb(k);
  for (int frame = 0; frame <= frames; ++frame) {
    INFO(name << ", frame " << frame << ", dim " << Dim << ", " << sizeof(Scalar) << " bytes");
    const auto pose = pose_at<Scalar, Dim>(2 * std::numbers::pi * frame / frames, {1, -2, 0.5}, moved);
    const auto world = placed_set(body.points.span(), pose);
    REQUIRE(holds_all(fit::update_rebuild(body.points.span(), pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_loose(body.reach, pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_rotated_box(body.box, pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_hill_climb(climb, pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_sphere(body.ball, fit::local_error(body.ball), pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_obb(body.oriented, fit::local_error(body.oriented), pose).volume, world.span()));
    REQUIRE(holds_all(fit::update_kdop_climb(climb_kdop, k, pose).volume, world.span()));
  }
}

template <class Scalar, int Dim>
bool same_box(const Aabb<Scalar, Dim>& a, const Aabb<Scalar, Dim>& b) {
  return a.min == b.min && a.max == b.max;
}

/// The corners of a cube of that width about the origin.
template <class Scalar, int Dim>
test::Cloud<Scalar, Dim> cube(Scalar width) {
  test::Cloud<Scalar, Dim> corners;
  for (int v = 0; v < 1 << Dim; ++v) {
    Vector<Scalar, Dim> corner;
    for (int i = 0; i < Dim; ++i) corner[i] = (v >> i & 1) == 0 ? -width / 2 : width / 2;
    corners.push_back(corner);
  }
  return corners;
}

/// Everyone's neighbour is the next in each of the lists.
HullNeighbors joined(const std::vector<std::vector<Index>>& lists) {
  HullNeighbors neighbors{{0}, {}, {}};
  for (const auto& list : lists) {
    neighbors.ends.insert(neighbors.ends.end(), list.begin(), list.end());
    neighbors.begin.push_back(static_cast<Index>(neighbors.ends.size()));
  }
  return neighbors;
}

}  // namespace

TEST_CASE_TEMPLATE("every update holds every placed point exactly, over full turns", Scalar, float, double) {
  for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(1, 24))
    check_one_turn<Scalar, 2>(name, Body<Scalar, 2>(points), 24, {0, 0, 0});
  for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(2, 24))
    check_one_turn<Scalar, 3>(name, Body<Scalar, 3>(points), 24, {0, 0, 0});
  for (const char* kind : {"cube", "sphere", "stick"})
    for (const double far : {0.0, 1e3, 1e8}) {
      const Vector<double, 3> moved(far, -0.3 * far, 0.7 * far);
      check_one_turn<Scalar, 2>(kind, Body<Scalar, 2>(test::generated<Scalar, 2>(kind, 60, 3)), 36, moved);
      check_one_turn<Scalar, 3>(kind, Body<Scalar, 3>(test::generated<Scalar, 3>(kind, 60, 4)), 36, moved);
    }
}

TEST_CASE_TEMPLATE("hill climbing gives the box that rebuilding gives, bit for bit", Scalar, float, double) {
  int walked = 0;
  for (const char* kind : {"sphere", "ball", "lattice", "cube", "line"})
    for (const double scale : {1.0, sizeof(Scalar) == 8 ? 1e-150 : 1e-18}) {
      CAPTURE(kind);
      // The hull's vertices alone are the body here.
      const Body<Scalar, 3> whole(test::generated<Scalar, 3>(kind, 400, 5, scale));
      const Body<Scalar, 3> body(whole.hull.vertices);
      REQUIRE(body.hull.vertices.size() == static_cast<std::size_t>(body.points.size()));
      auto climb = body.climb(6);
      std::array<fit::HillClimb<Scalar, 3>, 4> climbs{body.climb(6), body.climb(14), body.climb(18), body.climb(26)};
      for (int frame = 0; frame < 40; ++frame) {
        // Small turns and leaps; a quarter turn now and then, where whole faces lie across the axes.
        const double rate = frame % 5 == 4 ? 17.3 : frame % 7 == 6 ? std::numbers::pi / 2 : 0.05;
        const double far = frame % 2 == 0 ? 0 : 1e6 * scale;
        const auto pose = pose_at<Scalar, 3>(rate * frame, {frame % 3 == 0 ? 0.0 : 1.0, 0, 1}, {far, far, -far});
        Recorder<fit::UpdateStep<Aabb<Scalar, 3>>> recorder;
        const auto rebuilt = fit::update_rebuild(body.points.span(), pose).volume;
        CHECK(same_box(fit::update_hill_climb(climb, pose, recorder).volume, rebuilt));
        for (const auto& entry : recorder.entries) {
          const auto* fact = std::get_if<fit::ExtremeClimbed>(&entry.step.fact);
          walked += fact != nullptr && fact->path.size() > 1 ? 1 : 0;
        }
        const auto world = placed_set(body.points.span(), pose);
        for (std::size_t i = 0; i < climbs.size(); ++i) {
          const auto climbed = fit::update_kdop_climb(climbs[i], kEveryKSpace[i], pose).volume;
          const auto fitted = fit::kdop_fit(world.span(), kEveryKSpace[i]).volume;
          CHECK(climbed.min == fitted.min);
          CHECK(climbed.max == fitted.max);
        }
      }
    }
  CHECK(walked > 500);
}

TEST_CASE_TEMPLATE("hill climbing gives the rectangle that rebuilding gives, bit for bit", Scalar, float, double) {
  for (const char* kind : {"sphere", "lattice", "line"}) {
    const Body<Scalar, 2> whole(test::generated<Scalar, 2>(kind, 100, 5));
    const Body<Scalar, 2> body(whole.hull.vertices);
    auto climb = body.climb(4);
    std::array<fit::HillClimb<Scalar, 2>, 3> climbs{body.climb(4), body.climb(6), body.climb(8)};
    for (int frame = 0; frame < 100; ++frame) {
      const auto pose = pose_at<Scalar, 2>(frame % 9 == 8 ? std::numbers::pi / 4 * frame : 0.1 * frame, {}, {1, 2, 0});
      CHECK(same_box(fit::update_hill_climb(climb, pose).volume, fit::update_rebuild(body.points.span(), pose).volume));
      const auto world = placed_set(body.points.span(), pose);
      for (std::size_t i = 0; i < climbs.size(); ++i) {
        const auto fitted = fit::kdop_fit(world.span(), kEveryKPlane[i]).volume;
        CHECK(fit::update_kdop_climb(climbs[i], kEveryKPlane[i], pose).volume.max == fitted.max);
      }
    }
  }
}

TEST_CASE("a climb that is watched shows the walk vertex by vertex, and is the climb that is timed") {
  int steps = 0;
  for (const char* kind : {"sphere", "lattice", "ball"}) {
    const Body<double, 3> body(test::generated<double, 3>(kind, 200, 5));
    auto watched = body.climb(6), timed = body.climb(6);
    for (int frame = 0; frame < 30; ++frame) {
      const auto pose = pose_at<double, 3>(0.4 * frame, {1, 2, 3}, {0, 0, 0});
      std::vector<Index> before;
      for (int side = 0; side < 6; ++side) before.push_back(watched.end(side));
      Recorder<fit::UpdateStep<Aabb<double, 3>>> recorder;
      const auto box = fit::update_hill_climb(watched, pose, recorder).volume;
      CHECK(same_box(fit::update_hill_climb(timed, pose).volume, box));
      Index at = kNoIndex, looked_at = 0;  // of the climb at hand: where it goes next, how many vertices it examined
      int climbs = 0;
      for (const auto& entry : recorder.entries) {
        if (const auto* walk = std::get_if<fit::NeighborsCompared>(&entry.step.fact)) {
          ++steps;
          if (at == kNoIndex) {
            CHECK(walk->vertex == before[climbs]);
            looked_at = 1;
          }
          const auto around = body.neighbors.of(walk->vertex);
          for (const Index neighbor : walk->neighbors)
            CHECK(std::find(around.begin(), around.end(), neighbor) != around.end());
          const bool goes = walk->best != walk->vertex && walk->best != at;
          if (goes)
            CHECK(std::find(walk->neighbors.begin(), walk->neighbors.end(), walk->best) != walk->neighbors.end());
          looked_at += static_cast<Index>(walk->neighbors.size());
          at = walk->best;
        } else if (const auto* climbed = std::get_if<fit::ExtremeClimbed>(&entry.step.fact)) {
          CHECK(climbed->path.front() == before[climbs]);
          CHECK(climbed->path.back() == at);
          CHECK(climbed->path.back() == watched.end(climbs));
          CHECK(climbed->looked_at == looked_at);
          ++climbs, at = kNoIndex;
        }
      }
      CHECK(climbs == 6);
    }
  }
  CHECK(steps > 1000);
}

TEST_CASE("plateaus do not stop a walk: a chain of equal vertices, and hilltops that only rounding makes") {
  // Three places along a line, the first one twelve times over, and only its last copy knows the way on.
  test::Cloud<double, 2> vertices(12, {0, 0});
  vertices.push_back({1, 0});
  vertices.push_back({2, 0});
  std::vector<std::vector<Index>> lists;
  for (Index v = 0; v < 14; ++v) {
    lists.emplace_back();
    if (v > 0) lists.back().push_back(v - 1);
    if (v < 13) lists.back().push_back(v + 1);
  }
  const HullNeighbors chain = joined(lists);
  fit::HillClimb<double, 2> climb(vertices, chain, 4, true);
  CHECK(fit::update_hill_climb(climb, Pose<double, 2>{}).volume.max == Vector<double, 2>(2, 0));
  CHECK(fit::update_hill_climb(climb, Pose<double, 2>{turn(std::numbers::pi), {0, 0}}).volume.min[0] == -2);

  // A ring of points so close together that rounding shuffles their heights.
  test::Cloud<float, 2> ring;
  std::vector<std::vector<Index>> around;
  constexpr Index kRing = 3000;
  for (Index v = 0; v < kRing; ++v) {
    ring.push_back((turn(2 * std::numbers::pi * v / kRing) * Vector<double, 2>(1, 0)).cast<float>());
    around.push_back({(v + 1) % kRing, (v + kRing - 1) % kRing});
  }
  const HullNeighbors circle = joined(around);
  fit::HillClimb<float, 2> walk(ring, circle, 4, true);
  const auto set = test::set_of<float, 2>(ring);
  for (int frame = 0; frame < 200; ++frame) {
    const auto pose = pose_at<float, 2>(0.03 * frame, {}, {0, 0, 0});
    REQUIRE(same_box(fit::update_hill_climb(walk, pose).volume, fit::update_rebuild(set.span(), pose).volume));
  }
}

TEST_CASE("the loose box of a unit cube is the square root of 3 each way, in every orientation") {
  const Body<double, 3> body(cube<double, 3>(1));
  for (int frame = 0; frame < 50; ++frame) {
    const auto box = fit::update_loose(body.reach, pose_at<double, 3>(frame, {1, 2, 3}, {5, 6, 7})).volume;
    for (int i = 0; i < 3; ++i) CHECK(box.max[i] - box.min[i] == doctest::Approx(std::sqrt(3.0)).epsilon(1e-14));
    CHECK(measure(box) == doctest::Approx(3 * std::sqrt(3.0)));
  }
}

TEST_CASE("the four strategies on a square turned by 45 degrees have the slack that one expects") {
  const Body<double, 2> square(cube<double, 2>(1));
  auto climb = square.climb(4);
  const auto pose = pose_at<double, 2>(std::numbers::pi / 4, {}, {0, 0, 0});
  const double tight = measure(fit::update_rebuild(square.points.span(), pose).volume);
  CHECK(tight == doctest::Approx(2));
  CHECK(fit::slack(measure(fit::update_hill_climb(climb, pose).volume), tight) == 0);
  CHECK(fit::slack(measure(fit::update_rotated_box(square.box, pose).volume), tight) == doctest::Approx(0));
  CHECK(fit::slack(measure(fit::update_loose(square.reach, pose).volume), tight) == doctest::Approx(0));
  CHECK(fit::slack(measure(fit::update_loose(square.reach, Pose<double, 2>{}).volume), 1) == doctest::Approx(1));

  // A disc of the same width turns its box out of its tight place: twice too large.
  const Body<double, 2> disc(test::generated<double, 2>("sphere", 2000, 1));
  const double round = measure(fit::update_rebuild(disc.points.span(), pose).volume);
  CHECK(fit::slack(measure(fit::update_rotated_box(disc.box, pose).volume), round) == doctest::Approx(1).epsilon(0.01));
  CHECK(fit::slack(measure(fit::update_loose(disc.reach, pose).volume), round) == doctest::Approx(0).epsilon(0.01));
}

TEST_CASE("from the local box an update never drifts; from last frame's world box it grows without end") {
  const Body<double, 2> body(cube<double, 2>(1));
  const int frames = 360;
  const auto step = pose_at<double, 2>(2 * std::numbers::pi / frames, {}, {0, 0, 0});
  Aabb<double, 2> world = body.box;
  double worst_local = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    world = fit::update_rotated_box(world, step).volume;
    const auto pose = pose_at<double, 2>(2 * std::numbers::pi * frame / frames, {}, {0, 0, 0});
    worst_local = std::max(worst_local, measure(fit::update_rotated_box(body.box, pose).volume));
  }
  CHECK(worst_local == doctest::Approx(2));
  CHECK(measure(world) > 10000);  // (cos 1 + sin 1 degree)^720
}

TEST_CASE("an oriented box and a sphere stay as tight as they were, even through ten thousand updates of themselves") {
  const Body<double, 3> body(test::generated<double, 3>("stick", 40, 3));
  Obb<double, 3> box = body.oriented;
  Sphere<double, 3> ball = body.ball;
  auto points = body.points;
  const auto step = pose_at<double, 3>(0.01, {1, 2, -3}, {1e-3, 0, 0});
  for (int frame = 0; frame < 10000; ++frame) {
    box = fit::update_obb(box, fit::local_error(box), step).volume;
    ball = fit::update_sphere(ball, fit::local_error(ball), step).volume;
    points = placed_set(points.span(), step);
    if (frame % 1000 != 999) continue;
    CHECK(holds_all(box, points.span()));
    CHECK(holds_all(ball, points.span()));
  }
  CHECK((box.axes.transpose() * box.axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff() <
        tolerance::kObbAxes<double>);
  CHECK(measure(box) == doctest::Approx(measure(body.oriented)).epsilon(1e-8));
  CHECK(measure(ball) == doctest::Approx(measure(body.ball)).epsilon(1e-8));
}

TEST_CASE("what an update costs: a few vertices for a box, k walks for a k-DOP, nothing that grows for the others") {
  const Body<double, 3> body(test::generated<double, 3>("sphere", 4000, 7));
  const auto touched = [](const Counter& counter) {
    return counter.counts[static_cast<std::size_t>(Operation::kPointsTouched)];
  };
  Counter rebuild, box, kdop, rotated, oriented, ball;
  auto climb = body.climb(6);
  auto climb_kdop = body.climb(26);
  fit::update_hill_climb(climb, Pose<double, 3>{});  // the first walks are long
  fit::update_kdop_climb(climb_kdop, 26, Pose<double, 3>{});
  constexpr int kFrames = 100;
  for (int frame = 1; frame <= kFrames; ++frame) {
    const auto pose = pose_at<double, 3>(0.02 * frame, {1, 2, 3}, {0, 0, 0});
    fit::update_rebuild(body.points.span(), pose, rebuild);
    fit::update_hill_climb(climb, pose, box);
    fit::update_kdop_climb(climb_kdop, 26, pose, kdop);
    fit::update_rotated_box(body.box, pose, rotated);
    fit::update_obb(body.oriented, fit::local_error(body.oriented), pose, oriented);
    fit::update_sphere(body.ball, fit::local_error(body.ball), pose, ball);
  }
  CHECK(touched(rebuild) == 4000 * kFrames);
  CHECK(touched(box) * 20 < touched(rebuild));  // some 25 vertices a walk
  // 26 walks where the box takes 6.
  const double ratio = static_cast<double>(touched(kdop)) / static_cast<double>(touched(box));
  CHECK(ratio > 0.8 * 26 / 6);
  CHECK(ratio < 1.2 * 26 / 6);
  CHECK(touched(rotated) + touched(oriented) + touched(ball) == 0);
}

TEST_CASE("every update ends with a last step and names lines of its pseudocode; each kind of step happens") {
  const Body<double, 3> body(test::generated<double, 3>("gaussian", 100, 3));
  const auto pose = pose_at<double, 3>(1, {1, 2, 3}, {4, 5, 6});
  auto climb = body.climb(6);
  auto climb_kdop = body.climb(14);
  std::vector<bool> seen(std::variant_size_v<fit::UpdateStep<Aabb<double, 3>>::Fact>);
  const auto check = [&]<class VolumeType>(std::size_t lines, const Recorder<fit::UpdateStep<VolumeType>>& recorder) {
    REQUIRE(!recorder.entries.empty());
    CHECK(std::holds_alternative<fit::Finished>(recorder.entries.back().step.fact));
    CHECK(recorder.entries.back().step.has_volume);
    CHECK(static_cast<std::size_t>(recorder.entries.back().step.line) == lines - 1);
    for (const auto& entry : recorder.entries) {
      CHECK(static_cast<std::size_t>(entry.step.line) < lines);
      seen[entry.step.fact.index()] = true;
    }
  };
  Recorder<fit::UpdateStep<Aabb<double, 3>>> loose, rebuild, climbed, rotated;
  fit::update_loose(fit::loose_reach(body.points.span(), loose), pose, loose);
  check(fit::kUpdateLoosePseudocode.size(), loose);
  const auto rebuilt = fit::update_rebuild(body.points.span(), pose, rebuild);
  check(fit::kUpdateRebuildPseudocode.size(), rebuild);
  CHECK(same_box(rebuild.entries.back().step.volume, rebuilt.volume));
  const auto climbed_box = fit::update_hill_climb(climb, pose, climbed);
  check(fit::kUpdateHillClimbPseudocode.size(), climbed);
  CHECK(same_box(climbed.entries.back().step.volume, climbed_box.volume));
  fit::update_rotated_box(body.box, pose, rotated);
  check(fit::kUpdateRotatedBoxPseudocode.size(), rotated);
  Recorder<fit::UpdateStep<Sphere<double, 3>>> ball;
  fit::update_sphere(body.ball, fit::local_error(body.ball), pose, ball);
  check(fit::kUpdateSpherePseudocode.size(), ball);
  Recorder<fit::UpdateStep<Obb<double, 3>>> oriented;
  fit::update_obb(body.oriented, fit::local_error(body.oriented), pose, oriented);
  check(fit::kUpdateObbPseudocode.size(), oriented);
  Recorder<fit::UpdateStep<Kdop<double, 3>>> kdop;
  fit::update_kdop_climb(climb_kdop, 14, pose, kdop);
  check(fit::kUpdateKdopClimbPseudocode.size(), kdop);
  CHECK(std::count(seen.begin(), seen.end(), false) == 0);
}
