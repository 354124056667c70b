// What the panel beside a scene says of the updates of its volume, and what it keeps to itself.
#include "app/subjects/scene/update_costs.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "../../bench.hpp"
#include "../../viewed_lessons.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::app {
namespace {

constexpr Layout kNumbersBeside{{0, 0, 800, 440}, {0, 440, 800, 160}, {800, 0, 300, 1600}};

constexpr const char* kThreeUpdates = "algorithms = [\"k14\", \"k14_rebuild\", \"obb\"]\ncompare = \"obb\"";

lesson::Lesson scene_of_updates(std::string_view question = "", const char* updates = kThreeUpdates) {
  return test::viewed(
      std::string("volume = \"scene\"\n") + updates,
      "[points]\ndim = 3\ngenerate = \"gaussian\"\ncount = 30\n[scene]\nframes = 12\n"
      "[[scene.body]]\nname = \"body\"\nshape = \"points\"\n[[scene.effect]]\neffect = \"spin\"\nbody = \"body\"\n"
      "turns_per_second = 0.5\n[[scene.effect]]\neffect = \"refit\"\n" +
          std::string(question));
}

bool is_drawn(const std::vector<std::string>& words, const std::string& one) {
  return std::find(words.begin(), words.end(), one) != words.end();
}

/// The points that an update examines in the last frame, as a text.
std::string last_cost_text(const lesson::Session& session, std::string_view algorithm) {
  for (const lesson::Figure& figure : session.player().result(*lesson::find_method(session.lesson(), algorithm)))
    if (figure.key == "cost") return lesson::count_text(static_cast<std::int64_t>(figure.value));
  return "no cost";
}

}  // namespace

TEST_CASE("the panel of an updated volume shows its cost frame by frame, and what each update costs") {
  Bench bench(scene_of_updates(), kNumbersBeside);
  bench.session().jump(6);
  const auto words = bench.words();
  for (const char* due : {"Looseness, frame by frame", "Points examined, frame by frame", "Points examined in frame 12",
                          "14-DOP by hill climbing", "Transformed OBB"})
    CHECK_MESSAGE(is_drawn(words, due), due);
  for (const char* update : {"k14", "k14_rebuild", "obb"})
    CHECK_MESSAGE(is_drawn(words, last_cost_text(bench.session(), update)), update);
}

TEST_CASE("the scale of the looseness ends at the greatest one, in the words of the figure beside it") {
  Bench bench(scene_of_updates("", "algorithms = [\"k14_loose\"]"), kNumbersBeside);
  bench.session().jump(6);
  double most = 0;
  for (int step = 0; step < 6; ++step) {
    const auto& fact = lesson::scene_run(bench.session().player().run(0)).entry(step).step.fact;
    most = std::max(most, lesson::figure_of(*std::get_if<lesson::FrameTaken>(&fact), "slack"));
  }
  REQUIRE(most > 100);
  CHECK(is_drawn(bench.words(), lesson::scene_figure_text("slack", most)));
}

TEST_CASE("while its cost is to be predicted, neither the curve nor any bar tells it") {
  Bench bench(scene_of_updates(R"(
[[question]]
id = "cost"
algorithm = "k14"
before = "frame_taken"
nth = 6
asks = "figure"
figure = "cost"
bounds = [14, 30]
prompt = "How many?"
because = "So many."
)"),
              kNumbersBeside);
  bench.session().go(5);
  REQUIRE(bench.session().conversation().asked() != nullptr);
  const auto words = bench.words();
  CHECK(is_drawn(words, "Looseness, frame by frame"));
  CHECK_FALSE(is_drawn(words, "Points examined, frame by frame"));
  CHECK(is_drawn(words, "Points examined in frame 12"));
  CHECK_FALSE(is_drawn(words, last_cost_text(bench.session(), "k14_rebuild")));
}

}  // namespace snug::app
