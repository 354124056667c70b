// The drawing of a field follows its camera, and its panel measures one method in a frame, once nothing moves.
#include "app/subjects/field/draw.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

namespace snug::app {
namespace {

lesson::Session field_on_stage() {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = lesson::kFrustumField;
  auto tables = std::make_shared<lesson::FieldTables>();
  tables->stage.recipe.objects = 100;
  tables->stage.now = tables->stage.before = {{-30, 8, 10}, {0, 6, 0}};
  lesson.tables = std::move(tables);
  for (const lesson::Method& method : lesson::field_methods()) lesson.algorithms.emplace_back(method.name);
  return *lesson::Session::open(std::move(lesson));
}

const lesson::FieldStage& stage_of(const lesson::Session& session) {
  return lesson::as<lesson::FieldSubject>(session.stage().subject())->stage();
}

}  // namespace

TEST_CASE("the drawn sides of a frustum lie on its planes, and its faces are seen from outside") {
  const lesson::Session session = field_on_stage();
  const auto& stage = stage_of(session);
  const auto solid = frustum_solid(stage.recipe, stage.now);
  REQUIRE(solid.has_value());
  const auto frustum = lesson::frustum_of(stage.recipe, stage.now)->normalized();
  Point3 middle = Point3::Zero();
  for (const Point3& corner : solid->corners) middle += corner / 8;
  for (int plane = 0; plane < 6; ++plane) {
    CAPTURE(plane);
    const int axis = plane / 2;
    const bool positive = axis == 2 ? plane == 4 : plane % 2 == 1;
    const auto& face = solid->faces[2 * axis + (positive ? 0 : 1)];
    REQUIRE(face.size() == 4);
    const auto at = [&](std::size_t k) { return solid->corners[face[k]]; };
    for (std::size_t k = 0; k < 4; ++k) CHECK(std::abs(signed_distance(frustum[plane], at(k))) < 1e-9);
    const Point3 normal = (at(1) - at(0)).cross(at(2) - at(1));
    CHECK(normal.dot(at(0) - middle) > 0);
  }
}

TEST_CASE("one method is measured in a frame, none while the stage changes, and none twice") {
  lesson::Session session = field_on_stage();
  FieldCosts costs;
  const auto measured = [&] {
    int count = 0;
    for (const lesson::Method& method : lesson::field_methods()) {
      const FieldCosts::Entry* entry = costs.of(method);
      count += entry != nullptr && costs.is_of_now(*entry);
    }
    return count;
  };
  costs.measure(session);
  CHECK(measured() == 0);
  CHECK(costs.working());
  for (int frame = 1; frame <= 6; ++frame) {
    costs.measure(session);
    CHECK(measured() == frame);
  }
  costs.measure(session);
  CHECK_FALSE(costs.working());
  session.go(2);
  costs.measure(session);
  CHECK(measured() == 6);
  REQUIRE(session.stage().move(1, Point3(0, 6, 2)).has_value());
  costs.measure(session);
  CHECK(measured() == 0);
  CHECK(costs.of(lesson::field_methods()[0]) != nullptr);
  CHECK(costs.working());
}

}  // namespace snug::app
