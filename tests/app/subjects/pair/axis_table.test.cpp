// The table of axes in a panel that is too low for it.
#include "../../bench.hpp"
#include "../../course_lessons.hpp"

namespace snug::app {

TEST_CASE("the panel scrolls to the row of the step, and a frame is due for it") {
  const Rect panel{628, 0, 280, 752};
  Bench bench(course_lesson("vanishing-axes", false),
              {.stage = {0, 0, 628, 616}, .timeline = {0, 616, 628, 136}, .inspector = panel});
  ImGui::GetIO().DisplaySize = {panel.x + panel.width, panel.y + panel.height};
  const auto row_ends = [&](std::string_view name) {
    for (int i = 0; i < 20 && bench.app.wants_frame(0); ++i) bench.frames(1);
    const std::vector<DrawnWords> drawn = bench.drawn_words();
    float end = 1e9f;  // of the row's name at the panel's left, the lowest
    for (const DrawnWords& one : drawn)
      if (one.words == name && one.low.x >= panel.x && one.low.x < panel.x + 60) end = one.high.y;
    return end;
  };
  bench.session().jump(16);
  CHECK(row_ends("A z × B z") < panel.height);
  bench.session().jump(2);
  const float first = row_ends("A x");
  CHECK(first > 0);
  CHECK(first < panel.height);
}

}  // namespace snug::app
