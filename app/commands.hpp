// The app's commands, one row each: what buttons, keys and scripts call it, its keys, what it does. Keys, menus, the
// card of keys and App::command read this table; a new command is a new row.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace snug::app {

struct AppState;

struct Command {
  /// Where its keys mean it; in the other places they may mean another command.
  enum class Where { kAnywhere, kNothingSelected, kSelected, kInExercise, kAtSummary };

  std::string_view name;  // "zoom_in"; "turn:" stands for all names that begin so
  /// Does it; about: what stands behind the colon of its name. Returns false if it is impossible now.
  bool (*does)(AppState& state, std::string_view about);
  std::string_view keys = {};  // "+ =", as browsers name keys, but "Space"; with "Ctrl+", "Shift+" before
  Where where = Where::kAnywhere;
  std::string_view menu = {};  // its words in menus: "Zoom in"
  std::string_view card = {};  // its words on the card of keys; empty: it is not there
};

/// Says on the card of keys that a command's key stands in the row above.
inline constexpr std::string_view kAbove = "above";

[[nodiscard]] std::span<const Command> commands();
/// The row of a name; null if there is none.
[[nodiscard]] const Command* find_command(std::string_view name);

/// What else decides what a key means.
struct KeyPlace {
  bool selected = false;  // a point, which arrow keys move
  bool exercise = false;
  bool summary = false;
};
/// The command of a key, as browsers name keys; empty for none.
[[nodiscard]] std::string_view command_for(std::string_view key, bool shift, bool control, const KeyPlace& place = {});
/// Whether a row's keys, or a menu's, have this one among them.
[[nodiscard]] bool has_key(std::string_view keys, std::string_view key, bool shift, bool control);
/// The first of its keys as people read it: "Ctrl Z", "PgDn", "→"; empty if it has none.
[[nodiscard]] std::string shown_key(std::string_view keys);

/// A row of the card of keys.
struct KeyRow {
  std::string keys, words;
};
/// The rows of all commands, and of what else a key does in every door.
[[nodiscard]] std::vector<KeyRow> key_rows();

}  // namespace snug::app
