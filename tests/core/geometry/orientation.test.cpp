// Signs of determinants against rational arithmetic, over coordinates of every size and points that all but lie in a
// plane.
#include "geometry/orientation.hpp"

#include <doctest/doctest.h>

#include <array>

#include "core/at_random.hpp"
#include "core/exact.hpp"
#include "geometry/random.hpp"
#include "number/bits.hpp"

using namespace snug;
using exact::Rational;
using P2 = Vector<double, 2>;
using P3 = Vector<double, 3>;

namespace {

template <int Dim>
std::array<Rational, Dim> minus(const Vector<double, Dim>& a, const Vector<double, Dim>& b) {
  std::array<Rational, Dim> d;
  for (int i = 0; i < Dim; ++i) d[i] = Rational(a[i]) - Rational(b[i]);
  return d;
}

int true_cross_sign(const P2& a, const P2& b, const P2& c, const P2& d) {
  const auto e = minus<2>(b, a), f = minus<2>(d, c);
  return Rational(e[0] * f[1] - e[1] * f[0]).sign();
}

int true_orient3d(const P3& a, const P3& b, const P3& c, const P3& d) {
  const auto e = minus<3>(b, a), f = minus<3>(c, a), g = minus<3>(d, a);
  return Rational((e[1] * f[2] - e[2] * f[1]) * g[0] + (e[2] * f[0] - e[0] * f[2]) * g[1] +
                  (e[0] * f[1] - e[1] * f[0]) * g[2])
      .sign();
}

template <int Dim>
int true_dot_sign(const Vector<double, Dim>& a, const Vector<double, Dim>& b, const Vector<double, Dim>& c,
                  const Vector<double, Dim>& d) {
  const auto e = minus<Dim>(b, a), f = minus<Dim>(d, c);
  Rational sum = 0;
  for (std::size_t i = 0; i < Dim; ++i) sum += e[i] * f[i];
  return sum.sign();
}

/// How often each sign came.
struct Seen {
  std::array<int, 3> of{};
  void operator()(int sign) { ++of[sign + 1]; }
};

/// A few ulps to and fro.
double shaken(Random& random, double value) {
  for (auto k = random.below(3); k > 0; --k) value = std::nextafter(value, random.below(2) == 0 ? -1e308 : 1e308);
  return value;
}

/// d in the plane of a, b, c but for rounding and an ulp or two. offset, scale: of all coordinates.
template <int Dim>
std::array<Vector<double, Dim>, 4> nearly_flat(Random& random, double scale, double offset) {
  std::array<Vector<double, Dim>, 4> p;
  for (auto& point : p)
    for (int i = 0; i < Dim; ++i) point[i] = (random.between(-1, 1) + offset) * scale;
  const double s = random.between(-1, 2), t = Dim == 3 ? random.between(-1, 2) : 0;
  p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
  for (int i = 0; i < Dim; ++i) p[3][i] = shaken(random, p[3][i]);
  return p;
}

}  // namespace

TEST_CASE("points in a plane or on a line give zero, whatever their size") {
  for (const double scale : {0x1p-1074, 0x1p-1000, 0x1p-500, 1.0, 0x1p500, 0x1p1020}) {
    CHECK(orient2d(P2(0, 0) * scale, P2(1, 2) * scale, P2(3, 6) * scale) == 0);
    CHECK(orient3d(P3(0, 0, 1) * scale, P3(1, 0, 3) * scale, P3(0, 1, 5) * scale, P3(2, 1, 8) * scale) == -1);
    CHECK(orient3d(P3(0, 0, 1) * scale, P3(1, 0, 3) * scale, P3(0, 1, 5) * scale, P3(2, 1, 9) * scale) == 0);
    CHECK(collinear(P3(1, 2, 3) * scale, P3(2, 4, 6) * scale, P3(3, 6, 9) * scale));
    CHECK_FALSE(collinear(P3(1, 2, 3) * scale, P3(2, 4, 6) * scale, P3(3, 6, 8) * scale));
    CHECK(dot_sign<3>(P3(0, 0, 0), P3(1, 2, 3) * scale, P3(0, 0, 0), P3(3, 0, -1) * scale) == 0);
  }
  CHECK(orient2d(P2(0, 0), P2(1, 0), P2(0, 1)) == 1);
  CHECK(orient3d(P3(0, 0, 0), P3(1, 0, 0), P3(0, 1, 0), P3(0, 0, 1)) == 1);
}

TEST_CASE("signs are those of rational arithmetic, near zero too") {
  Random random(5);
  Seen flat, solid, along;
  int misled = 0;  // how often plain double arithmetic has another sign
  for (const double scale : {1e-300, 1e-150, 1e-20, 1.0, 1e150, 1e300})
    for (const double offset : {0.0, 1e3, 1e8}) {
      for (int turn = 0; turn < 150; ++turn) {
        const auto p = nearly_flat<2>(random, scale, offset);
        const int sign = cross_sign(p[0], p[1], p[0], p[3]);
        CHECK(sign == true_cross_sign(p[0], p[1], p[0], p[3]));
        flat(sign);
        // b turned by a right angle about a, so that the dot product all but vanishes
        const P2 turned(p[0][0] - (p[1][1] - p[0][1]), p[0][1] + (p[1][0] - p[0][0]));
        const int dot = dot_sign<2>(p[0], p[1], p[0], turned);
        CHECK(dot == true_dot_sign<2>(p[0], p[1], p[0], turned));
        along(dot);

        const auto q = nearly_flat<3>(random, scale, offset);
        const int side = orient3d(q[0], q[1], q[2], q[3]);
        CHECK(side == true_orient3d(q[0], q[1], q[2], q[3]));
        CHECK(orient3d(q[1], q[0], q[2], q[3]) == -side);
        solid(side);
        const P3 e = q[1] - q[0], f = q[2] - q[0], g = q[3] - q[0];
        const double rounded = (e[1] * f[2] - e[2] * f[1]) * g[0] + (e[2] * f[0] - e[0] * f[2]) * g[1] +
                               (e[0] * f[1] - e[1] * f[0]) * g[2];
        misled += (rounded > 0) - (rounded < 0) != side;
        CHECK(dot_sign<3>(q[0], q[1], q[2], q[3]) == true_dot_sign<3>(q[0], q[1], q[2], q[3]));
      }
    }
  CHECK(misled > 500);
  for (const Seen& seen : {flat, solid, along}) {
    CHECK(seen.of[0] > 200);
    CHECK(seen.of[2] > 200);
  }
}

TEST_CASE("signs are right for coordinates of any exponents at once") {
  Random random(6);
  Seen flat, solid;
  for (int turn = 0; turn < 400; ++turn) {
    std::array<P2, 4> p;
    std::array<P3, 4> q;
    for (auto& point : p) point = {test::any_finite(random), test::any_finite(random)};
    for (auto& point : q) point = {test::any_finite(random), test::any_finite(random), test::any_finite(random)};
    flat(cross_sign(p[0], p[1], p[2], p[3]));
    CHECK(cross_sign(p[0], p[1], p[2], p[3]) == true_cross_sign(p[0], p[1], p[2], p[3]));
    CHECK(dot_sign<2>(p[0], p[1], p[2], p[3]) == true_dot_sign<2>(p[0], p[1], p[2], p[3]));
    solid(orient3d(q[0], q[1], q[2], q[3]));
    CHECK(orient3d(q[0], q[1], q[2], q[3]) == true_orient3d(q[0], q[1], q[2], q[3]));
  }
  for (const Seen& seen : {flat, solid}) {
    CHECK(seen.of[0] > 100);
    CHECK(seen.of[2] > 100);
  }
}

TEST_CASE("where products underflow or overflow, the sign is right still") {
  Random random(7);
  Seen seen;
  const auto power = [&](int least, int most) {
    return std::ldexp(1.0, least + static_cast<int>(random.below(static_cast<std::uint32_t>(most - least))));
  };
  for (int turn = 0; turn < 2000; ++turn) {
    // Vectors with one large component and others whose products are lost to underflow.
    P3 e, f, g;
    for (int i = 0; i < 3; ++i) {
      e[i] = random.between(-1, 1) * power(-620, -500);
      f[i] = random.between(-1, 1) * power(-620, -500);
      g[i] = random.between(-1, 1) * power(-100, 1000);
    }
    if (random.below(2) == 0) f = e * power(-3, 3) + P3(0, power(-1074, -700), 0);
    const P3 zero = P3::Zero();
    const int sign = orient3d(zero, e, f, g);
    CHECK(sign == true_orient3d(zero, e, f, g));
    seen(sign);
  }
  CHECK(seen.of[0] > 300);
  CHECK(seen.of[2] > 300);
}

TEST_CASE("small whole numbers: every sign, and many zeros") {
  Random random(8);
  Seen flat, solid;
  const auto small = [&] { return static_cast<double>(random.below(5)); };
  for (int turn = 0; turn < 2000; ++turn) {
    std::array<P3, 4> q;
    for (auto& point : q) point = {small(), small(), small()};
    const int sign = orient3d(q[0], q[1], q[2], q[3]);
    CHECK(sign == true_orient3d(q[0], q[1], q[2], q[3]));
    solid(sign);
    const auto flattened = [&](std::size_t i) { return P2(q[i][0], q[i][1]); };
    const int turned = cross_sign(flattened(0), flattened(1), flattened(2), flattened(3));
    CHECK(turned == true_cross_sign(flattened(0), flattened(1), flattened(2), flattened(3)));
    flat(turned);
  }
  for (const Seen& seen : {flat, solid})
    for (const int count : seen.of) CHECK(count > 200);
}
