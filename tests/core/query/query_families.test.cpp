// A sample of the queries that `./run test --long` asks (tests/long.cpp).
#include "core/query/query_families.hpp"

#include <doctest/doctest.h>

using namespace snug;

namespace {

template <class Scalar>
std::uint64_t check_queries() {
  std::uint64_t hash = 0;
  for (std::size_t family = 0; family < test::kQueryFamilies.size(); ++family) {
    INFO(test::kQueryFamilies[family].name << ", " << sizeof(Scalar) << " bytes");
    test::QueryTally tally;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      test::add_query<Scalar, 2>(tally, family, seed);
      test::add_query<Scalar, 3>(tally, family, seed);
    }
    if (tally.sets == 0) continue;  // fields are in double alone
    CHECK(tally.wrong == 0);
    CHECK(static_cast<double>(tally.hard) >= test::kQueryFamilies[family].share * static_cast<double>(tally.sets));
    CHECK(tally.answers[0] > 0);
    CHECK(tally.answers[1] > 0);
    hash = hash * 0x100000001b3u ^ tally.hash;
  }
  return hash;
}

}  // namespace

TEST_CASE("queries of every family are answered as exact arithmetic does") {
  CHECK(check_queries<float>() == 12854644534478322158u);
  CHECK(check_queries<double>() == 16747014987590727903u);
}
