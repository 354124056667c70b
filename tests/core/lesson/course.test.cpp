#include "lesson/course.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kCourse = R"(version = 1

[[chapter]]
title = "Spheres"
lessons = [
  "ritter",
  "welzl",
]

[[chapter]]
title = "Boxes"
lessons = ["sat"]

[[idea]]
id = "a.radius"
slide = "Spheres"

[[idea]]
id = "a.support"
slide = "Spheres"

[[idea]]
id = "b"
slide = "Boxes"
)";

const std::array<std::string, 3> kIds{"ritter", "sat", "welzl"};

std::string with(std::string_view from, std::string_view to) {
  std::string text(kCourse);
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

struct BrokenCourse {
  std::string_view from, to;
  std::int64_t line;
  std::string_view says;
};

constexpr BrokenCourse kBrokenCourses[] = {
    {"version = 1", "version = = 1", 1, ""},
    {"version = 1", "version = 2", 1, "reads 1"},
    {"\"welzl\"", "\"wezl\"", 7, "no lesson \"wezl\""},
    {"\"welzl\"", "\"ritter\"", 7, "\"ritter\" is listed twice: in line 6 as well"},
    {"\"sat\"", "\"ritter\"", 12, "\"ritter\" is listed twice: in line 6 as well"},
    {"  \"welzl\",\n", "", 9, "\"welzl\" is in no chapter"},
    {"id = \"a.support\"", "id = \"a.radius\"", 19, "of an idea above: a.radius"},
    {"id = \"b\"\n", "", 22, "lacks the key \"id\""},
    {"[\"sat\"]", "[]", 12, "at least 1"},
    {"[\"sat\"]", "[3]", 12, "list of texts"},
    {"title = \"Boxes\"\n", "", 10, "lacks the key \"title\""},
    {"title = \"Boxes\"", "title = \"Boxes\"\nminutes = 3", 12, "no key \"minutes\""},
    {"version = 1", "version = 1\norder = 2", 2, "no key \"order\""},
};

}  // namespace

TEST_CASE("a course has its chapters and lessons in order") {
  const auto course = read_course(kCourse, "course.toml", kIds);
  REQUIRE_MESSAGE(course.has_value(), (course ? "" : course.error().message()));
  REQUIRE(course->chapters.size() == 2);
  CHECK(course->chapters[0].title == "Spheres");
  CHECK(course->chapters[0].lessons == std::vector<std::string>{"ritter", "welzl"});
  CHECK(course->chapters[1].lessons == std::vector<std::string>{"sat"});
  REQUIRE(course->ideas.size() == 3);
  CHECK(course->ideas[1].id == "a.support");
  CHECK(slides_of(*course, std::array<std::string, 3>{"b", "a.support", "a.radius"}) ==
        std::vector<std::string>{"Spheres", "Boxes"});
}

TEST_CASE("a course that is wrong is refused with its line") {
  for (const BrokenCourse& broken : kBrokenCourses) {
    CAPTURE(broken.to);
    const auto course = read_course(with(broken.from, broken.to), "folder/course.toml", kIds);
    REQUIRE_FALSE(course.has_value());
    CHECK(course.error().file == "folder/course.toml");
    CHECK(course.error().position == broken.line);
    CHECK_MESSAGE(course.error().what.find(broken.says) != std::string::npos, course.error().what);
  }
  CHECK_FALSE(read_course("version = 1\n", "course.toml", {}).has_value());
}
