#include "query/contain/contains.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "geometry/tolerance.hpp"

using namespace snug;
using exact::Rational;

namespace {

template <class Scalar, int Dim>
using RationalPoint = std::array<Rational, Dim>;

template <class Scalar, int Dim>
RationalPoint<Scalar, Dim> rational(const Vector<Scalar, Dim>& v) {
  RationalPoint<Scalar, Dim> exact;
  for (int i = 0; i < Dim; ++i) exact[i] = Rational(static_cast<double>(v[i]));
  return exact;
}

template <std::size_t Dim>
Rational dot(const std::array<Rational, Dim>& a, const std::array<Rational, Dim>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < Dim; ++i) sum += a[i] * b[i];
  return sum;
}

/// a + factor b
template <std::size_t Dim>
std::array<Rational, Dim> plus(std::array<Rational, Dim> a, const Rational& factor,
                               const std::array<Rational, Dim>& b) {
  for (std::size_t i = 0; i < Dim; ++i) a[i] += factor * b[i];
  return a;
}

/// The squared distance to the segment from the origin along an edge.
template <std::size_t Dim>
Rational square_to_segment(const std::array<Rational, Dim>& point, const std::array<Rational, Dim>& edge) {
  const Rational length = dot(edge, edge);
  Rational share = length == 0 ? Rational(0) : Rational(dot(point, edge) / length);
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  const auto rest = plus(point, -share, edge);
  return dot(rest, rest);
}

/// The same to the parallelogram of two edges: the foot of the perpendicular by Gram-Schmidt, or else the nearest side.
template <std::size_t Dim>
Rational square_to_parallelogram(const std::array<Rational, Dim>& point, const std::array<Rational, Dim>& e,
                                 const std::array<Rational, Dim>& f) {
  Rational best = std::min({square_to_segment(point, e), square_to_segment(point, f),
                            square_to_segment(plus(point, -1, f), e), square_to_segment(plus(point, -1, e), f)});
  if (dot(e, e) == 0) return best;
  const auto across = plus(f, -dot(e, f) / dot(e, e), e);
  if (dot(across, across) == 0) return best;
  const Rational t = dot(point, across) / dot(across, across);
  const auto rest = plus(point, -t, f);
  const Rational s = dot(rest, e) / dot(e, e);
  if (s < 0 || s > 1 || t < 0 || t > 1) return best;
  const auto apart = plus(rest, -s, e);
  return std::min(best, dot(apart, apart));
}

struct ContainsTally {
  int in = 0, on = 0, out = 0;
  void note(int side) { (side < 0 ? in : side > 0 ? out : on)++; }
  void check(int least) const {
    CHECK(in > least);
    CHECK(on > least);
    CHECK(out > least);
  }
};

/// What the volume says about the point is the sign, and so is the distance.
template <class Volume, class Point>
void check_side(const Volume& volume, const Point& point, int side) {
  CHECK(query::contains(volume, point) == (side <= 0));
  CHECK((query::outside_by(volume, point) > 0) == (side > 0));
}

/// Small whole numbers, which graze each other often, times a scale.
template <class Scalar, int Dim>
Vector<Scalar, Dim> lattice_point(Random& random, int most, Scalar scale) {
  Vector<Scalar, Dim> p;
  for (int i = 0; i < Dim; ++i)
    p[i] = scale * static_cast<Scalar>(static_cast<int>(random.below(2u * unsigned(most) + 1)) - most);
  return p;
}

template <class Scalar>
Scalar nudged(Scalar value, unsigned way) {
  if (way == 1) return std::nextafter(value, Scalar(0));
  return way == 2 ? std::nextafter(value, std::numeric_limits<Scalar>::max()) : value;
}

/// The nearest scalar whose square may be exactly that.
template <class Scalar>
Scalar root(const Rational& square) {
  return static_cast<Scalar>(std::sqrt(square.convert_to<double>()));
}

template <class Scalar>
int side_of(const Rational& square, Scalar radius) {
  const Rational r(static_cast<double>(radius));
  return Rational(square - r * r).sign();
}

template <class Scalar>
constexpr std::array<Scalar, 3> kScales = sizeof(Scalar) == 8
                                              ? std::array<Scalar, 3>{Scalar(1), Scalar(0x1p-490), Scalar(0x1p490)}
                                              : std::array<Scalar, 3>{Scalar(1), Scalar(0x1p-50), Scalar(0x1p50)};

}  // namespace

TEST_CASE_TEMPLATE("volumes of no size hold the one point that they are", Scalar, float, double) {
  const Vector<Scalar, 3> p(Scalar(0.1), Scalar(-2), Scalar(1e10));
  Vector<Scalar, 3> beside = p;
  beside[0] = std::nextafter(p[0], Scalar(1));
  const auto check = [&](const auto& volume) {
    CHECK(query::contains(volume, p));
    CHECK(query::outside_by(volume, p) == 0);
    CHECK(!query::contains(volume, beside));
    CHECK(query::outside_by(volume, beside) > 0);
    CHECK(query::outside_by(volume, beside) < 1e-7);
  };
  check(Sphere<Scalar, 3>{p, 0});
  check(Aabb<Scalar, 3>{p, p});
  check(Obb<Scalar, 3>{.center = p});
  check(Capsule<Scalar, 3>{p, p, 0});
  check(Lozenge<Scalar, 3>{.origin = p});
  Kdop<Scalar, 3> kdop{.k = 6};
  for (std::size_t i = 0; i < 3; ++i) kdop.min[i] = kdop.max[i] = p[static_cast<int>(i)];
  check(kdop);
}

TEST_CASE("distances outside are those of a drawing") {
  const Vector<double, 2> p(5, 6);
  CHECK(query::outside_by(Sphere<double, 2>{{2, 2}, 1}, p) == doctest::Approx(4));
  CHECK(query::outside_by(Aabb<double, 2>{{0, 0}, {2, 2}}, p) == doctest::Approx(5));
  CHECK(query::outside_by(Obb<double, 2>{.center = {1, 1}, .half_extents = {1, 1}}, p) == doctest::Approx(5));
  CHECK(query::outside_by(Capsule<double, 2>{{0, 2}, {2, 2}, 1}, p) == doctest::Approx(4));
  CHECK(query::outside_by(Capsule<double, 2>{{0, 2}, {9, 2}, 1}, p) == doctest::Approx(3));
  CHECK(query::outside_by(Lozenge<double, 2>{{0, 0}, {Vector<double, 2>{2, 0}, {0, 2}}, 1}, p) == doctest::Approx(4));
  CHECK(query::outside_by(Lozenge<double, 2>{{0, 0}, {Vector<double, 2>{9, 0}, {0, 9}}, 1}, p) == 0);
  Kdop<double, 2> kdop{.k = 6, .min = {0, 0, 0}, .max = {4, 4, 4}};
  CHECK(query::outside_by(kdop, p) == doctest::Approx(7 / std::sqrt(2.0)));
  CHECK(query::outside_by(kdop, {-1, 0}) == doctest::Approx(1));
}

TEST_CASE_TEMPLATE("a lozenge with skewed edges is the neighbourhood of its parallelogram", Scalar, float, double) {
  const Lozenge<Scalar, 3> lozenge{{0, 0, 0}, {Vector<Scalar, 3>{4, 0, 0}, {3, 3, 0}}, 1};
  CHECK(query::contains(lozenge, {5, 2, 1}));  // above its inside
  CHECK(!query::contains(lozenge, {5, 2, std::nextafter(Scalar(1), Scalar(2))}));
  CHECK(!query::contains(lozenge, {0, 2, 0}));  // beside the slanting edge
  CHECK(query::outside_by(lozenge, {0, 2, 0}) == doctest::Approx(std::sqrt(2.0) - 1));
}

TEST_CASE_TEMPLATE("a box holds a point just where its slabs do in rational arithmetic", Scalar, float, double) {
  Random random(1);
  ContainsTally tally;
  for (const Scalar scale : kScales<Scalar>) {
    for (int round = 0; round < 1000; ++round) {
      const bool far = round % 3 == 0;
      Obb<Scalar, 3> box;
      box.center = lattice_point<Scalar, 3>(random, far ? 100000 : 4, scale);
      for (int i = 0; i < 3; ++i) {
        box.axes.col(i) = lattice_point<Scalar, 3>(random, 3, 1);
        const Scalar length = box.axes.col(i).norm();
        if (length > 0) box.axes.col(i) /= length;
      }
      const Vector<Scalar, 3> p = box.center + lattice_point<Scalar, 3>(random, 4, scale);
      int side = -1;
      for (int i = 0; i < 3; ++i) {
        const auto axis = rational<Scalar, 3>(box.axes.col(i));
        const Rational projection = abs(Rational(dot(plus(rational(p), -1, rational(box.center)), axis)));
        box.half_extents[i] = nudged(projection.convert_to<Scalar>(), random.below(6));
        const int slab = (projection - Rational(static_cast<double>(box.half_extents[i]))).sign();
        CHECK(query::side_of_slab<Scalar, 3>(p, box.center, box.axes.col(i), box.half_extents[i]) == slab);
        side = std::max(side, slab);
      }
      tally.note(side);
      check_side(box, p, side);
    }
  }
  tally.check(50);
}

TEST_CASE_TEMPLATE("a k-DOP holds a point just where its slabs do in rational arithmetic", Scalar, float, double) {
  Random random(2);
  ContainsTally tally;
  for (const int k : {6, 14, 18, 26}) {
    for (int round = 0; round < 300; ++round) {
      Vector<Scalar, 3> p;
      for (int i = 0; i < 3; ++i) p[i] = static_cast<Scalar>(random.between(-1, 1) * (random.below(2) == 0 ? 1 : 1e-7));
      Kdop<Scalar, 3> kdop{.k = k};
      int side = -1;
      const auto axes = kdop_axes<3>(k);
      for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto projection =
            Rational(dot(rational(p), RationalPoint<Scalar, 3>{axes[i][0], axes[i][1], axes[i][2]}));
        const bool above = random.below(2) == 0;
        const unsigned way = round % 3 == 0 ? 2 : random.below(40);  // 2: outwards, 1: inwards
        auto near = projection.convert_to<Scalar>();
        if (way == 1 || way == 2) near = std::nextafter(near, above == (way == 2) ? Scalar(9) : Scalar(-9));
        kdop.min[i] = above ? near - 1 : near;
        kdop.max[i] = above ? near : near + 1;
        const Rational beyond = projection - Rational(static_cast<double>(near));
        side = std::max(side, above ? beyond.sign() : -beyond.sign());
      }
      tally.note(side);
      check_side(kdop, p, side);
    }
  }
  tally.check(80);
}

TEST_CASE_TEMPLATE("a capsule and a lozenge hold a point just where rational arithmetic says", Scalar, float, double) {
  Random random(3);
  ContainsTally capsules, lozenges, discs;
  for (const Scalar scale : kScales<Scalar>) {
    for (int round = 0; round < 250; ++round) {
      const auto place = [&] { return lattice_point<Scalar, 3>(random, round % 2 == 0 ? 2 : 5, scale); };
      const auto radius_near = [&](const Rational& square) { return nudged(root<Scalar>(square), random.below(4)); };
      const Vector<Scalar, 3> far =
          round % 5 == 0 ? lattice_point<Scalar, 3>(random, 100000, scale) : Vector<Scalar, 3>::Zero();
      const Vector<Scalar, 3> p = place() + far;

      Capsule<Scalar, 3> capsule{place() + far, place() + far, 0};
      const auto from_a = plus(rational(p), -1, rational(capsule.a));
      const Rational near = square_to_segment(from_a, plus(rational(capsule.b), -1, rational(capsule.a)));
      capsule.radius = radius_near(near);
      capsules.note(side_of(near, capsule.radius));
      check_side(capsule, p, side_of(near, capsule.radius));

      Lozenge<Scalar, 3> lozenge{place() + far, {place(), place()}, 0};
      const auto from_origin = plus(rational(p), -1, rational(lozenge.origin));
      const Rational nearest =
          square_to_parallelogram(from_origin, rational(lozenge.edges[0]), rational(lozenge.edges[1]));
      lozenge.radius = radius_near(nearest);
      lozenges.note(side_of(nearest, lozenge.radius));
      check_side(lozenge, p, side_of(nearest, lozenge.radius));

      const auto flat = [](const Vector<Scalar, 3>& v) { return Vector<Scalar, 2>(v[0], v[1]); };
      Lozenge<Scalar, 2> disc{flat(lozenge.origin), {flat(lozenge.edges[0]), flat(lozenge.edges[1])}, 0};
      const Vector<Scalar, 2> q = flat(p);
      const Rational least = square_to_parallelogram(plus(rational(q), -1, rational(disc.origin)),
                                                     rational(disc.edges[0]), rational(disc.edges[1]));
      disc.radius = radius_near(least);
      discs.note(side_of(least, disc.radius));
      check_side(disc, q, side_of(least, disc.radius));
    }
  }
  capsules.check(30);
  lozenges.check(30);
  discs.check(30);
}

TEST_CASE_TEMPLATE("long thin capsules and lozenges at odd angles are judged as rational arithmetic does", Scalar,
                   float, double) {
  Random random(4);
  int in = 0, out = 0;
  for (int round = 0; round < 300; ++round) {
    const auto any = [&](double size) {
      return Vector<Scalar, 3>(static_cast<Scalar>(size * random.between(-1, 1)),
                               static_cast<Scalar>(size * random.between(-1, 1)),
                               static_cast<Scalar>(size * random.between(-1, 1)));
    };
    const double thin = std::pow(10.0, -static_cast<int>(random.below(12)));
    Lozenge<Scalar, 3> lozenge{any(10), {any(100), Vector<Scalar, 3>::Zero()}, 0};
    lozenge.edges[1] = lozenge.edges[0].cross(any(1));
    const auto s = static_cast<Scalar>(random.between(-0.5, 1.5)), t = static_cast<Scalar>(random.between(-0.5, 1.5));
    const Vector<Scalar, 3> p = lozenge.origin + s * lozenge.edges[0] + t * lozenge.edges[1] + any(thin);
    const Rational square = square_to_parallelogram(plus(rational(p), -1, rational(lozenge.origin)),
                                                    rational(lozenge.edges[0]), rational(lozenge.edges[1]));
    lozenge.radius = nudged(root<Scalar>(square), random.below(3));
    const int side = side_of<Scalar>(square, lozenge.radius);
    (side <= 0 ? in : out)++;
    check_side(lozenge, p, side);
    CHECK(query::outside_by(lozenge, p) < 100 * tolerance::kRoundoff<Scalar> * 100);

    Capsule<Scalar, 3> capsule{lozenge.origin, lozenge.origin + lozenge.edges[0], 0};
    const auto from_a = plus(rational(p), -1, rational(capsule.a));
    const Rational near = square_to_segment(from_a, plus(rational(capsule.b), -1, rational(capsule.a)));
    capsule.radius = nudged(root<Scalar>(near), random.below(3));
    check_side(capsule, p, side_of<Scalar>(near, capsule.radius));
  }
  CHECK(in > 60);
  CHECK(out > 60);
}
