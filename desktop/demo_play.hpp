// A demo in the window: which state is shown, how much of it is revealed, and the keys of a clicker.
#pragma once

#include <ctime>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "desktop/cli/demo_files.hpp"
#include "lesson/vote.hpp"

namespace snug::desktop {

class Shell;

class DemoPlay {
 public:
  explicit DemoPlay(std::shared_ptr<const DemoFile> file) : file_(std::move(file)) {}

  [[nodiscard]] const std::vector<lesson::DemoState>& states() const { return file_->demo.states; }
  /// The state that is shown, counted from 0.
  [[nodiscard]] std::size_t at() const { return at_; }
  /// Whether a part stands beside the stage now.
  [[nodiscard]] bool shows(std::string_view part) const;
  /// "7 of 20"
  [[nodiscard]] std::string place_text() const;

  /// Shows a state as the file has it, with the first reveals.
  void show(Shell& shell, std::size_t state, std::size_t revealed = 0);
  /// Runs a key of the demo. Returns whether it was one.
  bool answer_key(Shell& shell, const std::string& key);
  /// A key is held, and was told as often as keyboards repeat it. One that leads then shows what stood there before it
  /// was pressed, as the file has it. Returns whether it was one.
  bool hold_key(Shell& shell, const std::string& key);

  /// The class's vote in this state, if there was one; and whether what it gave may be seen.
  [[nodiscard]] const lesson::Vote* vote() const;
  [[nodiscard]] bool vote_told() const;
  /// Whether something stands in its place that was revealed later.
  [[nodiscard]] bool vote_over() const;
  /// What the next press does.
  [[nodiscard]] std::string next_text() const;

  bool notes_wanted = false;  // whether the second window shows the notes
  double notes_second = -1;   // the clock's second that they show
  std::time_t began = std::time(nullptr);

 private:
  /// What is revealed so far.
  [[nodiscard]] std::span<const std::string> revealed() const {
    return std::span(states()[at_].reveal).first(revealed_);
  }
  void next(Shell& shell);
  void back(Shell& shell);
  void reveal(Shell& shell, const std::string& what, bool played);
  bool vote_by_key(Shell& shell, const std::string& key);

  std::shared_ptr<const DemoFile> file_;
  std::size_t at_ = 0, revealed_ = 0;
  std::pair<std::size_t, std::size_t> before_;  // the same before the last key that led
  int repeated_ = 0;                            // how often that was told again since it was pressed
  std::map<std::size_t, lesson::Vote> votes_;   // by the states
};

}  // namespace snug::desktop
