#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/say.hpp"

using namespace snug;
using namespace snug::lesson;
using test::choice;
using test::open_small;
using test::point;
using test::small_lesson_with;

namespace {

/// The small lesson with one question, on an algorithm of its own. Its seed puts Welzl's list in the order P1, P0, P4.
Session ask(const std::string& algorithm, const std::string& rest) {
  const std::string own =
      "[[question]]\nid = \"own\"\nprompt = \"?\"\nbecause = \"So.\"\nalgorithm = \"" + algorithm + "\"\n";
  std::string text = small_lesson_with("[[task]]", own + rest + "\n[[task]]");
  Session session = test::open(text.replace(text.find("seed = 5"), 8, "seed = 2"));
  REQUIRE(session.player().choose(0, algorithm).has_value());
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().asked()->question->id == "own");
  return session;
}

}  // namespace

TEST_CASE("axis: by the pair's name or by one of its points") {
  Session session = open_small();
  session.last();
  CHECK(session.conversation().asked()->choices == std::vector<std::string>{"the x pair", "the y pair"});
  CHECK(session.conversation().asked()->on_stage);
  CHECK_FALSE(session.conversation().give(point(2)));  // no extreme point, so no answer
  CHECK_FALSE(session.conversation().give(point(99)));
  CHECK_FALSE(session.conversation().give(choice(2)));
  CHECK(session.log().outcomes().empty());
  SUBCASE("wrong by choice") {
    REQUIRE(session.conversation().give(choice(1)));
    CHECK_FALSE(session.conversation().outcome()->right);
    CHECK(session.conversation().outcome()->predicted == "the y pair");
    CHECK(session.conversation().outcome()->happened == "the x pair");
    CHECK(session.conversation().outcome()->says == "P0 and P1, the x pair, lie farthest apart.");
    CHECK(session.conversation().outcome()->because == "It is farther apart.");
  }
  SUBCASE("right by point") {
    REQUIRE(session.conversation().give(point(1)));
    CHECK(session.conversation().outcome()->right);
    CHECK(session.conversation().outcome()->predicted == "the x pair (P1)");
    CHECK(session.conversation().outcome()->happened == "the x pair");
  }
  SUBCASE("wrong by point") {
    REQUIRE(session.conversation().give(point(4)));
    CHECK_FALSE(session.conversation().outcome()->right);
    CHECK(session.conversation().outcome()->predicted == "the y pair (P4)");
    CHECK(session.conversation().outcome()->says == "P0 and P1, the x pair, lie farthest apart.");
  }
}

TEST_CASE("axis: a point of two pairs means the right one") {
  Session session = open_small();
  REQUIRE(session.stage().move(1, {2, 3, 0}).has_value());  // the rightmost and the highest
  session.last();
  REQUIRE(session.conversation().give(point(1)));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->predicted == session.conversation().outcome()->happened + " (P1)");
}

TEST_CASE("of points in space, questions and what is said of them speak of spheres") {
  std::string text =
      small_lesson_with("Which point?", "Circles: which point does the circle, not the semicircle, take in?");
  text.replace(text.find("It lies outside."), 16, "The circle leaves it out.");
  Session session = test::open(text);
  session.jump(2);
  CHECK(session.conversation().asked()->prompt == "Circles: which point does the circle, not the semicircle, take in?");
  io::PointFile cloud{3, {}, {}};
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    cloud.points.push_back(session.stage().subject().at(i) + Vector<double, 3>(0, 0, i == 5 ? 0.25 : 0));
  REQUIRE(session.stage().load(cloud, "cloud.xyz").has_value());
  session.go(0);
  session.last();
  REQUIRE(session.conversation().give({}));
  REQUIRE(session.conversation().acknowledge());
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->prompt == "Spheres: which point does the sphere, not the semicircle, take in?");
  REQUIRE(session.conversation().give(point(4)));
  CHECK(session.conversation().outcome()->says == "P4 lies outside, and the sphere grows to it.");
  CHECK(session.conversation().outcome()->because == "The sphere leaves it out.");
}

TEST_CASE("point: any other point is wrong, and the sentence says what happened") {
  Session session = open_small();
  session.jump(2);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->choices.empty());
  CHECK_FALSE(session.conversation().give(choice(0)));
  REQUIRE(session.conversation().give(point(3)));
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "P4 lies outside, and the circle grows to it.");
}

TEST_CASE("grows: no where all points are inside, yes where one is let in") {
  Session session = open_small();
  session.jump(9);
  REQUIRE(session.conversation().give(choice(0)));
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "The radius stays 2.250.");

  Session welzl = ask("welzl", "before = \"boundary_forced\"\nnth = 2\nasks = \"grows\"");
  REQUIRE(welzl.conversation().give(choice(0)));
  CHECK(welzl.conversation().outcome()->right);
  CHECK(welzl.conversation().outcome()->says == "The radius grows from 0.000 to 2.000.");
}

TEST_CASE("choice: by the file's answer, and only on the lesson's own points") {
  Session session = open_small();
  session.jump(10);
  REQUIRE(session.conversation().give(choice(0)));
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "The answer is “three”.");
  session.stage().scatter(6);
  for (const Asked& asked : session.conversation().questions()) CHECK(asked.question->id != "number");
}

TEST_CASE("leaves: which point leaves the support when Welzl's recursion is through") {
  // P4 comes when P0 and P1 hold the circle: both stay. So nothing leaves.
  Session none = ask("welzl", "before = \"boundary_forced\"\nnth = 3\nasks = \"leaves\"");
  CHECK(none.conversation().asked()->choices == std::vector<std::string>{"none", "P0", "P1"});
  CHECK_FALSE(none.conversation().give(point(4)));  // it does not hold the circle yet, so it cannot leave
  REQUIRE(none.conversation().give(choice(0)));
  CHECK(none.conversation().outcome()->right);
  CHECK(none.conversation().outcome()->says == "No point left the support set.");
  CHECK(none.player().support(0).size() == 3);

  // P4 far off: the circle is then held by it and the farther of P0 and P1.
  Session session = ask("welzl", "before = \"boundary_forced\"\nnth = 3\nasks = \"leaves\"");
  REQUIRE(session.stage().move(0, {-1, 0, 0}).has_value());
  REQUIRE(session.stage().move(4, {-40, 0.5, 0}).has_value());
  session.jump(session.conversation().questions().front().step);
  REQUIRE(session.conversation().give(point(0)));
  CHECK(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->happened == "P0");
  CHECK(session.conversation().outcome()->says == "P0 left the support set.");
}

TEST_CASE("holds: how many points hold the ball, asked before anything is shown") {
  Session session = ask("brute_force", "before = \"finished\"\nafter = \"start\"\nasks = \"holds\"");
  CHECK(session.player().step() == 0);
  CHECK(session.conversation().asked()->choices.size() == 3);
  REQUIRE(session.conversation().give(choice(1)));
  CHECK(session.player().step() == session.player().steps());
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "P0, P1 and P4 support the circle.");
}

TEST_CASE("better: whether a candidate becomes the best") {
  Session session = ask("brute_force", "before = \"candidate_tried\"\nasks = \"better\"");
  REQUIRE(session.conversation().give(choice(0)));  // P0 and P1 leave P4 outside
  CHECK_FALSE(session.conversation().outcome()->right);
  CHECK(session.conversation().outcome()->says == "P4 lies outside, so it is not kept.");
}

TEST_CASE("a question stays out where another one is not decided yet") {
  const auto lesson = check::checked_lesson(
      small_lesson_with("before = \"radius_checked\"", "before = \"point_examined\"\nnth = 3"), "x.toml");
  REQUIRE_FALSE(lesson.has_value());
  CHECK(lesson.error().what == "the question comes while an earlier one is not decided yet: \"growth\", in line 32");
}

TEST_CASE("a step speaks of points just where its fact names some") {
  Session session = open_small();
  int named = 0, unnamed = 0;
  for (const char* algorithm : {"ritter", "welzl", "brute_force", "pca", "ritter_iterative", "aabb_center"}) {
    REQUIRE(session.player().choose(0, algorithm).has_value());
    for (int i = 0; i < session.player().steps(); ++i) {
      const std::string_view fact = session.player().run(0).fact(i);
      const bool none = fact == "midpoint_found" || fact == "mean_found" || fact == "covariance_found" ||
                        fact == "axes_found" || fact == "ball_shrunk" || fact == "pass_judged" || fact == "all_checked";
      CAPTURE(fact);
      CHECK(session.player().run(0).handles(i).empty() == none);
      ++(none ? unnamed : named);
    }
  }
  CHECK(named > 50);
  CHECK(unnamed > 10);
}

namespace {

/// The first question with words of its own for the lesson's own run.
std::string lesson_with_words_here(const std::string& text) {
  std::string own = text;
  const std::string_view because = "because = \"It is farther apart.\"\n";
  return own.insert(own.find(because) + because.size(), R"(prompt_here = "Which pair of the cross?"
because_here = "The cross's arm along x is the longer circle's diameter."
)");
}

/// Whether the first question speaks of the lesson's own run, in its prompt and in its reason.
bool speaks_of_here(Session& session) {
  session.forget_answers();
  session.go(0);
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().asked()->question->id == "pair");
  const bool here = session.conversation().asked()->prompt == "Which pair of the cross?";
  if (!here) CHECK(session.conversation().asked()->prompt == "Which pair?");
  REQUIRE(session.conversation().give(choice(0)));
  CHECK(session.conversation().outcome()->because ==
        (here ? "The cross's arm along x is the longer circle's diameter." : "It is farther apart."));
  return here;
}

}  // namespace

TEST_CASE("words that hold on the lesson's own points stand there alone") {
  Session session = test::open(lesson_with_words_here(std::string(test::kSmallLesson)));
  CHECK(speaks_of_here(session));
  REQUIRE(session.stage().move(2, {0.1, 1, 0}).has_value());
  CHECK_FALSE(speaks_of_here(session));
  session.stage().undo();
  CHECK(speaks_of_here(session));
  session.stage().scatter(6);
  CHECK_FALSE(speaks_of_here(session));
  session.stage().reset();
  CHECK(speaks_of_here(session));
  REQUIRE(session.stage().set_generator("cube", 12, 2, session.stage().subject().origin().seed).has_value());
  CHECK_FALSE(speaks_of_here(session));
  REQUIRE(session.stage()
              .load({2, {{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1, 2.5, 0}}, {}}, "five.xyz")
              .has_value());
  CHECK_FALSE(speaks_of_here(session));
  session.stage().scatter(session.lesson().seed);
  CHECK(speaks_of_here(session));
}

TEST_CASE("a mesh's own words stand on that mesh alone") {
  std::string text = lesson_with_words_here(std::string(test::kSmallLesson));
  const auto points = text.find("dim = 2\nlist"), end = text.find("[[section]]");
  text.replace(points, end - points, "mesh = \"bunny\"\n\n");
  text.erase(text.find("[[task]]"));
  auto lesson = check::checked_lesson(text, "mesh.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  const io::PointFile own{3, {{-2, 0, 0}, {2, 0, 0}, {0, 1, 0.5}, {0, 2.5, 0}}, {}};
  auto session = Session::open(*std::move(lesson), own);
  REQUIRE(session.has_value());
  const auto prompt = [&] {
    session->last();
    REQUIRE(session->conversation().asked() != nullptr);
    return session->conversation().asked()->prompt;
  };
  CHECK(prompt() == "Which pair of the cross?");
  REQUIRE(session->stage().load({3, {{0, 0, 0}, {3, 0, 0}, {1, 1, 1}}, {}}, "teapot").has_value());
  CHECK(prompt() == "Which pair?");
  REQUIRE(session->stage().load(own, "bunny").has_value());
  CHECK(prompt() == "Which pair of the cross?");
}

TEST_CASE("an answer is chosen first and given when it is chosen again, or by commit") {
  Session session = open_small();
  session.last();
  CHECK(session.conversation().target_names() == std::vector<std::string>{"P0", "P1", "P3", "P4"});
  CHECK_FALSE(session.conversation().commit());  // nothing is chosen
  REQUIRE(session.conversation().pick(point(1)));
  CHECK(session.log().outcomes().empty());
  CHECK(session.conversation().answer_says() == "P1 chosen. Tap it again or press Enter to answer.");
  REQUIRE(session.conversation().pick(choice(1)));  // another mind
  CHECK(session.conversation().answer_says() == "“the y pair” chosen. Choose it again or press Enter to answer.");
  session.conversation().unpick();
  CHECK(session.conversation().picked() == nullptr);
  CHECK(session.conversation().answer_says().empty());
  SUBCASE("by a second pick") {
    REQUIRE(session.conversation().pick(point(0)));
    REQUIRE(session.conversation().pick(point(0)));
  }
  SUBCASE("by commit") {
    REQUIRE(session.conversation().pick(point(0)));
    REQUIRE(session.conversation().commit());
  }
  SUBCASE("by name") {
    REQUIRE(session.conversation().pick(" p0"));
    REQUIRE(session.conversation().pick("P0"));  // to type it again is no second tap
    CHECK(session.log().outcomes().empty());
    REQUIRE(session.conversation().commit());
  }
  REQUIRE(session.log().outcomes().size() == 1);
  CHECK(session.log().outcomes().front().predicted == "the x pair (P0)");
  CHECK(session.conversation().picked() == nullptr);
}

TEST_CASE("what cannot be the answer is told and costs nothing") {
  Session session = open_small();
  session.last();
  CHECK_FALSE(session.conversation().pick(point(2)));
  CHECK(session.conversation().answer_says() == "P2 cannot be the answer. Choose P0, P1, P3 or P4.");
  CHECK_FALSE(session.conversation().pick("p5"));
  CHECK(session.conversation().answer_says() == "P5 cannot be the answer. Choose P0, P1, P3 or P4.");
  CHECK_FALSE(session.conversation().pick("2"));
  CHECK(session.conversation().answer_says() == "Nothing here is called “2”. Type P0, P1, P3 or P4.");
  CHECK(session.conversation().asked() != nullptr);
  CHECK(session.log().outcomes().empty());
  CHECK(session.conversation().picked() == nullptr);
}

TEST_CASE("a chosen answer is forgotten with the points it was of") {
  Session session = open_small();
  session.last();
  REQUIRE(session.conversation().pick(point(1)));
  REQUIRE(session.stage().move(2, {0.1, 1, 0}).has_value());
  CHECK(session.conversation().picked() == nullptr);
  CHECK_FALSE(session.conversation().commit());
}

TEST_CASE("a choice that names a point and a tap on that point are the same answer") {
  Session session = ask("welzl", "before = \"boundary_forced\"\nnth = 3\nasks = \"leaves\"");
  const std::string name = session.conversation().asked()->choices[1];  // asked ends with the answer
  REQUIRE(name.starts_with("P"));
  REQUIRE(session.conversation().pick(point(std::stoi(name.substr(1)))));
  REQUIRE(session.conversation().pick(choice(1)));
  REQUIRE(session.conversation().tried() != nullptr);  // it was given, and is wrong
  CHECK(session.conversation().answer_says() == "Not that one. Try once more.");
  CHECK_FALSE(session.conversation().pick(point(std::stoi(name.substr(1)))));
  CHECK(session.conversation().answer_says() == "You have tried that one. Try another.");
}

TEST_CASE("skipped, wrong and right are counted apart") {
  Session session = open_small();
  session.last();
  CHECK(session.conversation().score().empty());
  REQUIRE(session.conversation().give(choice(0)));
  session.last();
  REQUIRE(session.conversation().give({}));
  session.last();
  REQUIRE(session.conversation().give(choice(0)));  // it does not grow
  session.last();
  REQUIRE(session.conversation().give(choice(1)));
  REQUIRE(session.player().step() == session.player().steps());
  CHECK(session.conversation().score() == "2 of 4 predictions correct, 1 wrong, 1 skipped.");
  CHECK(session.conversation().tally().right == 2);
  CHECK(session.conversation().tally().wrong == 1);
  CHECK(session.conversation().tally().skipped == 1);
  CHECK(session.conversation().tally().open == 0);
  CHECK(verdict_text(session.log().outcomes()[0]) == "Correct");
  CHECK(verdict_text(session.log().outcomes()[1]) == "Skipped");
  CHECK(verdict_text(session.log().outcomes()[2]) == "Not quite");
}
