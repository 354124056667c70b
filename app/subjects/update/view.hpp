// A body, and one update of the volume around it.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> update_view();

}  // namespace snug::app
