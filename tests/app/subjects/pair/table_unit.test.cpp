// Lengths in the tables of two boxes have a power of ten for a unit where the boxes are large or small, so that columns
// do not run into each other.
#include "app/subjects/pair/table_unit.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../../bench.hpp"
#include "../../viewed_lessons.hpp"

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
  for (const char* zeros : {"", "e6", "e-6"}) {
    CAPTURE(zeros);
    const std::string e = zeros;
    lesson::Lesson boxes =
        test::viewed("volume = \"box_pair\"\nalgorithms = [\"no_epsilon_float\"]",
                     "[boxes]\ndim = 3\ncenter = [[0.0, 0.0, 0.0], [0.98" + e + ", 0.7" + e + ", 0.21" + e +
                         "]]\nhalf_extents = [[0.3" + e + ", 0.6" + e + ", 1.0" + e + "], [0.3" + e + ", 0.5" + e +
                         ", 0.9" + e + "]]\nturn = [[17, -13, -29], [17, -13, -28.9999427042204869]]");
    Bench bench(std::move(boxes),
                {.stage = {0, 0, 800, 600}, .timeline = {0, 600, 800, 100}, .inspector = {800, 0, 280, 900}});
    bench.session().jump(bench.session().player().steps());
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

TEST_CASE("the axes of two volumes have the stage's unit") {
  const auto box = [](const char* center) {
    return std::string("{ obb = { center = ") + center + ", half_extents = [1.0, 0.5], turn = 20 } }";
  };
  Bench bench(test::viewed("volume = \"volume_pair\"\nalgorithms = [\"separating_axes\"]",
                           "[volumes]\ndim = 2\na = " + box("[0.0, 0.0]") + "\nb = " + box("[3.0, 0.5]")),
              {.stage = {0, 0, 800, 600}, .timeline = {0, 600, 800, 100}, .inspector = {800, 0, 280, 900}});
  bench.session().jump(bench.session().player().steps());
  const std::vector<std::string> words = bench.words();
  CHECK(std::find(words.begin(), words.end(), "The axes") != words.end());
}

}  // namespace snug::app
