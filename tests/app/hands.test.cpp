// Hands on the stage, with a mouse that ImGui is fed with and no screen.
#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "app/inspector.hpp"
#include "app/look.hpp"
#include "app/shown.hpp"
#include "app/subjects/cost/costs.hpp"
#include "bench.hpp"
#include "course_lessons.hpp"
#include "lesson/exercise/instance.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/certificate_lines.hpp"
#include "lesson/subjects/scene/scene_set.hpp"

namespace snug::app {
namespace {

/// Ritter's pair is P0 and P1 (along x); P4 and P5 lie outside its circle, P6 is in the middle.
lesson::Lesson flat() {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.points.list = {{-2, 0, 0},    {2, 0, 0},        {0, 1.6, 0},  {0, -1.6, 0},
                        {1.5, 1.5, 0}, {-1.55, 1.55, 0}, {0.2, 0.1, 0}};
  lesson.algorithms = {"ritter", "welzl"};
  return lesson;
}

lesson::Lesson asking_for_pair() {
  lesson::Lesson lesson = flat();
  lesson::Question question;
  question.id = "pair";
  question.gate = {.algorithm = "ritter", .fact = "pair_chosen", .occurrence = 1, .after = ""};
  question.asks = "axis";
  question.prompt = "Which pair?";
  lesson.questions = {question};
  return lesson;
}

lesson::Lesson asking_at_start() {
  lesson::Lesson lesson = flat();
  lesson::Question question;
  question.id = "growth";
  question.gate = {.algorithm = "ritter", .fact = "ball_grown", .occurrence = 1, .after = "start"};
  question.asks = "point";
  question.prompt = "Which point makes it grow first?";
  lesson.questions = {question};
  return lesson;
}

lesson::Lesson in_space(int count) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.points = {.dim = 3, .generate = "gaussian", .count = count};
  lesson.algorithms = {"ritter"};
  return lesson;
}

}  // namespace

TEST_CASE("a view that was easing when the chart came over it asks for no more frames") {
  lesson::Lesson lesson = in_space(12);
  lesson.subject = lesson::subject_named("cost");
  Bench bench(std::move(lesson));
  bench.app.settings().reduced_motion = false;
  bench.app.cover()->show(false);
  bench.frames(3);
  REQUIRE(bench.app.command("orbit_left"));
  bench.frames(1);
  bench.app.cover()->show(true);
  bench.frames(50);
  CHECK_FALSE(bench.app.wants_frame(1e6));
}

TEST_CASE("a drag moves its point and leaves the arrow keys to the player") {
  Bench bench(flat());
  const Handle at = bench.handle("P4");
  const auto before = bench.session().stage().subject().at(4);
  bench.drag(at.x, at.y, 24, 12);
  CHECK(bench.session().stage().subject().at(4)[0] > before[0]);
  CHECK(bench.session().stage().subject().at(4)[1] < before[1]);
  CHECK(bench.key("ArrowRight") == "step");
  CHECK(bench.session().stage().can_undo());
}

TEST_CASE("a key that deletes the point in hand, or undoes it, ends the drag") {
  for (const char* command : {"delete_point", "undo"}) {
    CAPTURE(command);
    Bench bench(flat());
    const Index last = bench.session().stage().subject().size() - 1;
    const Handle at = bench.handle(bench.session().stage().subject().name_of(last));
    bench.press(at.x, at.y);
    bench.move(at.x + 24, at.y + 12);
    REQUIRE(bench.session().stage().dragging());
    REQUIRE(bench.app.command(command));
    const auto rows = bench.session().stage().subject().rows();
    bench.move(at.x + 60, at.y - 40);
    CHECK(bench.session().stage().subject().rows() == rows);
    CHECK_FALSE(bench.session().stage().dragging());
    bench.release();
    CHECK(bench.session().stage().subject().rows() == rows);
  }
}

TEST_CASE("arrow keys go to a point selected by a key, by its number, or by a click, and back with the next drag") {
  Bench bench(flat());
  CHECK(bench.key("ArrowRight") == "step");
  bench.click("P6");
  CHECK(bench.app.selected() == 6);
  CHECK(bench.key("ArrowRight") == "move_right");
  const Handle at = bench.handle("P4");
  bench.drag(at.x, at.y, 20, 0);
  CHECK(bench.key("ArrowRight") == "step");
  bench.app.select(2);
  CHECK(bench.key("ArrowUp") == "move_up");
  REQUIRE(bench.app.command("select_none"));
  CHECK(bench.key("ArrowUp") == "back");
  REQUIRE(bench.app.command("select_next"));
  CHECK(bench.key("ArrowLeft") == "move_left");
}

TEST_CASE("a handle selected in one situation selects none in another") {
  Bench bench(course_lesson("bvh-traverse"));
  REQUIRE(bench.session().stage().show_situation("copies").has_value());
  bench.frames(2);
  bench.click("Q");
  CHECK(bench.app.selected() != kNoIndex);
  REQUIRE(bench.session().stage().show_situation("misled").has_value());
  bench.frames(2);
  CHECK(bench.app.selected() == kNoIndex);
}

TEST_CASE("a handle that another algorithm does not read is selected no more") {
  Bench bench(course_lesson("bvh-traverse"));
  REQUIRE(bench.session().player().choose(0, "box_query").has_value());
  bench.frames(2);
  bench.click("R");
  CHECK(bench.app.selected() != kNoIndex);
  REQUIRE(bench.session().player().choose(0, "point_query").has_value());
  bench.frames(2);
  CHECK(bench.app.selected() == kNoIndex);
  const std::vector<std::string> words = bench.words();
  CHECK(std::find(words.begin(), words.end(), "R") == words.end());
}

TEST_CASE("a second click answers and selects nothing; a wrong guess is crossed and the right one ticked") {
  Bench bench(asking_for_pair());
  REQUIRE(bench.app.command("step"));
  REQUIRE(bench.session().conversation().asked() != nullptr);
  bench.click("P6");  // none of the extremes: nothing is answered, and the arrow keys do not go to it
  CHECK(bench.session().conversation().asked() != nullptr);
  CHECK(bench.key("ArrowRight") == "step");
  CHECK(bench.session().conversation().answer_says().starts_with("P6 cannot be the answer."));
  CHECK(bench.session().log().outcomes().empty());
  bench.click("P3");
  CHECK(bench.session().log().outcomes().empty());
  REQUIRE(bench.session().conversation().picked() != nullptr);
  CHECK(*bench.session().conversation().picked() == lesson::Answer(lesson::OneHandle{3}));
  bench.click("P3");
  REQUIRE(bench.session().conversation().outcome() != nullptr);
  CHECK_FALSE(bench.session().conversation().outcome()->right);
  CHECK(bench.app.selected() == kNoIndex);
  CHECK(bench.key("ArrowRight") == "step");
  const Shown shown = shown_at(bench.session());
  CHECK(shown.guessed_wrong == std::vector<Index>{3});
  CHECK(shown.right.empty());  // until it is asked for
  REQUIRE(bench.app.command("show_answer"));
  CHECK(shown_at(bench.session()).right == std::vector<Index>{0, 1});
  REQUIRE(bench.app.command("step"));
  CHECK(bench.session().conversation().outcome() == nullptr);
  CHECK(shown_at(bench.session()).right.empty());
}

TEST_CASE("of an answer of several choices, the handles of each are marked") {
  std::ifstream file(lessons_folder() + "exercises/be-gjk.toml");
  const lesson::ExerciseDraft draft =
      lesson::read_exercise(std::string(std::istreambuf_iterator<char>(file), {}), "be-gjk.toml");
  REQUIRE(draft.mistakes.empty());
  auto session = lesson::open_instance(draft.exercise, *lesson::make_instance(draft.exercise, 8), nullptr, true);
  REQUIRE(session);
  lesson::Conversation& conversation = session->conversation();
  const auto right = [&] { return lesson::model_answer(*conversation.asked(), session->player().run(0)); };
  while (conversation.asked() == nullptr || !conversation.asked()->many)
    if (conversation.asked() == nullptr) session->forward();
    else REQUIRE(conversation.give(right()));
  const auto handles = conversation.asked()->choice_handles;
  const int wrong = right() == lesson::Answer(lesson::SeveralChoices{{0}}) ? 1 : 0;  // this choice alone
  REQUIRE(conversation.give(lesson::SeveralChoices{{wrong}}));
  CHECK(shown_at(*session).guessed_wrong == handles[wrong]);
}

TEST_CASE("the bracket keys go through what can be the answer alone, and Enter gives it") {
  Bench bench(asking_for_pair());
  REQUIRE(bench.app.command("step"));
  const std::vector<Index> targets = bench.session().conversation().targets();
  REQUIRE(targets.size() < static_cast<std::size_t>(bench.session().stage().subject().size()));
  const auto picked = [&] { return std::get<lesson::OneHandle>(*bench.session().conversation().picked()).handle; };
  CHECK_FALSE(bench.app.command("commit_answer"));
  for (const Index wanted : targets) {
    REQUIRE(bench.app.command(bench.key("]")));
    REQUIRE(bench.session().conversation().picked() != nullptr);
    CHECK(picked() == wanted);
  }
  REQUIRE(bench.app.command(bench.key("]")));  // round to the first
  CHECK(picked() == targets.front());
  REQUIRE(bench.app.command(bench.key("[")));
  CHECK(picked() == targets.back());
  REQUIRE(bench.app.command(bench.key("Escape")));
  CHECK(bench.session().conversation().picked() == nullptr);
  REQUIRE(bench.app.command(bench.key("]")));
  CHECK(bench.app.selected() == kNoIndex);
  REQUIRE(bench.app.command(bench.key("Enter")));
  CHECK(bench.session().log().outcomes().size() == 1);
}

TEST_CASE("a press on what can be the answer drags it once it travels, and answers nothing then") {
  Bench bench(asking_for_pair());
  REQUIRE(bench.app.command("step"));
  const Handle at = bench.handle("P3");
  const Point3 before = bench.session().stage().subject().at(3);
  bench.drag(at.x, at.y, 40, 10);
  CHECK(bench.session().stage().subject().at(3) != before);
  CHECK(bench.session().log().outcomes().empty());
  CHECK(bench.session().conversation().picked() == nullptr);
}

TEST_CASE("while a question stands, a click on a point takes no arrow keys") {
  lesson::Lesson lesson = asking_for_pair();
  lesson.questions[0].asks = "choice";
  lesson.questions[0].choices = {"this", "that"};
  Bench bench(std::move(lesson));
  REQUIRE(bench.app.command("step"));
  REQUIRE(bench.session().conversation().asked() != nullptr);
  bench.click("P6");
  CHECK(bench.app.selected() == 6);
  CHECK(bench.key("ArrowRight") == "step");
}

TEST_CASE("the keys that go on skip a question at their second press; play waits for it") {
  Bench bench(asking_at_start());
  bench.session().go(0);
  REQUIRE(bench.session().conversation().asked() != nullptr);
  bench.app.command("play");
  CHECK_FALSE(bench.app.playing());
  const char* key = "next_mark";
  SUBCASE("PageDown") {}
  SUBCASE("a step") { key = "step"; }
  REQUIRE(bench.app.command(key));
  CHECK(bench.session().conversation().asked() != nullptr);
  CHECK(bench.session().log().outcomes().empty());
  CHECK(bench.session().conversation().answer_says() == "Press again to skip this question.");
  REQUIRE(bench.app.command(key));
  CHECK(bench.session().conversation().asked() == nullptr);
  REQUIRE(bench.session().log().outcomes().size() == 1);
  CHECK(bench.session().log().outcomes()[0].skipped);
  int presses = 0;
  while (bench.session().player().step() < bench.session().player().steps() && presses < 100)
    ++presses, bench.app.command("next_mark");
  CHECK(bench.session().player().step() == bench.session().player().steps());
}

TEST_CASE("watching an outcome plays from its question to it, and stops there") {
  Bench bench(asking_at_start());
  bench.session().go(0);
  CHECK_FALSE(bench.app.command("watch_outcome"));
  REQUIRE(bench.session().conversation().give(lesson::OneHandle{6}));
  const int decided = bench.session().player().step();
  REQUIRE(decided >= 2);
  REQUIRE(bench.app.command("watch_outcome"));
  CHECK(bench.session().player().step() == 0);
  CHECK(bench.app.playing());
  int seen = 0;
  for (int i = 0; i < 100 && bench.app.playing(); ++i) {
    const int before = bench.session().player().step();
    bench.wait(0.5);
    CHECK(bench.session().player().step() <= before + 2);
    seen += bench.session().player().step() != before;
  }
  CHECK(seen > 1);
  CHECK(bench.session().player().step() == decided);
  CHECK_FALSE(bench.app.playing());
  CHECK(bench.session().conversation().outcome() != nullptr);
}

TEST_CASE("answering plays what was skipped, in four seconds at most, and tells the outcome then") {
  Bench bench(asking_at_start());
  bench.session().go(0);
  bench.app.settings().reduced_motion = false;
  bench.frames(1);
  const int decided = bench.session().conversation().asked()->until;
  REQUIRE(decided >= 2);
  REQUIRE(bench.session().conversation().pick(lesson::OneHandle{6}));
  REQUIRE(bench.app.command("commit_answer"));
  if (bench.session().conversation().asked() != nullptr) {  // it was wrong, and may be tried again
    REQUIRE(bench.session().conversation().pick(lesson::OneHandle{2}));
    REQUIRE(bench.app.command("commit_answer"));
  }
  REQUIRE(bench.session().conversation().deciding() != nullptr);
  CHECK(bench.session().player().step() == 0);
  bench.frames(1);
  CHECK(bench.app.playing());
  SUBCASE("to its end") {
    bench.wait(0.4);
    CHECK(bench.session().conversation().outcome() == nullptr);
    for (int i = 0; i < 10; ++i) bench.wait(0.4);
  }
  SUBCASE("until any key is pressed") {
    REQUIRE(bench.app.end_playing());
    CHECK_FALSE(bench.app.end_playing());
  }
  SUBCASE("until a tap") { bench.press(20, 20); }
  CHECK(bench.session().player().step() == decided);
  REQUIRE(bench.session().conversation().outcome() != nullptr);
  CHECK_FALSE(bench.app.playing());
  REQUIRE(bench.app.command("continue"));
  CHECK(bench.session().conversation().outcome() == nullptr);
  CHECK(bench.session().player().step() == decided);
}

TEST_CASE("who wants no motion is taken to the outcome at once") {
  Bench bench(asking_at_start());
  bench.session().go(0);
  const int decided = bench.session().conversation().asked()->until;
  REQUIRE(bench.app.command("skip_question"));
  CHECK(bench.session().player().step() == decided);
  CHECK(bench.session().conversation().outcome() != nullptr);
}

TEST_CASE("nothing is watched where the outcome follows its question at once") {
  Bench bench(asking_for_pair());
  REQUIRE(bench.app.command("step"));
  REQUIRE(bench.session().conversation().give(lesson::OneChoice{0}));
  REQUIRE(bench.session().conversation().outcome() != nullptr);
  CHECK_FALSE(bench.app.command("watch_outcome"));
  CHECK_FALSE(bench.app.playing());
}

TEST_CASE("in dense space a drag turns the view; the selected point and one hit in its middle are dragged") {
  Bench bench(in_space(400));
  const auto hash = bench.session().player().trace_hash();
  // Right beside a point, in the middle of none.
  const auto handles = bench.app.handles();
  const auto beside = std::find_if(handles.begin(), handles.end(), [&](const Handle& one) {
    return std::all_of(handles.begin(), handles.end(), [&](const Handle& other) {
      return std::hypot(other.x - one.x - 3, other.y - one.y - 3) > 2.5f;
    });
  });
  REQUIRE(beside != handles.end());
  Handle at = *beside;
  bench.drag(at.x + 3, at.y + 3, 40, 0);
  CHECK(bench.session().player().trace_hash() == hash);
  const Handle turned = bench.handle(at.id);
  CHECK(std::hypot(turned.x - at.x, turned.y - at.y) > 1);

  bench.press(turned.x + 3, turned.y + 3);
  bench.release();
  const Index chosen = bench.app.selected();
  REQUIRE(chosen != kNoIndex);
  at = bench.handle("P" + std::to_string(chosen));
  const auto place = bench.session().stage().subject().at(chosen);
  bench.drag(at.x + 2, at.y - 3, 40, 0);
  CHECK((bench.session().stage().subject().at(chosen) - place).norm() > 0);

  bench.app.select(kNoIndex);
  const auto again = bench.session().player().trace_hash();
  at = bench.app.handles().front();
  bench.drag(at.x, at.y, 30, 10);
  CHECK(bench.session().stage().can_undo());
  bench.session().stage().undo();
  CHECK(bench.session().player().trace_hash() == again);
}

TEST_CASE("among few points in space a press beside one drags it") {
  Bench bench(in_space(20));
  const Handle at = bench.app.handles().front();
  const auto hash = bench.session().player().trace_hash();
  bench.drag(at.x + 3, at.y + 3, 60, 0);
  CHECK(bench.session().stage().can_undo());
  CHECK(bench.session().player().trace_hash() != hash);
}

TEST_CASE("a drag that ends before the next frame is drawn has moved its point as far as any other") {
  const auto dragged = [](bool quick) {
    Bench bench(flat());
    const Handle at = bench.handle("P4");
    if (quick) {
      bench.press(at.x, at.y);
      for (const float share : {0.5f, 1.0f}) ImGui::GetIO().AddMousePosEvent(at.x + 24 * share, at.y + 12 * share);
      bench.release();
    } else {
      bench.drag(at.x, at.y, 24, 12);
    }
    CHECK(bench.session().stage().can_undo());
    return bench.session().stage().subject().at(4);
  };
  CHECK(dragged(true) == dragged(false));
}

/// A body that turns for two seconds, and its box.
lesson::Lesson turning() {
  lesson::Lesson lesson = in_space(12);
  lesson.volume = "scene";
  auto set = std::make_shared<lesson::SceneSet>();
  set->bodies.resize(1);
  set->bodies[0].of_points = true;
  set->effects = {{.name = "spin", .settings = {{"turns_per_second", {1}, ""}}}, {.name = "refit"}};
  lesson.tables = std::move(set);
  lesson.algorithms = {"rebuild"};
  return lesson;
}

TEST_CASE("a scene plays in the time that it simulates, and an algorithm twice a second") {
  Bench scene(turning()), steps(flat());
  for (Bench* bench : {&scene, &steps}) {
    const int before = bench->session().player().step();
    REQUIRE(bench->app.command("play"));
    for (int i = 0; i < 50; ++i) bench->frames(1);  // a second
    const int taken = bench->session().player().step() - before;
    if (bench == &scene) CHECK(std::abs(taken - 60) <= 1);
    else CHECK(taken == 2);
  }
}

TEST_CASE("a scene's box is where its body is in every frame: it does not move there after it") {
  Bench bench(turning());
  bench.app.settings().reduced_motion = false;
  bench.frames(3);
  REQUIRE(bench.app.command("step"));
  bench.frames(3);
  REQUIRE(bench.app.command("step"));
  bench.frames(3);
  CHECK_FALSE(bench.app.wants_frame(0));
}

TEST_CASE("on a narrow stage the framed ball stays below the tools") {
  Bench bench(flat());
  ImGui::NewFrame();
  bench.app.frame({.stage = {0, 0, 390, 440}, .timeline = {0, 440, 390, 158}, .fingers = true}, 100);
  ImGui::Render();
  for (int i = 0; i < 2; ++i) {
    REQUIRE(bench.app.command("reset_view"));
    ImGui::NewFrame();
    bench.app.frame({.stage = {0, 0, 390, 440}, .timeline = {0, 440, 390, 158}, .fingers = true}, 101 + i);
    ImGui::Render();
  }
  for (const Handle& handle : bench.app.handles()) CHECK(handle.y > 56);
}

TEST_CASE("beside it: step, radius and excess of the second algorithm") {
  lesson::Lesson lesson = flat();
  lesson.compare = "welzl";
  lesson::Session session = *lesson::Session::open(std::move(lesson));
  session.jump(session.player().steps());
  const auto figures = figures_beside(session);
  REQUIRE(figures.size() == 3);
  const std::string steps = std::to_string(session.player().run(1).steps());
  CHECK(figures[0].text == steps + " of " + steps);
  CHECK(figures[1].key == "radius");
  CHECK(figures[1].value == doctest::Approx(std::get_if<fit::Sphere3>(session.player().volume(1))->radius));
  CHECK(figures[2].key == "excess");
  REQUIRE(session.player().choose(1, ""));
  CHECK(figures_beside(session).empty());
}

TEST_CASE("beside a naive algorithm, the careful one says that no point is outside, and how far it was widened") {
  lesson::Lesson lesson = flat();
  lesson.algorithms = {"welzl_naive", "welzl"};
  lesson.compare = "welzl";
  lesson::Session session = *lesson::Session::open(std::move(lesson));
  session.jump(session.player().steps());
  const auto figures = figures_beside(session);
  const auto of = [&](std::string_view key) {
    const auto found = std::find_if(figures.begin(), figures.end(), [&](const auto& one) { return one.key == key; });
    REQUIRE(found != figures.end());
    return found->value;
  };
  CHECK(of("outside_count") == 0);
  CHECK(of("worst_ulps") == 0);
  CHECK(of("widened_ulps") >= 0);
  REQUIRE(session.player().choose(0, "welzl"));
  CHECK(figures_beside(session).empty());  // the same once more
}

namespace {

const Layout kWithNumbers{{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 4000}, false, 88};

bool wrote(const std::vector<DrawnWords>& drawn, std::string_view words) {
  return std::any_of(drawn.begin(), drawn.end(), [&](const DrawnWords& one) { return one.words == words; });
}

std::vector<DrawnWords> drawn_at_end(Bench& bench) {
  std::vector<DrawnWords> drawn;
  bench.session().jump(bench.session().player().steps());
  bench.app.note_words(&drawn);
  bench.frames(2);
  bench.app.note_words(nullptr);
  return drawn;
}

}  // namespace

TEST_CASE("at the end the certificate stands beside the stage with its exact numbers, and not before") {
  Bench bench(course_lesson("cases/one-ulp-over"), kWithNumbers);
  const std::string heading = "The certificate, number by number";
  const auto drawn = drawn_at_end(bench);
  CHECK(wrote(drawn, heading));
  CHECK(std::any_of(drawn.begin(), drawn.end(), [](const DrawnWords& one) {  // it runs in float
    return one.words.starts_with("All of this is about the points");
  }));
  const auto lines = lesson::certificate_lines(lesson::fit_run(bench.session().player().run(0)));
  REQUIRE(lines.has_value());
  CHECK(lines->contained.front().excess.sign > 0);              // the naive circle leaves a point outside
  CHECK(wrote(drawn, lines->contained.front().excess.text()));  // longer ones take two lines
  std::vector<DrawnWords> before;
  bench.session().go(bench.session().player().step() - 1);
  bench.app.note_words(&before);
  bench.frames(2);
  bench.app.note_words(nullptr);
  CHECK_FALSE(wrote(before, heading));
}

TEST_CASE("beside a naive method stands the proof of the careful one") {
  Bench bench(course_lesson("cases/twins"), kWithNumbers);
  const auto drawn = drawn_at_end(bench);
  CHECK(wrote(drawn, "Proof"));
  CHECK(wrote(drawn, "Proof: Welzl"));
  CHECK(wrote(drawn, "Outside, exactly"));
}

}  // namespace snug::app
