#include "desktop/kept.hpp"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "desktop/cli/files.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::size_t kMostBytes = 1 << 22;

/// The specification requires an absolute path, and that others are ignored.
fs::path folder_of(const char* variable) {
  const char* name = std::getenv(variable);
  const fs::path folder = name != nullptr ? name : "";
  return folder.is_absolute() ? folder : fs::path();
}

fs::path path_of_state() {
  if (const fs::path state = folder_of("XDG_STATE_HOME"); !state.empty()) return state / "snug" / "course.json";
  if (const fs::path home = folder_of("HOME"); !home.empty()) return home / ".local" / "state" / "snug" / "course.json";
  return {};
}

/// value(…) of nlohmann throws where a key has another type.
template <class Type>
Type member(const Json& object, const char* key, Type otherwise, bool (Json::*is_type)() const noexcept) {
  const auto found = object.find(key);
  return found != object.end() && ((*found).*is_type)() ? found->template get<Type>() : otherwise;
}

int count(const Json& object, const char* key) {
  const auto number = member<std::uint64_t>(object, key, 0, &Json::is_number_unsigned);
  return static_cast<int>(std::min<std::uint64_t>(number, 1'000'000'000));
}

KeptLesson lesson_of(const Json& object) {
  KeptLesson lesson;
  lesson.seed = member<std::uint64_t>(object, "seed", 0, &Json::is_number_unsigned);
  lesson.step = count(object, "step"), lesson.steps = count(object, "steps");
  lesson.situation = member<std::string>(object, "situation", "", &Json::is_string);
  lesson.algorithm = member<std::string>(object, "algorithm", "", &Json::is_string);
  lesson.beside = member<std::string>(object, "beside", "", &Json::is_string);
  lesson.answered = count(object, "answered");
  lesson.done = member(object, "done", false, &Json::is_boolean);
  lesson.task = member(object, "task", false, &Json::is_boolean);
  lesson.answers = member<std::string>(object, "answers", "", &Json::is_string);
  lesson.file.own = member<std::string>(object, "file_own", "", &Json::is_string);
  lesson.file.runs = member<std::string>(object, "file_runs", "", &Json::is_string);
  lesson.file.typed = member<std::string>(object, "file_typed", "", &Json::is_string);
  return lesson;
}

}  // namespace

Kept::Kept() : path_(path_of_state()) {
  std::error_code error;
  works_ = !path_.empty();
  if (path_.empty() || !fs::exists(path_, error)) return;
  if (const auto text = read_start(path_.string(), kMostBytes)) read(*text);
  works_ = !path_.empty();
}

void Kept::read(const std::string& text) {
  const Json state = Json::parse(text, nullptr, false);
  if (!state.is_object()) return;
  const int version = count(state, "version");
  if (version > kVersion) path_.clear();  // the file of a later program is left as it is
  if (version != kVersion) return;
  last_ = member<std::string>(state, "last", "", &Json::is_string);
  invited = count(state, "invited");
  const auto lessons = state.find("lessons");
  if (lessons == state.end() || !lessons->is_object()) return;
  for (const auto& [id, entry] : lessons->items())
    if (entry.is_object()) lessons_[id] = lesson_of(entry);
}

const KeptLesson* Kept::lesson(const std::string& id) const {
  const auto found = lessons_.find(id);
  return found != lessons_.end() ? &found->second : nullptr;
}

void Kept::keep(const lesson::Session& session) {
  const std::string& id = session.lesson().id;
  const bool begun = !session.previewing() && (session.step() > 0 || !session.outcomes().empty() || session.edited());
  const KeptLesson* before = lesson(id);
  if (!begun && before == nullptr) return;
  const auto decided = [](const lesson::Outcome& outcome) { return !outcome.passed && !outcome.pending; };
  const auto& outcomes = session.outcomes();
  KeptLesson now;
  now.seed = session.seed();
  now.step = session.step(), now.steps = session.steps();
  if (session.situation() != lesson::kOwnSituation) now.situation = session.situation();
  now.algorithm = lesson::name_in(session.lesson(), *session.method(0));
  now.beside =
      session.method(1) != nullptr ? lesson::name_in(session.lesson(), *session.method(1)) : std::string(kNone);
  now.answered = static_cast<int>(std::count_if(outcomes.begin(), outcomes.end(), [&](const lesson::Outcome& outcome) {
    return decided(outcome) && !outcome.skipped;
  }));
  const auto asked = static_cast<std::ptrdiff_t>(session.questions().size());
  const bool through = asked > 0 ? std::count_if(outcomes.begin(), outcomes.end(), decided) >= asked
                                 : begun && session.step() == session.steps();
  // A lesson once done stays done, even if it is opened again.
  now.done = through || (before != nullptr && before->done);
  now.task = session.tasks_done() || (before != nullptr && before->task);
  now.answers = lesson::kept_text({outcomes, session.done_tasks()});
  const auto file = session.subject().file(), own = session.own().file();
  if (file && own && (file->runs != own->runs || file->typed != file->runs))
    now.file = {own->runs, file->runs, file->typed};
  lessons_[id] = std::move(now);
  last_ = id;
}

void Kept::erase() {
  lessons_.clear();
  last_.clear();
}

void Kept::write() {
  if (path_.empty()) return;
  Json state{{"version", kVersion}, {"last", last_}, {"invited", invited}, {"lessons", Json::object()}};
  for (const auto& [id, lesson] : lessons_) {
    state["lessons"][id] = {{"seed", lesson.seed},         {"situation", lesson.situation}, {"step", lesson.step},
                            {"steps", lesson.steps},       {"algorithm", lesson.algorithm}, {"beside", lesson.beside},
                            {"answered", lesson.answered}, {"done", lesson.done},           {"task", lesson.task},
                            {"answers", lesson.answers}};
    if (lesson.file.own.empty()) continue;
    state["lessons"][id]["file_own"] = lesson.file.own;
    state["lessons"][id]["file_runs"] = lesson.file.runs;
    state["lessons"][id]["file_typed"] = lesson.file.typed;
  }
  std::string text = state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (text == written_) return;
  std::error_code error;
  if (last_.empty() && lessons_.empty() && !fs::exists(path_, error)) return;  // nothing was begun yet
  fs::create_directories(path_.parent_path(), error);
  works_ = write_file(path_.string(), text).has_value();  // tried again with the next change, if it failed
  written_ = std::move(text);
}

}  // namespace snug::desktop
