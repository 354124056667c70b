// The window while its lessons are being written.
#include <algorithm>

#include "desktop/shell.hpp"
#include "lesson/reopening.hpp"

namespace snug::desktop {

/// Lists the lessons as the drafts have them; the one that is open stays that.
void Shell::take_files() {
  const std::string open = app_.session() != nullptr ? session().lesson().id : std::string();
  lessons_.clear();
  for (const DraftFile& draft : drafts_->files()) lessons_.push_back(draft.file);
  const auto it =
      std::find_if(lessons_.begin(), lessons_.end(), [&](const LessonFile& file) { return file.lesson.id == open; });
  open_ = it != lessons_.end() ? static_cast<std::size_t>(it - lessons_.begin()) : 0;
  course.lessons_changed();
}

bool Shell::waits_for(const std::string& id) {
  const DraftFile* const draft = drafts_ ? drafts_->find(id) : nullptr;
  if (draft == nullptr || draft->drawn) return false;
  waited_for_ = id;
  return course_shown = true;
}

const std::string& Shell::of_strip() const {
  static const std::string kNobody;
  if (!waited_for_.empty()) return waited_for_;
  return !course_shown && app_.session() != nullptr ? app_.session()->lesson().id : kNobody;
}

bool Shell::look_at_files() {
  if (!drafts_ || !drafts_->refresh(app_.session() != nullptr ? session().lesson().id : waited_for_)) return false;
  take_files();
  if (!waited_for_.empty()) {
    const DraftFile* const draft = drafts_->find(waited_for_);
    if (draft != nullptr && draft->drawn) open_at_place(std::string(waited_for_));
  }
  read_again();
  return true;
}

void Shell::read_again() {
  if (app_.session() == nullptr) return;
  const DraftFile* const draft = drafts_->find(session().lesson().id);
  if (draft == nullptr || draft->version == opened_version_ || !draft->draws) return;
  const lesson::Reopening place(session());
  const int hint = hint_of;
  if (!open(draft->file.lesson.id, true)) {
    if (!draft->says.empty()) notice.clear();  // the strip says it
    return;
  }
  place.take(session());
  kept_revision_.reset();  // what was done is kept with the file as it is now
  unread = false, hint_of = hint;
}

std::vector<check::DraftText> Shell::strip() const {
  std::vector<check::DraftText> all;
  if (!drafts_) return all;
  if (const DraftFile* const draft = drafts_->find(of_strip())) all.push_back(draft->says);
  all.push_back(drafts_->course_says());
  std::erase_if(all, [](const check::DraftText& says) { return says.empty(); });
  return all;
}

}  // namespace snug::desktop
