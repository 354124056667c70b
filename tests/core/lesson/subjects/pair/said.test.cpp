// What the tests of two volumes say: that touching counts as overlapping, what a distance is between, bounds as they
// are stored; and what their figures count.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_lesson.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/pair/volumes.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

Session opened(const std::string& algorithm, const std::string& volumes) {
  auto lesson = check::checked_lesson(
      "version = 2\ntitle = \"Two\"\nsummary = \"Two.\"\nminutes = 1\nvolume = \"volume_pair\"\nalgorithms = [\"" +
          algorithm + "\"]\n[volumes]\n" + volumes + "[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n",
      "two.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

/// The sentences of all steps.
std::vector<std::string> sentences(Session& session) {
  std::vector<std::string> all;
  while (session.player().step() < session.player().steps()) {
    session.go(session.player().step() + 1);
    all.push_back(session.telling().caption());
  }
  return all;
}

std::optional<double> figure(const Session& session, std::string_view key) {
  const std::vector<Figure> figures = session.telling().figures();
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.key == key; });
  return found == figures.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace

TEST_CASE("boxes that touch are said to, and that it counts as overlapping") {
  Session touching = opened("min_max", "a = { aabb = { min = [0, 0], max = [1, 1] } }\n"
                                       "b = { aabb = { min = [0.5, 1], max = [2, 2] } }\n");
  CHECK(sentences(touching) ==
        std::vector<std::string>{"Along x A covers [0.000, 1.000] and B [0.500, 2.000]: the intervals overlap.",
                                 "Along y A covers [0.000, 1.000] and B [1.000, 2.000]: the intervals touch, and "
                                 "touching counts as overlapping.",
                                 "The volumes touch, and touching counts as overlapping."});
  REQUIRE(touching.stage().set_rows({{0, 0, 1, 1}, {0.5, 0.75, 2, 2}}).has_value());
  touching.go(0);
  CHECK(sentences(touching).back() == "The volumes overlap.");
}

TEST_CASE("two spheres are compared by their centres") {
  Session spheres = opened("spheres", "a = { sphere = { center = [-1.5, -1], radius = 1.5 } }\n"
                                      "b = { sphere = { center = [2.5, 2], radius = 3.5 } }\n");
  CHECK(sentences(spheres) == std::vector<std::string>{"The centres are 5.000 apart, and the radii add up to 5.000: "
                                                       "the distance is not greater, so the volumes touch.",
                                                       "The volumes touch, and touching counts as overlapping."});
  Session by_gjk = opened("gjk", "a = { sphere = { center = [-1.5, -1], radius = 0.5 } }\n"
                                 "b = { sphere = { center = [2.5, 2], radius = 0.5 } }\n");
  const std::vector<std::string> said = sentences(by_gjk);
  CHECK(said[said.size() - 2] == "Both bounds meet: the centres are 5.000 apart.");
}

TEST_CASE("the bounds of k-DOPs are said as they are stored") {
  Session apart =
      opened("slabs_then_gjk", "a = { kdop = { k = 8, min = [-1.9, -1.3, -2.5, -1.7], max = [-0.2, 0.9, 0.2, 0.2] } }\n"
                               "b = { kdop = { k = 8, min = [-0.5, 0.3, 0.6, -1.5], max = [1.2, 1.7, 2.4, 0.2] } }\n");
  const std::vector<std::string> said = sentences(apart);
  CHECK(said[2] ==
        "Along x+y A covers [−2.500, 0.200] and B [0.600, 2.400]: the intervals are disjoint, so the volumes are "
        "apart.");
  CHECK(said.back() == "Apart: along x+y there is a gap of 0.283.");
  CHECK(figure(apart, "slabs") == 3);

  Session overlap = opened("slabs_then_gjk",
                           "a = { kdop = { k = 8, min = [-1.9, -1.3, -2.5, -1.7], max = [-0.2, 0.9, 0.2, 0.2] } }\n"
                           "b = { kdop = { k = 8, min = [-1.0, -0.2, -0.4, -1.5], max = [0.7, 1.2, 1.4, 0.2] } }\n");
  const std::vector<std::string> all = sentences(overlap);
  CHECK(all[all.size() - 2] == "The simplex contains the origin: the volumes have a point in common.");
  CHECK(figure(overlap, "slabs") == 4);
  CHECK(figure(overlap, "tests") == 7);  // with GJK's simplices
  CHECK_FALSE(figure(overlap, "radii"));
}

TEST_CASE("a slider of an oriented box's turn stands where the box does, and follows its knob") {
  Session session =
      opened("separating_axes", "a = { obb = { center = [0, 0], half_extents = [1, 0.5], turn = [10] } }\n"
                                "b = { obb = { center = [3, 0], half_extents = [1, 0.5], turn = [35] } }\n");
  const std::unique_ptr<Subject> subject = session.stage().subject().clone();
  const auto turn_of_a = [&] {
    for (const Drive& drive : subject->drives())
      if (drive.name == "A turn") return drive.now.value_or(0);
    return 0.0;
  };
  CHECK(turn_of_a() == doctest::Approx(10));
  REQUIRE(subject->drive("A turn", 10, 40).has_value());
  CHECK(turn_of_a() == doctest::Approx(40));
}
