// What the window keeps until it is opened again: the progress in each lesson, the place in it, and the answers. It is
// a separate file beside other programs' state; if it is missing or damaged, everything starts anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "lesson/invitations.hpp"
#include "lesson/session.hpp"

namespace snug::desktop {

/// In the place of an algorithm's name: none stands beside.
inline constexpr std::string_view kNone = "none";

struct KeptLesson {
  std::uint64_t seed = 0;
  int step = 0, steps = 0;
  std::string situation;          // empty: the lesson's own
  std::string algorithm, beside;  // empty: the lesson's own choice; beside: "none" for none
  int answered = 0;
  bool done = false, task = false;
  std::string answers;     // as lesson::kept_text writes them
  lesson::StageFile file;  // the scene's file as the lesson has it, as it runs and as it was typed; empty: unchanged
};

class Kept {
 public:
  /// Reads course.json in $XDG_STATE_HOME/snug, or else in ~/.local/state/snug. If neither variable names a folder,
  /// nothing is kept.
  Kept();
  /// Keeps nothing: pictures and previewed lessons leave no trace.
  struct Nothing {};
  explicit Kept(Nothing) : invited(lesson::Invitations::kAll), works_(false) {}

  /// The last lesson; empty before the first.
  [[nodiscard]] const std::string& last() const { return last_; }
  /// A lesson's state; null if it was not begun.
  [[nodiscard]] const KeptLesson* lesson(const std::string& id) const;
  /// Keeps a session's state, once something was done in it; in memory until write.
  void keep(const lesson::Session& session);
  /// Erases everything but the invitations, which are not shown again.
  void erase();
  /// Whether the file could be written the last time.
  [[nodiscard]] bool works() const { return works_; }
  /// How many invitations on the first lesson's stage were followed.
  int invited = 0;
  /// Writes what has changed. If the file cannot be written, only its content is lost.
  void write();

 private:
  void read(const std::string& text);

  std::filesystem::path path_;  // empty: nothing is written
  bool works_ = true;
  std::string last_, written_;
  std::map<std::string, KeptLesson> lessons_;
};

}  // namespace snug::desktop
