// Questions on a trace: where each stands, what may be answered, whether an answer is right, and what is said then.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "fit/catalogue.hpp"
#include "lesson/lesson.hpp"

namespace snug::lesson {

using Trace = std::span<const Recorder<fit::Step3>::Entry>;

/// An answer to a question: a point of the stage, or one of the question's choices.
struct Answer {
  enum class Kind { kPoint, kChoice, kSkipped } kind = Kind::kSkipped;
  int value = 0;  // the point's index, or the choice counted from 0
};

/// A question as it is asked now, with the choices worked out from the trace.
struct Asked {
  const Question* question = nullptr;
  std::string prompt;  // in the words of the points' dimension: a circle in space is a sphere
  std::string because;
  int dim = 2;
  bool boxes = false;  // whether the points are places of two boxes, or of a box and a frustum
  bool frustum = false;
  int step = 0;                      // the player's place where it stands
  std::vector<std::string> choices;  // what may be chosen; empty where only the stage answers
  std::vector<Index> choice_points;  // the point that each choice names, or kNoIndex
  bool on_stage = false;             // whether a click on a point answers
  bool many = false;                 // whether several choices together are an answer: its value's bits
  bool on_axes = false;              // whether the choices are the axes of the test, in their order, and then none
  std::vector<Index> stage_points;   // the handles that a tap can mean; empty where every point can be meant
  int fact = 0;                      // which step of the trace it speaks of, counted from 0
  int until = 0;                     // the player's place where it is decided: answering goes there
};

/// What happened, beside what was predicted.
struct Outcome {
  std::string question;  // its id
  Answer given;
  int from_step = 0;  // where it was asked, and
  int step = 0;       // where it was decided: what lies between shows how it came about
  bool right = false;
  bool skipped = false;
  bool pending = false;   // not decided yet: of the chart, which has to be measured first
  bool passed = false;    // skipped by a jump: it is asked when the player comes to it again
  std::string predicted;  // "P9", "yes", "the x pair", or "the x pair (P9)" where the point was tapped
  std::string happened;   // the same in fact: "P12", "the y pair"
  std::string says;       // that in a sentence: "P12 left the support set."
  std::string because;
};

/// "P9": how a point is called, everywhere.
[[nodiscard]] std::string point_name(Index i);

/// The question's prompt and reason; own_run: those that hold on the lesson's own run alone, where it has such.
void put_words(Asked& asked, bool own_run);

/// The questions of that algorithm that this trace has the gates of, in the timeline's order. One that stands where
/// another is still open is left out. own_run: whether the trace is of the lesson's own points, boxes or scene.
[[nodiscard]] std::vector<Asked> asked_on(const Lesson& lesson, std::string_view algorithm, Trace trace, int dim,
                                          bool own_run);

/// volume: the lesson's; the words are the general ones. Where one question stands on a trace; nothing where the trace
/// does not have its step, or the step cannot be asked that: why says it in one fragment then. Of boundary_forced and
/// moved_to_front only the outermost count, at which a point lies outside the smallest ball of all before it; "leaves"
/// and "grows" of it are decided when that point is in.
[[nodiscard]] std::optional<Asked> resolve(const Question& question, std::string_view volume, Trace trace, int dim,
                                           std::string& why);

/// Whether that is an answer to it at all: a choice in range, a point that it can mean. points: how many there are.
[[nodiscard]] bool answers(const Asked& asked, const Answer& answer, Index points);

/// Whether both say the same: a choice that names a point says what a tap on it does.
[[nodiscard]] bool same_answer(const Asked& asked, const Answer& a, const Answer& b);
/// Whether a choice is (of many: is among) what was picked.
[[nodiscard]] bool is_picked(const Asked& asked, const Answer& picked, int choice);

/// The outcome of an answer, which answers it (or is skipped).
[[nodiscard]] Outcome judge(const Asked& asked, const Answer& answer, Trace trace);

/// An answer that is right.
[[nodiscard]] Answer model_answer(const Asked& asked, Trace trace);

/// The points that a step speaks of, any of which is a right answer to "which point":
/// the extremes of extremes_found, both of pair_chosen, the point of farthest_found, point_examined, ball_grown and
/// moved_to_front, the one entered of support_replaced, the last one forced of boundary_forced, the farthest of
/// radius_checked, the one left outside by a candidate_tried or else its points, the support of finished, both ends of
/// each axis of extents_found, the vertices of hull_found, the points of points_chosen, the ends of the edge of
/// rectangle_found and edge_searched, the corners of B that come nearest to A of axis_tested, the one of corner_tried
/// and corner_tested, the p- and the n-vertex of plane_tested, the point or the points of box_widened, line_found,
/// end_pulled_in, thickness_found, side_pulled_in, corner_moved_out, slab_found, simplex_chosen, flat_found,
/// eye_chosen, edge_split and horizon_found. No others.
[[nodiscard]] std::vector<Index> points_named(const fit::Step3& step, int dim);

/// The points that hold the volume after the first so many steps: those that it touches by construction.
[[nodiscard]] std::vector<Index> support_after(Trace trace, int steps);

}  // namespace snug::lesson
