// A lesson as its TOML file says it. The format is documented in lessons/README.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"

namespace snug::lesson {

struct SubjectRow;

/// Where words of the prose lead: they do something, or light a mark on the stage.
struct Link {
  enum class Kind : std::uint8_t { kLesson, kMesh, kAlgorithm, kStep, kMark } kind;
  std::string target;  // a lesson's id, a mesh, an algorithm, a step's number; of a mark: see marked_handles
};

/// A stretch of prose; strong where the file says **so**: a term where it first stands.
struct Stretch {
  std::string text;  // of a formula, the formula in one line of Unicode
  bool strong = false;
  std::optional<Link> link = {};
  std::string tex = {};  // of a formula
};
using Paragraph = std::vector<Stretch>;

struct Section {
  std::string title;
  std::vector<Paragraph> paragraphs;
  std::vector<std::string> facts;  // whose steps it speaks of
  std::string algorithm;           // of which alone; empty for all
  int line = 0;                    // of its text in the file, for errors
};

/// Where the points of a subject that is made of points come from: exactly one of a generator, a mesh by name, or a
/// list.
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
  std::string fact;  // its name: "pair_chosen"
  int occurrence = 1;
  std::string after;  // a fact's name, kStart for the beginning, or empty
  int after_nth = 0;  // counted from 1; 0: the last one
  static constexpr std::string_view kStart = "start";
};

struct Question {
  std::string id;
  Gate gate;
  std::string asks = "point";  // "point", "choice", or what its subject's facts can be asked
  std::string prompt;
  std::vector<std::string> choices;  // of "choice"
  int answer = 0;                    // of "choice", counted from 0
  std::string figure;                // of "figure": its key, and
  std::vector<double> bounds;        // rising: up to the first, up to the second … and more
  bool own_points = false;           // asked only on the lesson's own points: the answer is true of those alone
  std::string because;               // shown with what happened, right or wrong
  std::string prompt_here;           // in the prompt's place while the run is the lesson's own; empty for none
  std::string because_here;          // the same of because
  std::string section;               // the title of the one that it is about; empty: the one that names its fact
  int line = 0;                      // of the file, for errors
};

/// What only a lesson's subject knows of its tables, or of its task: each has its own.
struct Tables {
  virtual ~Tables() = default;
};

/// "Make it fail" or "construct it": graded on what stands on the stage.
struct Task {
  std::string prompt;
  std::string algorithm;  // whose result is looked at
  int points = 0;         // how many it begins with; 0: as the lesson does
  std::string hint;
  std::vector<Vector<double, 3>> model;  // a solution, which the checks play, of a task on points
  std::shared_ptr<const Tables> terms;   // what it asks for
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
  std::string id;  // the file's name without .toml
  std::string title;
  std::string summary;              // one sentence
  int minutes = 0;                  // that it takes, about
  std::vector<std::string> covers;  // "lecture title: slide title", what of the lectures it stands for
  std::vector<Section> sections;
  Points points;
  const SubjectRow* subject = nullptr;   // what the stage is about; null: what the volume says
  std::shared_ptr<const Tables> tables;  // of the subject; null where it has none beside the points
  std::vector<std::string> meshes;       // which the student may load instead
  std::vector<std::string> generators;   // which the student may scatter by instead
  std::uint64_t seed = 1;
  Start start = Start::kBegin;
  std::string volume = "sphere";        // what the methods are of: one of kVolumeNames, or a subject's own word
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
