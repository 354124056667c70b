// What the window keeps until it is opened again: how far each lesson is, where one was in it, the answers given. A
// file of its own beside other programs' state; without it, or with one that is damaged, one starts anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "lesson/session.hpp"

namespace snug::desktop {

struct KeptLesson {
  std::uint64_t seed = 0;
  int step = 0, steps = 0;
  int answered = 0;
  bool done = false, task = false;
  std::string answers;  // as lesson::kept_text writes them
};

class Kept {
 public:
  /// Reads course.json of $XDG_STATE_HOME/snug, else of ~/.local/state/snug. Where neither variable names a folder,
  /// nothing is kept.
  Kept();
  /// Keeps nothing, for a picture.
  struct Nothing {};
  explicit Kept(Nothing) {}

  /// The lesson that one was in; empty before the first.
  [[nodiscard]] const std::string& last() const { return last_; }
  /// Null where it was not begun.
  [[nodiscard]] const KeptLesson* lesson(const std::string& id) const;
  /// Where a session stands, once something was done in it. In memory until write.
  void keep(const lesson::Session& session);
  void erase();
  /// The invitations on the first lesson's stage that were followed.
  int invited = 0;
  /// Writes what has changed. A file that cannot be written costs no more than what it would have kept.
  void write();

 private:
  void read(const std::string& text);

  std::filesystem::path path_;  // empty: nothing is written
  std::string last_, written_;
  std::map<std::string, KeptLesson> lessons_;
};

}  // namespace snug::desktop
