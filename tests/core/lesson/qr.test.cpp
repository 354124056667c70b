// The QR code of a state, and the four letters that say that two screens show the same.
#include "lesson/qr.hpp"

#include <doctest/doctest.h>

#include <set>

using namespace snug::lesson;

namespace {

/// Whether the square that a reader looks for has its corner there.
bool has_finder(const QrCode& code, int x, int y) {
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 7; ++k) {
      const int ring = std::max(std::abs(i - 3), std::abs(k - 3));
      if (code.at(x + i, y + k) != (ring != 2)) return false;
    }
  return true;
}

}  // namespace

TEST_CASE("an address makes a code with its three finders, no larger than the last row reads") {
  const auto small = qr_code("https://example.org/snug/?lesson=sphere-ritter&step=3&seed=7");
  REQUIRE(small);
  CHECK(small->size <= 33);
  const auto large = qr_code(std::string(321, 'x'));
  REQUIRE(large);
  CHECK(large->size == 61);
  for (const auto& code : {*small, *large}) {
    CHECK(has_finder(code, 0, 0));
    CHECK(has_finder(code, code.size - 7, 0));
    CHECK(has_finder(code, 0, code.size - 7));
    CHECK_FALSE(code.at(-1, 0));
    CHECK_FALSE(code.at(0, code.size));
  }
  CHECK_FALSE(qr_code(std::string(322, 'x')));
}

TEST_CASE("traces that differ have other letters, none of them a vowel") {
  CHECK(fingerprint(0) == "BBBB");
  CHECK(fingerprint(0x0123456789abcdef) == fingerprint(0x0123456789abcdef));
  std::set<std::string> all;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    all.insert(fingerprint(i * 0x9e3779b97f4a7c15u));
    CHECK(fingerprint(i).find_first_of("AEIOUL10") == std::string::npos);
  }
  CHECK(all.size() > 990);
}
