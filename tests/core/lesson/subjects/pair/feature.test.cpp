// Which feature of a rectangle is nearest: placed where the answer is known.
#include "lesson/subjects/pair/feature.hpp"

#include <doctest/doctest.h>

#include "core/lesson/small_lesson.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

using FeatureKind = RectangleFeature::Kind;

const Lozenge<double, 3> kSquare{{-1, -1, 0}, {Point3(2, 0, 0), Point3(0, 2, 0)}, 0.1};

/// A lesson with a sphere over the square, or beside it in the plane.
Session session_at(const std::string& center, int dim = 3) {
  const std::string z = dim == 3 ? ", 0" : "";
  return test::open("version = 2\ntitle = \"F\"\nsummary = \"F.\"\nminutes = 1\nvolume = \"volume_pair\"\n"
                    "algorithms = [\"swept_spheres\"]\n[volumes]\ndim = " +
                    std::to_string(dim) + "\na = { sphere = { center = " + center +
                    ", radius = 0.1 } }\nb = { lozenge = { origin = [-1, -1" + z + "], edges = [[2, 0" + z +
                    "], [0, 2" + z +
                    "]], radius = 0.1 } }\n[[section]]\ntitle = \"S\"\ntext = \"T.\"\n"
                    "[[question]]\nid = \"f\"\nalgorithm = \"swept_spheres\"\nbefore = \"cores_compared\"\n"
                    "asks = \"feature\"\nprompt = \"Which?\"\nbecause = \"So.\"\n");
}

std::string right_answer(const std::string& center, int dim = 3) {
  Session session = session_at(center, dim);
  session.go(0);
  REQUIRE(session.conversation().asked() != nullptr);
  const Answer answer = model_answer(*session.conversation().asked(), session.player().run(0));
  return session.conversation().asked()->choices[std::get<OneChoice>(answer).choice];
}

}  // namespace

TEST_CASE("a point of a rectangle lies on a vertex, on an edge or inside the face") {
  CHECK(feature_at(kSquare, {0.2, 0.3, 0}).kind == FeatureKind::kFace);
  const RectangleFeature edge = feature_at(kSquare, {1, 0.3, 0});
  REQUIRE(edge.kind == FeatureKind::kEdge);
  CHECK(edge.corners == std::vector<Point3>{{1, -1, 0}, {1, 1, 0}});
  const RectangleFeature vertex = feature_at(kSquare, {-1, 1, 0});
  REQUIRE(vertex.kind == FeatureKind::kVertex);
  CHECK(vertex.corners == std::vector<Point3>{{-1, 1, 0}});
  CHECK(feature_at(kSquare, {0, 0, 0}).corners == std::vector<Point3>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
}

TEST_CASE("the nearest feature is asked for, and follows the sphere") {
  CHECK(right_answer("[0.2, 0.1, 3]") == "the face");
  CHECK(right_answer("[0.2, 3, 3]") == "an edge");
  CHECK(right_answer("[4, 3, 3]") == "a vertex");
  CHECK(right_answer("[0.2, 3]", 2) == "an edge");
  CHECK(right_answer("[4, 3]", 2) == "a vertex");
}
