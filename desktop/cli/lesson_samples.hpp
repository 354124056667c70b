// Stages of every kind on which `snug lesson table` looks up what results have.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace snug::desktop {

/// The part of a lesson's file that says what stands on its stage.
struct LessonSample {
  std::string_view volume, chart;
  std::string_view algorithms;  // as the file lists them; empty: all of the volume
  std::string_view stage;       // its tables
};
[[nodiscard]] std::span<const LessonSample> lesson_samples();

/// The sample as a whole lesson. algorithms: as the file lists them.
[[nodiscard]] std::string lesson_of(const LessonSample& sample, std::string_view algorithms);

}  // namespace snug::desktop
