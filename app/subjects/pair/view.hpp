// Two boxes and their tests; two volumes of any kind and theirs.
#pragma once

#include <memory>

#include "app/subject.hpp"

namespace snug::app {

[[nodiscard]] std::unique_ptr<SubjectView> pair_view();
[[nodiscard]] std::unique_ptr<SubjectView> volumes_view();

}  // namespace snug::app
