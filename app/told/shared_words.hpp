// The headings and buttons that page and window share, by the names that the page has for them.
#pragma once

#include <string_view>
#include <utility>

#include "lesson/say.hpp"

namespace snug::app::told {

inline constexpr std::pair<std::string_view, std::string_view> kSharedWords[] = {
    {"answer", lesson::kAnswerWord},
    {"skip", lesson::kSkipWord},
    {"prediction", lesson::kPredictionWord},
    {"decision", lesson::kDecisionWord},
    {"watch", lesson::kWatchWord},
    {"again", lesson::kPredictAgainWord},
    {"practise", lesson::kPractiseWord},
    {"task", lesson::kTaskWord},
    {"hint", lesson::kHintWord},
    {"go_on", lesson::kContinueWord},
    {"show", lesson::kShowMeWord},
    {"summary", lesson::kSummaryWord},
    {"go_on_with", lesson::kGoOnWord},
    {"waiting", lesson::kWaitingWord},
    {"to_task", lesson::kToTaskWord},
    {"next_lesson", lesson::kNextLessonWord},
    {"close", lesson::kCloseWord},
    {"watching", lesson::kWatching},
    {"hand_in", lesson::kHandInWord},
    {"another", lesson::kAnotherInstanceWord},
    {"to_lesson", lesson::kToLessonWord},
    {"take_back", lesson::kTakeBackWord},
    {"your_mark", lesson::kYourMarkWord},
    {"finish", lesson::kFinishWord},
    {"start_again", lesson::kStartAgainWord},
    {"back_to_best", lesson::kBackToBestWord},
    {"back_to_solution", lesson::kBackToSolutionWord},
    {"show_model", lesson::kShowModelWord},
    {"model_stands", lesson::kModelStandsSays},
    {"harder", lesson::kHarderWord},
    {"without_mark", lesson::kWithoutMarkWord},
    {"for_mark", lesson::kForMarkWord},
    {"right_run", lesson::kRightRunWord},
    {"your_run", lesson::kYourRunWord},
    {"both_runs", lesson::kBothRunsWord},
    {"next_decision", lesson::kNextDecisionWord},
};

}  // namespace snug::app::told
