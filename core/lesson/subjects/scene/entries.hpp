// The entry of the one fact that a scene reports.
#pragma once

#include "lesson/subjects/scene/scene.hpp"

namespace snug::lesson {

/// "figure": in which range a figure of the scene lies; the choices are the ranges.
const char* offer_ranges(Asked& asked, const Run& run);
Truth range_truth(const Asked& asked, const Run& run);
/// "skipped": which effects are skipped in the frame; the choices are the effects.
const char* offer_effects(Asked& asked, const Run& run);
Truth skipped_truth(const Asked& asked, const Run& run);

/// "most_compared": which body the search compares with the most others; answered on the stage.
const char* offer_bodies(Asked& asked, const Run& run);
Truth most_compared_truth(const Asked& asked, const Run& run);

template <>
struct Entry<FrameTaken> : EntryDefaults {
  static constexpr std::array kQuestionKinds{
      QuestionKind{.name = "figure",
                   .offer = &offer_ranges,
                   .truth = &range_truth,
                   .read = &read_ranges,
                   .before = kMore,
                   .after = kLess},
      QuestionKind{.name = "most_compared", .offer = &offer_bodies, .truth = &most_compared_truth},
      QuestionKind{.name = "skipped", .offer = &offer_effects, .truth = &skipped_truth}};
  static std::string sentence(const FrameTaken& fact, const SceneRun::Where& where);
};

}  // namespace snug::lesson
