// Questions on a run: where each stands, what may be answered, whether an answer is right, and what is said then. What
// can be asked of a fact stands in its subject's entry (facts.hpp).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lesson/lesson.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class TomlTable;

/// An answer to a question: a handle of the stage, or one of the question's choices.
struct Answer {
  enum class Kind { kPoint, kChoice, kSkipped } kind = Kind::kSkipped;
  int value = 0;  // the handle's index, or the choice counted from 0; of many choices their bits
};

/// A question as it is asked now, with the choices worked out from the run.
struct Asked {
  static constexpr int kAnytime = -1;
  const Question* question = nullptr;
  const Subject* subject = nullptr;
  const Asking* asking = nullptr;
  std::string prompt;  // in the words of the points' dimension: a circle in space is a sphere
  std::string because;
  int dim = 2;
  int step = 0;                                    // the player's place where it stands, or kAnytime
  std::vector<std::string> choices;                // what may be chosen; empty where only the stage answers
  std::vector<std::vector<Index>> choice_handles;  // what each choice names on the stage
  bool on_stage = false;                           // whether a tap on a handle answers
  bool many = false;                               // whether several choices together are an answer: its value's bits
  bool on_axes = false;             // whether the choices are the axes of the test, in their order, and then none
  std::vector<Index> stage_points;  // the handles that a tap can mean; empty where every one can be meant
  int fact = 0;                     // which step of the run it speaks of, counted from 0
  int until = 0;                    // the player's place where it is decided: answering goes there

  void add_choice(std::string text, std::vector<Index> handles = {});
  /// "P3, P8 and P9"
  [[nodiscard]] std::string names(std::span<const Index> handles) const;
  /// The figure that would tell the answer; empty for none.
  [[nodiscard]] std::string_view hidden_figure() const;
};

/// What is the case: the right choices and handles, in few words and in a sentence.
struct Truth {
  std::vector<int> choices;
  std::vector<Index> points;
  std::string happened;
  std::string sentence;
  bool pending = false;  // it is not known yet
};

/// The key, as of a figure, of what a method comes to in the end, beside others.
inline constexpr std::string_view kResultFigure = "result";

/// Something that can be asked of a step.
struct Asking {
  std::string_view name;  // as lesson files say: "leaves"
  /// Adds what may be answered. Returns why the step cannot be asked that, or null.
  const char* (*offer)(Asked& asked, const Run& run);
  Truth (*truth)(const Asked& asked, const Run& run);
  /// The player's place where it is decided; null: right after the step.
  int (*decided)(const Run& run, int fact) = nullptr;
  /// The figure that tells its answer, where the question names none; empty for none.
  std::string_view figure = {};
  /// Reads keys of its own from a lesson's file; null for none.
  void (*read)(TomlTable& table, Question& question) = nullptr;
};

/// One of the things that can be asked of a fact; the fact is empty where it is asked of no step.
struct AskingOf {
  std::string_view fact;
  const Asking* asking;
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
  int tries = 1;          // the answers that were given to it: 2 where the first was wrong
  std::string predicted;  // "P9", "yes", "the x pair", or "the x pair (P9)" where the point was tapped
  std::string happened;   // the same in fact: "P12", "the y pair"
  std::string says;       // that in a sentence: "P12 left the support set."
  std::string because;
};

/// How it stands with a question: four things that no count mixes up.
enum class Standing { kOpen, kRight, kWrong, kSkipped };
/// outcome: null for none. What a jump passed, and what is not decided yet, is open.
[[nodiscard]] Standing standing_of(const Outcome* outcome);

/// How many of the questions are which.
struct Tally {
  int right = 0;   // of these
  int second = 0;  // at the second try
  int wrong = 0;
  int skipped = 0;
  int open = 0;
  [[nodiscard]] int all() const { return right + wrong + skipped + open; }
};
[[nodiscard]] Tally tally_of(std::span<const Asked> questions, std::span<const Outcome> outcomes);

/// The question's prompt and reason; own_run: those that hold on the lesson's own run alone, where it has such.
void put_words(Asked& asked, bool own_run);

/// The questions of that method that this run has the gates of, in the timeline's order. One that stands where another
/// is still open is left out. own_run: whether it is the run of the lesson's own points, volumes or scene.
[[nodiscard]] std::vector<Asked> asked_on(const Lesson& lesson, std::string_view method, const Subject& subject,
                                          const Run& run, bool own_run);

/// Where one question stands on a run, in the general words; nothing where the run does not have its step, or the step
/// cannot be asked that: why says it in one fragment then.
[[nodiscard]] std::optional<Asked> resolve(const Question& question, const SubjectRow& row, const Subject& subject,
                                           const Run& run, std::string& why);

/// Whether that is an answer to it at all: a choice in range, a handle that it can mean.
[[nodiscard]] bool answers(const Asked& asked, const Answer& answer);

/// Whether both say the same: a choice that names one handle says what a tap on it does.
[[nodiscard]] bool same_answer(const Asked& asked, const Answer& a, const Answer& b);
/// Whether a choice is (of many: is among) what was picked.
[[nodiscard]] bool is_picked(const Asked& asked, const Answer& picked, int choice);

/// Whether a wrong answer leaves a choice among others: of two answers it would tell the right one.
[[nodiscard]] bool has_second_try(const Asked& asked);

/// The outcome of an answer, which answers it (or is skipped).
[[nodiscard]] Outcome judge(const Asked& asked, const Answer& answer, const Run& run);

/// An answer that is right.
[[nodiscard]] Answer model_answer(const Asked& asked, const Run& run);

/// The truth of "choice": what the lesson's file says.
[[nodiscard]] Truth choice_truth(const Asked& asked, const Run& run);

}  // namespace snug::lesson
