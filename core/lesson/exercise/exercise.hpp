// An exercise: the student decides in an algorithm's place, on an instance made from a seed, for a mark. The format of
// its file is documented in lessons/README.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// What the student is told who follows a wrong rule (WrongRule).
struct RuleWords {
  std::string name;
  std::string says;
  FilePlace place;  // in the file, for errors
};

/// One of the things that the student decides, each time that the run comes to it. The question itself, with its
/// prompt and its reason, is that of the same number in Exercise::stage.
struct Decision {
  std::string hint;
  bool at_once = false;  // whether it is asked right after the decision before it, and what lies between is played then
  int least = 1, most = 100;  // how often it comes at least, and after how many the program goes on alone
  bool balanced = false;      // whether of half the instances all right answers are the same, and of the others not
  bool skip_ties = false;     // whether what is too near to a tie is left to the program, or passes the seed over
  std::vector<RuleWords> rules;
};

/// An example that the student builds: the stage's one task, met in levels, of which each earns a mark.
struct Build {
  /// Each requirement of the task may have easier bounds, the easiest first: reaching one of them earns a mark.
  std::vector<std::vector<double>> steps;
  int levels = 1;     // one more than there are steps
  std::string claim;  // what the example refutes; empty for none
};

/// What is harder at a level: what is not named stays as it was at the level below.
struct Harder {
  std::optional<int> count;             // of points
  std::optional<std::string> generate;  // how they are scattered
  std::optional<double> apart;          // see Exercise::apart
  bool ties = false;                    // see Exercise::ties
  std::optional<std::pair<int, int>> decisions;
};

struct Exercise {
  std::string id;      // the file's name without .toml
  Lesson stage;        // what stands on it, the algorithm, and in its sections what is asked
  std::string lesson;  // the id of the one that teaches it
  std::vector<Decision> decisions;
  std::optional<Build> build;  // in the place of decisions
  std::vector<Harder> harder;  // the levels above the first
  int level = 0;               // the one that this is
  bool told_at_once = true;    // or all at the end
  double apart = 0;            // no decision is nearer to a tie than this share of the extent (QuestionKind::margin)
  bool ties = false;           // whether some decision is a tie, in which each of the right answers is accepted
  int least = 1, most = 100;   // how many decisions an instance has
  std::uint64_t hash = 0;      // of the file's text

  /// "carry_out", "number", "order", "build" or "break_it": by what it asks.
  [[nodiscard]] std::string_view kind() const;
};

/// What could be read of an exercise's file, and what is wrong with it.
struct ExerciseDraft {
  std::vector<FileError> mistakes;  // in the order of the file
  Exercise exercise;                // sound if there are none
};

/// Reads an exercise's file. name: for errors and for the id. Mistakes, each with its line and column: those of a
/// lesson's file; a fact that cannot be decided; a wrong rule that there is not.
[[nodiscard]] ExerciseDraft read_exercise(std::string_view toml, std::string_view name);

/// An exercise has at most this many levels above its first.
inline constexpr int kMostLevels = 9;

/// The exercise at a level, counted from 0; at the highest if it has no such level.
[[nodiscard]] Exercise at_level(const Exercise& exercise, int level);

/// As many hints as a decision has at most; kHintPrices says what they cost.
inline constexpr int kMostHints = 3;

}  // namespace snug::lesson
