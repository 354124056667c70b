// Exercises: their instances, what a sitting takes and marks, and the attempt that is written and replayed.
#include <doctest/doctest.h>

#include <memory>
#include <set>
#include <string>

#include "core/lesson/lesson_files.hpp"
#include "lesson/exercise/sets.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/names.hpp"
#include "number/fnv.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

using Shared = std::shared_ptr<const Exercise>;

Shared exercise_from(const std::string& text, const std::string& id = "test") {
  ExerciseDraft draft = read_exercise(text, id + ".toml");
  for (const FileError& mistake : draft.mistakes) FAIL(mistake.message());
  return std::make_shared<const Exercise>(std::move(draft.exercise));
}

Shared exercise_of(const std::string& id) { return exercise_from(test::lessons_file("exercises/" + id + ".toml"), id); }

std::vector<ExerciseSet> sets() {
  const std::string text = test::lessons_file("exercises/sets.toml");
  std::set<std::string> ids;  // whatever the file names: whether it exists is seen where it is read
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos;) {
    const std::size_t end = text.find('"', at + 1);
    ids.insert(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  const std::vector<std::string> known(ids.begin(), ids.end());
  const auto read = read_sets(text, "sets.toml", known);
  REQUIRE_MESSAGE(read, (read ? "" : read.error().message()));
  return *read;
}

/// A sitting at an instance.
struct Sat {
  explicit Sat(Shared exercise, std::uint64_t seed = 1)
      : session(*open_instance(*exercise, *make_instance(*exercise, seed))), sitting(exercise, seed, session) {}
  Session session;
  Sitting sitting;
  [[nodiscard]] const Asked& asked() const { return *session.asked(); }
  [[nodiscard]] Answer right() const { return model_answer(asked(), session.run(0)); }
  void decide() { REQUIRE(session.propose(right())); }
  void decide_all() {
    while (!sitting.finished(session)) decide();
  }
};

std::string ritter_with(const std::string& from, const std::string& to) {
  std::string text = test::lessons_file("exercises/be-ritter.toml");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("every exercise of a set keeps its promise, and right decisions earn every mark") {
  std::set<std::string> ids;
  for (const ExerciseSet& set : sets()) {
    CHECK(set.exercises.size() == 10);
    ids.insert(set.exercises.begin(), set.exercises.end());
  }
  for (const std::string& id : ids) {
    CAPTURE(id);
    const Shared exercise = exercise_of(id);
    CHECK_NOTHROW(static_cast<void>(test::lesson_of(exercise->lesson)));
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(seed);
      Sat sat(exercise, seed);
      const auto decisions = static_cast<int>(sat.session.questions().size());
      CHECK(decisions >= exercise->least);
      CHECK(decisions <= exercise->most);
      for (const Asked& asked : sat.session.questions())
        CHECK(asked.asking->margin(asked, sat.session.run(0)) >= exercise->apart);
      sat.decide_all();
      CHECK(sat.sitting.mark(sat.session) == decisions);
      const auto graded = grade(exercise, sat.sitting.attempt(sat.session));
      REQUIRE(graded);
      CHECK(graded->mark == decisions);
    }
  }
}

TEST_CASE("a wrong rule is wrong somewhere, and named where it was followed") {
  for (const ExerciseSet& set : sets())
    for (const std::string& id : set.exercises) {
      CAPTURE(id);
      const Shared exercise = exercise_of(id);
      for (std::size_t kind = 0; kind < exercise->decisions.size(); ++kind)
        for (const RuleWords& words : exercise->decisions[kind].rules) {
          CAPTURE(words.name);
          Sat sat(exercise, 7);
          bool named = false;
          while (!sat.sitting.finished(sat.session) && !named) {
            const Asked& asked = sat.asked();
            const WrongRule* rule =
                decision_of(*exercise, *asked.question) == kind ? find_rule(asked, words.name) : nullptr;
            const auto answer = rule != nullptr ? rule->decides(asked, sat.session.run(0)) : std::nullopt;
            if (!answer || judge(asked, *answer, sat.session.run(0)).right) {
              sat.decide();
              continue;
            }
            REQUIRE(sat.session.propose(*answer));
            named = !sat.sitting.rule_says(sat.session).empty();
            CHECK(named);
          }
          CHECK(named);
        }
    }
}

TEST_CASE("the instance of a seed is the same everywhere, and no other exercise's") {
  const auto instance = make_instance(*exercise_of("be-ritter"), 17);
  REQUIRE(instance);
  CHECK(make_instance(*exercise_of("be-ritter"), 17)->own == instance->own);
  CHECK(make_instance(*exercise_of("be-ritter"), 18)->own != instance->own);
  CHECK(make_instance(*exercise_of("be-aabb-centre"), 17)->own != instance->own);
  CHECK(seed_of("Ada Lovelace") == seed_of("ada lovelace"));
  CHECK(seed_of("Ada") != seed_of("Ade"));
}

TEST_CASE("a second try earns a half, each hint a quarter less, and one that tells it nothing") {
  Sat sat(exercise_of("fit-a-kdop"));
  const Answer wrong{.kind = Answer::Kind::kPoints, .list = {0}};
  REQUIRE(sat.session.propose(wrong));
  CHECK(sat.sitting.mark(sat.session) == 0);
  CHECK(sat.session.tried() != nullptr);
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 0.5);
  CHECK(sat.sitting.next_price(sat.session) == 0.25);
  REQUIRE(sat.sitting.take_hint(sat.session));
  CHECK(sat.sitting.hints(sat.session).size() == 1);
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 1.25);
  for (int hint = 0; hint < kMostHints; ++hint) REQUIRE(sat.sitting.take_hint(sat.session));
  CHECK_FALSE(sat.sitting.take_hint(sat.session));
  CHECK(sat.sitting.hints(sat.session).back() ==
        "The answer: " + sat.asked().asking->truth(sat.asked(), sat.session.run(0)).happened + ".");
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 1.25);
  CHECK(sat.sitting.attempt(sat.session).made[2].hints == kMostHints);
}

TEST_CASE("after two wrong answers the right step is shown, and the run goes on from it") {
  Sat sat(exercise_of("be-quickhull"));
  const Index right = sat.right().value;
  for (const Index i : sat.session.targets())
    if (i != right && sat.session.outcome() == nullptr) REQUIRE(sat.session.propose({Answer::Kind::kPoint, i}));
  REQUIRE(sat.session.outcome() != nullptr);
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.outcome()->right);
  CHECK(sat.session.step() == sat.session.outcome()->step);
  REQUIRE(sat.session.acknowledge());
  CHECK(sat.sitting.at(sat.session) == 1);
  sat.decide_all();
  CHECK(sat.sitting.mark(sat.session) == sat.sitting.of() - 1);
}

TEST_CASE("a tap decides, a key only chooses, nothing can be skipped, and the stage stays as it is") {
  Sat sat(exercise_of("be-quickhull"));
  const Answer right = sat.right();
  const Rows rows = sat.session.subject().rows();
  REQUIRE(sat.session.pick(right, false));
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.skip());
  CHECK(sat.session.pass_by());
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.move(0, Point3(1, 1, 0)));
  CHECK_FALSE(sat.session.may_move(0));
  sat.session.scatter(99);
  sat.session.reset();
  CHECK_FALSE(sat.session.can_undo());
  CHECK(sat.session.subject().rows() == rows);
  REQUIRE(sat.session.pick(right));
  CHECK(sat.sitting.at(sat.session) == 1);
}

TEST_CASE("where all is told at the end, a decision can be taken back, and nothing is told before") {
  Sat sat(
      exercise_from(ritter_with("lesson = \"sphere-ritter\"", "lesson = \"sphere-ritter\"\ntold = \"at the end\"")));
  const Answer none{.kind = Answer::Kind::kPoints, .list = {0}};
  REQUIRE(sat.session.propose(none));
  CHECK(sat.session.tried() == nullptr);
  CHECK(sat.session.outcome() == nullptr);
  CHECK(sat.sitting.at(sat.session) == 1);
  CHECK(sat.sitting.rule_says(sat.session).empty());
  CHECK(sat.sitting.marked(sat.session)[0].standing == Standing::kOpen);
  REQUIRE(sat.session.take_back());
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.take_back());
  sat.decide_all();
  CHECK(sat.sitting.mark(sat.session) == sat.sitting.of());
  CHECK(sat.sitting.marked(sat.session)[0].standing == Standing::kRight);
}

TEST_CASE("an attempt is written, read and replayed to the same mark") {
  const Shared exercise = exercise_of("p-and-n-vertex");
  Sat sat(exercise, 5);
  sat.sitting.take_hint(sat.session);
  sat.decide();
  const Index right = sat.right().value;
  REQUIRE(sat.session.propose({Answer::Kind::kChoice, right == 0 ? 1 : 0}));
  sat.decide();
  Attempt attempt = sat.sitting.attempt(sat.session);
  CHECK(attempt.made.size() == 2);
  for (Made& made : attempt.made) {
    const auto again = made_of(text_of(made));
    REQUIRE(again);
    CHECK(again->hints == made.hints);
    CHECK(again->tries == made.tries);
    made = *again;
  }
  const auto graded = grade(exercise, attempt);
  REQUIRE(graded);
  CHECK(graded->mark == sat.sitting.mark(sat.session));
  CHECK(graded->decided == 2);
  Sat later(exercise, 5);
  REQUIRE(later.sitting.take_up(later.session, attempt));
  CHECK(later.sitting.at(later.session) == 2);
  attempt.made.push_back({0, {{Answer::Kind::kPoint, 4000}}, {}, 1});
  CHECK_FALSE(grade(exercise, attempt));
}

TEST_CASE("a decision's text is refused if it is damaged") {
  for (const char* text : {"", "p", "px", "p-1@3", "p3", "p3@", "p3@x", "p3@-1", "p3@inf", "????p3@1", "p1>p2>p3@1",
                           "q7@1", "l1..2@1", "n@1", "nnan@1", "@1"})
    CHECK_MESSAGE(!made_of(text), text);
  CHECK(text_of(*made_of("??p3>c1@12.25")) == "??p3>c1@12.2");
  CHECK(text_of(*made_of("l3.7@0.0")) == "l3.7@0.0");
  CHECK(text_of(*made_of("o2.0.1@1.5")) == "o2.0.1@1.5");
  CHECK(made_of("n0.1@1")->tries[0].number == 0.1);
}

TEST_CASE("mistakes in an exercise's file are told with their places") {
  const auto says = [](const std::string& text) {
    const ExerciseDraft draft = read_exercise(text, "x.toml");
    return draft.mistakes.empty() ? std::string() : draft.mistakes.front().message();
  };
  CHECK(says(ritter_with("apart = 0.01", "apart = 0.9")).find("x.toml:9:") == 0);
  CHECK(says(ritter_with("farthest = \"You took the point farthest", "farhtest = \"You took the point farthest"))
            .find("did you mean farthest?") != std::string::npos);
  CHECK(says(ritter_with("asks = \"next_outside\"", "asks = \"grows\""))
            .find("an exercise cannot ask grows of ball_grown") != std::string::npos);
  CHECK(says(ritter_with("hint = \"Compare", "hnit = \"Compare")).find("lacks the key \"hint\"") != std::string::npos);
  CHECK(says(ritter_with("[exercise]", "[exercize]")).find("[exercise]") != std::string::npos);
  CHECK(says(ritter_with("decisions = [4, 9]", "decisions = [9, 4]")).find("two numbers") != std::string::npos);
}

TEST_CASE("an exercise whose promise cannot be kept says what is lacking") {
  const auto made = make_instance(*exercise_from(ritter_with("decisions = [4, 9]", "decisions = [80, 90]")), 1);
  REQUIRE_FALSE(made);
  CHECK(made.error().what == "none of 1000 instances of test keeps the promise; most have too few decisions");
}
