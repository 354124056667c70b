// One number over the traces of every algorithm on every cloud. It is the same natively, with sanitizers and as
// WebAssembly, or a compiler has changed our arithmetic. After a wanted change of an algorithm, or a new one, run the
// test and put the number that it prints here.
#include <doctest/doctest.h>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
std::uint64_t hash_of_all(bool loses_points = false) {
  std::uint64_t all = 0;
  for (const std::uint64_t seed : {1, 2, 3})
    for (const int n : {5, 20, loses_points ? 60 : 700})  // the naive methods record steps by the square
      for (const auto& cloud : test::degenerate_clouds<Scalar, Dim>(seed, n)) {
        const AnyPointSet set = test::set_of<Scalar, Dim>(cloud.points);
        for (const fit::Algorithm& algorithm : fit::algorithms())
          if (algorithm.loses_points == loses_points && fit::takes(algorithm, Dim) &&
              fit::count_of(set) <= algorithm.max_points &&
              (algorithm.volume == "sphere" || n * static_cast<int>(seed) <= 20))
            all = all * 0x100000001b3u ^ fit::hash_of(algorithm.record(set, {}).steps);
      }
  return all;
}

}  // namespace

TEST_CASE("the same bits everywhere") {
  CHECK(hash_of_all<double, 2>() == 7322874625847122294u);
  CHECK(hash_of_all<double, 3>() == 14577239180299234958u);
  CHECK(hash_of_all<float, 2>() == 11535272243641064592u);
  CHECK(hash_of_all<float, 3>() == 16590904797225650403u);
}

TEST_CASE("the same bits everywhere, of algorithms that may lose points, too") {
  CHECK(hash_of_all<double, 2>(true) == 10750371959077105539u);
  CHECK(hash_of_all<double, 3>(true) == 15611739971319673854u);
  CHECK(hash_of_all<float, 2>(true) == 10254834727170760587u);
  CHECK(hash_of_all<float, 3>(true) == 9748459083890811225u);
}
