// A box and the frustum that culls it.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> frustum_view();

}  // namespace snug::app
