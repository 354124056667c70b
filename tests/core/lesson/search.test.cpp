#include "lesson/search.hpp"

#include <doctest/doctest.h>

using namespace snug::lesson;

namespace {

Lesson a_lesson() {
  Lesson lesson;
  lesson.title = "Welzl's algorithm";
  lesson.summary = "Three points fix the circle.";
  lesson.algorithms = {"brute_force"};
  const Paragraph words{{.text = "plain "}, {.text = "support set", .strong = true}};
  lesson.sections = {{.title = "The list", .blocks = {{.rows = {{words}}}}}};
  return lesson;
}

}  // namespace

TEST_CASE("a lesson is found by all that a reader may know of it, however it is written") {
  const std::string text =
      search_text(a_lesson(), 3, "Bounding spheres", std::vector<std::string>{"Gärtner’s Miniball"});
  for (const char* asked : {"welzls", "WELZL’s", "three points", "spheres, list", "gartner", "Gärtners", "brute force",
                            "support", "mini", "3", "  "})
    CHECK_MESSAGE(is_found(text, asked), asked);
  for (const char* asked : {"plain", "lecture", "welzl pca", "zzz"}) CHECK_FALSE_MESSAGE(is_found(text, asked), asked);
}

TEST_CASE("nothing but blanks asks for nothing") {
  CHECK_FALSE(is_search(" , "));
  CHECK(is_search(" a "));
}

TEST_CASE("what is found is counted, and what is not is said again, shortened between letters") {
  CHECK(found_text({1}, "x") == "1 lesson");
  CHECK(found_text({13, 1, 2}, "x") == "13 lessons, 1 lab sheet, 2 exercises");
  CHECK(found_text({0, 0, 1}, "x") == "1 exercise");
  CHECK(found_text({}, " zzz ") == "No lesson or exercise has “zzz”.");
  std::string accents;
  for (int i = 0; i < 20; ++i) accents += "é";
  CHECK(found_text({}, accents) == "No lesson or exercise has “" + accents + "”.");  // forty bytes
  CHECK(found_text({}, "x" + accents) == "No lesson or exercise has “x" + accents.substr(0, 38) + "”.");
}
