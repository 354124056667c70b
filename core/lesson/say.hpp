// What a student reads about questions, answers and tasks. The page and the window show these words and add none of
// their own, so that both say the same.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "lesson/session.hpp"

namespace snug::lesson {

// Headings and buttons.
inline constexpr std::string_view kAnswerWord = "Answer", kSkipWord = "Skip", kPredictionWord = "Your prediction",
                                  kWatchWord = "Watch how", kPredictAgainWord = "Predict again",
                                  kPractiseWord = "On another example", kTaskWord = "Your turn", kHintWord = "Hint",
                                  kDismissWord = "Dismiss", kAlgorithmWord = "Algorithm", kCompareWord = "Compare with",
                                  kNoneWord = "(none)", kComparedWord = "Final result, compared",
                                  kContinueWord = "Continue", kShowMeWord = "Show me",
                                  kSummaryWord = "Your predictions", kGoOnWord = "Go on with",
                                  kWaitingWord = "More questions wait under", kNextLessonWord = "Next lesson",
                                  kToTaskWord = "To the task", kCloseWord = "Close";

// The headings and buttons of an exercise.
inline constexpr std::string_view kHandInWord = "Hand in", kAnotherInstanceWord = "Another instance",
                                  kToLessonWord = "To the lesson", kTakeBackWord = "Take back",
                                  kYourMarkWord = "Your mark", kDecisionWord = "Your decision", kBuildWord = "Build it",
                                  kBreakWord = "Break it", kFinishWord = "Done", kStartAgainWord = "Start again",
                                  kBackToBestWord = "Back to my best", kShowModelWord = "Show a solution",
                                  kModelStandsSays = "On the stage: a solution.",
                                  kBackToSolutionWord = "Back to my solution", kHarderWord = "Harder instance",
                                  kPracticeWord = "Practice", kPracticeSays = "no mark",
                                  kWithoutMarkWord = "Practise without a mark", kForMarkWord = "Do it for a mark",
                                  kShowAnswerWord = "Show the answer", kExercisesWord = "Exercises for a mark",
                                  kExercisesSay =
                                      "Carry out an algorithm, work out a number, or build an example, on an instance "
                                      "of your own. Your work is marked, and you can begin a new instance at any time. "
                                      "What you do stays on this device until you hand it in.";

/// After a wrong answer that has a second try; and after the "next" key at a question.
inline constexpr std::string_view kStageIsFixed = "in an exercise, the stage stays as it is";
inline constexpr std::string_view kNoSkipping = "In an exercise, each decision is made before the run goes on.";
inline constexpr std::string_view kTryAgain = "Not that one. Try once more.",
                                  kTryOrderAgain = "Not in that order. Try once more.",
                                  kTryThoseAgain = "Not those. Try once more.",
                                  kTriedAlready = "You have tried that one. Try another.",
                                  kPressToSkip = "Press again to skip this question.",
                                  kSkipHint = "Page Down twice skips.",
                                  kWatching = "Watch how it comes about. Any key or tap goes to the end.";

/// The words for kept answers and for erasing them, which takes a second press.
inline constexpr std::string_view kKeptHere =
                                      "Your answers and your place in each lesson are kept on this device alone.",
                                  kKeptFoot =
                                      "Your answers and your place are kept on this device and go nowhere else.",
                                  kNotKept = "Snug cannot write them here, though: they last until you close it.",
                                  kEraseWord = "Erase my answers", kEraseSureWord = "Press again to erase them",
                                  kEraseWarning =
                                      "This erases your answers and your place in every lesson from this device.",
                                  kErased = "Your answers are erased.";

/// Replaces the task's state while a question is open.
inline constexpr std::string_view kTaskWaits = "The task is checked once the question is answered.";

/// What a method is called in a lesson: "Exact minimum"; where there are several volumes, "OBB: exact minimum".
[[nodiscard]] std::string title_in(const Lesson& lesson, const Method& method);
/// What an algorithm is called beside those of other volumes: "OBB: exact minimum"; the names given if it is unknown.
[[nodiscard]] std::string title_among_volumes(std::string_view volume, std::string_view algorithm);

/// "Correct", "Correct on the second try", "Not quite", "Skipped", or "Not decided" before the chart is measured.
[[nodiscard]] std::string_view verdict_text(const Outcome& outcome);
/// "Tap one of the ringed points, or type its name."
[[nodiscard]] std::string how_to_answer(const Asked& asked);
/// "B2 chosen. Tap it again or press Enter to answer." name: that of the chosen handle; empty if a choice is
/// chosen.
[[nodiscard]] std::string chosen_text(const Asked& asked, const Answer& answer, const std::string& name);
/// Says that a handle cannot be the answer, and which ones can. targets: their names.
[[nodiscard]] std::string no_target_text(const std::string& name, std::span<const std::string> targets);
/// Says that nothing has the typed name. targets: as above.
[[nodiscard]] std::string no_such_name_text(std::string_view typed, std::span<const std::string> targets);
/// "2 of 4 predictions correct (1 on the second try), 1 wrong, 1 skipped."; empty if none was answered or skipped.
[[nodiscard]] std::string score_text(const Tally& tally);
/// The state of a question in the summary: "right", "right on the second try", "wrong", "skipped", "open".
[[nodiscard]] std::string_view answer_state_text(const Outcome* outcome);
/// A prompt as a line of the summary: the sentence that asks, if the prompt is long.
[[nodiscard]] std::string_view short_prompt(std::string_view prompt);
/// "3 of 5": the question's number among those of this run.
[[nodiscard]] std::string place_text(const Asked& asked, std::span<const Asked> all);
/// The words on the button that starts a task: "Start with 4 points"; for two boxes, "Start".
[[nodiscard]] std::string start_task_text(const Session& session, const Task& task);
/// The heading of a task: "Your turn"; of several, "Your turn, 2 of 3".
[[nodiscard]] std::string task_heading(std::size_t task, std::size_t tasks);
/// Says how far a task is from being done; of one that was done, and no longer is, that as well.
[[nodiscard]] std::string task_says(const Session& session, std::size_t task);
/// Says what a task leaves to be moved.
[[nodiscard]] std::string only_text(const Task& task);
/// The label of the field in which an answer is typed: "Name", "Names", "Number"; empty if there is none.
[[nodiscard]] std::string_view field_word(const Asked& asked);
/// Says that what was typed is not a number.
[[nodiscard]] std::string no_number_text(std::string_view typed);

}  // namespace snug::lesson
