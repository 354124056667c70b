// A sample of the queries that `./run test --long` asks (tests/long.cpp).
#include "core/query/query_families.hpp"

#include <doctest/doctest.h>

using namespace snug;

namespace {

template <class Scalar>
std::uint64_t check_queries() {
  std::uint64_t hash = 0;
  for (std::size_t family = 0; family < test::kQueryFamilies.size(); ++family) {
    INFO(test::kQueryFamilies[family] << ", " << sizeof(Scalar) << " bytes");
    test::QueryTally tally;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      test::add_query<Scalar, 2>(tally, family, seed);
      test::add_query<Scalar, 3>(tally, family, seed);
    }
    CHECK(tally.wrong == 0);
    CHECK(4 * tally.hard >= tally.sets);  // rounded numbers decide less than three quarters
    CHECK(tally.answers[0] > 0);
    CHECK(tally.answers[1] > 0);
    hash = hash * 0x100000001b3u ^ tally.hash;
  }
  return hash;
}

}  // namespace

TEST_CASE("queries of every family are answered as exact arithmetic does") {
  CHECK(check_queries<float>() == 16075789641998179641u);
  CHECK(check_queries<double>() == 12955561485054177618u);
}
