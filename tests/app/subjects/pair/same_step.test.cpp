// At every step of the lessons on two boxes, stage, sentence, figures, table and code speak of the same axis.
#include "../every_step.hpp"
#include "app/subjects/pair/axis_table.hpp"
#include "app/subjects/pair/shown.hpp"
#include "lesson/subjects/pair/box_figures.hpp"

namespace snug::app {
namespace {

/// The axis that a sentence names, or "—".
std::string axis_in(const std::string& caption, int dim) {
  std::string found = "—";
  for (const lesson::AxisName& name : lesson::axis_names(dim))  // the edges' names, which hold the faces', come last
    if (caption.find("long " + name.text + " ") != std::string::npos ||
        caption.find("long " + name.text + ",") != std::string::npos)
      found = name.text;
  return found;
}

std::string code_at(const lesson::Session& session) {
  return session.player().line() < 0 ? "" : std::string(session.player().pseudocode(0)[session.player().line()]);
}

}  // namespace

TEST_CASE("the axis on the stage is the one in the sentence, in the figures, in the lit row and in the code") {
  int verdicts_with_axis = 0;
  for (const char* id : {"obb-sat", "obb-axes"})
    at_every_step(id, [&](const lesson::Session& session) {
      const PairShown shown = pair_shown_at(session);
      const int dim = session.stage().subject().dim();
      const std::string staged = shown.axis ? lesson::axis_text(dim, shown.axis->axis) : "—";
      const std::string caption = session.telling().caption();
      const bool axes = !lesson::axes_seen(lesson::pair_run(session.player().run(0)).trace()).empty();
      if (axes) REQUIRE(axis_in(caption, dim) == staged);
      REQUIRE((axes ? figure(session, "axis") : "—") == staged);
      const int row = lit_row(session);
      REQUIRE((row < 0 ? "—" : lesson::axis_names(dim)[row].text) == staged);
      if (!shown.axis) return;
      if (session.player().step() == session.player().steps()) ++verdicts_with_axis;
      if (!shown.axis->skipped) {
        REQUIRE(figure(session, "distance") == lesson::number_text(shown.axis->distance) + " units");
        REQUIRE(caption.find(shown.finished ? lesson::number_text(std::abs(shown.axis->axis.gap))
                                            : lesson::number_text(shown.axis->distance)) != std::string::npos);
      }
      if (session.player().step() < session.player().steps())
        REQUIRE(code_at(session).find(shown.axis->skipped ? "parallel" : "distance > r_A + r_B") != std::string::npos);
    });
  CHECK(verdicts_with_axis > 6);
}

TEST_CASE("a question about an axis shows its direction, and what the step has shown stays") {
  lesson::Session session = lesson_session("obb-sat", true);
  session.go(1);
  REQUIRE(session.conversation().asked() != nullptr);
  PairShown shown = pair_shown_at(session);
  REQUIRE(shown.axis_asked);
  CHECK(lesson::axis_text(2, shown.axis_asked->axis) == "A x");
  CHECK_FALSE(shown.axis);
  REQUIRE(session.conversation().give(lesson::model_answer(*session.conversation().asked(), session.player().run(0))));
  session.conversation().acknowledge();
  shown = pair_shown_at(session);
  REQUIRE(shown.axis_asked);
  CHECK(lesson::axis_text(2, shown.axis_asked->axis) == "A y");
  REQUIRE(shown.axis);
  CHECK(lesson::axis_text(2, shown.axis->axis) == "A x");
}

TEST_CASE("a bound that a sentence of GJK gives is the one in the figures, or is said to be weaker") {
  lesson::Session session = lesson_session("overlap-any", false);
  const std::string bounds = " are at least ", weaker = "weaker than the one so far, ";
  int new_ones = 0, weaker_ones = 0;
  for (int step = 1; step < session.player().steps(); ++step) {
    session.jump(step);
    const std::string caption = session.telling().caption(), lower = figure(session, "lower");
    CAPTURE(caption);
    const std::string number = lower.substr(0, lower.find(' '));
    if (caption.find(bounds) != std::string::npos) {
      ++new_ones;
      CHECK(caption.find(bounds + number + " apart.") != std::string::npos);
    }
    if (caption.find(weaker) != std::string::npos) {
      ++weaker_ones;
      CHECK(caption.find(weaker + number + ".") != std::string::npos);
    }
  }
  CHECK(new_ones == 3);
  CHECK(weaker_ones == 1);
}

}  // namespace snug::app
