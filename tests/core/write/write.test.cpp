#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "lesson/beside.hpp"
#include "lesson/lesson.hpp"
#include "lesson/session.hpp"
#include "write/judge.hpp"
#include "write/shape.hpp"
#include "write/stage.hpp"

namespace snug {
namespace {

std::vector<write::Answered> right_answers(const write::Function& function, const std::vector<write::Case>& cases) {
  std::vector<write::Answered> answers;
  for (const write::Case& one : cases) answers.emplace_back(function.right(one.input));
  return answers;
}

}  // namespace

TEST_CASE("each function's cases have its shape, and the right answers earn every mark") {
  for (const write::Function* function : write::all_functions()) {
    CAPTURE(function->id);
    for (const std::uint64_t seed : {1u, 2u}) {
      const auto cases = write::cases_of(*function, seed);
      for (const write::Case& one : cases) {
        REQUIRE(write::fits(function->takes, one.input));
        REQUIRE(write::fits(function->gives, function->right(one.input)));
      }
      const auto judged = write::judge(*function, cases, right_answers(*function, cases));
      CHECK(judged.mark() == judged.of());
      CHECK(!judged.first);
      for (const auto& [kind, passed, of] : judged.kinds) CHECK(of >= write::kNamedCases);
    }
    CHECK(write::cases_of(*function, 1).front().input != write::cases_of(*function, 2).front().input);
  }
}

TEST_CASE("one answer for all cases earns nothing") {
  for (const write::Function* function : write::all_functions()) {
    if (function->gives != "b") continue;
    CAPTURE(function->id);
    const auto cases = write::cases_of(*function, 1);
    for (const double same : {0.0, 1.0})
      CHECK(write::judge(*function, cases, std::vector<write::Answered>(cases.size(), write::Numbers{same})).mark() ==
            0);
  }
}

TEST_CASE("an answer that is missing, thrown, of another shape or no number is wrong") {
  const write::Function& grow = *write::find_function("grow-sphere");
  const write::Numbers input{0, 0, 0, 1, 3, 0, 0};
  CHECK(write::is_right(grow, input, write::Numbers{1, 0, 0, 2}));
  CHECK_FALSE(write::is_right(grow, input, write::Numbers{1, 0, 0, 2 + 1e-9}));
  CHECK_FALSE(write::is_right(grow, input, write::Numbers{1, 0, 0}));
  CHECK_FALSE(write::is_right(grow, input, write::Numbers{1, 0, 0, std::numeric_limits<double>::quiet_NaN()}));
  const auto read = write::read_answers("1 0 0 2\n!it threw\nx\n\n", 5);
  CHECK(read[0] == write::Numbers{1, 0, 0, 2});
  CHECK(read[1].error() == "it threw");
  for (const std::size_t i : {2, 3, 4}) CHECK_FALSE(read[i]);
}

TEST_CASE("an input is written as JSON, also -0 and an empty list") {
  CHECK(write::json_of("{a:2n,b:*{c:i},d:b,e:one|two}", {-0.0, 1e-300, 1, 7, 1, 1}) ==
        R"({"a":[-0,1e-300],"b":[{"c":7}],"d":true,"e":"two"})");
  CHECK(write::json_of("{b:*3n,c:n}", {0, 4}) == R"({"b":[],"c":4})");
  CHECK_FALSE(write::fits("*n", {3, 1, 2}));
  CHECK_FALSE(write::fits("*n", {0.5, 1}));
  CHECK_FALSE(write::fits("one|two", {2}));
}

TEST_CASE("what is shorter is shorter, and valid") {
  for (const write::Function* function : write::all_functions()) {
    const auto cases = write::cases_of(*function, 1);
    for (std::size_t i = 0; i < cases.size(); i += 97)
      for (const write::Numbers& one : write::shorter(*function, cases[i].input)) {
        REQUIRE(write::fits(function->takes, one));
        REQUIRE((function->valid == nullptr || function->valid(one)));
        REQUIRE(write::json_of(function->takes, one).size() < write::json_of(function->takes, cases[i].input).size());
      }
  }
}

TEST_CASE("the first case of each kind opens on a stage, and so does what is shorter; with answers that are volumes") {
  const std::map<std::string_view, std::vector<std::string>> names{
      {"b", {}},
      {"inside|intersecting|outside", {}},
      {"33n", {"right", "yours"}},
      {"{distance:n,r_a:n,r_b:n}", {"right A", "right B", "your A", "your B"}},
      {"3n", {"right", "yours"}},
      {"{center:3n,radius:n}", {"right", "yours"}},
      {"{center:3n,half_extents:3n}", {"right", "yours"}},
      {"{p:3n,n:3n}", {"right p", "right n", "your p", "your n"}},
      {"i", {"right", "yours"}},
  };
  for (const write::Function* function : write::all_functions()) {
    const auto cases = write::cases_of(*function, 1);
    for (std::size_t kind = 0; kind < function->kinds.size(); ++kind) {
      CAPTURE(function->id);
      CAPTURE(function->kinds[kind].name);
      write::Numbers input = std::find_if(cases.begin(), cases.end(), [&](const write::Case& one) {
                               return one.kind == static_cast<int>(kind);
                             })->input;
      for (int round = 0; round < 3; ++round) {
        write::Numbers answer = function->right(input);
        const bool is_none = function->gives == "i" && answer.front() < 0;
        answer.front() += 1;
        const std::string text = write::lesson_of(*function, input, answer, "Right: 1\nYours: 2");
        CAPTURE(text);
        const auto read = lesson::read_lesson(text, "case.toml");
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message()));
        const auto opened = lesson::Session::open(*read);
        REQUIRE_MESSAGE(opened, (opened ? "" : opened.error().message()));
        std::vector<std::string> found;
        if (read->beside)
          for (const lesson::Beside& one : *read->beside)
            if (one.is != lesson::Beside::Is::kGiven) found.push_back(one.name);
        if (kind == 0 && !is_none) CHECK(found == names.at(function->gives));  // far away they may be too large
        const auto next = write::shorter(*function, input);
        if (next.empty()) break;
        input = next[next.size() / 2];
      }
    }
  }
}

TEST_CASE("what cannot be drawn of an answer is left out, and a box that is inside out is not") {
  const write::Function& rotated = *write::find_function("rotated-aabb");
  const write::Numbers input{0, 0, 0, 1, 2, 3, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const auto count = [&](const write::Answered& answer) {
    const auto read = lesson::read_lesson(write::lesson_of(rotated, input, answer, "Right: 1"), "case.toml");
    REQUIRE(read);
    return read->beside->size();
  };
  CHECK(count(write::Numbers{0, 0, 0, 1, -2, 3}) == 2);
  CHECK(count(write::Numbers{0, 0, 0, 1, std::numeric_limits<double>::quiet_NaN(), 3}) == 1);
  CHECK(count(tl::unexpected(std::string("it threw"))) == 1);
  const write::Function& farthest = *write::find_function("farthest-from-edge");
  const std::string text =
      write::lesson_of(farthest, {3, 0, 0, 4, 0, 1, 2, 0, 1}, write::Numbers{7}, "Right: 2\nYours: 7");
  CHECK(text.find("is = \"right\"\nname = \"right\"\nvolume = { sphere = { center = [1, 2], radius = 0 } }") !=
        std::string::npos);
  CHECK(text.find("\"yours\"") == std::string::npos);  // there is no such point
  const auto words = [&](const write::Answered& answer) {
    return write::words_of(farthest, {3, 0, 0, 4, 0, 1, 2, 0, 1}, answer);
  };
  CHECK(words(write::Numbers{0}) == "On the stage what is right has dashes or a ring; yours has dots or a cross.");
  CHECK(words(write::Numbers{7}) == "On the stage what is right has dashes or a ring; yours cannot be drawn.");
  CHECK(write::words_of(*write::find_function("overlap-spheres"), {0, 0, 0, 1, 3, 0, 0, 1}, write::Numbers{1}).empty());
}

/// What stands beside a case, of one kind.
std::vector<lesson::HeldVolume> beside_of(const write::Function& function, const write::Numbers& input,
                                          const write::Numbers& answer, lesson::Beside::Is is) {
  const auto read = lesson::read_lesson(write::lesson_of(function, input, answer, "Right: 1"), "case.toml");
  REQUIRE(read);
  std::vector<lesson::HeldVolume> found;
  for (const lesson::Beside& one : *read->beside)
    if (one.is == is) found.push_back(one.volume);
  return found;
}

TEST_CASE("a covariance is drawn as a box of its standard deviations around the mean, unless it is none") {
  const write::Function& function = *write::find_function("covariance");
  // Along x as far as 3, and along y as far as 1, from (5, 0, 7).
  const write::Numbers input{4, 8, 1, 7, 8, -1, 7, 2, 1, 7, 2, -1, 7};
  const auto yours = [&](const write::Numbers& answer) {
    return beside_of(function, input, answer, lesson::Beside::Is::kYours);
  };
  const write::Numbers right = function.right(input);
  const auto drawn = beside_of(function, input, right, lesson::Beside::Is::kRight);
  REQUIRE(drawn.size() == 1);
  const auto& box = std::get<Obb<double, 3>>(drawn.front().volume);
  CHECK((box.center - Vector<double, 3>(5, 0, 7)).norm() < 1e-12);
  const Vector<double, 3> reach = box.axes.cwiseAbs() * box.half_extents;
  CHECK((reach - Vector<double, 3>(3, 1, 0)).norm() < 1e-9);
  const auto none = yours({0, 0, 0, 0, 0, 0, 0, 0, 0});
  REQUIRE(none.size() == 1);
  CHECK(std::get<Sphere<double, 3>>(none.front().volume).radius == 0);
  const auto line = yours({0, 0, 0, 0, 4, 0, 0, 0, 0});
  REQUIRE(line.size() == 1);
  const auto& segment = std::get<Capsule<double, 3>>(line.front().volume);
  CHECK((segment.b - segment.a).cwiseAbs().isApprox(Vector<double, 3>(0, 4, 0)));
  const write::Numbers lopsided{9, 1, 0, 0, 1, 0, 0, 0, 0}, negative{-9, 0, 0, 0, 1, 0, 0, 0, 0};
  for (const write::Numbers& answer : {lopsided, negative}) {
    CHECK(yours(answer).empty());
    const std::string words = write::words_of(function, input, answer);
    CHECK(words.find("yours cannot be drawn: it is not symmetric, or a variance is negative.") != std::string::npos);
    CHECK(words.find("A matrix is drawn as a box around the mean") != std::string::npos);
  }
  CHECK(write::words_of(function, input, tl::unexpected(std::string("it threw"))).find("cannot be drawn. A matrix") !=
        std::string::npos);
}

TEST_CASE("a row's projections are drawn along the axis below the boxes, B where the distance puts it") {
  const write::Function& function = *write::find_function("sat-row");
  const write::Numbers input{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 3, 4,  // A
                             7, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1,  // B
                             1, 0, 0};
  const auto ends = [&](const write::Numbers& answer, lesson::Beside::Is is) {
    std::vector<std::array<double, 2>> all;
    for (const lesson::HeldVolume& held : beside_of(function, input, answer, is)) {
      const auto& segment = std::get<Capsule<double, 3>>(held.volume);
      CHECK(segment.radius == 0);
      CHECK(std::max(segment.a[1], segment.b[1]) < -3);
      all.push_back({segment.a[0], segment.b[0]});
    }
    return all;
  };
  using Ends = std::vector<std::array<double, 2>>;
  CHECK(ends({7, 2, 1}, lesson::Beside::Is::kRight) == Ends{{-2, 2}, {6, 8}});
  CHECK(ends({-7, 2, 0.5}, lesson::Beside::Is::kYours) == Ends{{-2, 2}, {-7.5, -6.5}});
  CHECK(write::words_of(function, input, write::Numbers{7, 2, 2}).find("projections of A and B") != std::string::npos);
}

TEST_CASE("functions have names of their own, and what they are judged by has a hash") {
  std::set<std::string_view> names;
  std::set<std::uint64_t> hashes;
  for (const write::Function* function : write::all_functions()) {
    CHECK(names.insert(function->id).second);
    CHECK(hashes.insert(write::hash_of(*function)).second);
    CHECK(write::find_function(function->id) == function);
  }
  CHECK(write::find_function("no-such-function") == nullptr);
}

}  // namespace snug
