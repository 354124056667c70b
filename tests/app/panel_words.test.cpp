// What the panels beside the stage draw is told in words as well, and is worked out where nothing can be drawn.
#include "app/panel_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "bench.hpp"
#include "course_lessons.hpp"

namespace snug::app {
namespace {

const Layout kBesideNumbers{{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 300, 4000}, false, 88};

/// A lesson of the course without its questions, at the end of a method's run.
struct AtItsEnd {
  Bench bench;

  AtItsEnd(const std::string& id, const std::string& situation, const std::string& method)
      : bench(course_lesson(id, false), kBesideNumbers) {
    REQUIRE(bench.session().stage().show_situation(situation).has_value());
    REQUIRE(bench.session().player().choose(0, method).has_value());
    bench.session().jump(bench.session().player().steps());
  }
  /// Whether every cell of the panels' tables was drawn, and the words of their buttons.
  void check_drawn() {
    bench.frames(20);
    const std::vector<std::string> drawn = bench.words();
    const auto check = [&](const std::string& words) {
      CAPTURE(words);
      CHECK(std::find(drawn.begin(), drawn.end(), words) != drawn.end());
    };
    for (const PanelWords& panel : bench.app.panel_words()) {
      check(panel.table.title);
      if (panel.button) check(panel.button->words);
      for (const auto& row : panel.table.rows)
        for (const std::string& cell : row)
          if (!cell.empty()) check(cell);
    }
  }
};

}  // namespace

TEST_CASE("what the trees of many boxes cost is told as it is drawn, once a run is at its end") {
  AtItsEnd tree("bvh-build", "own", "insertion");
  REQUIRE(tree.bench.app.panel_words().size() == 1);
  tree.check_drawn();
  const WordTable table = tree.bench.app.panel_words()[0].table;
  REQUIRE(table.rows.size() == 4);
  CHECK(table.rows[3][0] == "Insertion");
  CHECK_FALSE(table.rows[3][1].empty());
  CHECK(table.rows[0][1].empty());  // its run was not at its end
  tree.bench.session().go(1);
  CHECK(tree.bench.app.panel_words().empty());
}

TEST_CASE("the numbers of all six planes are told as they are drawn, and follow the point") {
  AtItsEnd point("frustum-point", "space", "half_spaces");
  point.check_drawn();
  const auto numbers = [&] { return point.bench.app.panel_words()[0].table.rows; };
  REQUIRE(numbers().size() == 6);
  CHECK(numbers()[0][0] == "Left");
  const auto before = numbers();
  REQUIRE(point.bench.session().stage().move(0, lesson::Point3(9, 9, 9)).has_value());
  CHECK(numbers() != before);
  point.check_drawn();
}

TEST_CASE("R, t and the half extents of two boxes are told as they are drawn, from the step on that computes them") {
  AtItsEnd boxes("obb-sat", "own", "sat");
  boxes.check_drawn();
  const auto numbers = [&] { return boxes.bench.app.panel_words()[0].table.rows; };
  const auto after = numbers();
  REQUIRE(after.size() == 3);
  CHECK(after[0][0] == "A x");
  CHECK(after[2][0] == "b");
  boxes.bench.session().go(0);
  const auto before = numbers();
  CHECK(before[0][1] == "—");
  CHECK(before[0][3] == "—");
  CHECK(before[0][4] == after[0][4]);  // the half extents are given
  CHECK(before[2] == after[2]);
}

TEST_CASE("a million spheres are counted where nothing is drawn, and then told as they are drawn") {
  AtItsEnd sphere("frustum-sphere", "edge", "grown_planes");
  const auto panel = [&] { return sphere.bench.app.panel_words()[1]; };
  REQUIRE(panel().button.has_value());
  CHECK(panel().button->enabled);
  CHECK(panel().table.rows.empty());
  CHECK_FALSE(sphere.bench.app.command("measure_pairs"));
  REQUIRE(sphere.bench.app.command(panel().button->command));
  CHECK_FALSE(sphere.bench.app.command(panel().button->command));  // it is started already
  CHECK(sphere.bench.app.seconds_until_unseen(0) > 0);
  sphere.bench.app.advance_unseen(0);  // without a clock it is done at once
  CHECK(panel().button->words == "Tested: 1,000,000 random spheres");
  CHECK(panel().table.rows.size() == 4);
  sphere.check_drawn();
}

TEST_CASE("a plane's number that a later step is asked for is not told in words either") {
  Bench bench(course_lesson("frustum-point"), kBesideNumbers);
  REQUIRE(bench.session().telling().is_hidden("distance"));
  bench.session().go(0);
  while (bench.session().conversation().asked() != nullptr) {
    REQUIRE(bench.session().conversation().give({}, false));
    bench.session().conversation().acknowledge();
  }
  const std::vector<PanelWords> panels = bench.app.panel_words();
  REQUIRE(panels.size() == 1);
  CHECK(bench.session().telling().is_hidden("distance"));
  const auto& rows = panels[0].table.rows;
  REQUIRE(rows.size() > 1);
  CHECK(rows[0][1] != "—");  // the plane whose question was skipped
  for (std::size_t i = 1; i < rows.size(); ++i) CHECK(rows[i][1] == "—");
}

}  // namespace snug::app
