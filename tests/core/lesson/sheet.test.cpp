// The lab sheets in lessons/labs: each is sound, and what is built for one is judged exactly.
#include <doctest/doctest.h>

#include "core/lesson/lesson_files.hpp"
#include "lesson/sheet.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

Sheet sheet_named(const std::string& id) {
  const SheetDraft draft = read_sheet(test::lessons_file("labs/" + id + ".toml"), id + ".toml");
  for (const FileError& mistake : draft.mistakes) FAIL(mistake.what);
  return draft.sheet;
}

std::string first_mistake(const std::string& toml) {
  const SheetDraft draft = read_sheet(toml, "x.toml");
  return draft.mistakes.empty() ? std::string() : draft.mistakes.front().what;
}

const std::string kSmall =
    "version = 2\ntitle = \"T\"\nsummary = \"S.\"\nminutes = 5\nalgorithms = [\"welzl\"]\n\n[points]\ngenerate = "
    "\"gaussian\"\ncount = 5\n\n[[section]]\ntitle = \"T\"\ntext = \"Text.\"\n";

}  // namespace

TEST_CASE("What a sheet asks for is read, and each says what to hand in") {
  const Sheet mesh = sheet_named("own-mesh"), even = sheet_named("break-even"), broken = sheet_named("break-float");
  CHECK(mesh.measured.size() == 2);
  CHECK(even.measured.size() == 1);
  CHECK(broken.lesson.tasks.size() == 1);
  for (const Sheet* const sheet : {&mesh, &even, &broken}) {
    CHECK(sheet->written.size() >= 3);
    CHECK(sheet->hash != 0);
    CHECK(is_sheet(test::lessons_file("labs/" + sheet->lesson.id + ".toml")));
  }
  CHECK_FALSE(is_sheet(test::lessons_file("sphere-ritter.toml")));
}

TEST_CASE("A table belongs to the part that names its points, or to the one that names none") {
  const Sheet mesh = sheet_named("own-mesh");
  CHECK(measurement_of(mesh, "costs", "teapot")->id == "teapot");
  CHECK(measurement_of(mesh, "costs", "chair.ply")->id == "own");
  CHECK(measurement_of(mesh, "growth", "teapot") == nullptr);
}

TEST_CASE("An example is judged anew: two points break the sphere in float, and others do not") {
  const Sheet sheet = sheet_named("break-float");
  CHECK(judge_built(sheet, 0, sheet.lesson.tasks[0].model)->met);
  const auto two = judge_built(sheet, 0, {{0, 0}, {1, 1}});
  REQUIRE(two);
  CHECK(two->met);
  CHECK_FALSE(judge_built(sheet, 0, {{0, 0}, {1, 0}})->met);
  CHECK_FALSE(judge_built(sheet, 1, {{0, 0}, {1, 1}}));
  CHECK_FALSE(judge_built(sheet, 0, {{0, 0, 0, 0}}));
}

TEST_CASE("Of two examples that with fewer points is smaller, and of as many that with the shorter numbers") {
  CHECK(is_smaller({{0, 0}, {1, 1}}, {{0, 0}, {1, 1}, {2, 2}}));
  CHECK(is_smaller({{0, 0}, {1, 1}}, {{0.5, 0}, {1, 1}}));
  CHECK_FALSE(is_smaller({{0, 0}, {1, 1}}, {{0, 0}, {1, 1}}));
}

TEST_CASE("What is wrong with a sheet's file is told") {
  CHECK(first_mistake(kSmall + "\n[[written]]\nid = \"a\"\nprompt = \"Why?\"\n").empty());
  CHECK(first_mistake(kSmall).find("nothing to hand in") != std::string::npos);
  CHECK(first_mistake(kSmall + "\n[[written]]\nid = \"a\"\n").find("prompt") != std::string::npos);
  CHECK(first_mistake(kSmall + "\n[[measured]]\nid = \"a\"\nprompt = \"P\"\ntable = \"cost\"\n").find("costs") !=
        std::string::npos);
  const std::string one = "\n[[written]]\nid = \"a\"\nprompt = \"Why?\"\n";
  CHECK(first_mistake(kSmall + one + one).find("two parts") != std::string::npos);
}
