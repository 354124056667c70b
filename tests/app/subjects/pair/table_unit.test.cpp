// Lengths in the tables of two boxes have a power of ten for a unit where the boxes are large or small, so that columns
// do not run into each other.
#include "app/subjects/pair/table_unit.hpp"

#include <algorithm>
#include <string>

#include "../../bench.hpp"
#include "core/lesson/lesson_files.hpp"

namespace snug::app {

TEST_CASE("the unit is the power of ten below the size of boxes that are large or small") {
  lesson::BoxPair pair{.dim = 3};
  const auto unit_at = [&](double size) {
    for (auto& box : pair.boxes) box.half_extents = Vector<double, 3>::Constant(size);
    return table_unit(pair);
  };
  CHECK(unit_at(1).words() == "units");
  CHECK(unit_at(9999).power == 0);
  CHECK(unit_at(1.5e6).words() == "10⁶ units");
  CHECK(unit_at(1.5e6).in(3e6) == doctest::Approx(3));
  CHECK(unit_at(2e-6).words() == "10⁻⁶ units");
  CHECK(unit_at(0).power == 0);
}

TEST_CASE("no two numbers in a row of the tables overlap, however large or small the boxes are") {
  for (const char* situation : {"own", "large", "small"}) {
    CAPTURE(situation);
    lesson::Lesson lesson = test::lesson_of("epsilons");
    lesson.questions.clear();
    Bench bench(std::move(lesson),
                {.stage = {0, 0, 800, 600}, .timeline = {0, 600, 800, 100}, .inspector = {800, 0, 280, 900}});
    REQUIRE(bench.session().show_situation(situation).has_value());
    REQUIRE(bench.session().choose(0, "no_epsilon_float").has_value());
    bench.session().jump(bench.session().steps());
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.frames(2);
    int numbers = 0;
    for (const DrawnWords& one : drawn)
      for (const DrawnWords& other : drawn) {
        const bool both = one.low.x >= 800 && other.low.x > one.low.x && one.words.find_first_of("0123456789") < 3 &&
                          other.words.find_first_of("0123456789") < 3;
        if (!both || std::abs(one.low.y - other.low.y) > 2) continue;
        ++numbers;
        CHECK_MESSAGE(one.high.x <= other.low.x, one.words << " " << other.words);
      }
    CHECK(numbers > 30);
  }
}

}  // namespace snug::app
