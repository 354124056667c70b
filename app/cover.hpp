// What can stand in the stage's place, of subjects that have more to show than the stage can.
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

  /// Whether it stands in the stage's place now.
  [[nodiscard]] virtual bool shown() const = 0;
  virtual void show(bool on) = 0;
  /// The words on the button that leads to the other of the two.
  [[nodiscard]] virtual std::string_view button_words() const = 0;
  /// In the current pane.
  virtual void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) = 0;
  [[nodiscard]] virtual std::string caption(const lesson::Session& session) const = 0;
  [[nodiscard]] virtual std::vector<Handle> handles() const = 0;

  /// Its own commands, before all others. false: there is none of that name, or it cannot be done now.
  virtual bool command(lesson::Session& session, std::string_view name) = 0;
  /// Its own keys, before all others; empty for none.
  [[nodiscard]] virtual std::string_view command_of_key(std::string_view key) const = 0;
  /// A file's points. Errors: as of Session::load.
  virtual tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                              std::string_view name) = 0;
  /// Goes on with what is under way for so many nanoseconds, or one piece that cannot be cut.
  virtual void work(lesson::Session& session, double budget) = 0;
  /// Whether something is under way, and how much of it is done, from 0 to 1.
  [[nodiscard]] virtual bool running() const = 0;
  [[nodiscard]] virtual double progress() const = 0;
  /// Changes with whatever it shows.
  [[nodiscard]] virtual int version() const = 0;
};

}  // namespace snug::app
