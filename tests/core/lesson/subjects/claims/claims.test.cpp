// The lesson kind with the charts of claims: asked before they are tried, decided by all clouds, graded on the stage.
#include "lesson/subjects/claims/claims.hpp"

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kClaims = R"(version = 2
title = "Claims"
summary = "Claims for tests."
minutes = 1
chart = "claims"
algorithms = ["sphere/brute_force_slide", "sphere/brute_force", "sphere/ritter", "sphere/pca", "sphere/ritter_iterative", "sphere/welzl", "obb/pca_hull", "obb/face_aligned", "kdop/k14"]
generators = ["stick"]

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

[[question]]
id = "own"
asks = "choice"
choices = ["Yes", "No"]
answer = "No"
holds = "always"
prompt = "And is this?"
because = "So."

[[task]]
prompt = "Refute it."
algorithm = "sphere/brute_force_slide"
points = 6
hint = "A stick."
model = [[0, 0, 2], [0, 0, -2], [0.6, 0, 0.2], [-0.6, 0, 0.1], [0, 0.6, 0], [0, -0.6, -0.1]]

[[task.require]]
figure = "excess"
algorithm = "sphere/brute_force_slide"
over = "sphere/brute_force"
at_least = 100
)";

std::string with(std::string_view old_words, std::string_view new_words) {
  std::string text(kClaims);
  const std::size_t at = text.find(old_words);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old_words.size(), new_words);
}

Session opened() {
  auto lesson = check::checked_lesson(kClaims, "claims.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

void try_claims(Session& session) {
  REQUIRE(session.inform<ClaimsSubject>([](ClaimsSubject& claims) { claims.tried(cost::all_trials()); }));
}

Answer choice(int i) { return OneChoice{i}; }

}  // namespace

TEST_CASE("the answers wait for the clouds, and no edit of the stage changes them") {
  Session session = opened();
  CHECK(session.lesson().subject == &kClaimsRow);
  CHECK(session.conversation().asked() == nullptr);  // first seen, then asked
  session.conversation().ask_predictions();
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->choices.size() == 3);
  REQUIRE(session.conversation().give(choice(2)));
  REQUIRE(session.conversation().give(choice(0)));
  REQUIRE(session.log().outcomes().size() == 2);
  for (const Outcome& outcome : session.log().outcomes()) CHECK(outcome.pending);
  try_claims(session);
  CHECK(session.log().outcomes()[0].right);
  CHECK(session.log().outcomes()[0].says.find(" of 240 clouds.") != std::string::npos);
  CHECK_FALSE(session.log().outcomes()[1].right);
  REQUIRE(session.stage().set_generator("stick", 12, 3, 5));
  CHECK(session.log().outcomes().size() == 2);
  CHECK(session.conversation().asked() == nullptr);
  CHECK(as<ClaimsSubject>(session.stage().subject())->trials().size() == cost::all_trials().size());
}

TEST_CASE("a cloud of a row is the one that its kind, number and seed scatter") {
  Session session = opened();
  const auto worst = cost::tally_trials("four_points", cost::all_trials()).worst;
  REQUIRE(worst.has_value());
  REQUIRE(session.stage().set_generator(worst->kind, worst->points, 3, static_cast<std::uint64_t>(worst->seed)));
  const AnyPointSet cloud = cost::trial_cloud(worst->kind, worst->points, worst->seed);
  REQUIRE(session.stage().subject().size() == fit::count_of(cloud));
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    CHECK(session.stage().subject().at(i) == fit::point_of(cloud, i));
  CHECK(shown_by(session.lesson(), *cost::find_trial("four_points")) == "brute_force_slide");
  CHECK(shown_by(session.lesson(), *cost::find_trial("kdop_tighter")) == "kdop/k14");
}

TEST_CASE("its model answers are sound, and its task is graded on the points") {
  Session session = opened();
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  CHECK(played->sound());
  session.stage().start_task(0);
  CHECK_FALSE(session.grade(0).done);
}

TEST_CASE("a claim that there is not, and an algorithm that no claim can do without, are told with their place") {
  const auto refusal = [](const std::string& text) {
    const auto lesson = check::checked_lesson(text, "claims.toml");
    return lesson ? std::string() : lesson.error().message();
  };
  CHECK(refusal(with("claim = \"four_points\"", "claim = \"five_points\"")).find("five_points") != std::string::npos);
  CHECK(refusal(with(", \"kdop/k14\"", "")).find("lacks kdop/k14") != std::string::npos);
}

TEST_CASE("a count of clouds reads as a sentence has it") {
  CHECK(tally_text({.clouds = 240, .held = 240}) == "all 240 clouds");
  CHECK(tally_text({.clouds = 240, .held = 91}) == "91 of 240 clouds");
  CHECK(tally_text({.clouds = 240, .held = 0}) == "none of 240 clouds");
}
