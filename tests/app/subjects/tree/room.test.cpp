// The room that is framed for the volumes of a tree.
#include "../every_step.hpp"
#include "app/subjects/tree/draw.hpp"

namespace snug::app {
namespace {

constexpr double kRounding = 1e-12;  // of sums of coordinates as large as these

}  // namespace

TEST_CASE("merged volumes are framed whole") {
  for (const char* const way : {"merge_aabb", "merge_sphere", "merge_obb"}) {
    CAPTURE(way);
    lesson::Session session = lesson_session("bvh-merge", false);
    REQUIRE(session.player().choose(0, way).has_value());
    const lesson::Box2 room = stage_room(session);
    for (const fit::Volume3& volume : lesson::tree_run(session.player().run(0)).volumes().merged)
      if (const auto* circle = std::get_if<fit::Sphere3>(&volume)) {
        const lesson::Point2 center = circle->center.head<2>(), half = lesson::Point2::Constant(circle->radius);
        CHECK((center - half - room.min).minCoeff() >= -kRounding);
        CHECK((room.max - center - half).minCoeff() >= -kRounding);
      }
  }
}

}  // namespace snug::app
