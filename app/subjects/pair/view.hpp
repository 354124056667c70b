// Two boxes and the test between them.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> pair_view();

}  // namespace snug::app
