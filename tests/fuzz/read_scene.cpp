// libFuzzer: any bytes as the text of a scene that is typed beside the stage, or that an address or the window's state
// carries. It runs, or the student is told in which line what is wrong; and the lesson plays on.
#include <fstream>
#include <sstream>

#include "fuzz/bytes.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene_text.hpp"

namespace {

using namespace snug;
using fuzz::require;

constexpr Index kMostHandles = 60;
constexpr int kMostFrames = 30;
constexpr std::size_t kMostBodies = 12;  // more take their time

/// The one session of the lesson, for opening it takes long: every input undoes what it did. fuzz.sh runs in the
/// project's folder.
lesson::Session& opened() {
  static lesson::Session session = [] {
    std::ifstream file("lessons/scene-effects.toml");
    std::stringstream text;
    text << file.rdbuf();
    auto draft = lesson::read_draft(text.str(), "scene-effects");
    require(draft.lesson && draft.mistakes.empty());
    auto made = lesson::Session::open(*std::move(draft.lesson));
    require(made.has_value());
    return *std::move(made);
  }();
  return session;
}

void play(lesson::Session& session) {
  for (int i = 0; i < kMostFrames && session.player().step() < session.player().steps(); ++i) {
    if (session.conversation().asked() != nullptr) require(session.conversation().give({}, false));
    else session.forward();
    require(session.telling().caption().find("nan") == std::string::npos);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const lesson::SceneTyped typed = lesson::read_typed(text);
  require(typed.set.has_value() == typed.mistakes.empty());
  for (const lesson::FileError& mistake : typed.mistakes) require(mistake.place.line >= 1 && !mistake.what.empty());
  if (typed.set && typed.set->bodies.size() > kMostBodies) return 0;
  lesson::Session& session = opened();
  const auto before = session.stage().subject().file();
  require(before.has_value());
  if (!session.stage().set_file(text)) return 0;
  const auto after = session.stage().subject().file();
  require(after && after->typed == text);
  require((after->runs == text) == after->mistakes.empty());
  if (session.stage().subject().size() <= kMostHandles) play(session);
  session.jump(0);
  session.stage().end_typing();
  if (text != before->typed) session.stage().undo();
  require(session.stage().subject().file()->runs == before->runs &&
          session.stage().subject().file()->typed == before->typed);
  return 0;
}
