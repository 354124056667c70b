// libFuzzer: any bytes as what the window keeps of the course. What is damaged is left out, and what was read is
// written in a form that is read again as the same.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "desktop/kept.hpp"
#include "fuzz/bytes.hpp"
#include "lesson/kept_answers.hpp"

namespace {

using namespace snug;
namespace fs = std::filesystem;

/// A folder of this process, for it alone.
const fs::path& folder() {
  static const fs::path path = [] {
    const fs::path made = fs::temp_directory_path() / ("snug_fuzz_" + std::to_string(getpid()));
    fs::create_directories(made / "snug");
    setenv("XDG_STATE_HOME", made.c_str(), 1);
    return made;
  }();
  return path;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  std::ofstream(folder() / "snug" / "course.json", std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  const desktop::Kept kept;
  fuzz::require(kept.invited >= 0);
  if (const desktop::KeptLesson* lesson = kept.lesson(kept.last(), 0)) {
    fuzz::require(lesson->step >= 0 && lesson->steps >= 0 && lesson->answered >= 0);
    const lesson::KeptAnswers answers = lesson::kept_answers_of(lesson->answers);
    const lesson::KeptAnswers again = lesson::kept_answers_of(lesson::kept_text(answers));
    fuzz::require(again.outcomes.size() == answers.outcomes.size() && again.tasks.size() == answers.tasks.size());
  }
  return 0;
}
