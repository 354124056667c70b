// [view] of a lesson's file: what it says, what is wrong with it, and how its names and decimals are used everywhere.
#include "lesson/read_view.hpp"

#include <algorithm>

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/figures.hpp"
#include "lesson/speaking.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::small_lesson_with;

namespace {

std::string with_view(const std::string& keys) {
  return small_lesson_with("[[section]]", "[view]\n" + keys + "\n[[section]]");
}

/// The first mistake, as "line: what", lines counted from that of [view].
std::string mistake(const std::string& keys) {
  const std::string text = with_view(keys);
  const auto draft = check::checked_draft(text, "small.toml");
  if (draft.mistakes.empty()) return "none";
  const auto before = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("[view]")), '\n');
  const FileError& first = draft.mistakes.front();
  return std::to_string(first.place.line - static_cast<int>(before) - 1) + ": " + first.what;
}

Session boxes(const std::string& centers, const std::string& view = "") {
  return test::open(R"(version = 2
title = "Boxes"
summary = "A lesson for tests."
minutes = 1
volume = "box_pair"
algorithms = ["sat"]
[boxes]
center = )" + centers +
                    R"(
half_extents = [[1, 0.5], [1, 0.5]]
turn = [[0], [0]]
)" + view + R"(
[[section]]
title = "First"
text = "A **term**."
)");
}

}  // namespace

TEST_CASE("a lesson's file says how the stage shows it") {
  const auto lesson =
      check::checked_lesson(with_view("zoom = 2.5\nlook_at = [1, -0.5]\nnames = [\"Anna\", \"Ben\"]\noutline = true\n"
                                      "decimals = 2\npoint_size = 1.5\ninset = { at = \"Ben\", size = 0.2 }"),
                            "small.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  const StageView& view = lesson->view;
  CHECK(view.zoom == 2.5);
  REQUIRE(view.look_at);
  CHECK(view.look_at->at == Vector<double, 3>(1, -0.5, 0));
  CHECK(view.names == std::vector<std::string>{"Anna", "Ben"});
  CHECK(view.named);
  CHECK(view.outline);
  CHECK(view.decimals == 2);
  CHECK(view.point_size == 1.5);
  REQUIRE(view.inset);
  CHECK(view.inset->at.handle == "Ben");
  CHECK(view.inset->size == 0.2);
  CHECK_FALSE(check::checked_lesson(with_view("names = \"none\""), "small.toml")->view.named);
}

TEST_CASE("what is wrong with it is told with its place and, where there is one, the name that is meant") {
  CHECK(mistake("zoom = 2") == "none");
  CHECK(mistake("zom = 2") == "1: [view] has no key \"zom\": did you mean \"zoom\"?");
  CHECK(mistake("zoom = 0") == "1: \"zoom\" must be above 0 and at most 1000");
  CHECK(mistake("outline = true\ncamera = [30, 10]") == "2: \"camera\" is for lessons in space");
  CHECK(mistake("camera = [30, 95]").find("from -85 to 85") != std::string::npos);
  CHECK(mistake("look_at = [1, 2, 3]") == "1: \"look_at\" must have 2 coordinates");
  CHECK(mistake("look_at = [1]").find("coordinates: [x, y]") != std::string::npos);
  CHECK(mistake("look_at = \"P7\"") == "1: \"look_at\" names no handle: P7; the last one is P5");
  CHECK(mistake("look_at = \"gap\"").find("and there are none") != std::string::npos);
  CHECK(mistake("inset = { at = \"P3\" }").find("lacks the key \"size\"") != std::string::npos);
  CHECK(mistake("inset = { at = \"P33\", size = 1 }") == "1: \"at\" names no handle: P33; did you mean P3?");
  CHECK(mistake("inset = { at = \"P3\", size = -1 }").find("\"size\" must be above 0") != std::string::npos);
  CHECK(mistake("inset = { at = \"P3\", sise = 1 }").find("did you mean \"size\"?") != std::string::npos);
  CHECK(mistake("inset = 3").find("must be a table") != std::string::npos);
  CHECK(mistake("names = \"nobody\"").find("a list of names, or \"none\"") != std::string::npos);
  CHECK(mistake("names = [\"A\", \"a\"]") == "1: \"names\" has a name twice: a");
  CHECK(mistake("names = [\"P3\"]") == "1: \"names\" has a name that another point has: P3");
  CHECK(mistake("names = [\"A/B\"]").find("no name may have: A/B") != std::string::npos);
  CHECK(mistake("names = [\"gap\"]").find("means something else") != std::string::npos);
  CHECK(mistake("names = [\"Bartholomew the Great\"]").find("longer than 12") != std::string::npos);
  CHECK(mistake("names = [\"A\", \"B\", \"C\", \"D\", \"E\", \"F\", \"G\"]") ==
        "1: \"names\" are 7, and there are only 6 points");
  CHECK(mistake("decimals = 10") == "1: \"decimals\" must be from 0 to 9");
}

TEST_CASE("points have their names in sentences, choices, typed answers and links") {
  Session session = test::open(with_view("names = [\"Anna\", \"Ben\", \"Cleo\"]"));
  session.go(1);
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().give(test::choice(0)));
  CHECK(session.telling().caption().find("Anna and Ben, the extremes along x") != std::string::npos);
  CHECK(session.conversation().outcome()->says.find("Anna and Ben") != std::string::npos);
  session.conversation().acknowledge();
  session.go(2);
  CHECK(session.conversation().target_names() == std::vector<std::string>{"Anna", "Ben", "Cleo", "P3", "P4", "P5"});
  CHECK_FALSE(session.conversation().pick("P0"));
  CHECK(session.conversation().pick("ben"));
  CHECK(handle_named(session.stage().subject(), "Cleo") == Index{2});
  CHECK_FALSE(handle_named(session.stage().subject(), "P2"));
  REQUIRE(session.stage().remove(0));  // the others keep theirs
  CHECK(session.stage().subject().name_of(0) == "Ben");
  CHECK(session.stage().subject().name_of(2) == "P2");
  session.stage().undo();
  CHECK(session.stage().subject().name_of(0) == "Anna");
}

TEST_CASE("lengths have the decimals that the file asks for, and none is written as 0 that is not") {
  const auto radius = [](const std::string& keys) {
    Session session = test::open(keys.empty() ? std::string(test::kSmallLesson) : with_view(keys));
    session.jump(session.player().steps());
    for (const Figure& figure : session.telling().figures())
      if (figure.key == "radius") return figure.text;
    return std::string();
  };
  CHECK(radius("") == "2.250 units");
  CHECK(radius("decimals = 1") == "2.2 units");
  CHECK(radius("decimals = 5") == "2.25000 units");
  CHECK(radius("decimals = 0") == "2 units");
  const WithDecimals two(2);
  CHECK(number_text(-0.0) == "0.00");
  CHECK(number_text(-0.25) == "−0.25");
  CHECK(number_text(0.0004) == "4.000 × 10⁻⁴");
  {
    const WithDecimals none(std::nullopt);
    CHECK(number_text(0.25) == "0.250");
  }
  CHECK(number_text(0.25) == "0.25");
}

TEST_CASE(
    "a plain number has no zeros behind its digits, before a power of ten either, and keeps those of a whole part") {
  CHECK(plain_number(0.25) == "0.25");
  CHECK(plain_number(2.00001) == "2");
  CHECK(plain_number(1200.3) == "1,200");
  CHECK(plain_number(1e-6) == "10⁻⁶");
  CHECK(plain_number(-1e-6) == "−10⁻⁶");
  CHECK(plain_number(-2.5e-12) == "−2.5 × 10⁻¹²");
  CHECK(plain_number(3.16e-5) == "3.16 × 10⁻⁵");
}

TEST_CASE("a gap is written with two digits, and the lengths around it with decimals that show it") {
  CHECK(gap_text(0.1234) == "0.123");
  CHECK(gap_text(0.0034) == "0.0034");
  CHECK(gap_text(-0.00034) == "−0.00034");
  CHECK(gap_text(3e-7) == "3.000 × 10⁻⁷");
  CHECK(gap_text(-0.0) == "0.000");
  CHECK(decimal_text(-0.0001, 2) == "0.00");
  CHECK(decimals_showing(0.5) == 2);
  CHECK(decimals_showing(0.003) == 4);
  CHECK(decimals_showing(0.0003) == 5);
  CHECK(decimals_showing(0) == 0);
  CHECK(length_text(2.3003, decimals_showing(0.003)) == "2.3003");
  CHECK(length_text(2.3003, decimals_showing(0.5)) == "2.300");
  CHECK(length_text(0.0075, decimals_showing(0.5)) == "0.0075");
  CHECK(length_text(2e9, decimals_showing(0.003)) == "2.000 × 10⁹");
}

TEST_CASE("the sentence about an axis shows the gap in its numbers, as the figures do") {
  Session session = boxes("[[-1, 0], [1.0003, 0]]");
  session.jump(2);
  CHECK(session.telling().caption().find(
            "the distance 2.00030 is greater than r_A\u00a0+\u00a0r_B = 1.00000 + 1.00000") != std::string::npos);
  for (const Figure& figure : session.telling().figures()) {
    if (figure.key == "distance") CHECK(figure.text == "2.00030 units");
    if (figure.key == "gap") CHECK(figure.text == "0.00030 units");
  }
}

TEST_CASE("the gap between two boxes is where they are nearest, and where they would touch") {
  const auto gap = [](const std::string& centers) { return *boxes(centers).stage().subject().with_volumes()->gap(); };
  const auto apart = gap("[[-1, 0], [1.003, 0]]");
  CHECK(apart[0][0] == doctest::Approx(0));
  CHECK(apart[1][0] == doctest::Approx(0.003));
  CHECK(std::abs(apart[0][1] - apart[1][1]) < 1e-9);
  const auto inside = gap("[[-1, 0], [0.99, 0]]");  // overlapping by 0.01
  CHECK(inside[0][0] == doctest::Approx(0));
  CHECK(inside[1][0] == doctest::Approx(-0.01));
  const auto same = gap("[[0, 0], [0, 0]]");  // moved out along x
  CHECK((same[1] - same[0]).norm() == doctest::Approx(2));
}
