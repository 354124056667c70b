// Every lesson of the house, played to its end without a window.
#include <algorithm>
#include <array>
#include <set>

#include "check/play.hpp"
#include "core/lesson/lesson_files.hpp"
#include "core/lesson/small_lesson.hpp"
#include "geometry/generate.hpp"
#include "lesson/prose.hpp"
#include "lesson/reopening.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::lesson_of;
using snug::test::session_of;

namespace {

constexpr std::array kSphereLessons{"sphere-ritter", "sphere-pca", "sphere-welzl", "sphere-iterative"};

int words(const Paragraph& paragraph) {
  int count = 0;
  bool inside = false;
  for (const Stretch& stretch : paragraph)
    for (const char c : stretch.text) {
      if (c != ' ' && !inside) ++count;
      inside = c != ' ';
    }
  return count;
}

}  // namespace

TEST_CASE("each lesson reads well: sections, short paragraphs, terms, lectures") {
  for (const char* id : kSphereLessons) {
    CAPTURE(id);
    const Lesson lesson = lesson_of(id);
    CHECK(lesson.id == id);
    CHECK(lesson.sections.size() >= 3);
    CHECK(lesson.sections.size() <= 5);
    CHECK_FALSE(lesson.covers.empty());
    CHECK(std::count(lesson.meshes.begin(), lesson.meshes.end(), "bunny") == 1);
    int strong = 0;
    for (const Section& section : lesson.sections)
      for (const Paragraph* paragraph : paragraphs_of(section)) {
        CHECK_MESSAGE(words(*paragraph) <= 60, paragraph->front().text);
        for (const Stretch& stretch : *paragraph) strong += stretch.strong;
      }
    CHECK(strong >= 5);
  }
}

TEST_CASE("each lesson opens on its result, and the first step shows step 1 or asks the question before it") {
  for (const char* id : kSphereLessons) {
    CAPTURE(id);
    Session session = session_of(id);
    CHECK(session.player().previewing());
    REQUIRE(session.player().line() >= 0);
    CHECK(recording_of(session, 0)->steps.back().step.has_volume);
    CHECK(session.conversation().asked() == nullptr);
    session.forward();
    CHECK_FALSE(session.player().previewing());
    CHECK(session.player().step() ==
          (session.conversation().asked() != nullptr && session.conversation().questions().front().step == 0 ? 0 : 1));
  }
}

TEST_CASE("each lesson asks at least three questions of its first algorithm, in more than one way") {
  for (const char* id : kSphereLessons) {
    CAPTURE(id);
    Session session = session_of(id);
    CHECK(session.conversation().questions().size() >= 3);
    std::set<std::string> kinds;
    for (const Asked& asked : session.conversation().questions()) kinds.insert(asked.question->asks);
    CHECK(kinds.size() >= 2);
  }
}

TEST_CASE("each lesson plays to its end with the model answers, and its task is solved by the model alone") {
  for (const char* id : kSphereLessons) {
    CAPTURE(id);
    Session session = session_of(id);
    REQUIRE(session.grade().has_value());
    CHECK_FALSE(session.grade()->done);
    session.stage().start_task();
    CHECK_FALSE(session.grade()->done);
    session.stage().reset();
    const auto played = check::play(session);
    REQUIRE_MESSAGE(played.has_value(), (played ? "" : played.error().message()));
    CHECK(played->sound());
    CHECK(played->not_asked.empty());
    REQUIRE(!played->grades.empty());
    for (const Grade& grade : played->grades) CHECK(grade.done);
  }
}

TEST_CASE("each algorithm of each lesson can be stepped through, forth and back, with all that is shown") {
  for (const char* id : kSphereLessons) {
    Session session = session_of(id);
    for (const std::string& algorithm : session.lesson().algorithms) {
      CAPTURE(id);
      CAPTURE(algorithm);
      REQUIRE(session.player().choose(0, algorithm).has_value());
      session.go(0);
      test::play_to_end(session);
      CHECK(session.player().proofs().front().holds);
      int steps = 0;
      for (; session.player().step() > 0; session.go(session.player().step() - 1), ++steps) {
        REQUIRE(session.player().line() >= 0);
        CHECK(session.player().line() < static_cast<int>(session.player().pseudocode(0).size()));
        CHECK_FALSE(session.telling().figures().empty());
      }
      CHECK(steps == session.player().steps());
    }
    for (const auto& rival : session.player().rivals()) CHECK(rival.excess > -1e-12);
  }
}

TEST_CASE("a lesson's trace is the same each time, and another for each lesson") {
  std::set<std::uint64_t> hashes;
  for (const char* id : kSphereLessons) {
    Session first = session_of(id);
    Session second = session_of(id);
    CHECK(first.player().trace_hash() == second.player().trace_hash());
    CHECK(hashes.insert(first.player().trace_hash()).second);
    const auto own = second.player().trace_hash();
    second.stage().scatter(second.stage().subject().origin().seed + 1);
    CHECK(second.player().trace_hash() != own);
    second.stage().undo();
    CHECK(second.player().trace_hash() == own);
  }
}

TEST_CASE("scattered anew, each lesson still plays: questions that the points do not raise are left out") {
  int asked = 0, left_out = 0;
  for (const char* id : kSphereLessons) {
    Session session = session_of(id);
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
      session.stage().scatter(seed);
      session.forget_answers();
      session.go(0);
      const auto all = static_cast<int>(session.lesson().questions.size());
      asked += static_cast<int>(session.conversation().questions().size());
      left_out += all - static_cast<int>(session.conversation().questions().size());
      test::play_to_end(session);
      for (const Outcome& outcome : session.log().outcomes()) CHECK(outcome.right);
    }
  }
  CHECK(asked > 200);
  CHECK(left_out > 50);
}

TEST_CASE("what a run does only by rounding is not asked, and no pass is better by rounding alone") {
  const auto question = [](const Session& session, const char* id) -> const Asked* {
    for (const Asked& asked : session.conversation().questions())
      if (asked.question->id == id) return &asked;
    return nullptr;
  };
  Session pca = session_of("sphere-pca");
  CHECK(question(pca, "grows-first") != nullptr);
  pca.stage().scatter(2);  // an end of the first diameter lies outside by rounding, and no other point does
  CHECK(question(pca, "grows-first") == nullptr);
  Session iterative = session_of("sphere-iterative");
  iterative.stage().scatter(307);  // the first pass ends with Ritter's circle, but for rounding
  REQUIRE(question(iterative, "first-pass") != nullptr);
  const int no = 1;
  CHECK(model_answer(*question(iterative, "first-pass"), iterative.player().run(0)) == Answer(OneChoice{no}));
}

TEST_CASE("a lesson holds its questions on a mesh as well") {
  Session session = session_of("sphere-ritter");
  io::PointFile mesh{3, {}, {}};
  for (int i = 0; i < 500; ++i) {
    const double t = 0.37 * i;
    mesh.points.emplace_back(std::cos(t), std::sin(t), 0.004 * i - 1);
  }
  REQUIRE(session.stage().load(mesh, "bunny").has_value());
  CHECK(session.stage().subject().dim() == 3);
  session.go(0);
  test::play_to_end(session);
  REQUIRE_FALSE(session.log().outcomes().empty());
  CHECK(session.log().outcomes().front().question == "which-pair");
  CHECK(session.conversation().questions().front().choices.size() == 3);
}

TEST_CASE("the example that lessons/README.md gives is a sound lesson") {
  const std::string readme = test::lessons_file("README.md");
  const auto begin = readme.find("```toml\nversion");
  REQUIRE(begin != std::string::npos);
  const auto end = readme.find("```\n", begin + 8);
  Session session = test::open(readme.substr(begin + 8, end - begin - 8));
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  CHECK(played->sound());
  CHECK(played->algorithms.front().outcomes.size() == 1);
}

TEST_CASE("lessons/README.md names every step, algorithm and kind of points") {
  const std::string readme = test::lessons_file("README.md");
  const auto says = [&](std::string_view name) {
    return readme.find('`' + std::string(name) + '`') != std::string::npos;
  };
  for (const SubjectRow* subject : subjects())
    for (const std::string_view fact : subject->facts()) CHECK_MESSAGE(says(fact), fact);
  for (const auto& algorithm : fit::algorithms()) CHECK_MESSAGE(says(algorithm.name), algorithm.name);
  for (const std::string_view kind : generator_kinds()) CHECK_MESSAGE(says(kind), kind);
  for (const std::string& mesh : mesh_names()) CHECK_MESSAGE(says(mesh), mesh);
}

TEST_CASE("whatever the stage is about, a lesson that reads as before stands as before") {
  for (const char* const subject :
       {"cloud", "pair", "frustum", "field", "tree", "scene", "update", "cost", "criteria", "claims"}) {
    CAPTURE(subject);
    const std::string id = std::string("examples/") + subject;
    Session before = session_of(id);
    REQUIRE(before.player().choose(0, before.lesson().algorithms.back()));
    before.go(0);
    REQUIRE(before.stage().move(1, before.stage().subject().at(1) +
                                       Point3(0.01, 0.02, before.stage().subject().dim() == 3 ? 0.03 : 0)));
    before.jump(before.player().steps() / 2);
    const Reopening place(before);
    Session now = session_of(id);
    place.take(now);
    CHECK(now.stage().subject().rows() == before.stage().subject().rows());
    CHECK(now.player().trace_hash() == before.player().trace_hash());
    CHECK(now.player().step() == before.player().step());
    CHECK(now.player().method(0) == before.player().method(0));
    CHECK(now.log().outcomes().size() == before.log().outcomes().size());
    CHECK(now.telling().caption() == before.telling().caption());
  }
}
