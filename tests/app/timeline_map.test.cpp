#include "app/timeline_map.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "bench.hpp"
#include "course_lessons.hpp"
#include "lesson/exercise/instance.hpp"

namespace snug::app {

TEST_CASE("steps and pixels: there and back, and no step beyond either end") {
  for (const int steps : {1, 7, 58, 1850}) {
    const TimelineMap map{400, 2000, steps};
    for (int step = 0; step <= steps; ++step) REQUIRE(map.step_at(map.x_of(step)) == step);
    CHECK(map.step_at(-50) == 0);
    CHECK(map.step_at(9999) == steps);
  }
  const TimelineMap empty{0, 100, 0};
  CHECK(empty.x_of(0) == 0);
  CHECK(empty.step_at(70) == 0);
}

TEST_CASE("marks with room: all questions, the others apart from each other and from gates") {
  using Kind = lesson::Mark::Kind;
  std::vector<lesson::Mark> marks;
  for (int step = 1; step <= 1000; ++step) marks.push_back({step, step % 400 == 0 ? Kind::kQuestion : Kind::kGrew});
  const TimelineMap map{0, 500, 1000};
  const auto kept = marks_with_room(marks, map, 13);
  CHECK(std::count_if(kept.begin(), kept.end(), [](const auto& m) { return m.kind == Kind::kQuestion; }) == 2);
  CHECK(kept.size() > 25);
  for (std::size_t i = 1; i < kept.size(); ++i) REQUIRE(map.x_of(kept[i].step) - map.x_of(kept[i - 1].step) >= 12.99f);
  const std::vector<lesson::Mark> few{{3, Kind::kGrew}, {500, Kind::kReplaced}};
  CHECK(marks_with_room(few, map, 13).size() == 2);
}

TEST_CASE("a best is never left out for want of room: what stands too near gives way") {
  using Kind = lesson::Mark::Kind;
  const std::vector<lesson::Mark> marks{
      {10, Kind::kGrew}, {12, Kind::kBest}, {14, Kind::kBest}, {16, Kind::kGrew}, {60, Kind::kGrew}};
  const auto kept = marks_with_room(marks, {0, 500, 1000}, 13);
  REQUIRE(kept.size() == 3);
  CHECK(kept[0].step == 12);
  CHECK(kept[1].step == 14);
  CHECK(kept[2].step == 60);
}

namespace {

/// Welzl's run of a lesson that asks these questions where a point is forced onto the boundary for the third time.
lesson::Session asking_at_third(const std::vector<std::string>& ids) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.points = {.dim = 2, .generate = "clusters", .count = 14};
  lesson.algorithms = {"welzl"};
  for (const std::string& id : ids) {
    lesson::Question& question = lesson.questions.emplace_back();
    question.id = id;
    question.gate = {.algorithm = "welzl", .fact = "boundary_forced", .occurrence = 3, .after = ""};
    question.asks = "point";
    question.prompt = "Which?";
  }
  return *lesson::Session::open(std::move(lesson));
}

}  // namespace

TEST_CASE("marks beyond the first question without an answer would tell it: they come with the answer") {
  lesson::Session session = asking_at_third({"third"});
  REQUIRE(session.conversation().questions().size() == 1);
  const int gate = session.conversation().questions()[0].step;
  const auto hidden = [&] { return session.player().marks().size() - marks_to_show(session).size(); };
  REQUIRE(std::any_of(session.player().marks().begin(), session.player().marks().end(),
                      [&](const auto& mark) { return mark.step > gate; }));
  CHECK(hidden() > 0);
  for (const auto& mark : marks_to_show(session)) CHECK(mark.step <= gate);
  session.go(gate);
  CHECK(hidden() > 0);
  REQUIRE(session.conversation().give({}));
  CHECK(hidden() == 0);
  session.go(0);
  CHECK(hidden() == 0);
  session.forget_answers();
  session.jump(gate + 1);  // passes it: what was shown stays
  for (const auto& mark : marks_to_show(session)) CHECK(mark.step <= gate + 1);
  CHECK(hidden() > 0);
}

TEST_CASE("of two questions at one step, the second waits when the first has its answer, and marks stay away") {
  lesson::Session session = asking_at_third({"first", "second"});
  REQUIRE(session.conversation().questions().size() == 2);
  REQUIRE(session.conversation().questions()[0].step == session.conversation().questions()[1].step);
  session.go(session.conversation().questions()[0].step);
  REQUIRE(session.conversation().give({}));
  CHECK_FALSE(is_open(session, session.conversation().questions()[0]));
  CHECK(is_open(session, session.conversation().questions()[1]));
  CHECK(marks_to_show(session).size() < session.player().marks().size());
}

TEST_CASE("gates of steps that lie close together stand side by side, within the track") {
  using Kind = lesson::Mark::Kind;
  const std::vector<lesson::Mark> marks{{0, Kind::kQuestion},  {1, Kind::kGrew},       {2, Kind::kQuestion},
                                        {60, Kind::kQuestion}, {119, Kind::kQuestion}, {120, Kind::kQuestion}};
  const TimelineMap map{100, 480, 120};
  const std::vector<float> flags = flag_places(marks, map, 17);
  REQUIRE(flags.size() == 5);
  for (std::size_t i = 1; i < flags.size(); ++i) CHECK(flags[i] - flags[i - 1] >= 17);
  CHECK(flags[0] == map.x_of(0));
  CHECK(flags[2] == map.x_of(60));  // where there is room it stands over its step
  CHECK(flags[4] == map.x_of(120));
}

namespace {

std::shared_ptr<const lesson::Exercise> course_exercise(const std::string& id) {
  std::ifstream file(lessons_folder() + "exercises/" + id + ".toml");
  lesson::ExerciseDraft draft =
      lesson::read_exercise(std::string(std::istreambuf_iterator<char>(file), {}), id + ".toml");
  REQUIRE(draft.mistakes.empty());
  return std::make_shared<const lesson::Exercise>(std::move(draft.exercise));
}

bool says(Bench& bench, const std::string& wanted) {
  const std::vector<std::string> words = bench.words();
  return std::find(words.begin(), words.end(), wanted) != words.end();
}

}  // namespace

TEST_CASE("where the number of steps would tell the end of a test, it is told with the last decision") {
  Bench bench(course_lesson("obb-axes"));
  for (const char* id : {"sat-space", "aabb-overlap", "kdop-overlap-test", "cull-a-box"}) {
    REQUIRE(bench.app.open_exercise(course_exercise(id), 1));
    bench.frames(3);
    lesson::Session& session = bench.session();
    lesson::Conversation& talk = session.conversation();
    while (!all_decided(session)) {
      const int step = session.player().step();
      CHECK_MESSAGE(says(bench, "step " + std::to_string(step)), id);
      const auto open = [&](const lesson::Asked& asked) { return is_open(session, asked); };
      const auto next = std::find_if(talk.questions().begin(), talk.questions().end(), open);
      CHECK_MESSAGE(furthest_to_show(session, bench.app.sitting()) == std::max(next->step, step), id);
      if (talk.asked() == nullptr) session.forward();
      else REQUIRE(talk.give(lesson::model_answer(*talk.asked(), session.player().run(0))));
    }
    CHECK_FALSE(furthest_to_show(session, bench.app.sitting()));
    const std::string all = std::to_string(session.player().steps());
    CHECK_MESSAGE(says(bench, "step " + std::to_string(session.player().step()) + " of " + all), id);
  }
}

TEST_CASE("where an exercise says how many decisions there are, its steps are counted") {
  Bench bench(course_lesson("obb-axes"));
  REQUIRE(bench.app.open_exercise(course_exercise("sat-plane"), 1));
  bench.frames(3);
  CHECK_FALSE(furthest_to_show(bench.session(), bench.app.sitting()));
  const lesson::Player& player = bench.session().player();
  CHECK(says(bench, "step " + std::to_string(player.step()) + " of " + std::to_string(player.steps())));
}

}  // namespace snug::app
