#include "desktop/cli/drafts.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "check/check_lesson.hpp"
#include "desktop/cli/files.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/sheet.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

/// Empty if there is no such file.
std::string stamp_of(const std::string& path) {
  std::error_code error;
  const auto time = fs::last_write_time(path, error);
  const auto size = error ? 0 : fs::file_size(path, error);
  if (error) return {};
  return std::to_string(time.time_since_epoch().count()) + ' ' + std::to_string(size);
}

/// played: whether to play the lesson as well, which takes up to seconds.
lesson::Draft draft_of(const std::string& text, const std::string& path, bool played) {
  lesson::Draft draft = check::checked_draft(text, path);
  tl::expected<std::optional<io::PointFile>, InputError> mesh;
  if (played && draft.lesson) mesh = mesh_of(*draft.lesson);
  if (mesh && *mesh) draft = check::checked_draft(text, path, &**mesh);
  check::check_names_beside(draft, path, beside(path));
  if (!mesh) draft.mistakes.push_back({1, mesh.error().what, path});
  else if (played) check::check_played(draft, path, *std::move(mesh));
  return draft;
}

/// A lab sheet's lesson, and the sheet.
lesson::Draft sheet_draft(const std::string& text, LessonFile& file) {
  lesson::SheetDraft read = lesson::read_sheet(text, file.path);
  if (!read.mistakes.empty()) return {{}, std::move(read.mistakes), {}};
  file.sheet = std::make_shared<const lesson::Sheet>(std::move(read.sheet));
  return {file.sheet->lesson, {}, {}};
}

void read_into(DraftFile& draft, bool played) {
  const std::string& path = draft.file.path;
  const auto text = read_start(path, lesson::kMostLessonBytes);
  draft.file.sheet = nullptr;
  lesson::Draft read = !text                     ? lesson::Draft{{}, {{1, text.error().what, path}}, {}}
                       : lesson::is_sheet(*text) ? sheet_draft(*text, draft.file)
                                                 : draft_of(*text, path, played);
  draft.says = check::text_of(read, fs::path(path).filename().string());
  draft.played = played;
  draft.draws = read.lesson.has_value();
  if (!draft.draws) return;
  draft.file.lesson = *std::move(read.lesson), draft.drawn = true;
  draft.hash = lesson::hash_of_text(*text);
}

/// Reads it if it has changed. names: of the files beside it. Returns whether it has.
bool read_anew(DraftFile& draft, const std::string& names) {
  std::string stamp = stamp_of(draft.file.path) + ' ' + names;
  if (draft.version > 0 && stamp == draft.stamp) return false;
  draft.stamp = std::move(stamp);
  read_into(draft, false);
  ++draft.version;
  return true;
}

DraftFile unread(const std::string& path) {
  DraftFile draft;
  draft.file.path = path;
  draft.file.lesson.id = draft.file.lesson.title = id_of(path);
  return draft;
}

std::string name_of_folder(const std::string& folder) {
  std::error_code error;
  fs::path path = fs::absolute(folder, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  return path.filename().string();
}

}  // namespace

tl::expected<Drafts, InputError> Drafts::open(std::string folder, std::string file) {
  Drafts drafts(std::move(folder), std::move(file));
  if (const auto paths = drafts.paths(); !paths) return tl::unexpected(paths.error());
  drafts.refresh("");
  return drafts;
}

/// Errors: those of the folder and the file; none is a lesson.
tl::expected<std::vector<std::string>, InputError> Drafts::paths() const {
  std::vector<std::string> all;
  if (!folder_.empty()) {
    auto of_folder = lesson_paths(folder_);
    if (!of_folder) return of_folder;
    all = *std::move(of_folder);
    if (all.empty() && file_.empty()) return tl::unexpected(no_lessons(folder_));
  }
  if (file_.empty()) return all;
  if (const auto text = read_start(file_, 0); !text) return tl::unexpected(text.error());
  std::error_code error;
  const bool listed =
      std::any_of(all.begin(), all.end(), [&](const std::string& path) { return fs::equivalent(path, file_, error); });
  if (!listed) all.push_back(file_);
  return all;
}

bool Drafts::refresh(std::string_view kept) {
  const auto now = paths();
  bool changed = false;
  if (now) {
    const auto gone = [&](const DraftFile& draft) {
      return draft.file.lesson.id != kept && std::find(now->begin(), now->end(), draft.file.path) == now->end();
    };
    changed = std::erase_if(files_, gone) > 0;
    for (const std::string& path : *now) {
      const auto same = [&](const DraftFile& draft) { return draft.file.path == path; };
      if (std::any_of(files_.begin(), files_.end(), same)) continue;
      files_.push_back(unread(path));
      changed = true;
    }
  }
  std::string names = folder_.empty() ? "" : stamp_of((fs::path(folder_) / kCourseFile).string());
  for (const DraftFile& draft : files_) names += ' ' + draft.file.path;
  for (DraftFile& draft : files_) changed = read_anew(draft, names) || changed;
  std::string stamp = folder_.empty() ? "" : stamp_of((fs::path(folder_) / kCourseFile).string());
  changed = std::exchange(course_stamp_, stamp) != stamp || changed;
  if (changed) put_in_order();
  return changed;
}

void Drafts::put_in_order() {
  std::map<std::string, std::pair<std::size_t, std::string>> ranks;  // a lesson's place and chapter
  course_says_ = {};
  if (!course_stamp_.empty()) {
    const auto course = read_course_of(folder_);
    if (!course) {
      course_says_ = check::text_of(course.error(), kCourseFile);
    } else {
      for (const lesson::Chapter& chapter : course->chapters)
        for (const std::string& id : chapter.lessons) ranks.emplace(id, std::pair(ranks.size(), chapter.title));
      for (DraftFile& draft : files_) draft.file.slides = lesson::slides_of(*course, draft.file.lesson.covers);
    }
  }
  const auto rank = [&](const DraftFile& draft) {
    const auto found = ranks.find(draft.file.lesson.id);
    return std::pair(found != ranks.end() ? found->second.first : ranks.size(), draft.file.path);
  };
  std::sort(files_.begin(), files_.end(), [&](const DraftFile& a, const DraftFile& b) { return rank(a) < rank(b); });
  const std::string others = folder_.empty() ? std::string() : name_of_folder(folder_);
  for (DraftFile& draft : files_) {
    const auto found = ranks.find(draft.file.lesson.id);
    draft.file.chapter = found != ranks.end() ? found->second.second : others;
  }
}

void Drafts::play(std::string_view id) {
  for (DraftFile& draft : files_)
    if (draft.file.lesson.id == id && !draft.played) read_into(draft, true);
}

const DraftFile* Drafts::find(std::string_view id) const {
  const auto found =
      std::find_if(files_.begin(), files_.end(), [&](const DraftFile& draft) { return draft.file.lesson.id == id; });
  return found != files_.end() ? &*found : nullptr;
}

}  // namespace snug::desktop
