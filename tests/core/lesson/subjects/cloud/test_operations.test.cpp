// What the overlap test of a fitted volume takes, as a figure, and a task that is graded by it.
#include <doctest/doctest.h>

#include <string>

#include "core/lesson/lesson_files.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

Session opened_fit() {
  auto session = Session::open(test::lesson_of("swept-fit"));
  REQUIRE(session.has_value());
  return *std::move(session);
}

double operations_of(const Session& session, std::string_view algorithm) {
  for (const Figure& figure : session.player().result(*find_method(session.lesson(), algorithm)))
    if (figure.key == "test_operations") return figure.value;
  return -1;
}

}  // namespace

TEST_CASE("two capsules take one distance, and two boxes up to fifteen axes") {
  Session session = opened_fit();
  REQUIRE(session.stage().show_situation("plate").has_value());
  CHECK(operations_of(session, "capsule/pca") == 1);
  CHECK(operations_of(session, "sphere/welzl") == 1);
  CHECK(operations_of(session, "lozenge/pca") > 1);
  CHECK(operations_of(session, "obb/exact") > operations_of(session, "lozenge/pca"));
  CHECK(operations_of(session, "obb/exact") > 15);
}

TEST_CASE("of a body that is too short the task names the figure that falls short, and no other") {
  Session session = opened_fit();
  const std::size_t task = session.lesson().tasks.size() - 1;
  const auto solved = session.solve_task(task, session.lesson().tasks[task].model);
  REQUIRE(solved.has_value());
  CHECK_MESSAGE(solved->done, solved->says);
  // The same body, shorter.
  REQUIRE(session.stage()
              .set_rows({{-0.43, -0.47, 0.07},
                         {-0.06, -0.59, -0.24},
                         {0.11, -0.26, -0.58},
                         {-0.1, 0.2, -0.6},
                         {-0.47, 0.32, -0.29},
                         {-0.64, -0.01, 0.04},
                         {-0.6, -0.3, -0.6},
                         {0.43, 0.47, -0.07},
                         {0.06, 0.59, 0.24},
                         {-0.11, 0.26, 0.58},
                         {0.1, -0.2, 0.6},
                         {0.47, -0.32, 0.29},
                         {0.64, 0.01, -0.04},
                         {0.6, 0.3, 0.6}})
              .has_value());
  const Grade shorter = session.grade(task);
  CHECK_FALSE(shorter.done);
  CHECK(shorter.says.find("Operations of a test (") != std::string::npos);
  CHECK(shorter.says.find("it must be at least 200 %") != std::string::npos);
  CHECK(shorter.says.find("it must be at least 20 operations") == std::string::npos);
  CHECK(shorter.says.find("it must be at least 0") == std::string::npos);
}
