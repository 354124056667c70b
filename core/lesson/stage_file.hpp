// The text that a stage is made from, where the student may edit it: a scene's file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snug::lesson {

inline constexpr std::string_view kFileWord = "File";

struct StageFile {
  std::string own;    // as the lesson has it, with the effects called for that were switched by their controls
  std::string runs;   // from which the stage is made
  std::string typed;  // as it was typed: the same, unless that has mistakes
  std::vector<std::string> mistakes = {};  // of what was typed, in its order: "12:3: what is wrong"

  /// "2 mistakes: the stage shows the last text without any."; "" for none.
  [[nodiscard]] std::string heading() const;
};

}  // namespace snug::lesson
