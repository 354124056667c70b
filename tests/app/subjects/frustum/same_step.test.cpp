// At every step of the lessons on a box and a frustum, stage, sentence and figures speak of the same plane.
#include "../../bench.hpp"
#include "../every_step.hpp"
#include "app/subjects/frustum/shown.hpp"

namespace snug::app {
namespace {

/// The plane that a sentence names alone, or "—": several are those that the box crosses.
std::string plane_in(const std::string& caption, int dim) {
  if (caption.find("crosses the") != std::string::npos && caption.find("Intersecting") == 0) return "—";
  for (int plane = 0; plane < lesson::planes_of_frustum(dim); ++plane) {
    std::string name = lesson::plane_name(dim, plane) + " plane";
    if (caption.find(name) != std::string::npos) return lesson::plane_name(dim, plane);
    name.front() = static_cast<char>(std::toupper(name.front()));
    if (caption.find(name) != std::string::npos) return lesson::plane_name(dim, plane);
  }
  return "—";
}

}  // namespace

TEST_CASE("the plane on the stage is the one in the sentence and in the figures") {
  int with_plane = 0, without = 0;
  for (const char* id : {"frustum-2d", "frustum-3d"})
    at_every_step(id, [&](const lesson::Session& session) {
      const FrustumShown shown = frustum_shown_at(session);
      const std::string staged =
          shown.plane_at < 0 ? "—" : lesson::plane_name(session.stage().subject().dim(), shown.plane_at);
      if (session.player().step() > 0)
        REQUIRE(plane_in(session.telling().caption(), session.stage().subject().dim()) == staged);
      REQUIRE(figure(session, "plane") == staged);
      if (shown.plane) REQUIRE(shown.plane->plane == shown.plane_at);
      if (!shown.finished)
        for (const auto& corner : shown.corners)
          if (session.player().method(0)->name == "corners_per_plane") REQUIRE(corner.plane == shown.plane_at);
      ++(shown.plane_at < 0 ? without : with_plane);
    });
  CHECK(with_plane > 50);
  CHECK(without > 10);
}

TEST_CASE("knobs that a task forbids are not drawn") {
  const auto drawn = [](bool forbids) {
    lesson::Lesson lesson = course_lesson("frustum-sphere", false);
    REQUIRE_FALSE(lesson.tasks.at(0).only.empty());
    if (!forbids) lesson.tasks[0].only.clear();
    Bench bench(std::move(lesson));
    bench.session().stage().start_task(0);
    bench.frames(3);
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  CHECK(drawn(true) < drawn(false));
}

}  // namespace snug::app
