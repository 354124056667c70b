// GJK against whole numbers, and where rounding hides the nearest features.
#include "query/distance/gjk.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/query/volume_pairs.hpp"
#include "geometry/random.hpp"

using namespace snug;
using query::Separation;

namespace {

using Whole = std::array<std::int64_t, 3>;
using Hull = ConvexHull<double, 3>;

Whole minus(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
std::int64_t dot_of(const Whole& a, const Whole& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The least of some fractions.
struct Least {
  std::int64_t above = -1, below = 1;
  void offer(std::int64_t a, std::int64_t b) {
    if (above < 0 || a * below < above * b) above = a, below = b;
  }
};

void offer_edge(Least& least, const Whole& a, const Whole& b) {
  const Whole e = minus(b, a);
  const std::int64_t along = -dot_of(a, e), square = dot_of(e, e);
  if (along >= 0 && along <= square && square > 0) least.offer(dot_of(a, a) * square - along * along, square);
}

void offer_triangle(Least& least, const Whole& a, const Whole& b, const Whole& c) {
  const Whole n = cross(minus(b, a), minus(c, a));
  const std::int64_t square = dot_of(n, n), height = dot_of(a, n);
  if (square == 0 || dot_of(n, cross(a, b)) < 0 || dot_of(n, cross(b, c)) < 0 || dot_of(n, cross(c, a)) < 0) return;
  least.offer(height * height, square);
}

bool holds_origin(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  const std::array<std::int64_t, 4> volumes{dot_of(b, cross(c, d)), -dot_of(a, cross(c, d)), dot_of(d, cross(a, b)),
                                            -dot_of(c, cross(a, b))};
  std::int64_t sum = 0;
  for (const std::int64_t volume : volumes) sum += volume;
  if (sum == 0) return false;  // flat: its triangles tell
  return std::all_of(volumes.begin(), volumes.end(), [&](std::int64_t v) { return sum > 0 ? v >= 0 : v <= 0; });
}

/// The squared distance of the hulls of two sets of lattice points: every simplex of their difference is tried.
Least exact_square(const std::vector<Whole>& a, const std::vector<Whole>& b) {
  std::vector<Whole> w;
  for (const Whole& p : a)
    for (const Whole& q : b) w.push_back(minus(p, q));
  Least least;
  for (std::size_t i = 0; i < w.size(); ++i) {
    least.offer(dot_of(w[i], w[i]), 1);
    for (std::size_t j = i + 1; j < w.size(); ++j) {
      offer_edge(least, w[i], w[j]);
      for (std::size_t k = j + 1; k < w.size(); ++k) {
        offer_triangle(least, w[i], w[j], w[k]);
        for (std::size_t l = k + 1; l < w.size(); ++l)
          if (holds_origin(w[i], w[j], w[k], w[l])) return {0, 1};
      }
    }
  }
  return least;
}

template <int Dim>
ConvexHull<double, Dim> hull_of(const std::vector<Whole>& points, double scale) {
  ConvexHull<double, Dim> hull;
  for (const Whole& p : points) {
    auto& vertex = hull.vertices.emplace_back();
    for (int i = 0; i < Dim; ++i) vertex[i] = static_cast<double>(p[i]) * scale;
  }
  return hull;
}

template <int Dim>
void check_lattice(std::uint64_t seed, int rounds) {
  Random random(seed);
  int touching = 0, apart = 0;
  for (int round = 0; round < rounds; ++round) {
    CAPTURE(round);
    const auto any = [&](int shift) {
      std::vector<Whole> points(1 + random.below(4));
      for (Whole& p : points)
        for (std::size_t i = 0; i < Dim; ++i) p[i] = static_cast<int>(random.below(5)) - 2 + shift;
      return points;
    };
    const auto a = any(0), b = any(static_cast<int>(random.below(4)));
    const Least exact = exact_square(a, b);
    const double distance = std::sqrt(static_cast<double>(exact.above) / static_cast<double>(exact.below));
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(600)) - 300);
    const auto found = *query::gjk(hull_of<Dim>(a, scale), hull_of<Dim>(b, scale));
    const double doubt = 64 * tolerance::kRoundoff<double> * 8;
    CHECK(found.overlap == (exact.above == 0));
    CHECK(std::abs(found.distance / scale - distance) <= doubt);
    CHECK(std::abs(found.gap / scale - distance) <= doubt);
    CHECK(found.gap <= found.distance);
    if (!found.overlap) CHECK(std::abs((found.on_a - found.on_b).norm() / scale - distance) <= doubt);
    (found.overlap ? touching : apart) += 1;
  }
  CHECK(touching > rounds / 10);
  CHECK(apart > rounds / 10);
}

/// Counts what the run did.
struct Watch {
  int doubled = 0, steps = 0, nearest = 0;
  double before = -1;
  bool nearer = true;
  query::GjkStep last;

  void operator()(const query::GjkStep& step) {
    ++steps;
    last = step;
    if (std::holds_alternative<query::DigitsDoubled>(step.fact)) ++doubled, before = -1;
    const auto* found = std::get_if<query::NearestFound>(&step.fact);
    if (found == nullptr) return;
    ++nearest;
    nearer = nearer && (before < 0 || found->distance <= before);
    before = found->distance;
  }
  void count(Operation, std::int64_t) {}
};

}  // namespace

TEST_CASE("hulls of lattice points have the distance that whole numbers give") {
  check_lattice<2>(1, 400);
  check_lattice<3>(2, 400);
}

TEST_CASE("the hulls of one point, two and three in every order") {
  const Hull point{.vertices = {{0, 0, 3}}};
  const Hull edge{.vertices = {{-1, 0, 0}, {1, 0, 0}}};
  const Hull triangle{.vertices = {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}};
  CHECK(query::gjk(point, edge)->distance == 3);
  CHECK(query::gjk(edge, point)->distance == 3);
  CHECK(query::gjk(triangle, point)->distance == 2);
  CHECK(query::gjk(edge, triangle)->distance == 1);
  CHECK(query::gjk(edge, triangle)->direction == Vector<double, 3>(0, 0, 1));
  CHECK(query::gjk(triangle, triangle)->overlap);
  CHECK(query::gjk(point, point)->overlap);
  CHECK_FALSE(query::gjk(point, Hull{}).has_value());
  const Hull many{.vertices = std::vector<Vector<double, 3>>(50, Vector<double, 3>(0, 0, 3))};
  CHECK(query::gjk(many, point)->overlap);
  CHECK(query::gjk(many, edge)->distance == 3);
}

TEST_CASE("gaps from a whole to a rounding are found between faces, edges and slivers") {
  // Two prisms over the same triangle, one above the other: rounding makes each simplex's own direction far too rough
  // for the small gaps, and a sliver's rougher still.
  Random random(3);
  int doubled = 0, slivers_undecided = 0, others_undecided = 0;
  for (int round = 0; round < 400; ++round) {
    const double gap = std::pow(10.0, -random.between(0, 13));
    const double thin = random.below(2) == 0 ? 1 : std::pow(10.0, -random.between(0, 12));
    CAPTURE(gap);
    CAPTURE(thin);
    const Matrix<double, 3> turned = turn({random.between(-1, 1), random.between(-1, 1), 0.3}, random.between(-3, 3));
    Hull a, b;
    for (int i = 0; i < 3; ++i) {
      const Vector<double, 3> p(random.between(-1, 1), thin * random.between(-1, 1), 0);
      const Vector<double, 3> q(random.between(-1, 1), thin * random.between(-1, 1), gap);
      a.vertices.push_back(turned * p), a.vertices.push_back(turned * (p - Vector<double, 3>(0, 0, 1)));
      b.vertices.push_back(turned * q), b.vertices.push_back(turned * (q + Vector<double, 3>(0, 0, 1)));
    }
    Watch watch;
    const auto found = *query::gjk(a, b, false, watch);
    CHECK(found.overlap == false);
    // A sliver's own plane is known by some digits fewer; so are both bounds, in a few rounds of a hundred.
    const bool undecided = found.distance - found.gap > 32 * tolerance::kRoundoff<double>;
    CHECK(found.gap >= gap - (thin == 1 ? 100 : 1e4) * tolerance::kRoundoff<double>);
    (thin == 1 ? others_undecided : slivers_undecided) += undecided;
    doubled += watch.doubled;
  }
  CHECK(doubled > 20);
  CHECK(slivers_undecided < 20);
  CHECK(others_undecided < 4);  // their corners are drawn, and may make a sliver by themselves
}

TEST_CASE("both bounds meet for hulls of many points, cospherical and flat") {
  test::VolumeMaker<double, 3> make(4);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    Hull a, b;
    for (int i = 0; i < 500; ++i) {
      a.vertices.push_back(make.direction());
      Vector<double, 3> p = make.direction();
      if (round % 2 == 0) p[2] = 0;
      b.vertices.push_back(p + Vector<double, 3>(make.between(-1e-9, 1e-9), 0, 1.9 + 0.01 * round));
    }
    Watch watch;
    const auto found = *query::gjk(a, b, false, watch);
    CHECK(found.distance - found.gap <= 64 * tolerance::kRoundoff<double>);
    CHECK(watch.nearest < 60);
    CHECK(watch.nearer);
  }
}

TEST_CASE("the run ends in a step that says what was found, and each simplex is nearer than the one before") {
  test::VolumeMaker<double, 3> make(5);
  int apart = 0;
  for (int round = 0; round < 50; ++round) {
    const auto a = std::get<ConvexHull<double, 3>>(make.make(6, test::Make::kSolid));
    const auto b = std::get<ConvexHull<double, 3>>(
        test::moved<double, 3>(make.make(6, test::Make::kSolid), make.direction() * 1.5));
    Watch watch;
    const Separation<double, 3> found = *query::gjk(a, b, false, watch);
    REQUIRE(std::holds_alternative<query::DistanceFound>(watch.last.fact));
    const auto& end = std::get<query::DistanceFound>(watch.last.fact);
    CHECK(watch.nearer);
    CHECK(watch.nearest == found.turns);
    CHECK(watch.last.line < static_cast<int>(query::kGjkPseudocode.size()));
    const Separation<double, 3> unwatched = *query::gjk(a, b);
    CHECK(unwatched.distance == found.distance);
    CHECK(unwatched.turns == found.turns);
    if (found.overlap) continue;
    ++apart;
    CHECK(end.distance == found.distance);
    CHECK(end.gap == found.gap);
  }
  CHECK(apart > 5);
  CHECK(apart < 45);
}

TEST_CASE("k-DOPs about to touch are told apart") {
  test::VolumeMaker<double, 3> maker(5);
  for (int round = 0; round < 60; ++round) {
    std::vector<Vector<double, 3>> cloud;
    for (int i = 0; i < 300; ++i)
      cloud.emplace_back(maker.random.normal(), maker.random.normal(), maker.random.normal());
    const int k = std::array{14, 18, 26}[round % 3];
    const Kdop<double, 3> fixed = maker.kdop_of(k, cloud);
    const Vector<double, 3> direction = maker.direction();
    const auto moved = [&](double distance) {
      Kdop<double, 3> copy = fixed;
      const auto axes = kdop_axes<3>(k);
      for (std::size_t i = 0; i < axes.size(); ++i) {
        const double by =
            distance * (axes[i][0] * direction[0] + axes[i][1] * direction[1] + axes[i][2] * direction[2]);
        copy.min[i] += by, copy.max[i] += by;
      }
      return copy;
    };
    const auto touch = [&](double distance) { return query::gjk(fixed, moved(distance))->overlap; };
    double near = 0, far = 40;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (near + far) / 2;
      (touch(middle) ? near : far) = middle;
    }
    CHECK(touch(0.999 * near));
    CHECK_FALSE(touch(1.001 * far));
  }
}

namespace {

/// An ellipsoid along the coordinate axes: it has no vertex at all.
struct Smooth {
  Vector<double, 3> center, half_axes;
  [[nodiscard]] query::SupportMapping mapping() const {
    const auto farthest = [](const void* core, const Vector<double, 3>& direction) {
      const auto& own = *static_cast<const Smooth*>(core);
      const Vector<double, 3> scaled = own.half_axes.cwiseProduct(direction);
      return query::Supported{own.center + own.half_axes.cwiseProduct(scaled) / scaled.norm()};
    };
    return {this, farthest, {center}, 1};
  }
};

}  // namespace

TEST_CASE("GJK knows a core by its support mapping alone, so that smooth ones fit") {
  const Smooth egg{{0, 0, 0}, {0.3, 0.2, 0.1}}, ball{{0.7, 0.4, 0.2}, {0.1, 0.1, 0.1}};
  const Corners<3> point{{0.8, 0, 0}}, inside{{0.1, 0.1, 0}};
  Ignore ignore;
  const auto between = [&](const query::SupportMapping& a, const query::SupportMapping& b) {
    query::Gjk<Ignore> run(a, b, 1, ignore);
    run.run(std::nullopt);
    return std::pair(run.least, run.most);
  };
  const auto [least, most] = between(egg.mapping(), query::support_mapping(point));
  CHECK(least == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(most == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(between(egg.mapping(), query::support_mapping(inside)).second < 1e-15);
  // Held against a fine grid of the egg's own points.
  const auto [low, high] = between(egg.mapping(), ball.mapping());
  CHECK(high - low < 1e-9);
  double nearest = 1;
  for (int i = 0; i <= 2000; ++i)
    for (int j = 0; j <= 1000; ++j) {
      const double a = 1.2 * i / 2000, b = 1.2 * j / 1000;
      const Vector<double, 3> p(0.3 * std::cos(a) * std::cos(b), 0.2 * std::sin(a) * std::cos(b), 0.1 * std::sin(b));
      nearest = std::min(nearest, (p - ball.center).norm());
    }
  CHECK(low < nearest - 0.1 + 1e-9);
  CHECK(high > nearest - 0.1 - 1e-6);
}

TEST_CASE("a kept simplex gives the same verdict, in fewer turns, however the volumes have moved since") {
  test::VolumeMaker<double, 3> make(6);
  int with = 0, without = 0, apart = 0, frames = 0;
  for (int round = 0; round < 60; ++round) {
    const auto a = std::get<ConvexHull<double, 3>>(make.make(6, test::Make::kSolid));
    auto b = std::get<ConvexHull<double, 3>>(make.make(6, round % 5 == 0 ? test::Make::kFlat : test::Make::kSolid));
    b = moved(b, Vector<double, 3>(make.direction() * 2.0));
    const Vector<double, 3> step = make.direction() * (round % 3 == 0 ? 0.5 : 0.02);
    query::KeptSimplex kept;
    for (int frame = 0; frame < 40; ++frame, ++frames) {
      CAPTURE(round);
      CAPTURE(frame);
      b = moved(b, Vector<double, 3>(frame < 20 ? step : -step));
      const auto resumed = *query::gjk(a, b, true, Ignore{}, &kept), anew = *query::gjk(a, b, true);
      CHECK(resumed.overlap == anew.overlap);
      if (!resumed.overlap) CHECK(resumed.gap <= query::gjk(a, b)->distance * (1 + 1e-9));
      with += resumed.turns, without += anew.turns, apart += anew.overlap ? 0 : 1;
    }
  }
  CHECK(with < without);
  CHECK(apart > frames / 10);
  CHECK(apart < frames);
}
