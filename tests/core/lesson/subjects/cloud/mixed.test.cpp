// Lessons whose algorithms are of several volumes, and the one reference that sizes are compared with.
#include <algorithm>

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kMixed = R"(version = 2
title = "Mixed"
summary = "Three volumes."
minutes = 3
algorithms = ["aabb/min_max", "kdop/k8", "obb/exact"]
reference = "hull/quickhull"
meshes = ["bunny"]

[points]
list = [[-2, 0], [2, 0.5], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]

[[section]]
title = "First"
text = "Choose [the 8-DOP](algorithm:kdop/k8)."

[[question]]
id = "slab"
algorithm = "kdop/k8"
before = "slab_found"
asks = "point"
prompt = "Which point?"
because = "It is farthest."
)";

std::string mixed_with(std::string_view from, std::string_view to) {
  std::string text(kMixed);
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

const Figure* figure_of(const std::vector<Figure>& figures, std::string_view key) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.key == key; });
  return found == figures.end() ? nullptr : &*found;
}

std::string refusal(const std::string& text) {
  const Draft draft = check::checked_draft(text, "mixed.toml");
  return draft.mistakes.empty() ? "" : draft.mistakes.front().message();
}

}  // namespace

TEST_CASE("volumes of several kinds stand beside each other, and one reference is over none of them") {
  Session session = test::open(std::string(kMixed));
  CHECK(is_mixed(session.lesson()));
  CHECK(session.lesson().volume == "aabb");
  CHECK(session.lesson().algorithms == std::vector<std::string>{"min_max", "kdop/k8", "obb/exact"});
  REQUIRE(session.player().rivals().size() == 3);
  const double hull = 7;  // of P0, P3, P1 and P4, by the shoelace formula
  for (const Rival& rival : session.player().rivals()) {
    CHECK(find_method(session.lesson(), name_in(session.lesson(), *rival.method)) == rival.method);
    REQUIRE(rival.excess.has_value());
    CHECK(*rival.excess > 0);  // nothing convex round the points is smaller than their hull
    CHECK(rival.size == doctest::Approx((1 + *rival.excess) * hull));
  }
  // An 8-DOP has the AABB's slabs and four planes more.
  CHECK(session.player().rivals()[1].size < session.player().rivals()[0].size);
  for (const char* name : {"min_max", "kdop/k8", "obb/exact", "aabb/min_max"}) {
    CAPTURE(name);
    REQUIRE(session.player().choose(0, name).has_value());
    session.jump(session.player().steps());
    const std::vector<Figure> figures = session.telling().figures();
    const Figure* excess = figure_of(figures, "excess");
    REQUIRE(excess != nullptr);
    CHECK(excess->name == "Excess over the convex hull");
    for (const Rival& rival : session.player().rivals())
      if (rival.method == session.player().method(0)) CHECK(excess->value == doctest::Approx(100 * *rival.excess));
  }
  CHECK_FALSE(session.player().choose(0, "kdop/k9").has_value());
  CHECK_FALSE(session.player().choose(0, "kd/k8").has_value());
}

TEST_CASE("a question names an algorithm of another volume, and is asked in its run alone") {
  Session session = test::open(std::string(kMixed));
  CHECK(session.conversation().questions().empty());
  REQUIRE(session.player().choose(0, "kdop/k8").has_value());
  REQUIRE(session.conversation().questions().size() == 1);
  test::play_to_end(session);
  CHECK(session.log().outcomes().front().right);
}

TEST_CASE("beside other volumes a sphere is compared by its area") {
  Session session = test::open(mixed_with("\"obb/exact\"]", "\"sphere/welzl\"]"));
  REQUIRE(session.player().choose(0, "sphere/welzl").has_value());
  session.jump(session.player().steps());
  const std::vector<Figure> figures = session.telling().figures();
  const Figure *radius = figure_of(figures, "radius"), *area = figure_of(figures, "measure");
  REQUIRE((radius != nullptr && area != nullptr));
  CHECK(area->value == doctest::Approx(3.14159265358979 * radius->value * radius->value));
  CHECK(session.player().rivals().back().size == doctest::Approx(area->value));
}

TEST_CASE("k-DOPs are compared with nothing unless the lesson says with what") {
  const Session session = test::open(mixed_with("reference = \"hull/quickhull\"\n", ""));
  for (const Rival& rival : session.player().rivals()) CHECK_FALSE(rival.excess.has_value());
  CHECK(figure_of(session.telling().figures(), "excess") == nullptr);
}

TEST_CASE("what a lesson of several volumes says wrongly is told") {
  CHECK(refusal(mixed_with("\"kdop/k8\", \"obb", "\"kdop/k9\", \"obb")).find("k9") != std::string::npos);
  CHECK(refusal(mixed_with("reference = \"hull/quickhull\"", "reference = \"hull/quick\""))
            .find(":6:13: \"reference\"") != std::string::npos);
  CHECK(refusal(mixed_with("[\"aabb/min_max\", \"kdop/k8\"", "[\"kdop/k14\", \"aabb/min_max\", \"kdop/k8\""))
            .find("14-DOP is for points in space") != std::string::npos);
  CHECK(test::warnings_of(mixed_with("\"obb/exact\"]", "\"obb/exact\", \"kdop/k14\"]")) ==
        "small.toml:5:14: 14-DOP is for points in space, and is not offered for these\n");
}

// ---- questions worked out from the run ---------------------------------------------------------------------------

namespace {

/// The mixed lesson with one question more, on the AABB's run.
Session asked_session(std::string_view keys) {
  return test::open(std::string(kMixed) +
                    "\n[[question]]\nid = \"one\"\nalgorithm = \"min_max\"\nbefore = \"finished\"\n" +
                    std::string(keys) + "\nprompt = \"Which?\"\nbecause = \"So it is.\"\n");
}

}  // namespace

TEST_CASE("which algorithm is tightest is worked out from all their results, which are hidden until it is predicted") {
  Session session = asked_session("after = \"start\"\nasks = \"tightest\"");
  session.go(0);
  const Asked* asked = session.conversation().asked();
  REQUIRE(asked != nullptr);
  CHECK(asked->choices.size() == 3);
  for (const char* name : {"min_max", "kdop/k8", "obb/exact"})
    CHECK(session.telling().hides_result(*find_method(session.lesson(), name)));
  const auto smallest = std::min_element(session.player().rivals().begin(), session.player().rivals().end(),
                                         [](const Rival& a, const Rival& b) { return a.size < b.size; });
  const int right = static_cast<int>(smallest - session.player().rivals().begin());
  REQUIRE(session.conversation().give(test::choice(right)));
  CHECK(session.log().outcomes().front().right);
  CHECK(session.log().outcomes().front().says.find(std::string(smallest->method->title)) == 0);
  session.conversation().acknowledge();
  session.last();
  CHECK_FALSE(session.telling().hides_result(*session.player().method(0)));
}

TEST_CASE("of several tightest algorithms each is a right answer") {
  // Of the corners of an upright square the AABB, the 4-DOP and the smallest oriented box are the same square.
  const std::string text =
      mixed_with("[[-2, 0], [2, 0.5], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]", "[[0, 0], [1, 0], [0, 1], [1, 1]]");
  Session session =
      test::open(text + "\n[[question]]\nid = \"one\"\nalgorithm = \"min_max\"\nbefore = \"finished\"\nasks = "
                        "\"tightest\"\nprompt = \"Which?\"\nbecause = \"So it is.\"\n");
  session.go(session.player().steps());
  const Asked* asked = session.conversation().asked();
  REQUIRE(asked != nullptr);
  const Truth truth = asked->kind->truth(*asked, session.player().run(0));
  CHECK(truth.choices == std::vector<int>{0, 1, 2});
}

TEST_CASE("a range of any figure can be asked, and the figure is hidden until it is") {
  Session session = asked_session("asks = \"figure\"\nfigure = \"excess\"\nbounds = [10, 60]");
  session.go(session.player().steps());
  const Asked* asked = session.conversation().asked();
  REQUIRE(asked != nullptr);
  CHECK(asked->choices == std::vector<std::string>{"at most 10 %", "10 to 60 %", "more than 60 %"});
  CHECK(session.telling().is_hidden("excess"));
  const double excess = 100 * *session.player().rivals().front().excess;
  const int right = excess <= 10 ? 0 : excess <= 60 ? 1 : 2;
  REQUIRE(session.conversation().give(test::choice(right)));
  CHECK(session.log().outcomes().front().right);
  const std::string lost = mixed_with("prompt = \"Which point?\"", "prompt = \"Which point?\"") +
                           "\n[[question]]\nid = \"one\"\nalgorithm = \"min_max\"\nbefore = \"finished\"\nasks = "
                           "\"figure\"\nfigure = \"beauty\"\nbounds = [1]\nprompt = \"?\"\nbecause = \"!\"\n";
  CHECK(refusal(lost).find("\"figure\" after finished is none of measure") != std::string::npos);
}

TEST_CASE("what is asked of one algorithm's size stays hidden while another is on the stage") {
  Session session = asked_session("asks = \"figure\"\nfigure = \"excess\"\nbounds = [10, 60]");
  const Method &asked = *find_method(session.lesson(), "min_max"), &other = *find_method(session.lesson(), "kdop/k8");
  const auto excess_beside = [&] { return figure_of(session.telling().figures(1), "excess")->known; };
  REQUIRE(session.player().choose(0, "obb/exact").has_value());
  REQUIRE(session.player().choose(1, "min_max").has_value());
  session.last();
  CHECK(session.telling().hides_result(asked));
  CHECK_FALSE(session.telling().hides_result(other));
  CHECK_FALSE(excess_beside());
  REQUIRE(session.player().choose(0, "min_max").has_value());
  session.go(0);
  session.go(session.player().steps());
  REQUIRE(session.conversation().give(test::choice(0)));
  session.conversation().acknowledge();
  REQUIRE(session.player().choose(0, "obb/exact").has_value());
  session.last();
  CHECK_FALSE(session.telling().hides_result(asked));
  CHECK(excess_beside());
}

TEST_CASE("ranges of counts and of measures") {
  CHECK(range_texts(std::vector<double>{0, 12}, "pairs") ==
        std::vector<std::string>{"none", "1 to 12 pairs", "more than 12 pairs"});
  CHECK(range_texts(std::vector<double>{3, 4}, "") == std::vector<std::string>{"at most 3", "4", "more than 4"});
  CHECK(range_texts(std::vector<double>{0.5, 2}, "units") ==
        std::vector<std::string>{"at most 0.5 units", "0.5 to 2 units", "more than 2 units"});
}
