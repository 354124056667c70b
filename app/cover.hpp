// What can replace the stage, for subjects that have more to show than the stage can.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"

namespace snug::app {

class Cover {
 public:
  Cover() = default;
  virtual ~Cover() = default;
  Cover(const Cover&) = delete;
  Cover& operator=(const Cover&) = delete;

  /// Whether it is shown instead of the stage now.
  [[nodiscard]] virtual bool shown() const = 0;
  virtual void show(bool on) = 0;
  /// The words on the button that switches to the other of the two.
  [[nodiscard]] virtual std::string_view button_words() const = 0;
  /// Draws in the current pane.
  virtual void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) = 0;
  [[nodiscard]] virtual std::string caption(const lesson::Session& session) const = 0;
  [[nodiscard]] virtual std::vector<Handle> handles() const = 0;

  /// Runs one of its own commands, which take precedence. Returns false if it is unknown or impossible now.
  virtual bool command(lesson::Session& session, std::string_view name) = 0;
  /// The command of one of its own keys, which take precedence; empty for none.
  [[nodiscard]] virtual std::string_view command_of_key(std::string_view key) const = 0;
  /// Loads a file's points. Errors: those of Session::load.
  virtual tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                              std::string_view name) = 0;
  /// Continues its work for budget nanoseconds, or by one indivisible piece.
  virtual void work(lesson::Session& session, double budget) = 0;
  /// Whether work is in progress, and how much of it is done, from 0 to 1.
  [[nodiscard]] virtual bool running() const = 0;
  [[nodiscard]] virtual double progress() const = 0;
  /// A number that changes with whatever it shows.
  [[nodiscard]] virtual int version() const = 0;
};

}  // namespace snug::app
