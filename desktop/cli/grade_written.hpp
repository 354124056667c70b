// Grades code that was handed in: it is built and tried again.
#pragma once

#include <string>

#include "desktop/cli/result_file.hpp"

namespace snug::desktop {

struct GradedCode {
  std::string status, says;  // as `snug grade` reports them
  double mark = 0;
  int of = 0;
};

/// claimed: with its code. version: of the program that wrote the file.
[[nodiscard]] GradedCode grade_written(const Claimed& claimed, const std::string& version);

}  // namespace snug::desktop
