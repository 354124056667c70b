// A cloud of points and the volume fitted around it.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> cloud_view();

}  // namespace snug::app
