// A sample of what `./run test --long` runs (tests/long.cpp): the same here as WebAssembly and with sanitizers.
#include <doctest/doctest.h>

#include "core/fit/family_checks.hpp"

using namespace snug;

namespace {

/// The first of these is transformed as well.
constexpr std::uint64_t kSampledSeeds = 12;

template <class Scalar>
void check_tally(const test::FamilyTally& tally) {
  for (std::size_t i = 0; i < tally.fitters.size(); ++i) {
    const test::FitterTally& fitter = tally.fitters[i];
    const fit::Algorithm& algorithm = fit::algorithms()[i];
    INFO(algorithm.volume << " " << algorithm.name);
    CHECK(fitter.outside == 0);
    CHECK(fitter.not_finite == 0);
    CHECK(fitter.off_boundary == 0);
    CHECK(fitter.unproven == 0);
    CHECK(fitter.unlike == 0);
    CHECK(fitter.moved == 0);
    CHECK(fitter.other_scalar == 0);
    CHECK(fitter.of_stated_steps <= 1);
    CHECK(fitter.excess <= test::stated_excess<Scalar>(algorithm));
  }
  CHECK(tally.pairs.unordered == 0);
  CHECK(tally.pairs.missed == 0);
  CHECK(tally.pairs.unlike == 0);
  CHECK(tally.pairs.turned == 0);
  CHECK(tally.pairs.turns <= test::kStatedTurns);
}

template <class Scalar>
std::uint64_t check_families() {
  std::uint64_t hash = 0;
  for (std::size_t family = 0; family < test::families().size(); ++family) {
    const test::Family& known = test::families()[family];
    INFO(known.name << ", " << sizeof(Scalar) << " bytes");
    test::FamilyTally tally;
    for (std::uint64_t seed = 0; seed < kSampledSeeds; seed += static_cast<std::uint64_t>(known.rarer)) {
      if (known.plane) test::add_member<Scalar, 2>(tally, family, seed, seed == 0);
      test::add_member<Scalar, 3>(tally, family, seed, seed == 0);
    }
    check_tally<Scalar>(tally);
    // A few may miss it; the long run counts all.
    CHECK(static_cast<double>(tally.hard) >= known.share * static_cast<double>(tally.sets) / 2);
    hash = hash * 0x100000001b3u ^ tally.hash;
  }
  return hash;
}

}  // namespace

TEST_CASE("every family keeps its promises") {
  CHECK(check_families<float>() == 16251730792546955616u);
  CHECK(check_families<double>() == 14317589005408804113u);
}
