// The questions and their answers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/told/prose.hpp"
#include "lesson/session.hpp"

namespace snug::app::told {

/// The state of a question, which scripts know as its kind.
using StateWord = Word<"right", "wrong", "skipped", "open">;

/// The numbers of the choices (in the chosen order, if that is asked), and what could be typed: a handle's name,
/// several, or a number.
struct Answer {
  std::vector<int> choices;
  std::optional<std::string> handle;
  SNUG_FIELDS(choices, handle);
};

struct Asked {
  std::string_view id;
  std::string prompt;
  Paragraph prompt_words;
  int step = 0;
  std::span<const std::string> choices;
  bool many = false, ordered = false;
  Word<"Name", "Names", "Number", ""> field;
  bool on_stage = false;
  std::string place, how;
  std::optional<Answer> picked, tried;
  bool ready = false;
  std::string_view says;
  SNUG_FIELDS(id, prompt, prompt_words, step, choices, many, ordered, field, on_stage, place, how, picked, tried, ready,
              says);
};

struct Outcome {
  StateWord kind;
  int tries = 0;
  std::string_view question;
  std::uint64_t on = 0;
  int from_step = 0, step = 0;
  bool right = false, skipped = false, passed = false, pending = false;
  std::string_view verdict, predicted, happened, says;
  std::string because;
  Paragraph because_words;
  SNUG_FIELDS(kind, tries, question, on, from_step, step, right, skipped, passed, pending, verdict, predicted, happened,
              says, because, because_words);
};

/// An outcome that is shown, or about to be shown, with its question.
struct Told : Outcome {
  using Base = Outcome;
  std::string prompt;
  Paragraph prompt_words;
  std::string place;
  std::span<const std::string> choices;
  bool ordered = false;
  std::optional<Answer> given;
  bool can_watch = false, can_show = false, shown = false;
  std::vector<int> right_choices;
  SNUG_FIELDS(prompt, prompt_words, place, choices, ordered, given, can_watch, can_show, shown, right_choices);
};

struct Prediction {
  std::string_view id;
  std::string prompt, short_;
  StateWord kind;
  std::string_view standing;
  SNUG_FIELDS(id, prompt, short_, kind, standing);
};

struct Tally {
  int right = 0, second = 0, wrong = 0, skipped = 0, open = 0;
  SNUG_FIELDS(right, second, wrong, skipped, open);
};

struct Grade {
  bool done = false;
  int points = 0;
  double excess = 0;
  std::string says;
  SNUG_FIELDS(done, points, excess, says);
};

struct TaskGrade : Grade {
  using Base = Grade;
  bool was = false, kept = false;
  SNUG_FIELDS(was, kept);
};

struct Progress {
  bool begun = false;
  int answered = 0;
  bool done = false;
  SNUG_FIELDS(begun, answered, done);
};

/// What is asked and told now.
struct Conversation {
  std::optional<Asked> asked;
  std::optional<Told> outcome, deciding;
  bool summary = false;
  SNUG_FIELDS(asked, outcome, deciding, summary);
};

/// Every question of the run, in order, and every outcome of the lesson.
struct Log {
  std::size_t questions = 0;
  List<Prediction> predictions;
  Tally tally;
  std::vector<std::string> waiting;
  bool can_practise = false;
  std::vector<std::string> situations_waiting;
  List<Outcome> outcomes;
  std::string score;
  Progress progress;
  SNUG_FIELDS(questions, predictions, tally, waiting, can_practise, situations_waiting, outcomes, score, progress);
};

struct Tasks {
  std::optional<Grade> grade;  // of the task in hand
  List<TaskGrade> tasks;
  std::size_t task = 0;
  bool tasks_done = false;
  SNUG_FIELDS(grade, tasks, task, tasks_done);
};

[[nodiscard]] std::string_view state_word(lesson::AnswerState state);
[[nodiscard]] Conversation conversation_of(const lesson::Session& session);
[[nodiscard]] Log log_of(const lesson::Session& session);
[[nodiscard]] Tasks tasks_of(const lesson::Session& session);

}  // namespace snug::app::told
