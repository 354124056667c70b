// A lesson, as in its TOML file. The format is documented in lessons/README.md.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"
#include "lesson/file_place.hpp"
#include "lesson/view.hpp"

namespace snug::io {
struct PointFile;
}

namespace snug::lesson {

struct SubjectRow;
struct Beside;

/// The target of a link in the prose: an action, or a mark on the stage that lights up.
struct Link {
  enum class Kind : std::uint8_t { kLesson, kMesh, kAlgorithm, kStep, kMark, kSituation } kind;
  std::string target;  // a lesson's id, a mesh, an algorithm, a step's number, a mark (see marked_handles), a situation
};

/// A figure of the run within a text: {radius}, {excess kdop/k8}, {count after_broad}.
struct RunFigure {
  std::string key;        // as figures have it
  std::string algorithm;  // the lesson's name of one, at the end of its run; empty: the one on the stage, at its step
  bool count = false;     // only its number, without the unit
  friend bool operator==(const RunFigure&, const RunFigure&) = default;
};

/// A stretch of prose, as the file marks it: **strong**, as a term at its first use, *emphasised*, `code`.
struct Stretch {
  enum class Script : std::uint8_t { kNone, kLow, kHigh };
  std::string text;  // for a formula: one line of Unicode; for a figure: kHiddenFigure (prose.hpp)
  bool strong = false;
  std::optional<Link> link = {};
  std::string tex = {};  // only for a formula
  bool emphasis = false, code = false;
  Script script = Script::kNone;
  std::optional<RunFigure> figure = {};
  std::size_t at = 0;  // where it begins in the text that was read
  int sentence = -1;   // which one of a paragraph with figures it belongs to; elsewhere -1
};
using Paragraph = std::vector<Stretch>;

/// A paragraph of the prose, a list or a table: a paragraph is one cell, a list has a row of one cell for each item,
/// and the first row of a table is its head.
struct Block {
  enum class Kind : std::uint8_t { kParagraph, kBullets, kNumbers, kTable } kind = Kind::kParagraph;
  std::vector<std::vector<Paragraph>> rows;
  std::vector<bool> right = {};  // of a table: for each column whether it is flush right
};

struct Section {
  std::string title;
  std::vector<Block> blocks;
  std::vector<std::string> facts;  // the facts whose steps it is about
  std::string algorithm;           // only in the run of this one; empty for all
  std::string situation;           // which one it is about; empty for any
  FilePlace place;                 // where its text begins in the file, for errors
};

/// Where a lesson's points come from: exactly one of a generator, a mesh by name, or a
/// list.
struct Points {
  int dim = 2;
  std::string generate;  // a kind of snug::generate: "gaussian", "clusters" …
  int count = 0;         // how many are generated
  std::string mesh;      // one of mesh_names(): the page or the window loads it
  std::vector<Vector<double, 3>> list;
  bool in_float = false;  // whether they are rounded to float, and the runs computed in it
};

/// The name of the lesson's own situation, which its own tables describe.
inline constexpr std::string_view kOwnSituation = "own";

/// The available meshes: "bunny", "teapot", "dragon".
[[nodiscard]] const std::vector<std::string>& mesh_names();

/// The step that a question is about: the n-th of that name, counted from 1, in the algorithm's trace. The question
/// is asked just before that step. If after is given, it is asked earlier, so that the steps leading to the answer
/// are not shown yet: right after the last step with the name `after` before it, or after the one that after_nth
/// counts.
struct Gate {
  std::string algorithm;
  std::string fact;  // its name: "pair_chosen"
  int occurrence = 1;
  std::string after;                  // a fact's name, kStart for the beginning, or empty
  int after_nth = 0;                  // counted from 1; 0: the last one
  FilePlace fact_place, after_place;  // in the file, for errors
  static constexpr std::string_view kStart = "start";
};

/// What a particular wrong answer means.
struct Meaning {
  std::string answer;  // the text of a choice, or a handle's name
  std::string says;
  FilePlace place;  // in the file, for errors
};

/// A condition on the result of an algorithm: bounds of one of its figures, or a goal that its subject knows by name.
struct Requirement {
  std::string figure;     // its key; empty for a goal
  std::string algorithm;  // whose figure; empty: that of the task or the question
  std::string over;       // for "excess": over this algorithm's size instead of the reference's
  double at_least = -std::numeric_limits<double>::infinity(), at_most = std::numeric_limits<double>::infinity();
  std::string goal;
  FilePlace place;  // in the file, for errors
};

/// Which runs a fixed answer is true of.
enum class Holds : std::uint8_t {
  kAlways,
  kHere,  // of the lesson's own run alone: the question is asked of no other
};

struct Question {
  std::string id;
  Gate gate;
  bool predicts = false;       // before the first step, without a gate
  std::string asks = "point";  // "point", "choice", or anything that its subject's facts can be asked
  std::string prompt;
  std::vector<std::string> choices;  // for "choice"; for "sequence" in the right order
  int answer = 0;                    // for "choice", counted from 0
  Holds holds = Holds::kAlways;
  std::vector<Requirement> conditions;   // it is asked where these hold, for its answer is true there
  std::string figure;                    // for "figure" and "number": its key, and
  std::vector<double> bounds;            // for "figure", rising: up to the first, up to the second, …, more
  double tolerance = 0;                  // for "number": how far off a right answer may be
  std::uint64_t shuffled = 0;            // for "sequence": another order for each instance of an exercise
  std::vector<Meaning> meanings;         // of wrong answers
  std::string because;                   // shown with what happened, right or wrong
  std::string prompt_here;               // replaces the prompt while the run is the lesson's own; empty for none
  std::string because_here;              // the same for because
  std::string section;                   // the title of the section that it is about; empty: that which names its fact
  std::string situation{kOwnSituation};  // asked in this one alone
  FilePlace place, figure_place;         // in the file, for errors
  bool sound = true;                     // false while it is checked although it has mistakes: then it is left out
  bool can_be_asked = true;              // whether `asks` and the keys that go with it have none
};

/// A lesson's tables, as only its subject knows them. Each subject derives its own.
struct Tables {
  virtual ~Tables() = default;
};

/// Another set of points, another pair or another scene on the same stage. It is named in links and addresses.
struct Situation {
  std::string name, title;  // title: the words on its control
  Points points;
  std::shared_ptr<const Tables> tables;
  FilePlace place;  // in the file, for errors
};

/// A slider beside the stage, which drives a number of what stands there.
struct Slider {
  std::string title, drives;  // drives: one of Subject::drives
  double from = 0, to = 1;
  std::optional<double> start;      // none: where the lesson's own stands, if that lies between, or else `from`
  int steps = 0;                    // from one end to the other; 0: as many as suit the numbers
  bool logarithmic = false;         // each step is a factor
  std::optional<int> decimals;      // none: as many as the steps need
  std::optional<std::string> unit;  // none: that of what it drives
  std::string situation;            // in this one alone; empty for all
  bool must_move = false;           // whether the lesson is about it, and not done before it was moved
  FilePlace place, drives_place;    // in the file, for errors
  bool sound = true;                // as of questions
};

/// The "model" of a task of an exercise: each instance has its own, which a search finds.
inline constexpr std::string_view kSearch = "search";

/// "Make it fail" or "construct it": graded on what stands on the stage.
struct Task {
  std::string prompt;
  std::string algorithm;          // shown when the task is started, and graded where a requirement names no other
  int points = 0;                 // exactly how many there must be, and how many it begins with; 0: any number
  std::vector<std::string> only;  // the handles that may be moved; empty: all
  std::vector<Requirement> conditions;
  std::string hint;
  std::vector<std::vector<double>> model;    // a solution, which the checks play: see Subject::rows
  bool searched = false;                     // whether there is none, for each instance of an exercise has its own
  std::string situation{kOwnSituation};      // the one that it begins in and is graded in
  FilePlace place, only_place, model_place;  // in the file, for errors
  bool sound = true;                         // as of questions
  bool can_be_solved = true;                 // whether its model and its requirements have no mistakes
};

/// An algorithm's pseudocode in the lesson's own words, with as many lines as the catalogue's.
struct Pseudocode {
  std::string algorithm;
  std::vector<std::string> lines;
};

struct Lesson {
  /// What the stage shows when the lesson opens.
  enum class Start {
    kBegin,  // the points alone, before the first step
    kEnd,    // the result: see Player::previewing
  };
  std::string id;  // the file's name without .toml
  std::string title;
  std::string summary;              // one sentence
  int minutes = 0;                  // how long it takes, about
  std::vector<std::string> covers;  // the ids of the ideas that it covers (see Course)
  std::string source;               // of a named case: where a known program failed on it; empty for none
  std::vector<Section> sections;
  Points points;
  const SubjectRow* subject = nullptr;   // what the stage is about; null: determined by the volume
  std::shared_ptr<const Tables> tables;  // the subject's; null if it has none besides the points
  std::string own_title = "First";       // the words on the control of the lesson's own situation
  std::vector<Situation> situations;     // besides the lesson's own
  std::vector<Slider> sliders;
  std::vector<std::string> meshes;      // those that the student may load instead
  std::vector<std::string> generators;  // those that the student may scatter points with instead
  std::uint64_t seed = 1;
  Start start = Start::kBegin;
  std::string volume = "sphere";        // the volume of the methods: one of kVolumeNames, or a subject's own word
  std::vector<std::string> algorithms;  // offered, in this order; the first is shown at the start. "k8", or
                                        // "kdop/k8" where it is of another volume than the lesson's
  std::string reference;                // the algorithm that sizes are compared with; empty: see CloudSubject
  std::string compare;                  // a second one, shown from the start for comparison; empty for none
  std::vector<Pseudocode> pseudocode;   // the lesson's own, if it has any
  StageView view;                       // how the stage shows it
  std::vector<Question> questions;
  std::vector<Task> tasks;
  std::vector<RunFigure> figures;  // those that its texts show, each once
  std::shared_ptr<const std::vector<Beside>>
      beside;  // what stands beside its own situation (beside.hpp); null: nothing
};

/// The greatest size of a lesson file, bytes: fifty times a long lesson. Nested tables, of which two bytes can open
/// one, must not overflow the parser's stack.
inline constexpr std::size_t kMostLessonBytes = 1 << 18;

/// A lesson that a file links to, or an idea that it covers: other files say whether it exists.
struct NameBeside {
  std::string name;
  bool idea = false;
  FilePlace place;  // in the file, for errors
};

/// What could be read of a lesson file, and what is wrong with it. Questions and tasks with mistakes are left out.
struct Draft {
  std::optional<Lesson> lesson;     // none if what stands on its stage could not be read
  std::vector<FileError> mistakes;  // in the order of the file
  std::vector<FileError> warnings;  // what is allowed but probably not meant
  std::vector<NameBeside> names_beside = {};
};

/// Reads a lesson file as it is written, without running it (core/check does). name: for errors and for the id.
/// Mistakes, each with its line and column: of TOML, after which nothing more is read; an unknown or missing key; an
/// algorithm, fact, generator, mesh or answer that does not exist.
[[nodiscard]] Draft read_draft(std::string_view toml, std::string_view name);

/// The lesson of a file without mistakes. Errors: the first mistake.
[[nodiscard]] tl::expected<Lesson, InputError> read_lesson(std::string_view toml, std::string_view name);

}  // namespace snug::lesson
