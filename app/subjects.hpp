// Every subject that the app can show.
#pragma once

#include <memory>
#include <string_view>

#include "app/cover.hpp"
#include "app/subject.hpp"

namespace snug::app {

struct SubjectRow {
  std::string_view name;  // that of its folder
  std::unique_ptr<SubjectView> (*view)();
  std::unique_ptr<Cover> (*cover)(const Platform& platform);  // null: only the stage
};

/// The view of a lesson's subject.
[[nodiscard]] const SubjectRow& subject_of(const lesson::Lesson& lesson);

}  // namespace snug::app
