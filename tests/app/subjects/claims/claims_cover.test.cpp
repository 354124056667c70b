// The charts of claims on the stage: tried in slices, chosen, walked through by keys; a cloud is put on the stage.
#include "app/subjects/claims/claims_cover.hpp"

#include <doctest/doctest.h>

#include "lesson/subjects/claims/claims.hpp"

using namespace snug;
using namespace snug::app;

namespace {

constexpr std::string_view kClaimsLesson = R"(version = 2
title = "Claims"
summary = "Claims for tests."
minutes = 1
chart = "claims"
algorithms = ["sphere/brute_force_slide", "sphere/brute_force", "sphere/ritter", "sphere/pca", "sphere/ritter_iterative", "sphere/welzl", "obb/pca_hull", "obb/face_aligned", "kdop/k14"]

[points]
dim = 3
list = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1], [0.1, 0, 0], [0, 0.1, 0]]

[[section]]
title = "One"
text = "Prose."

[[question]]
id = "four"
asks = "verdict"
claim = "four_points"
prompt = "Is it so?"
because = "So."
)";

lesson::Session opened(std::string_view text = kClaimsLesson) {
  auto lesson = lesson::read_lesson(text, "claims.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = lesson::Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

double no_time() { return 0; }

void answer_and_measure(ClaimsCover& cover, lesson::Session& session) {
  CHECK(session.conversation().asked() == nullptr);  // first seen, then asked
  REQUIRE(cover.command(session, "measure"));
  CHECK_FALSE(cover.running());
  CHECK_FALSE(cover.command(session, "measure"));
  REQUIRE(session.conversation().give(lesson::OneChoice{2}));
  REQUIRE(cover.command(session, "measure"));
  while (cover.running()) cover.work(session, -1);
}

}  // namespace

TEST_CASE("nothing is tried before the predictions, and nothing can be saved") {
  lesson::Session session = opened();
  ClaimsCover cover({.clock = no_time});
  REQUIRE(cover.command(session, "measure"));  // which asks
  CHECK_FALSE(cover.running());
  CHECK_FALSE(cover.work_buttons(session)[0].enabled);
  CHECK_FALSE(cover.command(session, "measure"));
  CHECK(cover.file("csv").empty());
  CHECK(cover.table(session).rows.empty());
  CHECK(cover.choices(session).size() == 10);
}

TEST_CASE("after Measure the answer is decided, and the worst cloud is marked and can be put on the stage") {
  lesson::Session session = opened();
  ClaimsCover cover({.clock = no_time});
  answer_and_measure(cover, session);
  CHECK(cover.decided(session));
  REQUIRE(session.log().outcomes().size() == 1);
  CHECK(session.log().outcomes()[0].right);
  CHECK(cover.table(session).rows.size() == 10);
  CHECK(cover.file("csv").starts_with("# snug table: trials\n"));
  const auto worst = cost::tally_trials("four_points", cost::all_trials()).worst;
  CHECK(cover.caption(session).find("cloud " + std::to_string(worst->seed) + ":") != std::string::npos);
  REQUIRE(cover.command(session, "chart_load"));
  CHECK_FALSE(cover.shown());
  CHECK(session.stage().subject().size() == worst->points);
  CHECK(session.stage().subject().origin().source == worst->kind);
  CHECK(session.player().method(0)->name == "brute_force_slide");
  CHECK(session.player().step() == session.player().steps());
}

TEST_CASE("keys walk along a line and from line to line, and wrap around") {
  lesson::Session session = opened();
  ClaimsCover cover({.clock = no_time});
  answer_and_measure(cover, session);
  REQUIRE(cover.command(session, "show_brute_force_growth"));
  CHECK(cover.claim().name == "brute_force_growth");
  CHECK(cover.caption(session).find("Marked") == std::string::npos);  // it has no counter-example
  CHECK_FALSE(cover.command(session, "chart_load"));
  for (const char* const key : {"ArrowRight", "ArrowLeft", "ArrowDown", "ArrowUp"})
    CHECK(cover.command(session, cover.command_of_key(key)));
  const std::string first = cover.caption(session);
  for (int i = 0; i < cost::kTrialSeeds; ++i) REQUIRE(cover.command(session, "chart_next"));
  CHECK(cover.caption(session) == first);
  for (std::size_t i = 0; i < cost::trial_kinds().size(); ++i) REQUIRE(cover.command(session, "chart_down"));
  CHECK(cover.caption(session) == first);
  CHECK(cover.command(session, "chart_load"));
  CHECK_FALSE(cover.command(session, "show_nothing"));
}

TEST_CASE("a run that is stopped shows its clouds and decides nothing") {
  lesson::Session session = opened();
  ClaimsCover cover({.clock = no_time});
  session.conversation().ask_predictions();
  REQUIRE(session.conversation().give(lesson::OneChoice{2}));
  REQUIRE(cover.command(session, "measure"));
  for (int i = 0; i < 50; ++i) cover.work(session, -1);
  REQUIRE(cover.command(session, "stop_measuring"));
  CHECK_FALSE(cover.running());
  CHECK_FALSE(cover.decided(session));
  CHECK(session.log().outcomes()[0].pending);
  CHECK(cover.table(session).rows.size() == 1);
}

TEST_CASE("the chart is that of the question that is asked, until another is chosen") {
  std::string text(kClaimsLesson);
  const std::string_view own = "claim = \"four_points\"";
  text.replace(text.find(own), own.size(), "claim = \"kdop_tighter\"");
  lesson::Session session = opened(text);
  ClaimsCover cover({.clock = no_time});
  CHECK(cover.claim().name == "four_points");
  session.conversation().ask_predictions();
  cover.work(session, 0);
  CHECK(cover.claim().name == "kdop_tighter");
  REQUIRE(cover.command(session, "show_welzl_growth"));
  cover.work(session, 0);
  CHECK(cover.claim().name == "welzl_growth");
}
