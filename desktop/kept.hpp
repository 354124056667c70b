// What the window keeps until it is opened again: how it looks, the progress in each lesson, the place in it, and the
// answers. It is a separate file beside other programs' state. Several windows may keep it at once: each writes its own
// lessons and leaves the others'. A damaged file is set aside, and everything starts anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "desktop/cli/sheet_files.hpp"
#include "lesson/exercise/attempt.hpp"
#include "lesson/invitations.hpp"
#include "lesson/place.hpp"

namespace snug::desktop {

struct KeptLesson {
  std::uint64_t hash = 0;  // of the file, for a lesson of one's own: once it says something else, it starts anew
  lesson::Place place;
  std::uint64_t text = 0;  // of the stage as the lesson has it: what the place changes of it holds for no other
  int step = 0, steps = 0;
  int answered = 0;
  bool done = false, task = false;
  std::string answers;  // as lesson::kept_text writes them
};

/// The hash of the text that the lesson's own stage is made from; 0 without one.
[[nodiscard]] std::uint64_t text_of_stage(const lesson::Session& session);

/// An exercise: how many attempts were finished, what the best of them earned, and one that is not finished.
struct KeptExercise {
  int tries = 0;
  double mark = 0;
  int of = 0;
  std::optional<lesson::Attempt> now;
};

/// How the window looks. width, height, and its place: in the window system's own units.
struct KeptView {
  int theme = 0;
  float text_scale = 1;
  int width = 0, height = 0;
  int x = 0, y = 0;
  friend bool operator==(const KeptView&, const KeptView&) = default;
};

class Kept {
 public:
  /// Reads course.json in $XDG_STATE_HOME/snug, or else in ~/.local/state/snug. If neither variable names a folder,
  /// nothing is kept. folder: that of lessons of one's own, which are kept apart from the course's; empty for the
  /// course.
  explicit Kept(const std::string& folder = "");
  /// Keeps nothing: pictures leave no trace.
  struct Nothing {};
  explicit Kept(Nothing) : invited(lesson::Invitations::kAll), works_(false) {}

  /// The last lesson; empty before the first.
  [[nodiscard]] const std::string& last() const { return last_; }
  /// A lesson's state; null if it was not begun, or if its file had another hash.
  [[nodiscard]] const KeptLesson* lesson(const std::string& id, std::uint64_t hash) const;
  /// Keeps a session's state, once something was done in it; in memory until write.
  void keep(const lesson::Session& session, std::uint64_t hash, std::vector<double> camera);
  /// An exercise's state; null if it was not begun.
  [[nodiscard]] const KeptExercise* exercise(const std::string& id) const;
  /// Keeps an attempt, once something was decided in it; in memory until write.
  void keep(lesson::Attempt attempt, double mark, int of, bool finished, bool counts);
  /// What was done of a lab sheet; sheet_changed says that it is to be kept, in memory until write.
  [[nodiscard]] SheetWork& sheet(const std::string& id) { return sheets_[id]; }
  void sheet_changed(const std::string& id) { changed_.insert("sheet:" + id); }
  /// The point files that were opened last, the latest first.
  std::vector<std::string> recent;
  /// The student's name; empty until one is typed.
  std::string student;
  /// Erases everything but the invitations, which are not shown again.
  void erase();
  /// Whether the file could be written the last time.
  [[nodiscard]] bool works() const { return works_; }
  /// Where a file went that could not be understood; empty if there was none.
  [[nodiscard]] const std::string& set_aside() const { return set_aside_; }
  /// How many invitations on the first lesson's stage were followed.
  int invited = 0;
  /// How the window looked last; none before the first time. Of several windows, the one that changed it last decides.
  std::optional<KeptView> view;
  /// Writes what has changed, into what other windows wrote meanwhile. If the file cannot be written, only its content
  /// is lost.
  void write();

 private:
  using Lessons = std::map<std::string, KeptLesson>;
  using Exercises = std::map<std::string, KeptExercise>;
  struct State {
    std::string last;
    int invited = 0;
    std::optional<KeptView> view;
    Lessons lessons;
    Exercises exercises;
    std::map<std::string, SheetWork> sheets;
    std::string student;
    std::vector<std::string> recent;
  };
  /// What the file says; none if it is not there, or set aside.
  [[nodiscard]] std::optional<State> read();
  /// What a lesson or an exercise is kept by.
  [[nodiscard]] std::string key(const std::string& id) const { return folder_.empty() ? id : folder_ + id + ".toml"; }
  void put_aside();
  /// Takes the lessons that this window has not changed from the file, and what was done in either window.
  void merge(State file);
  [[nodiscard]] std::string text() const;

  std::filesystem::path path_;  // empty: nothing is written
  std::string folder_;          // with a slash at its end; empty for the course
  bool works_ = true, erased_ = false;
  std::string last_, written_, set_aside_;
  Lessons lessons_;
  Exercises exercises_;
  std::map<std::string, SheetWork> sheets_, sheets_read_;  // the second: as the file had them last
  std::string student_read_;
  std::vector<std::string> recent_read_;
  std::set<std::string> changed_;  // the lessons and exercises that this window has kept
  std::optional<KeptView> view_read_;
};

}  // namespace snug::desktop
