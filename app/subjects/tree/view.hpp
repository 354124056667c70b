// The view of boxes and the hierarchy over them.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> tree_view();

}  // namespace snug::app
