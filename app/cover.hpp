// What can replace the stage, for subjects that have more to show than the stage can.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "trace/fields.hpp"

namespace snug::app {

struct Chart;

/// The part of a cover's rectangle that a chart has: below the buttons, or where it is low between them.
struct CoverRoom {
  Rect chart;
  float taken = 0;  // how far the buttons reach into the right end of its first line
};
/// below: the height of what stands beneath.
[[nodiscard]] CoverRoom cover_room(const Look& look, const Rect& rect, float below);

/// What a cover says while its predictions wait.
inline constexpr std::string_view kPressMeasure = "Press Measure: first you predict, then it is measured.";

/// A button that runs one of the cover's commands.
struct CoverButton {
  std::string command;
  std::string words;
  bool chosen = false;
  bool enabled = true;
  SNUG_FIELDS(command, words, chosen, enabled);
};

/// What the cover shows, in words, for people who cannot see it. If it can be sorted, everyone sees it.
struct WordTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;  // the first word of each row names it
  // The table that everyone sees:
  std::string title = {};
  std::vector<std::string> sorts = {};       // of each column, the command that sorts by it
  int sorted = -1;                           // the column that it is sorted by
  std::vector<std::string> picks = {};       // of each row, the command that chooses it
  int picked = -1;                           // the row that is chosen
  std::vector<std::vector<bool>> best = {};  // of each row and column, whether nothing in its column is better
  SNUG_FIELDS(head, rows, title, sorts, sorted, picks, picked, best);
};

class Cover {
 public:
  Cover() = default;
  virtual ~Cover() = default;
  Cover(const Cover&) = delete;
  Cover& operator=(const Cover&) = delete;

  /// Whether it is shown instead of the stage now.
  [[nodiscard]] virtual bool shown() const = 0;
  virtual void show(bool on) = 0;
  /// The button that switches to the other of the two.
  [[nodiscard]] virtual CoverButton button() const = 0;
  /// Draws in the current pane.
  virtual void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) = 0;
  [[nodiscard]] virtual std::string caption(const lesson::Session& session) const = 0;
  [[nodiscard]] virtual std::vector<Handle> handles() const = 0;

  /// Runs one of its own commands, which take precedence. Returns false if it is unknown or impossible now.
  virtual bool command(lesson::Session& session, std::string_view name) = 0;
  /// The command of one of its own keys, which take precedence; empty for none.
  [[nodiscard]] virtual std::string_view command_of_key(std::string_view key) const = 0;
  // ---- the controls that a door shows beside it ---------------------------------------------
  /// The charts or pictures that it can show, one at a time.
  [[nodiscard]] virtual std::vector<CoverButton> choices(const lesson::Session& session) const = 0;
  /// The buttons that start and stop its work.
  [[nodiscard]] virtual std::array<CoverButton, 2> work_buttons(const lesson::Session& session) const = 0;
  /// One line: what to do next, or the result.
  [[nodiscard]] virtual std::string status(const lesson::Session& session) const = 0;
  [[nodiscard]] virtual WordTable table(const lesson::Session& session) const = 0;
  /// Whether the predictions about it are decided.
  [[nodiscard]] virtual bool decided(const lesson::Session& session) const = 0;
  /// What it shows, as a file: the possible formats, the file's name without its extension, and the text, which is
  /// empty if there is nothing to save.
  [[nodiscard]] virtual std::span<const std::string_view> formats() const = 0;
  [[nodiscard]] virtual std::string file_name() const = 0;
  [[nodiscard]] virtual std::string file(std::string_view format) const = 0;
  /// The same as a picture (app/chart.hpp), which doors save as SVG and PNG; null if it is no chart.
  [[nodiscard]] virtual const Chart* picture() const { return nullptr; }
  /// Shows an earlier file, in the first format, over the current result. none: the text is no such file. Errors: those
  /// of reading it; it cannot be shown now.
  virtual std::optional<tl::expected<void, InputError>> lay_over(lesson::Session& session, std::string_view text,
                                                                 std::string_view name) = 0;

  /// Loads a file's points. Errors: those of Stage::load.
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
