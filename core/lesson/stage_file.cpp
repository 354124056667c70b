#include "lesson/stage_file.hpp"

#include "io/text.hpp"

namespace snug::lesson {

std::string StageFile::heading() const {
  if (mistakes.empty()) return {};
  return io::counted(static_cast<std::int64_t>(mistakes.size()), "mistake") +
         ": the stage shows the last text without any.";
}

}  // namespace snug::lesson
