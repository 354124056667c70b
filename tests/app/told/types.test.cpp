// The types that the page is written against are those of what it is told: web/page/told.d.ts is made here.
#include "types.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <type_traits>

#include "../bench.hpp"
#include "../course_lessons.hpp"
#include "app/told/door.hpp"
#include "app/told/lesson.hpp"
#include "app/told/shared_words.hpp"
#include "app/told/view.hpp"

namespace snug::app::told {
namespace {

constexpr std::string_view kHead = "// What the program tells the page, made from app/told by "
                                   "tests/app/told/types.test.cpp, which says how to make it\n"
                                   "// anew. No browser loads this, and the site is built without it.\n\n";

std::string all_types(App& app) {
  Types types;
  types.add(std::string(kHead));
  std::string parts;
  see_parts(app, [&](From, const auto& part) {
    using Part = decltype(part());
    types.declare<Part>();
    parts += (parts.empty() ? "" : ", ") + name_of_type<Part>();
  });
  types.add("/** What changes while a lesson is open. */\ninterface View extends\n  " + parts + " {}\n\n");
  types.declare<Lesson>();
  types.declare<Attempt>();
  types.declare<Handle>();
  types.declare<Point>();
  types.declare<LessonRead>();
  types.declare<PlaceNow>();
  types.declare<PlaceRead>();
  types.declare<WayGone>();
  types.declare<CoverFile>();
  types.add("type SharedWords = Record<\n");
  for (const auto& [name, word] : kSharedWords) types.add("  | \"" + std::string(name) + "\"\n");
  types.add("  , string>;\n");
  return types.text();
}

TEST_CASE("the page's types are those of what it is told") {
  Bench bench(course_lesson("sphere-ritter"));
  const std::string types = all_types(bench.app), path = lessons_folder() + "../web/page/told.d.ts";
  if (std::getenv("SNUG_WRITE_TYPES") != nullptr) std::ofstream(path, std::ios::binary) << types;
  std::ifstream file(path, std::ios::binary);
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  CHECK_MESSAGE(written == types, "web/page/told.d.ts is stale: SNUG_WRITE_TYPES=1 build/release/tests/snug_app_tests "
                                  "--source-file='*told/types*' writes it anew");
}

}  // namespace
}  // namespace snug::app::told
