// Questions about a run: where each is asked, which answers it takes, whether an answer is right, and the feedback.
// What can be asked of a fact is in its entry (facts.hpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lesson/answer.hpp"
#include "lesson/lesson.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

class TomlTable;

/// A question as it is asked now, with the choices worked out from the run.
struct Asked {
  static constexpr int kAnytime = -1;
  const Lesson* lesson = nullptr;
  const Question* question = nullptr;
  const Subject* subject = nullptr;
  const QuestionKind* kind = nullptr;
  std::string prompt;  // in words for the points' dimension: a circle in space is a sphere
  std::string because;
  std::string of;        // what it is about, which takes the place of {of} in both: "P7", "x + y"
  bool own_run = false;  // whether the run is the lesson's own: words about its handles are said of no other
  int dim = 2;
  int step = 0;                                    // the player's place where it is asked, or kAnytime
  std::vector<std::string> choices;                // what may be chosen; empty if only the stage answers
  std::vector<std::vector<Index>> choice_handles;  // what each choice names on the stage
  bool on_stage = false;                           // whether a tap on a handle answers
  bool many = false;                               // whether an answer can have several choices or handles
  bool ordered = false;                            // whether an answer puts all choices into an order
  bool number = false;                             // whether the answer is a number, and
  std::string unit;                                // its unit: "units", "%", "points"; empty for none
  bool on_axes = false;                            // whether the choices are the test's axes, in order, and then "none"
  std::vector<Index> stage_points;                 // the handles that can be tapped; empty if all can
  int fact = 0;                                    // which step of the run it is about, counted from 0
  int until = 0;                                   // the player's place where it is decided: an answer goes there

  void add_choice(std::string text, std::vector<Index> handles = {});
  /// "P3, P8 and P9"
  [[nodiscard]] std::string names(std::span<const Index> handles) const;
  /// The figure that would give the answer away; empty for none.
  [[nodiscard]] std::string_view hidden_figure() const;
};

/// The right choices and handles, in a few words and in a sentence.
struct Truth {
  std::vector<int> choices;
  std::vector<Index> points;
  std::string happened;
  std::string sentence;
  bool pending = false;         // it is not known yet
  std::vector<int> ranks = {};  // of an order: each choice's place, equal where either may come first
  double number = 0;            // of a number, within
  double tolerance = 0;
  /// An answer of several handles may have ties. This then has a list for each handle that is due: any handle of the
  /// list is right. The points are those of all lists.
  std::vector<std::vector<Index>> tied = {};
};

/// The keys, like those of figures, of a method's result in the final comparison, and of which method is best.
inline constexpr std::string_view kResultFigure = "result", kComparedFigure = "compared";

/// A mistake that many make, as a rule that decides in the right one's place.
struct WrongRule {
  std::string_view name;  // as exercises say: "nearest"
  /// What somebody answers who follows it; none where it decides nothing.
  std::optional<Answer> (*decides)(const Asked& asked, const Run& run);
};

/// Says of a wrong range which way the right one lies.
inline constexpr std::string_view kMore = "It is more than that.", kLess = "It is less than that.";

/// Something that can be asked of a step.
struct QuestionKind {
  std::string_view name;  // as lesson files say: "leaves"
  /// Adds the possible answers. Returns why this cannot be asked of the step, or null.
  const char* (*offer)(Asked& asked, const Run& run);
  Truth (*truth)(const Asked& asked, const Run& run);
  /// The player's place where it is decided; null: right after the step.
  int (*decided)(const Run& run, int fact) = nullptr;
  /// The figure that gives its answer away, if the question names none; empty for none.
  std::string_view figure = {};
  /// Reads keys of its own from a lesson's file; null for none.
  void (*read)(TomlTable& table, Question& question) = nullptr;
  /// The right answer's lead over the runner-up, as a share of the stage's extent; 0 at a tie. Null: an exercise cannot
  /// ask for it.
  double (*margin)(const Asked& asked, const Run& run) = nullptr;
  std::span<const WrongRule> rules = {};
  /// What a wrong choice is told where the lesson has no words for it: one that comes before the right one, and one
  /// after it; empty for nothing.
  std::string_view before = {}, after = {};
};

/// Something that can be asked of a fact; the fact is empty if the question is not about a step.
struct FactQuestionKind {
  std::string_view fact;
  const QuestionKind* kind;
};

/// What happened, and what was predicted.
struct Outcome {
  std::string question;  // its id
  std::uint64_t on = 0;  // what it was asked on (Conversation::instance)
  Answer given;
  int from_step = 0;  // where it was asked, and
  int step = 0;       // where it was decided: the steps in between show how
  bool right = false;
  bool skipped = false;
  bool pending = false;   // not decided yet: a question about the chart, which has to be measured first
  bool passed = false;    // skipped by a jump: it is asked when the player comes to it again
  int tries = 1;          // how many answers were given: 2 if the first was wrong
  std::string predicted;  // "P9", "yes", "the x pair", or "the x pair (P9)" if the point was tapped
  std::string happened;   // what really happened: "P12", "the y pair"
  std::string says;       // the same in a sentence: "P12 left the support set."
  std::string because;
};

/// The state of a question.
enum class AnswerState { kOpen, kRight, kWrong, kSkipped };
/// outcome: null for none. A question is open if a jump passed it, or if it is not decided yet.
[[nodiscard]] AnswerState answer_state_of(const Outcome* outcome);

/// How many questions are in each state.
struct Tally {
  int right = 0;   // how many of these
  int second = 0;  // at the second try
  int wrong = 0;
  int skipped = 0;
  int open = 0;
  [[nodiscard]] int all() const { return right + wrong + skipped + open; }
};
/// Counts a question by its outcome; null for none.
void add_to(Tally& tally, const Outcome* outcome);

/// Sets the question's prompt and reason. own_run: uses prompt_here and because_here, if the question has them.
void put_words(Asked& asked, bool own_run);

/// The method's questions whose gates this run has, in the timeline's order. A question that would come while another
/// is still open is left out. own_run: whether this is the run of the lesson's own points, volumes or scene.
[[nodiscard]] std::vector<Asked> asked_on(const Lesson& lesson, std::string_view method, const Subject& subject,
                                          const Run& run, bool own_run);

/// Finds where one of the lesson's questions is asked on a run, with its general words. None if the run does not have
/// its step, or if the step cannot be asked that; then why gives the reason, as a sentence fragment.
[[nodiscard]] std::optional<Asked> resolve(const Question& question, const Lesson& lesson, const Subject& subject,
                                           const Run& run, std::string& why);

/// Why a question about a figure cannot be asked, in general and with the figures that there are.
inline constexpr std::string_view kNoFigureAfter = "\"figure\" names none that there is after this step";
[[nodiscard]] std::string no_figure_after(const Asked& asked, const Run& run);

/// Whether the step that the question is asked after comes before the one that it is about.
[[nodiscard]] bool comes_before(const Run& run, const Gate& gate);

/// What any step can be asked, by the names that lesson files use.
[[nodiscard]] std::vector<std::string_view> general_question_kinds(const SubjectRow& subject);
/// One of these by name; null if it is none of them.
[[nodiscard]] const QuestionKind* general_question_kind(std::string_view name, const SubjectRow& subject);

/// Reads the increasing "bounds" of a question about a figure.
void read_bounds(TomlTable& table, Question& question);
/// Whether a unit is of something measured, and not of things that are counted.
[[nodiscard]] bool is_measured(std::string_view unit);
/// The ranges between a figure's bounds: "none", "1 to 12 points", "more than 12 points"; "at most 10 %".
[[nodiscard]] std::vector<std::string> range_texts(std::span<const double> bounds, std::string_view unit);

/// An answer that was kept or handed in, as its question means it: there, the bits of several choices look like one.
[[nodiscard]] Answer as_asked(const Asked& asked, Answer answer);

/// Whether this can be an answer to the question: a choice in range, or a handle that can be tapped.
[[nodiscard]] bool answers(const Asked& asked, const Answer& answer);

/// What the lesson says to this wrong answer, or to the first wrong part of it; empty for nothing.
[[nodiscard]] std::string meaning_of(const Asked& asked, const Answer& answer, const Truth& truth);
/// Whether the question can be answered with that: the text of a choice, the name of a handle, a number.
[[nodiscard]] bool can_be_said(const Asked& asked, std::string_view answer);

/// The number that was typed, perhaps with its unit: "2.5", "−3", "12 %", "1,839". None if it is no number.
[[nodiscard]] std::optional<double> typed_number(std::string_view text, std::string_view unit);

/// Whether two answers mean the same: a choice that names one handle means the same as a tap on it.
[[nodiscard]] bool same_answer(const Asked& asked, const Answer& a, const Answer& b);
/// Whether a choice is what was picked, or among it.
[[nodiscard]] bool is_picked(const Asked& asked, const Answer& picked, int choice);
/// The place of a choice in the order that was picked, counted from 1; 0 if it has none.
[[nodiscard]] int place_in_order(const Answer& picked, int choice);
/// Whether a handle is what was picked, or among it.
[[nodiscard]] bool names_handle(const Answer& picked, Index handle);

/// Whether a wrong answer leaves at least two others: with only two answers, it would give the right one away.
[[nodiscard]] bool has_second_try(const Asked& asked);

/// The outcome of an answer, as the question means it. given: one that answers() accepts, or a skip.
[[nodiscard]] Outcome judge(const Asked& asked, const Answer& given, const Run& run);

/// Whether several answers are right, because what they name is equally far, large or early, while others are wrong.
[[nodiscard]] bool has_tie(const Asked& asked, const Run& run);

/// A right answer.
[[nodiscard]] Answer model_answer(const Asked& asked, const Run& run);

/// The truth of "choice": the answer in the lesson's file.
[[nodiscard]] Truth choice_truth(const Asked& asked, const Run& run);

}  // namespace snug::lesson
