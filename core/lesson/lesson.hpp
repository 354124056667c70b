// A lesson as its TOML file says it. The format is documented in lessons/README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"
#include "lesson/boxes.hpp"
#include "lesson/scene_set.hpp"

namespace snug::lesson {

/// A stretch of prose; strong where the file says **so**: a term where it first stands.
struct Stretch {
  std::string text;
  bool strong = false;
};
using Paragraph = std::vector<Stretch>;

struct Section {
  std::string title;
  std::vector<Paragraph> paragraphs;
};

/// Where the points come from: exactly one of a generator, a mesh by name, or a list.
struct Points {
  int dim = 2;
  std::string generate;  // a kind of snug::generate: "gaussian", "clusters" …
  int count = 0;         // of generated points
  std::string mesh;      // one of mesh_names(): loaded by the door that runs the lesson
  std::vector<Vector<double, 3>> list;
};

/// The meshes that every door has: "bunny", "teapot", "dragon".
[[nodiscard]] const std::vector<std::string>& mesh_names();

/// What a question speaks of: the n-th step of that name, counted from 1, in the algorithm's trace. The question stands
/// just before it; or, where after is given, right after the last step of that name before it, or the one that
/// after_nth counts, so that what leads to the answer is not shown yet (the next growth, asked right after the last
/// one).
struct Gate {
  std::string algorithm;
  std::string fact;  // as fit::fact_names() has it: "pair_chosen"
  int occurrence = 1;
  std::string after;  // a fact's name, kStart for the beginning, or empty
  int after_nth = 0;  // counted from 1; 0: the last one
  static constexpr std::string_view kStart = "start";
};

struct Question {
  enum class Asks {
    kPoint,   // which point the step speaks of: answered on the stage
    kAxis,    // of pair_chosen: which pair of extremes; the choices are the axes, or one of the pair's points
    kGrows,   // whether the radius is larger after the step than where the question stands: yes or no
    kLeaves,  // of support_replaced or boundary_forced: which point leaves the support; the choices are its points and
              // none
    kChoice,  // one of the choices that the file gives
    kBetter,  // of pass_judged or candidate_tried: whether the ball becomes the best so far: yes or no
    kHolds,   // of finished: how many points hold the ball; the choices are 1 to Dim + 1
    kSeparates,  // of axis_tested: whether the boxes are apart along it: yes or no
    kWhichAxis,  // of verdict: which axis separates the boxes; the choices are the test's axes and none
    kPVertex,  // of plane_tested: which corner of the box is farthest along the plane's normal; on the stage, or by its
    kNVertex,  // signs; and which against it
    kPlaneSide,    // of plane_tested: on which side of the plane the box is; the choices are query::kCullingNames
    kVerdict,      // of classified: where the box is, of the frustum; the same choices
    kFigure,       // of frame_taken: between which bounds a figure of the scene lies; the choices are the ranges
    kOnFront,      // of the chart: which algorithms no other undercuts; any number of them
    kSlowest,      // of the chart: which algorithm takes longest
    kTimesSlower,  // of the chart: how many times as long the slowest takes as the fastest; the choices are decades
  };
  std::string id;
  Gate gate;
  Asks asks = Asks::kPoint;
  std::string prompt;
  std::vector<std::string> choices;  // of kChoice
  int answer = 0;                    // of kChoice, counted from 0
  std::string figure;                // of kFigure: one of scene_figure_names()
  std::vector<double> bounds;        // of kFigure, rising: up to the first, up to the second … and more
  bool own_points = false;           // asked only on the lesson's own points: the answer is true of those alone
  std::string because;               // shown with what happened, right or wrong
  std::string prompt_here;           // in the prompt's place while the run is the lesson's own; empty for none
  std::string because_here;          // the same of because
  int line = 0;                      // of the file, for errors
};

/// "Make it fail" or "construct it": graded on the points as they stand.
struct Task {
  std::string prompt;
  std::string volume = "sphere";  // the lesson's
  std::string algorithm;          // whose volume is compared with the smallest
  double excess_at_least = 0;     // its size / the smallest - 1: of balls the radius, of others the area or volume
  int support_size = 0;           // how many points must hold the smallest ball; 0 where the task does not say
  int points = 0;                 // how many points there must be; of the chart, how many it begins with
  double tighter_by = 0;          // of the chart: what is to be found is smaller than algorithm's by such a share
  std::string hint;
  std::vector<Vector<double, 3>> model;  // a solution, which the checks play

  /// For two boxes, reached one after the other: "extents_only", "corners_only": a place where that test is wrong;
  /// "only_edges", "last_axis": where edge axes alone, or the last axis alone, separate the boxes. For a box and a
  /// frustum, "corners_outside": where that test loses a box that shares a point with the frustum.
  std::vector<std::string> goals;
  std::vector<BoxPair> models;  // one a goal

  /// What a figure of the scene's last frame must come to.
  struct Requirement {
    std::string figure;  // of scene_figure_names()
    static constexpr double kNoMost = 1e300;
    double at_least = 0, at_most = kNoMost;
  };
  std::vector<Requirement> requirements;
};

/// An algorithm's pseudocode in the lesson's own words; as many lines as the catalogue's.
struct Pseudocode {
  std::string algorithm;
  std::vector<std::string> lines;
};

struct Lesson {
  /// What stands on the stage when the lesson opens.
  enum class Start {
    kBegin,  // the points alone, before the first step
    kEnd,    // the result: see Session::previewing
  };
  std::string id;     // the file's name without .toml
  std::string group;  // "Spheres"
  std::string title;
  std::string summary;              // one sentence
  int order = 0;                    // among all lessons
  std::vector<std::string> covers;  // "lecture title: slide title", what of the lectures it stands for
  std::vector<Section> sections;
  Points points;
  std::optional<BoxPair> boxes;         // of volumes kBoxPair and kFrustumBox, which have no points
  std::optional<SceneSet> scene;        // of volume kScene: what moves, made of the points
  std::vector<std::string> meshes;      // which the student may load instead
  std::vector<std::string> generators;  // which the student may scatter by instead
  bool measures = false;  // whether the stage has the chart of costs, which all questions and the task are of
  std::uint64_t seed = 1;
  Start start = Start::kBegin;
  std::string volume = "sphere";        // of kVolumeNames: what the algorithms fit
  std::vector<std::string> algorithms;  // offered, in this order; the first is shown at the start
  std::string compare;                  // a second one beside it from the start; empty for none
  std::vector<Pseudocode> pseudocode;   // where the lesson has its own
  std::vector<Question> questions;
  std::optional<Task> task;
};

/// A lesson file's size, bytes: fifty times a long lesson's. The parser's tables within tables, a level for two bytes,
/// must not outgrow the stack.
inline constexpr std::size_t kMostLessonBytes = 1 << 18;

/// How far a lesson is checked: by what its file says alone, or by all that comes of running it, which may take
/// seconds.
enum class Checked : std::uint8_t { kAsWritten, kAsRun };

/// Reads a lesson file. name: for errors and for the id. Errors: of TOML, of an unknown or missing key, of an
/// algorithm, fact, generator, mesh or answer that does not exist; where it is run, of a question whose step the
/// algorithm does not take on the lesson's own points, of a model solution that the task does not accept; each with its
/// line.
[[nodiscard]] tl::expected<Lesson, InputError> read_lesson(std::string_view toml, std::string_view name,
                                                           Checked checked = Checked::kAsRun);

}  // namespace snug::lesson
