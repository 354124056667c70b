// What is wrong with a lesson that is being written, as the page and the window say it beside its stage.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::check {

using namespace lesson;

struct DraftText {
  struct Line {
    std::string text;  // "12:3: what is wrong", the place first
    bool warning = false;
  };
  std::string heading;  // "spheres.toml: 2 mistakes and 1 warning"
  std::vector<Line> lines;

  [[nodiscard]] bool empty() const { return lines.empty(); }
};

/// In the order of the file; empty if nothing is wrong. file: its name.
[[nodiscard]] DraftText text_of(const Draft& draft, std::string_view file);
/// The same for a course file's mistake.
[[nodiscard]] DraftText text_of(const InputError& mistake, std::string_view file);

}  // namespace snug::check
