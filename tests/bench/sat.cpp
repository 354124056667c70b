// Do two oriented boxes overlap? One pair against a plain textbook test. Prints the table that RESULTS.md keeps.
#include <cstdio>
#include <vector>

#include "bench/plain_tests.hpp"
#include "bench/ratio.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "query/overlap/obb_sat.hpp"

using namespace snug;

namespace {

constexpr int kPairs = 2000;
constexpr int kRounds = 301;

/// The unit of measure: the table's fifteen tests as books print them.
template <class Scalar>
__attribute__((noinline)) bool textbook(const bench::PlainObb<Scalar>& a, const bench::PlainObb<Scalar>& b) {
  return bench::plain_overlap(a, b);
}

template <class Scalar>
__attribute__((noinline)) bool ours(const Obb<Scalar, 3>& a, const Obb<Scalar, 3>& b) {
  return query::obbs_overlap(a, b);
}

template <class Scalar>
struct Scene {
  std::vector<Obb<Scalar, 3>> a, b;
  std::vector<bench::PlainObb<Scalar>> plain_a, plain_b;

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
  Scene(double spread, bool upright) {
    Random random(1);
    for (int i = 0; i < kPairs; ++i) {
      a.push_back(any(random, spread, upright)), b.push_back(any(random, spread, upright));
      plain_a.emplace_back(a.back()), plain_b.emplace_back(b.back());
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
