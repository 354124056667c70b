// A handle has its name once on the stage, although a volume's centre can be selected.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "bench.hpp"
#include "course_lessons.hpp"

namespace snug::app {
namespace {

/// At how many places the name stands, alone or before a colon. A halo and its words are one.
std::size_t places_named(Bench& bench, const std::string& name) {
  std::vector<DrawnWords> drawn, found;
  bench.app.note_words(&drawn);
  bench.frames(1);
  bench.app.note_words(nullptr);
  for (const DrawnWords& one : drawn) {
    const auto same = [&](const DrawnWords& other) {
      return std::abs(one.low.x - other.low.x) < 5 && std::abs(one.low.y - other.low.y) < 5;
    };
    if (one.words != name && !one.words.starts_with(name + ":")) continue;
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(one);
  }
  return found.size();
}

}  // namespace

TEST_CASE("what the view writes beside a volume is not written again at its selected centre") {
  struct Named {
    const char *lesson, *name;
  };
  for (const auto& [id, name] :
       {Named{"obb-sat", "A"}, Named{"obb-sat", "B"}, Named{"frustum-point", "Point"}, Named{"frustum-2d", "Box"},
        Named{"frustum-2d", "Frustum"}, Named{"overlap-any", "A"}}) {
    CAPTURE(id);
    CAPTURE(name);
    Bench bench(course_lesson(id, false));
    for (const int step : {0, 1, 99}) {
      CAPTURE(step);
      bench.session().go(std::min(step, bench.session().player().steps()));
      bench.frames(2);
      CHECK(places_named(bench, name) == 1);
      for (Index i = 0; i < bench.session().stage().subject().size(); ++i)
        if (bench.session().stage().subject().name_of(i) == name) bench.app.select(i);
      bench.frames(2);
      CHECK(places_named(bench, name) == 1);
      bench.app.command("select_none");
    }
  }
}

TEST_CASE("the places of a query are named, however crowded the boxes are") {
  Bench bench(course_lesson("bvh-traverse", false));
  for (const char* const situation : {"", "outside", "misled"})
    for (const char* const way : {"point_query", "box_query", "ray_nearest", "ray_by_hand", "frustum_query"}) {
      CAPTURE(situation);
      CAPTURE(way);
      if (*situation != 0) REQUIRE(bench.session().stage().show_situation(situation).has_value());
      REQUIRE(bench.session().player().choose(0, way).has_value());
      for (const int step : {0, 3, 99}) {
        CAPTURE(step);
        bench.session().go(std::min(step, bench.session().player().steps()));
        bench.frames(2);
        CHECK(places_named(bench, "Q") == 1);
        if (std::string_view(way) != "point_query") CHECK(places_named(bench, "R") == 1);
      }
    }
}

TEST_CASE("a box of a tree is named beside its leaf, however many outlines surround it") {
  for (const char* const id : {"bvh-traverse", "bvh-merge"}) {
    CAPTURE(id);
    Bench bench(course_lesson(id, false));
    for (const int step : {0, 3, 99}) {
      CAPTURE(step);
      bench.session().go(std::min(step, bench.session().player().steps()));
      bench.frames(2);
      for (Index i = 0; i < bench.session().stage().subject().size(); ++i) {
        const std::string name = bench.session().stage().subject().name_of(i);
        CAPTURE(name);
        if (name != "Q" && name != "R") CHECK(places_named(bench, name) == 2);  // of the box and of the leaf
      }
    }
  }
}

}  // namespace snug::app
