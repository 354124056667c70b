// At every step of the lessons on two boxes and on a box and a frustum, stage, sentence, figures, table and code speak
// of the same axis or plane.
#include <doctest/doctest.h>

#include <fstream>
#include <string>

#include "app/axis_table.hpp"
#include "app/captions.hpp"
#include "app/shown.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"

namespace snug::app {
namespace {

lesson::Session session_of(const std::string& id, bool asks) {
  std::ifstream file(std::string(SNUG_SOURCE_DIR) + "/lessons/" + id + ".toml", std::ios::binary);
  const std::string toml{std::istreambuf_iterator<char>(file), {}};
  auto lesson = lesson::read_lesson(toml, id + ".toml", lesson::Checked::kAsWritten);
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  if (!asks) lesson->questions.clear();
  return *lesson::Session::open(*std::move(lesson));
}

/// "—" where there is none.
std::string figure(const lesson::Session& session, std::string_view key) {
  for (const lesson::Figure& figure : session.figures())
    if (figure.key == key) return figure.text;
  return "—";
}

/// The axis that a sentence names, or "—".
std::string axis_in(const std::string& caption, int dim) {
  std::string found = "—";
  for (const lesson::AxisName& name : lesson::axis_names(dim))  // the edges' names, which hold the faces', come last
    if (caption.find("long " + name.text + " ") != std::string::npos ||
        caption.find("long " + name.text + ",") != std::string::npos)
      found = name.text;
  return found;
}

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

std::string code_at(const lesson::Session& session) {
  const auto* entry = session.current(0);
  return entry == nullptr ? "" : std::string(session.pseudocode(0)[entry->step.line]);
}

/// Lessons with every method, on the boxes as they stand, scattered, and thrown into each other.
template <class Check>
void at_every_step(const char* id, Check check) {
  for (int seed = 0; seed < 6; ++seed) {
    lesson::Session session = session_of(id, false);
    if (seed > 0) session.scatter(static_cast<std::uint64_t>(seed));
    if (seed == 5) {
      lesson::BoxPair pair = *session.boxes();
      pair.boxes[0].center = pair.boxes[1].center;
      REQUIRE(session.set_boxes(pair).has_value());
    }
    for (const std::string& method : session.lesson().algorithms) {
      CAPTURE(id);
      CAPTURE(seed);
      CAPTURE(method);
      REQUIRE(session.choose(0, method).has_value());
      for (int step = 0; step <= session.steps(); ++step) {
        session.jump(step);
        CAPTURE(step);
        CAPTURE(caption_at(session));
        check(session, shown_at(session, false));
      }
    }
  }
}

}  // namespace

TEST_CASE("the axis on the stage is the one in the sentence, in the figures, in the lit row and in the code") {
  int verdicts_with_axis = 0;
  for (const char* id : {"obb-sat", "obb-axes"})
    at_every_step(id, [&](const lesson::Session& session, const Shown& shown) {
      const int dim = session.dim();
      const std::string staged = shown.axis ? lesson::axis_text(dim, shown.axis->axis) : "—";
      const std::string caption = caption_at(session);
      const bool axes = session.algorithm(0)->name.substr(0, 3) == "sat";
      if (axes) REQUIRE(axis_in(caption, dim) == staged);
      REQUIRE((axes ? figure(session, "axis") : "—") == staged);
      const int row = lit_row(session);
      REQUIRE((row < 0 ? "—" : lesson::axis_names(dim)[row].text) == staged);
      if (!shown.axis) return;
      if (session.step() == session.steps()) ++verdicts_with_axis;
      if (!shown.axis->skipped) {
        REQUIRE(figure(session, "distance") == lesson::number_text(shown.axis->distance) + " units");
        REQUIRE(caption.find(shown.overlap ? lesson::number_text(std::abs(shown.axis->axis.gap))
                                           : lesson::number_text(shown.axis->distance)) != std::string::npos);
      }
      if (session.step() < session.steps())
        REQUIRE(code_at(session).find(shown.axis->skipped ? "parallel" : "distance > r_A + r_B") != std::string::npos);
    });
  CHECK(verdicts_with_axis > 6);
}

TEST_CASE("the plane on the stage is the one in the sentence and in the figures") {
  int with_plane = 0, without = 0;
  for (const char* id : {"frustum-2d", "frustum-3d"})
    at_every_step(id, [&](const lesson::Session& session, const Shown& shown) {
      const std::string staged = shown.plane_at < 0 ? "—" : lesson::plane_name(session.dim(), shown.plane_at);
      if (session.step() > 0) REQUIRE(plane_in(caption_at(session), session.dim()) == staged);
      REQUIRE(figure(session, "plane") == staged);
      if (shown.plane) REQUIRE(shown.plane->plane == shown.plane_at);
      if (!shown.finished)
        for (const auto& corner : shown.corners)
          if (session.algorithm(0)->name == "corners_per_plane") REQUIRE(corner.plane == shown.plane_at);
      ++(shown.plane_at < 0 ? without : with_plane);
    });
  CHECK(with_plane > 50);
  CHECK(without > 10);
}

TEST_CASE("a question about an axis shows its direction, and what the step has shown stays") {
  lesson::Session session = session_of("obb-sat", true);
  session.go(1);
  REQUIRE(session.asked() != nullptr);
  Shown shown = shown_at(session, false);
  REQUIRE(shown.axis_asked);
  CHECK(lesson::axis_text(2, shown.axis_asked->axis) == "A x");
  CHECK_FALSE(shown.axis);
  REQUIRE(session.answer(lesson::model_answer(*session.asked(), session.recording(0).steps)));
  shown = shown_at(session, false);
  REQUIRE(shown.axis_asked);
  CHECK(lesson::axis_text(2, shown.axis_asked->axis) == "A y");
  REQUIRE(shown.axis);
  CHECK(lesson::axis_text(2, shown.axis->axis) == "A x");
}

}  // namespace snug::app
