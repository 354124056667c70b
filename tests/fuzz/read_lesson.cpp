// libFuzzer: any bytes as a lesson, a course or kept answers. They are refused with a place, or read; a small lesson
// that was read is opened, stepped to its end and back.
#include "check/check_beside.hpp"
#include "fuzz/bytes.hpp"
#include "lesson/course.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace {

using namespace snug;
using fuzz::require;

constexpr Index kMostHandles = 60;
constexpr int kMostSteps = 200;

void play(lesson::Lesson lesson) {
  const bool small = lesson.points.count <= kMostHandles && lesson.points.mesh.empty() && lesson.situations.empty();
  if (!small) return;
  auto session = lesson::Session::open(std::move(lesson));
  if (!session || session->stage().subject().size() > kMostHandles) return;
  for (int i = 0; i < kMostSteps && session->player().step() < session->player().steps(); ++i) {
    if (session->conversation().asked() != nullptr) require(session->conversation().give({}, false));
    else session->forward();
    require(session->telling().caption().find("nan") == std::string::npos);
  }
  session->jump(0);
  require(session->player().step() == 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  lesson::Draft draft = lesson::read_draft(text, "a.toml");
  for (const lesson::FileError& mistake : draft.mistakes) require(mistake.place.line >= 1 && !mistake.what.empty());
  require(draft.lesson || !draft.mistakes.empty());
  if (draft.lesson && draft.mistakes.empty()) play(*std::move(draft.lesson));
  const std::vector<std::string> ids{"a", "b"};
  static_cast<void>(lesson::read_course(text, "course.toml", ids));
  static_cast<void>(lesson::kept_answers_of(text));
  return 0;
}
