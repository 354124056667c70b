#include "lesson/progress.hpp"

#include <algorithm>

namespace snug::lesson {

Progress progress_of(const Session& session) {
  const Lesson& lesson = session.lesson();
  const auto answered = [&](const Question& question) {
    return std::any_of(session.log().outcomes().begin(), session.log().outcomes().end(), [&](const Outcome& outcome) {
      const AnswerState stands = answer_state_of(&outcome);
      return outcome.question == question.id && (stands == AnswerState::kRight || stands == AnswerState::kWrong);
    });
  };
  Progress progress;
  progress.begun =
      !session.player().previewing() && (session.player().step() > 0 || !session.log().outcomes().empty() ||
                                         session.stage().edited() || session.conversation().tried() != nullptr);
  progress.asked = static_cast<int>(lesson.questions.size());
  progress.answered = static_cast<int>(std::count_if(lesson.questions.begin(), lesson.questions.end(), answered));
  const bool through = progress.asked > 0 ? progress.answered == progress.asked
                                          : progress.begun && session.player().step() == session.player().steps();
  progress.done = through && session.log().to_move().empty();
  progress.task = session.tasks_done();
  return progress;
}

}  // namespace snug::lesson
