// The exercise that is open, beyond its questions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "app/told/answers.hpp"

namespace snug::app::told {

struct ExerciseRow {
  std::string_view id;
  std::string short_;
  StateWord kind;
  int hints = 0;
  double mark = 0;
  SNUG_FIELDS(id, short_, kind, hints, mark);
};

struct Level {
  std::string words;
  bool now = false, best = false;
  SNUG_FIELDS(words, now, best);
};

/// What is built, and how far it is. targets: what may be moved.
struct Build {
  std::string_view heading, prompt;
  Paragraph prompt_words;
  std::string_view claim;
  List<Level> levels;
  std::string is_now;
  std::vector<std::string> targets;
  bool adds = false, can_go_back = false, can_finish = false;
  SNUG_FIELDS(heading, prompt, prompt_words, claim, levels, is_now, targets, adds, can_go_back, can_finish);
};

/// mark: null until it is told, and where it is practice. run: at the end, the one that is looked at.
struct ShownExercise {
  std::string_view exercise;
  Word<"carry_out", "number", "order", "build", "break_it"> kind;
  std::string_view lesson;
  std::uint64_t seed = 0;
  int level = 0;
  bool practises = false, leads_on = false;
  std::optional<Build> build;
  std::size_t decision = 0;
  int decisions = 0;
  std::optional<double> mark;
  int of = 0;
  bool told = false, tells_at_once = false, count_known = false, finished = false;
  std::vector<std::string> hints;
  std::string hint, rule;
  std::vector<std::string> followed;
  Word<"", "own", "right"> run;
  std::string compared, first_difference;
  bool can_take_back = false;
  List<ExerciseRow> rows;
  SNUG_FIELDS(exercise, kind, lesson, seed, level, practises, leads_on, build, decision, decisions, mark, of, told,
              tells_at_once, count_known, finished, hints, hint, rule, followed, run, compared, first_difference,
              can_take_back, rows);
};

/// As a result file has it, without the student.
struct Attempt {
  std::string exercise, hash;
  std::uint64_t seed = 0;
  IfAny<int> level;
  std::vector<std::string> decisions;
  int hints = 0;
  double mark = 0;
  int of = 0;
  double seconds = 0;
  SNUG_FIELDS(exercise, hash, seed, level, decisions, hints, mark, of, seconds);
};

struct Exercise {
  std::optional<ShownExercise> exercise;  // none while a lesson is open
  SNUG_FIELDS(exercise);
};

[[nodiscard]] Exercise exercise_of(App& app);
/// None while a lesson is open, and where one practises.
[[nodiscard]] std::optional<Attempt> attempt_of(App& app);
[[nodiscard]] std::string attempt_text(App& app);  // as JSON

}  // namespace snug::app::told
