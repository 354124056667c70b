// The lessons on a field, played to their ends, and what the reader refuses.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "lesson/subjects/field/field.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::array kFieldLessons{"frustum-field", "examples/field"};

}  // namespace

TEST_CASE("the lessons on a field play to their ends, with their tasks solved by the model alone") {
  for (const char* id : kFieldLessons) {
    CAPTURE(id);
    Session session = test::session_of(id);
    for (std::size_t task = 0; task < session.lesson().tasks.size(); ++task) CHECK_FALSE(session.grade(task).done);
    const auto played = check::play(session);
    REQUIRE_MESSAGE(played.has_value(), (played ? "" : played.error().message()));
    CHECK(played->sound());
    for (std::uint64_t seed = 2; seed <= 5; ++seed) {
      CAPTURE(seed);
      session.stage().scatter(seed);
      for (const std::string& name : session.lesson().algorithms) {
        REQUIRE(session.player().choose(0, name).has_value());
        for (const Asked& one : session.conversation().questions())
          CHECK(judge(one, model_answer(one, session.player().run(0)), session.player().run(0)).right);
      }
    }
  }
}

TEST_CASE("a step of a field says that no object is left out, and not that 0 objects are") {
  Session session = test::session_of("frustum-field");
  REQUIRE(session.player().choose(0, "tree_masking").has_value());
  for (int step = 0; step <= session.player().steps(); ++step) {
    session.jump(step);
    CHECK_MESSAGE(session.telling().caption().find(" 0 objects are") == std::string::npos, session.telling().caption());
  }
}

TEST_CASE("each mistake about a field is told with its line") {
  struct Broken {
    std::string_view from, to, marker, says;
  };
  const std::string good = test::lessons_file("examples/field.toml");
  for (const Broken& broken : std::initializer_list<Broken>{
           {"[field]", "[things]", "[things]", "the lesson has no key \"things\"; it lacks [field]"},
           {"objects = 1000", "objects = 3", "objects = 3", "8"},
           {"camera = [-20, 6, 14]", "camera = [-20, 6]", "camera = [", "three numbers"},
           {"camera = [-20, 6, 14]\n", "", "[field]", "camera"},
           {"aim = [0, 4, 0]\n", "aim = [-20, 4, 14]\n", "camera = [", "straight up or down"},
           {"far = 30", "far = 0.5", "camera = [", "near"},
           {"far = 30", "size = [0.5, 0.1]", "size = [", "the least first"},
           {"far = 30", "colour = 1", "colour", "colour"},
           {"at_least = 300", "at_least = 999", "model = {", "does not solve the task"},
       }) {
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
}
