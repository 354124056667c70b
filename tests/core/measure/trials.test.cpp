// The lectures' claims, tried on hundreds of clouds: what comes out, why, and that a row says what its cloud does.
#include "measure/trials.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "measure/report.hpp"

using namespace snug;
using namespace snug::cost;

namespace {

TrialTally tally_of(std::string_view claim) { return tally_trials(claim, all_trials()); }

double radius(std::string_view algorithm, const AnyPointSet& points) {
  return fit::size_of(fit::find_algorithm("sphere", algorithm)->fit(points, {}).volume, 3);
}

}  // namespace

TEST_CASE("ten claims are tried on 240 clouds each") {
  CHECK(tried_claims().size() == 10);
  CHECK(all_trials().size() == 10 * 240);
  std::set<std::string_view> names;
  for (const Claim* tried : tried_claims()) {
    const Claim& claim = *tried;
    CAPTURE(claim.name);
    CHECK(names.insert(claim.name).second);
    CHECK(find_trial(claim.name) == &claim);
    CHECK(fit::find_algorithm(claim.volume, claim.algorithm) != nullptr);
    CHECK(tally_of(claim.name).clouds == 240);
  }
  CHECK(find_trial("flat_earth") == nullptr);
  CHECK(find_claim("welzl_stack") != nullptr);
  CHECK(find_trial("welzl_stack") == nullptr);
}

TEST_CASE("all three verdicts come out, each with its reason") {
  CHECK(tally_of("brute_force_growth").verdict() == "holds");
  CHECK_FALSE(tally_of("brute_force_growth").worst.has_value());
  CHECK(tally_of("as_much_memory").verdict() == "holds");
  for (const std::string_view typical :
       {"better_start", "welzl_growth", "hull_helps", "ritter_ten_per_cent", "iterative_five_per_cent", "kdop_tighter"})
    CHECK_MESSAGE(tally_of(typical).verdict() == "typical", typical);
  CHECK(tally_of("four_points").verdict() == "false");
  CHECK(tally_of("box_on_a_face").verdict() == "false");
  CHECK(TrialTally{}.verdict() == "unknown");
  CHECK(TrialTally{.clouds = 4, .held = 2}.verdict() == "false");
  CHECK(TrialTally{.clouds = 4, .held = 3}.verdict() == "typical");
}

TEST_CASE("a sphere through four points is as small as the smallest exactly where that is supported by four") {
  for (const TrialRow& row : all_trials()) {
    if (row.claim != "four_points") continue;
    CAPTURE(row.kind);
    CAPTURE(row.seed);
    const AnyPointSet cloud = trial_cloud(row.kind, row.points, row.seed);
    const fit::Result least = fit::find_algorithm("sphere", "brute_force")->fit(cloud, {});
    CHECK(row.holds == (least.support.size() == 4));
  }
}

TEST_CASE("a 14-DOP takes 56 bytes and an oriented box 60, whatever the points") {
  for (const TrialRow& row : all_trials())
    if (row.claim == "as_much_memory") CHECK(row.value == 56.0 / 60);
}

TEST_CASE("a row's value is that of its cloud, and it holds up to the claim's limit") {
  for (const TrialRow& row : all_trials()) {
    CHECK(row.value > 0);
    CHECK(row.holds == (row.value <= find_trial(row.claim)->limit));
  }
  const TrialTally ritter = tally_of("ritter_ten_per_cent");
  REQUIRE(ritter.worst.has_value());
  const AnyPointSet cloud = trial_cloud(ritter.worst->kind, ritter.worst->points, ritter.worst->seed);
  CHECK(ritter.worst->value == doctest::Approx(radius("ritter", cloud) / radius("welzl", cloud)));
  CHECK(ritter.worst->value > 1.1);
  for (const TrialRow& row : all_trials())
    if (row.claim == "ritter_ten_per_cent") CHECK(row.value <= ritter.worst->value);
}

TEST_CASE("Welzl's work grows in proportion on average, though not in every order") {
  double sum = 0;
  int clouds = 0;
  for (const TrialRow& row : all_trials())
    if (row.claim == "welzl_growth") sum += row.value, ++clouds;
  CHECK(sum / clouds == doctest::Approx(1).epsilon(0.15));
}

TEST_CASE("a run can be stopped, and its table is read back to the same bits") {
  TrialRun run({find_trial("ritter_ten_per_cent")});
  for (int i = 0; i < 60; ++i) run.step();
  CHECK(run.progress() == doctest::Approx(0.25));
  CHECK_FALSE(run.done());
  run.stop();
  CHECK(run.done());
  REQUIRE(run.rows().size() == 60);
  const auto table = read_csv<TrialRow>(csv_of(Provenance{}, std::span<const TrialRow>(run.rows())), "trials.csv");
  REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().message()));
  REQUIRE(table->rows.size() == 60);
  for (std::size_t i = 0; i < 60; ++i) {
    CHECK(table->rows[i].value == run.rows()[i].value);
    CHECK(table->rows[i].kind == run.rows()[i].kind);
    CHECK(table->rows[i].holds == run.rows()[i].holds);
  }
}
