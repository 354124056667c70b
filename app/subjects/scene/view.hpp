// A scene that moves.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> scene_view();

}  // namespace snug::app
