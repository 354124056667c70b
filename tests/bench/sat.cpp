// Do two oriented boxes overlap? One pair against a plain textbook test. Prints the table that RESULTS.md keeps.
#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/ratio.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "query/obb_sat.hpp"

using namespace snug;

namespace {

constexpr int kPairs = 2000;
constexpr int kRounds = 301;

template <class Scalar>
struct PlainBox {
  Scalar c[3], u[3][3], e[3];
};

/// The unit of measure: the table's fifteen tests written out, with an epsilon against parallel edges, as books print
/// them. Source: C. Ericson, Real-Time Collision Detection, 2005, 4.4.1, for the method.
template <class Scalar>
__attribute__((noinline)) bool textbook(const PlainBox<Scalar>& a, const PlainBox<Scalar>& b) {
  constexpr Scalar kEpsilon = sizeof(Scalar) == 4 ? Scalar(1e-6) : Scalar(1e-14);
  Scalar r[3][3], s[3][3], t[3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = a.u[i][0] * b.u[j][0] + a.u[i][1] * b.u[j][1] + a.u[i][2] * b.u[j][2];
  const Scalar d[3] = {b.c[0] - a.c[0], b.c[1] - a.c[1], b.c[2] - a.c[2]};
  for (int i = 0; i < 3; ++i) t[i] = d[0] * a.u[i][0] + d[1] * a.u[i][1] + d[2] * a.u[i][2];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) s[i][j] = std::abs(r[i][j]) + kEpsilon;
  for (int i = 0; i < 3; ++i)
    if (std::abs(t[i]) > a.e[i] + (b.e[0] * s[i][0] + b.e[1] * s[i][1] + b.e[2] * s[i][2])) return false;
  for (int j = 0; j < 3; ++j)
    if (std::abs(t[0] * r[0][j] + t[1] * r[1][j] + t[2] * r[2][j]) >
        (a.e[0] * s[0][j] + a.e[1] * s[1][j] + a.e[2] * s[2][j]) + b.e[j])
      return false;
  const auto crossed = [&](int i, int i1, int i2, int j, int j1, int j2) {
    return std::abs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) >
           (a.e[i1] * s[i2][j] + a.e[i2] * s[i1][j]) + (b.e[j1] * s[i][j2] + b.e[j2] * s[i][j1]);
  };
  if (crossed(0, 1, 2, 0, 1, 2)) return false;
  if (crossed(0, 1, 2, 1, 2, 0)) return false;
  if (crossed(0, 1, 2, 2, 0, 1)) return false;
  if (crossed(1, 2, 0, 0, 1, 2)) return false;
  if (crossed(1, 2, 0, 1, 2, 0)) return false;
  if (crossed(1, 2, 0, 2, 0, 1)) return false;
  if (crossed(2, 0, 1, 0, 1, 2)) return false;
  if (crossed(2, 0, 1, 1, 2, 0)) return false;
  if (crossed(2, 0, 1, 2, 0, 1)) return false;
  return true;
}

template <class Scalar>
__attribute__((noinline)) bool ours(const Obb<Scalar, 3>& a, const Obb<Scalar, 3>& b) {
  return query::obbs_overlap(a, b);
}

template <class Scalar>
struct Scene {
  std::vector<Obb<Scalar, 3>> a, b;
  std::vector<PlainBox<Scalar>> plain_a, plain_b;

  Obb<Scalar, 3> any(Random& random, double spread, bool upright) {
    Obb<Scalar, 3> box;
    for (int k = 0; k < 3; ++k) {
      box.center[k] = static_cast<Scalar>(random.between(-spread, spread));
      box.half_extents[k] = static_cast<Scalar>(random.between(0.2, 1));
    }
    const Vector<double, 3> axis(random.normal(), random.normal(), random.normal());
    if (!upright) box.axes = turn(axis, random.between(0, 6)).template cast<Scalar>();
    return box;
  }
  static PlainBox<Scalar> plain(const Obb<Scalar, 3>& box) {
    PlainBox<Scalar> result;
    for (int k = 0; k < 3; ++k) {
      result.c[k] = box.center[k], result.e[k] = box.half_extents[k];
      for (int m = 0; m < 3; ++m) result.u[k][m] = box.axes(m, k);
    }
    return result;
  }
  Scene(double spread, bool upright) {
    Random random(1);
    for (int i = 0; i < kPairs; ++i) {
      a.push_back(any(random, spread, upright)), b.push_back(any(random, spread, upright));
      plain_a.push_back(plain(a.back())), plain_b.push_back(plain(b.back()));
    }
  }
};

template <class Scalar>
void one_scene(const char* name, double spread, bool upright) {
  const Scene<Scalar> scene(spread, upright);
  const auto by_book = [&] {
    int count = 0;
    for (std::size_t i = 0; i < kPairs; ++i) count += textbook(scene.plain_a[i], scene.plain_b[i]);
    bench::keep(count);
  };
  const auto one_by_one = [&] {
    int count = 0;
    for (std::size_t i = 0; i < kPairs; ++i) count += ours(scene.a[i], scene.b[i]);
    bench::keep(count);
  };
  int overlapping = 0;
  for (std::size_t i = 0; i < kPairs; ++i) overlapping += ours(scene.a[i], scene.b[i]);
  const auto book = bench::ratio(one_by_one, by_book, kRounds);
  std::printf("| %s | %s | %d %% | %.0f ns | %.2f (%.2f to %.2f) |\n", sizeof(Scalar) == 4 ? "float" : "double", name,
              100 * overlapping / kPairs, book.base / kPairs * 1e9, book.median, book.low, book.high);
}

template <class Scalar>
void all_scenes() {
  one_scene<Scalar>("far apart", 3, false);
  one_scene<Scalar>("mixed", 1.2, false);
  one_scene<Scalar>("near", 0.8, false);
  one_scene<Scalar>("all overlap", 0.3, false);
  one_scene<Scalar>("upright", 1.2, true);
}

}  // namespace

int main() {
  std::printf("| scalar | boxes | overlap | textbook, one pair | one pair / textbook |\n");
  std::printf("|---|---|---:|---:|---|\n");
  all_scenes<float>();
  all_scenes<double>();
}
