#include "desktop/kept.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "desktop/cli/files.hpp"
#include "desktop/cli/result_file.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/progress.hpp"
#include "lesson/text_change.hpp"
#include "number/fnv.hpp"

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

std::uint64_t hash_of(std::string_view text) {
  Fnv1a hash;
  for (const char c : text) hash.add_bits(static_cast<unsigned char>(c));
  return hash.value();
}

/// The place as files of old have it, key by key.
lesson::Place old_place(const Json& object) {
  const auto text = [&](const char* key) { return member<std::string>(object, key, "", &Json::is_string); };
  lesson::Place place{.situation = text("situation"), .algorithm = text("algorithm")};
  if (const std::string beside = text("beside"); !beside.empty()) place.beside = beside == "none" ? "" : beside;
  place.seed = member<std::uint64_t>(object, "seed", 0, &Json::is_number_unsigned);
  place.file = lesson::change_of(text("file_own"), text("file_runs"));
  place.draft = lesson::change_of(text("file_runs"), text("file_typed"));
  place.step = count(object, "step");
  return place;
}

KeptLesson lesson_of(const Json& object) {
  KeptLesson lesson;
  lesson.hash = member<std::uint64_t>(object, "hash", 0, &Json::is_number_unsigned);
  const std::string place = member<std::string>(object, "place", "", &Json::is_string);
  lesson.place = place.empty() ? old_place(object) : lesson::read_place(place).place;
  lesson.text = member<std::uint64_t>(object, "text", 0, &Json::is_number_unsigned);
  if (const auto own = object.find("file_own"); own != object.end() && own->is_string())
    lesson.text = hash_of(own->get<std::string>());
  lesson.step = count(object, "step"), lesson.steps = count(object, "steps");
  lesson.answered = count(object, "answered");
  lesson.done = member(object, "done", false, &Json::is_boolean);
  lesson.task = member(object, "task", false, &Json::is_boolean);
  lesson.answers = member<std::string>(object, "answers", "", &Json::is_string);
  return lesson;
}

KeptExercise exercise_of(const Json& object) {
  KeptExercise exercise{count(object, "tries"), member(object, "mark", 0.0, &Json::is_number), count(object, "of"), {}};
  if (const auto now = object.find("now"); now != object.end())
    if (auto read = attempt_of(*now)) exercise.now = std::move(read->attempt);
  return exercise;
}

/// None where a number is missing or out of range.
std::optional<KeptView> view_of(const Json& object) {
  if (!object.is_object()) return std::nullopt;
  const auto place = [&](const char* key) {  // left of the main screen or above it, it is below zero
    return static_cast<int>(
        std::clamp<std::int64_t>(member<std::int64_t>(object, key, 0, &Json::is_number_integer), -100'000, 100'000));
  };
  KeptView view{count(object, "theme"),
                member<float>(object, "text_scale", 0, &Json::is_number),
                count(object, "width"),
                count(object, "height"),
                place("x"),
                place("y")};
  const bool sound = view.theme < 4 && view.text_scale >= 0.5f && view.text_scale <= 4 && view.width <= 20'000 &&
                     view.height <= 20'000;
  return sound ? std::optional(view) : std::nullopt;
}

/// Keeps other windows from reading and writing the file, as long as it lives.
class Lock {
 public:
  explicit Lock(const fs::path& path) : file_(::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600)) {
    while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
    }
  }
  ~Lock() {
    if (file_ >= 0) ::close(file_);
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

 private:
  int file_;
};

bool same(const MeasuredTable& a, const MeasuredTable& b) { return a.date == b.date && a.table == b.table; }
bool same(const auto& a, const auto& b) { return a == b; }

/// Takes the parts of another window that this one has not changed since both had those of before.
template <class Parts>
void take_parts(Parts& own, const Parts& before, Parts theirs) {
  for (auto& [part, work] : theirs) {
    const auto mine = own.find(part);
    const auto then = before.find(part);
    const bool changed =
        mine == own.end() ? then != before.end() : then == before.end() || !same(mine->second, then->second);
    if (!changed) own.insert_or_assign(part, std::move(work));
  }
}

fs::path beside(fs::path path, const char* ending) { return path += ending; }

}  // namespace

std::uint64_t text_of_stage(const lesson::Session& session) {
  const auto file = session.stage().own().file();
  return file ? hash_of(file->own) : 0;
}

Kept::Kept(const std::string& folder) : path_(path_of_state()) {
  std::error_code error;
  if (!folder.empty()) folder_ = (fs::weakly_canonical(folder, error) / "").string();
  works_ = !path_.empty();
  if (auto file = read()) {
    last_ = file->last, invited = file->invited, lessons_ = std::move(file->lessons);
    exercises_ = std::move(file->exercises), sheets_ = sheets_read_ = std::move(file->sheets);
    student = student_read_ = file->student, recent = recent_read_ = file->recent;
    view = view_read_ = file->view;
  }
  works_ = !path_.empty();
}

std::optional<Kept::State> Kept::read() {
  std::error_code error;
  if (path_.empty() || !fs::exists(path_, error)) return std::nullopt;
  const auto text = read_start(path_.string(), kMostBytes);
  if (!text) return std::nullopt;
  const Json json = Json::parse(*text, nullptr, false);
  const int version = json.is_object() ? count(json, "version") : 0;
  if (version > kVersion) return path_.clear(), std::nullopt;  // the file of a later program is left as it is
  if (version != kVersion) return put_aside(), std::nullopt;
  State state{member<std::string>(json, "last", "", &Json::is_string), count(json, "invited"), {}, {}, {}, {}, {}, {}};
  state.student = member<std::string>(json, "student", "", &Json::is_string);
  if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
    for (const Json& path : *recent)
      if (path.is_string()) state.recent.push_back(path.get<std::string>());
  if (const auto sheets = json.find("sheets"); sheets != json.end() && sheets->is_object())
    for (const auto& [id, entry] : sheets->items())
      if (auto read = sheet_of(entry)) state.sheets[id] = std::move(read->work);
  if (const auto look = json.find("view"); look != json.end()) state.view = view_of(*look);
  if (const auto exercises = json.find("exercises"); exercises != json.end() && exercises->is_object())
    for (const auto& [id, entry] : exercises->items())
      if (entry.is_object()) state.exercises[id] = exercise_of(entry);
  const auto lessons = json.find("lessons");
  if (lessons == json.end() || !lessons->is_object()) return state;
  for (const auto& [id, entry] : lessons->items())
    if (entry.is_object()) state.lessons[id] = lesson_of(entry);
  return state;
}

void Kept::put_aside() {
  const fs::path aside = beside(path_, ".damaged");
  std::error_code error;
  fs::rename(path_, aside, error);
  set_aside_ = error ? std::string() : aside.string();
}

void Kept::merge(State file) {
  invited = std::max(invited, file.invited);
  if (view == view_read_) view = file.view;
  view_read_ = view;
  if (erased_) return;
  if (student == student_read_) student = file.student;
  student_read_ = student;
  if (recent == recent_read_) recent = file.recent;
  recent_read_ = recent;
  for (auto& [id, work] : file.sheets) {
    const SheetWork before = sheets_read_[id];
    take_parts(sheets_[id].written, before.written, std::move(work.written));
    take_parts(sheets_[id].measured, before.measured, std::move(work.measured));
    take_parts(sheets_[id].built, before.built, std::move(work.built));
  }
  sheets_read_ = sheets_;
  if (changed_.empty() || !folder_.empty()) last_ = file.last;
  for (auto& [id, exercise] : file.exercises)
    if (changed_.count("exercise:" + id) == 0) exercises_[id] = std::move(exercise);
  for (auto& [id, lesson] : file.lessons) {
    if (changed_.count(id) == 0) {
      lessons_[id] = std::move(lesson);
      continue;
    }
    KeptLesson& own = lessons_[id];
    if (own.hash != lesson.hash) continue;
    own.done = own.done || lesson.done, own.task = own.task || lesson.task;  // a lesson once done stays done
  }
}

const KeptLesson* Kept::lesson(const std::string& id, std::uint64_t hash) const {
  const auto found = lessons_.find(key(id));
  return found != lessons_.end() && found->second.hash == hash ? &found->second : nullptr;
}

void Kept::keep(const lesson::Session& session, std::uint64_t hash, std::vector<double> camera) {
  const std::string& id = session.lesson().id;
  const lesson::Progress progress = lesson::progress_of(session);
  const KeptLesson* before = lesson(id, hash);
  if (!progress.begun && before == nullptr) return;
  KeptLesson now;
  now.hash = hash;
  now.place = lesson::NamedStages().place_of(session);
  now.place.camera = std::move(camera);
  now.place.step = now.step = session.player().step(), now.steps = session.player().steps();
  now.answered = progress.answered;
  // A lesson once done stays done, even if it is opened again.
  now.done = progress.done || (before != nullptr && before->done);
  now.task = progress.task || (before != nullptr && before->task);
  now.answers = lesson::kept_text(lesson::answers_of(session));
  now.text = text_of_stage(session);
  lessons_[key(id)] = std::move(now);
  changed_.insert(key(id));
  if (folder_.empty()) last_ = id;
}

const KeptExercise* Kept::exercise(const std::string& id) const {
  const auto found = exercises_.find(key(id));
  return found != exercises_.end() ? &found->second : nullptr;
}

void Kept::keep(lesson::Attempt attempt, double mark, int of, bool finished, bool counts) {
  if (attempt.made.empty()) return;
  const std::string id = key(attempt.exercise);
  KeptExercise& own = exercises_[id];
  changed_.insert("exercise:" + id);
  if (!finished) return static_cast<void>(own.now = std::move(attempt));
  own.tries += counts ? 1 : 0;
  own.now.reset();
  if (own.of == 0 || mark * own.of > own.mark * of) own.mark = mark, own.of = of;
}

void Kept::erase() {
  lessons_.clear();
  exercises_.clear();
  sheets_.clear();
  sheets_read_.clear();
  student.clear();
  recent.clear();
  changed_.clear();
  last_.clear();
  erased_ = true;
}

std::string Kept::text() const {
  Json state{{"version", kVersion}, {"last", last_}, {"invited", invited}, {"lessons", Json::object()}};
  if (view)
    state["view"] = {{"theme", view->theme}, {"text_scale", view->text_scale},
                     {"width", view->width}, {"height", view->height},
                     {"x", view->x},         {"y", view->y}};
  for (const auto& [id, exercise] : exercises_) {
    state["exercises"][id] = {{"tries", exercise.tries}, {"mark", exercise.mark}, {"of", exercise.of}};
    if (exercise.now) state["exercises"][id]["now"] = json_of(*exercise.now, 0, 0);
  }
  if (!recent.empty()) state["recent"] = recent;
  if (!student.empty()) state["student"] = student;
  for (const auto& [id, work] : sheets_)
    if (!work.written.empty() || !work.measured.empty() || !work.built.empty())
      state["sheets"][id] = json_of(id, 0, work);
  for (const auto& [id, lesson] : lessons_) {
    state["lessons"][id] = {{"place", lesson::address_of(lesson.place)},
                            {"step", lesson.step},
                            {"steps", lesson.steps},
                            {"answered", lesson.answered},
                            {"done", lesson.done},
                            {"task", lesson.task},
                            {"answers", lesson.answers}};
    if (lesson.hash != 0) state["lessons"][id]["hash"] = lesson.hash;
    if (lesson.text != 0) state["lessons"][id]["text"] = lesson.text;
  }
  return state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void Kept::write() {
  if (path_.empty() || text() == written_) return;
  std::error_code error;
  if (last_.empty() && lessons_.empty() && exercises_.empty() && changed_.empty() && recent.empty() && !view &&
      !fs::exists(path_, error))
    return;  // nothing was begun yet
  fs::create_directories(path_.parent_path(), error);
  const Lock lock(beside(path_, ".lock"));
  if (auto file = read()) merge(std::move(*file));
  if (path_.empty()) return;  // a later program has written it meanwhile
  written_ = text();
  works_ = write_file(path_.string(), written_).has_value();  // tried again with the next change, if it failed
  erased_ = false;
}

}  // namespace snug::desktop
