// Two boxes on the stage: its points follow A's frame, and no row stays lit when its table has gone.
#include "app/stage.hpp"

#include <algorithm>

#include "../../lone_stage.hpp"
#include "../every_step.hpp"
#include "app/subjects/pair/axis_table.hpp"
#include "app/subjects/pair/view.hpp"

namespace snug::app {

TEST_CASE("the points on the stage follow A's frame, there and back") {
  for (const char* const id : {"obb-sat", "obb-axes"}) {
    Bench bench(course_lesson(id, false));
    lesson::Session session = lesson_session(id, false);
    const auto view = pair_view();
    Stage stage;
    stage.open(session, *view);
    double now = 0;
    const auto points = [&] {
      ImGui::NewFrame();
      stage.draw(bench.app.look(), bench.app.settings(), session, {0, 0, 800, 440}, now += 0.02);
      ImGui::EndFrame();
      return stage.scene().points;
    };
    const auto of_world = points();
    REQUIRE_FALSE(of_world.empty());
    view->local_frame(session)->show(true);
    CHECK(points() != of_world);
    view->local_frame(session)->show(false);
    CHECK(points() == of_world);
  }
}

/// The longer side of what a step is about: both boxes' vertices, and the words at the axis; its second picture is none
/// of that.
float extent_on_stage(Bench& bench) {
  Around around;
  for (const Handle& handle : bench.app.handles())
    if (handle.id.size() == 2) around.take({handle.x, handle.y});  // A0 … B7
  for (const DrawnWords& one : bench.drawn_words()) {
    const bool second = one.words.find(" ≤ ") != std::string::npos || one.words.find(" > ") != std::string::npos;
    for (const char* const words : {"r_A = ", "r_B = ", "distance ", "separation ", "penetration "})
      if (one.words.starts_with(words) && !second) around.take(one.low), around.take(one.high);
  }
  return around.longer();
}

TEST_CASE("at each step both boxes take three fifths of the free stage's smaller side, also beside a question's card") {
  constexpr float kRuler = 96;
  for (const char* const id : {"obb-sat", "obb-axes", "vanishing-axes"})
    for (const ImVec2 size : {ImVec2{628, 566}, ImVec2{880, 640}, ImVec2{390, 390}})
      for (const float card : {0.0f, 150.0f}) {
        if (card > 0 && size.y < 500) continue;  // on a phone the card is below the stage
        CAPTURE(id);
        CAPTURE(size.x);
        CAPTURE(card);
        Bench bench(course_lesson(id, false),
                    {.stage = {0, 0, size.x, size.y}, .timeline = {0, size.y, size.x, 140}, .foot = card});
        for (int step = 0; step <= bench.session().player().steps(); ++step) {
          CAPTURE(step);
          bench.session().jump(step);
          bench.frames(6);
          const float ruler = step > 0 && bench.session().stage().subject().dim() == 3 && size.x >= 560 ? kRuler : 0;
          CHECK(extent_on_stage(bench) >= 0.6f * free_side(size, card, ruler));
        }
      }
}

TEST_CASE("an axis's second picture is of the row that is pointed at, as the stage is") {
  Bench bench(course_lesson("obb-axes", false), {.stage = {0, 0, 880, 640}, .timeline = {0, 640, 880, 140}});
  bench.session().jump(8);
  bench.frames(4);
  const auto picture = [&] {
    for (const std::string& one : bench.words())
      if (one.starts_with("distance ") && one.find(" ≤ ") != std::string::npos) return one;
    return std::string();
  };
  CHECK(picture().starts_with("distance 0.710 ≤ "));  // A x × B x
  bench.app.light("A y");
  CHECK(picture().starts_with("distance 0.157 ≤ "));
  bench.app.light("");
  CHECK(picture().starts_with("distance 0.710 ≤ "));
}

TEST_CASE("in A's frame A's centre is still lit, though no hand can take it") {
  Bench bench(course_lesson("obb-sat", false));
  const std::vector<DrawnWords> drawn = bench.drawn_words();
  const auto button =
      std::find_if(drawn.begin(), drawn.end(), [](const DrawnWords& one) { return one.words == "A's frame"; });
  REQUIRE(button != drawn.end());
  bench.press((button->low.x + button->high.x) / 2, (button->low.y + button->high.y) / 2);
  bench.release();
  const auto handles = bench.app.handles();
  REQUIRE(std::none_of(handles.begin(), handles.end(), [](const Handle& handle) { return handle.id == "A"; }));
  bench.move(20, 20);
  const int before = ImGui::GetDrawData()->TotalVtxCount;
  bench.app.light("A");
  bench.frames(2);
  CHECK(ImGui::GetDrawData()->TotalVtxCount > before);
}

TEST_CASE("on a phone the Minkowski difference is above the volumes, which have the stage's whole width") {
  const Layout phone{
      .stage = {0, 0, 390, 390}, .timeline = {0, 390, 390, 120}, .inspector = {}, .fingers = true, .tools = 96};
  for (const char* const id : {"overlap-any", "swept-overlap"}) {
    CAPTURE(id);
    Bench bench(course_lesson(id, false), phone);
    bench.app.settings().prose_in_canvas = false;
    bench.session().go(2);
    bench.frames(3);
    float title = 0;
    for (const DrawnWords& one : bench.drawn_words())
      if (one.words.ends_with("A − B")) title = one.low.y;
    REQUIRE(title > 0);
    float left = 390, right = 0;
    for (const Handle& handle : bench.app.handles()) {
      CAPTURE(handle.id);
      CHECK(handle.y > title + 150);  // its lower rim, and the mark of a wrong answer on a vertex
      left = std::min(left, handle.x), right = std::max(right, handle.x);
    }
    CHECK(left > 20);
    CHECK(right < 370);
    CHECK(left + right == doctest::Approx(390).epsilon(0.15));
  }
}

TEST_CASE("a row that was pointed at is not lit any more when a test without axes is chosen") {
  Bench bench(course_lesson("obb-sat", false));
  lesson::Session session = lesson_session("obb-sat", false);
  AxisLight light;
  light.pointed = 1, light.tapped = 2;
  REQUIRE(session.player().choose(0, "extents_only").has_value());
  ImGui::NewFrame();
  CHECK(draw_axis_panel(bench.app.look(), session, {}, {0, 0}, 240, &light) == 0);
  ImGui::EndFrame();
  CHECK(light.row(session.stage().subject().dim()) == -1);
}

TEST_CASE("another pair of the table begins at its first step, or shows its result where a result was shown") {
  for (const bool at_end : {false, true}) {
    CAPTURE(at_end);
    Bench bench(course_lesson("overlap-any", false),
                {.stage = {280, 0, 800, 600}, .timeline = {280, 600, 800, 100}, .inspector = {0, 0, 280, 700}});
    bench.session().jump(at_end ? bench.session().player().steps() : 2);
    const std::vector<DrawnWords> drawn = bench.drawn_words();
    const auto cell = std::find_if(drawn.begin(), drawn.end(),
                                   [](const DrawnWords& one) { return one.high.x <= 280 && one.words == "GJK"; });
    REQUIRE(cell != drawn.end());
    bench.press((cell->low.x + cell->high.x) / 2, (cell->low.y + cell->high.y) / 2);
    bench.release();
    CHECK(bench.session().stage().edited());
    CHECK(bench.session().player().method(0)->name == "gjk");
    CHECK(bench.session().player().step() == (at_end ? bench.session().player().steps() : 0));
  }
}

}  // namespace snug::app
