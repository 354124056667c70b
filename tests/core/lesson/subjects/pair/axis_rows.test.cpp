// The formulas of the table of axes give the numbers that the test finds, and the lesson prints just these.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "core/lesson/lesson_files.hpp"
#include "lesson/subjects/pair/axis_rows.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

using namespace snug;

namespace {

struct Numbers {
  const Obb<double, 3>&a, &b;
  query::FramesRelated<double, 3> frames;
};

/// The number that a factor's letter and indices name.
double factor(char letter, const std::string& digits, const Numbers& numbers) {
  const int i = digits[0] - '1';
  if (letter == 'R') return numbers.frames.rotation(i, digits[1] - '1');
  return letter == 't' ? numbers.frames.translation[i] : (letter == 'a' ? numbers.a : numbers.b).half_extents[i];
}

/// The value of a sum of products, or of a radius, whose entries of R stand between bars.
double value(const std::string& formula, const Numbers& numbers, bool radius) {
  double sum = 0, product = 1, sign = 1;
  for (std::size_t k = 0; k < formula.size(); ++k) {
    const char c = formula[k];
    if (c == '+' || c == '-') sum += sign * product, product = 1, sign = c == '+' ? 1 : -1;
    if (c != 'R' && c != 't' && c != 'a' && c != 'b') continue;
    const double one = factor(c, formula.substr(c == 'R' ? k + 3 : k + 2, 2), numbers);
    product *= radius ? std::abs(one) : one;
  }
  return radius ? sum + sign * product : std::abs(sum + sign * product);
}

}  // namespace

TEST_CASE("each row's formulas give its distance and radii") {
  for (const int dim : {2, 3}) {
    lesson::BoxPair like{.dim = dim};
    for (auto& box : like.boxes) box.half_extents = {0.7, 0.4, dim == 3 ? 0.9 : 0.0};
    for (int seed = 1; seed <= 20; ++seed) {
      const lesson::BoxPair pair = lesson::scattered(like, seed);
      const lesson::PairTrace trace = lesson::record("sat_all", pair);
      const Numbers numbers{pair.boxes[0], pair.boxes[1],
                            std::get<query::FramesRelated<double, 3>>(trace.front().step.fact)};
      const auto rows = lesson::axes_seen(trace);
      REQUIRE(rows.size() == lesson::axis_names(dim).size());
      for (const auto& row : rows) {
        const lesson::RowFormulas formulas = lesson::row_formulas(dim, lesson::axis_index(dim, row.axis));
        CHECK(value(formulas.distance, numbers, false) == doctest::Approx(row.distance * row.length));
        CHECK(value(formulas.radius_a, numbers, true) == doctest::Approx(row.radius_a * row.length));
        CHECK(value(formulas.radius_b, numbers, true) == doctest::Approx(row.radius_b * row.length));
      }
    }
  }
}

TEST_CASE("the entries of a row are those in its formulas") {
  for (const int dim : {2, 3})
    for (int row = 0; row < static_cast<int>(lesson::axis_names(dim).size()); ++row) {
      const lesson::RowFormulas formulas = lesson::row_formulas(dim, row);
      const std::string all = formulas.distance + formulas.radius_a + formulas.radius_b;
      const lesson::RowEntries entries = lesson::row_entries(dim, row);
      const auto has = [&](const std::string& name) { return all.find(name) != std::string::npos; };
      for (int i = 0; i < 3; ++i) {
        const std::string index = std::to_string(i + 1);
        CHECK(has("t_" + index) == ((entries.translation >> i & 1) != 0));
        CHECK(has("a_" + index) == ((entries.half_a >> i & 1) != 0));
        CHECK(has("b_" + index) == ((entries.half_b >> i & 1) != 0));
        for (int j = 0; j < 3; ++j)
          CHECK(has("R_{" + index + std::to_string(j + 1) + "}") == ((entries.rotation >> (3 * i + j) & 1) != 0));
      }
    }
}

TEST_CASE("the lesson on the fifteen axes prints each row's formulas, but for the radius that it asks for") {
  const std::string text = test::lessons_file("obb-axes.toml");
  for (int row = 0; row < 15; ++row) {
    const std::string name = lesson::axis_names(3)[row].text;
    const lesson::RowFormulas formulas = lesson::row_formulas(3, row);
    const std::string radius_b = name == "A y × B z" ? "…" : "$" + formulas.radius_b + "$";
    const std::string line = "| [" + name + "](mark:" + name + ") | $" + formulas.distance + "$ > $" +
                             formulas.radius_a + "$ + " + radius_b + " |";
    CHECK_MESSAGE(text.find(line) != std::string::npos, line);
  }
}
