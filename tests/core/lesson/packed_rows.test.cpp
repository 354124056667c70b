// Rows as a word of an address: exact, and short enough for 800 points.
#include "lesson/packed_rows.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "geometry/random.hpp"

using namespace snug;
using lesson::packed_rows;
using lesson::Rows;
using lesson::unpacked_rows;

namespace {

/// Equal to the last bit: -0.0 is not 0.0.
bool same_bits(const Rows& a, const Rows& b) {
  if (a != b) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].size(); ++k)
      if (std::signbit(a[i][k]) != std::signbit(b[i][k])) return false;
  return true;
}

Rows random_rows(std::size_t points, double unit) {
  Random random(7);
  Rows rows;
  for (std::size_t i = 0; i < points; ++i) {
    const double x = random.between(-2, 2), y = random.between(-2, 2);
    rows.push_back({unit > 0 ? std::round(x / unit) * unit : x, unit > 0 ? std::round(y / unit) * unit : y});
  }
  return rows;
}

}  // namespace

TEST_CASE("rows come back bit for bit, whatever their numbers and lengths") {
  using Limits = std::numeric_limits<double>;
  for (const Rows& rows :
       {Rows{{0.0, -0.0}}, Rows{{1, 2, 3}, {4}, {5}, {-6, 0.125}}, Rows{{0.1, 123456.789}, {-0.001, 1e15}},
        Rows{{Limits::max(), Limits::denorm_min(), -Limits::min(), 1.0 / 3}}, random_rows(300, 0)}) {
    const auto back = unpacked_rows(packed_rows(rows));
    REQUIRE(back);
    CHECK(same_bits(*back, rows));
  }
}

TEST_CASE("800 points of a file take 5 kB, and 800 that were dragged 17 kB") {
  Rows file = random_rows(800, 0);
  for (std::vector<double>& row : file)
    for (double& number : row) number = std::round(number * 1000) / 1000;
  CHECK(packed_rows(file).size() < 5000);
  CHECK(packed_rows(random_rows(800, 0)).size() < 17'200);
}

TEST_CASE("a damaged word is refused, never misread into nonsense") {
  CHECK_FALSE(unpacked_rows(""));
  CHECK_FALSE(unpacked_rows("A"));
  CHECK_FALSE(unpacked_rows("not a word"));
  const std::string word = packed_rows({{1, 2}, {3, 4}});
  CHECK_FALSE(unpacked_rows(word.substr(0, word.size() - 2)));
  CHECK_FALSE(unpacked_rows("________________________"));
  Random random(3);
  for (int i = 0; i < 2000; ++i) {  // nothing but that they end, and are finite
    std::string any;
    for (int k = 0; k < 40; ++k) any += "ABCDEFGHIJ_-0189"[random.below(16)];
    if (const auto rows = unpacked_rows(any))
      for (const auto& row : *rows)
        for (const double number : row) REQUIRE(std::isfinite(number));
  }
}
