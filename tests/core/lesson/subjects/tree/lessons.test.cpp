// The lessons on trees, played to their ends, and what the reader refuses.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "lesson/subjects/tree/entries.hpp"
#include "lesson/subjects/tree/tree.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::session_of;

namespace {

constexpr std::array kLessons{"bvh-build", "bvh-traverse", "bvh-merge", "examples/tree"};

struct Broken {
  std::string_view from, to, marker, says;
};

void check_broken(const std::string& good, const Broken& broken) {
  CAPTURE(broken.to);
  std::string text = good;
  const auto at = text.find(broken.from);
  REQUIRE(at != std::string::npos);
  text.replace(at, broken.from.size(), broken.to);
  const auto lesson = check::checked_lesson(text, "x.toml");
  REQUIRE_FALSE(lesson.has_value());
  CHECK_MESSAGE(lesson.error().message().find(broken.says) != std::string::npos, lesson.error().message());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(broken.marker));
  const auto line = std::count(text.begin(), end, '\n') + 1;
  CHECK_MESSAGE(lesson.error().message().find("x.toml:" + std::to_string(line)) == 0, lesson.error().message());
}

}  // namespace

TEST_CASE("the lessons on trees play to their ends, with their tasks solved by the model alone") {
  for (const char* id : kLessons) {
    CAPTURE(id);
    Session session = session_of(id);
    CHECK(session.lesson().sections.size() <= 5);
    for (std::size_t task = 0; task < session.lesson().tasks.size(); ++task) CHECK_FALSE(session.grade(task).done);
    const auto played = check::play(session);
    REQUIRE_MESSAGE(played.has_value(), (played ? "" : played.error().message()));
    CHECK(played->sound());
    for (const auto& algorithm : played->algorithms) CHECK(algorithm.steps > 0);
  }
}

TEST_CASE("scattered anew, the lessons on trees still play, and every model answer is right") {
  int asked = 0;
  for (const char* id : kLessons)
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      CAPTURE(id);
      CAPTURE(seed);
      Session session = session_of(id);
      session.stage().scatter(seed);
      for (const std::string& name : session.lesson().algorithms) {
        REQUIRE(session.player().choose(0, name).has_value());
        for (const Asked& one : session.conversation().questions()) {
          CHECK(judge(one, model_answer(one, session.player().run(0)), session.player().run(0)).right);
          ++asked;
        }
      }
    }
  CHECK(asked > 100);
}

TEST_CASE("each mistake about boxes under a tree is told with its line") {
  const std::string build = test::lessons_file("examples/tree.toml");
  for (const Broken& broken : std::initializer_list<Broken>{
           {"[objects]", "[things]", "[things]", "the lesson has no key \"things\"; it lacks [objects]"},
           {"half_extents = [[0.25, 0.2]]\n\n[[section]]", "\n[[section]]", "[objects]", "half_extents"},
           {"half_extents = [[0.25, 0.2]]\n\n[[section]]", "half_extents = [[1, 1], [1, 1]]\n\n[[section]]",
            "half_extents = [[1, 1]", "as many as the centres"},
           {"half_extents = [[0.25, 0.2]]\n\n[[section]]", "half_extents = [[-1, 1]]\n\n[[section]]", "center",
            "below 0"},
           {"center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7], [1.4, 0.5], [2.2, -0.2]]",
            "center = [[-2, 0.8]]", "center = [[-2, 0.8]]", "2 to 14 boxes"},
           {"center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7], [1.4, 0.5], [2.2, -0.2]]\nhalf",
            "generate = \"claster\"\ncount = 8\n#", "generate", "did you mean clusters?"},
           {"center = [[-2, 0.8], [-1.2, -0.4], [-0.4, 0.6], [0.6, -0.7], [1.4, 0.5], [2.2, -0.2]]\nhalf",
            "generate = \"clusters\"\ncount = 20\n#", "count", "14"},
           {"volume = \"bvh_build\"", "volume = \"bvh_query\"", "# A lesson", "the lesson lacks [query]"},
           {"asks = \"points\"", "asks = \"pair\"", "[[question]]", "can only be asked of nodes_merged"},
           {"[20, -0.2]", "[2, -0.2]", "model = {", "does not solve the task"},
           {"[[section]]", "built = [[0, 0]]\n[[section]]", "built", "bvh_update"},
           {"[[section]]", "[query]\nfrom = [0, 0]\nto = [1, 1]\n[[section]]", "[query]", "bvh_query"},
       })
    check_broken(build, broken);
}

TEST_CASE("a loss that is no more than a rounded 0 % is not called 0 %") {
  CHECK(loss_words(0.083) == "8.3 %");
  CHECK(loss_words(0.0009) == "0.1 %");
  CHECK(loss_words(0.00002) == "less than 0.1 %");
}
