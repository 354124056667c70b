// Every subject that the app can show.
#pragma once

#include <memory>
#include <string_view>

#include "app/cover.hpp"
#include "app/subject.hpp"

namespace snug::app {

struct SubjectRow {
  std::string_view name;  // of its folder
  std::unique_ptr<SubjectView> (*view)();
  std::unique_ptr<Cover> (*cover)(const Platform& platform);  // null: nothing but the stage
};

/// How what a lesson's stage is about is seen.
[[nodiscard]] const SubjectRow& subject_of(const lesson::Lesson& lesson);

}  // namespace snug::app
