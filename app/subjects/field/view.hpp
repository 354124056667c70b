// The view of a field of boxes and the camera that flies over it.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> field_view();

}  // namespace snug::app
