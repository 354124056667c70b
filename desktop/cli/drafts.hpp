// Lessons while they are being written: each as far as it can be read, and read anew when its file has changed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "check/draft_text.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {

struct DraftFile {
  LessonFile file;         // with the last lesson that could be drawn; before there is one, with an id and title alone
  bool drawn = false;      // whether there was one
  bool draws = false;      // whether the file as it reads now is one
  std::uint64_t hash = 0;  // of the text that the last lesson was read from
  int version = 0;         // how often the file was read
  check::DraftText says;   // what is wrong with the file
  std::string stamp;       // changes with the file, and with the names of those beside it
  bool played = false;     // whether `says` has what playing shows
};

class Drafts {
 public:
  /// The lessons of a folder, and that of a file besides; either may be "" for none. Errors: the folder or the file
  /// cannot be read; there is no lesson.
  [[nodiscard]] static tl::expected<Drafts, InputError> open(std::string folder, std::string file);

  /// Reads the files that have changed. A lesson whose file is gone is dropped, unless its id is `kept` or
  /// none is left. Returns whether anything has changed.
  bool refresh(std::string_view kept);
  /// Plays a lesson, unless that was done since its file changed, so that what it says has what only playing shows.
  void play(std::string_view id);
  /// In the order of the folder's course; by name if it has none or if there is a mistake in it.
  [[nodiscard]] const std::vector<DraftFile>& files() const { return files_; }
  /// Null if there is none with that id.
  [[nodiscard]] const DraftFile* find(std::string_view id) const;
  /// What is wrong with the folder's course file.
  [[nodiscard]] const check::DraftText& course_says() const { return course_says_; }

 private:
  Drafts(std::string folder, std::string file) : folder_(std::move(folder)), file_(std::move(file)) {}
  [[nodiscard]] tl::expected<std::vector<std::string>, InputError> paths() const;
  void put_in_order();

  std::string folder_, file_;
  std::vector<DraftFile> files_;
  std::string course_stamp_;
  check::DraftText course_says_;
};

}  // namespace snug::desktop
