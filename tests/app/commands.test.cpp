#include "app/commands.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

namespace snug::app {

TEST_CASE("arrow keys step, and move the selected point where there is one") {
  CHECK(command_for("ArrowRight", false, false) == "step");
  CHECK(command_for("ArrowLeft", false, false) == "back");
  CHECK(command_for("ArrowRight", true, false) == "step");
  CHECK(command_for("ArrowRight", false, false, {.selected = true}) == "move_right");
  CHECK(command_for("ArrowUp", true, false, {.selected = true}) == "move_up_fine");
  CHECK(command_for("ArrowUp", false, true, {.selected = true}) == "orbit_up");
  CHECK(command_for("<", true, false, {.selected = true}) == "move_farther_fine");
  CHECK(command_for("<", true, false) == "slower");
}

TEST_CASE("the player's keys, and the lecturer's clicker") {
  CHECK(command_for(" ", false, false, {.selected = true}) == "play");
  CHECK(command_for("Home", false, false) == "first");
  CHECK(command_for("End", false, false) == "last");
  CHECK(command_for("PageDown", false, false, {.selected = true}) == "next_mark");
  CHECK(command_for("PageUp", false, false) == "previous_mark");
}

TEST_CASE("undo and redo, with Caps Lock on as well; unknown keys mean nothing") {
  CHECK(command_for("z", false, true) == "undo");
  CHECK(command_for("Z", false, true) == "undo");
  CHECK(command_for("Z", true, true) == "redo");
  CHECK(command_for("z", true, true) == "redo");
  CHECK(command_for("y", false, true) == "redo");
  CHECK(command_for("z", false, false).empty());
  CHECK(command_for("F5", false, false).empty());
  CHECK(command_for("Delete", false, false, {.selected = true}) == "delete_point");
  CHECK(command_for("Escape", false, false, {.selected = true}) == "select_none");
}

TEST_CASE("in an exercise Backspace takes back, H hints; at the summary Escape closes it") {
  CHECK(command_for("Backspace", false, false) == "delete_point");
  CHECK(command_for("Backspace", false, false, {.exercise = true}) == "take_back");
  CHECK(command_for("H", true, false, {.exercise = true}) == "hint");
  CHECK(command_for("r", false, false, {.exercise = true}) == "other_run");
  CHECK(command_for("h", false, false).empty());
  CHECK(command_for("Escape", false, false, {.summary = true}) == "close_summary");
}

TEST_CASE("each command has a name of its own, and its key is on the card") {
  std::set<std::string_view> names;
  for (const Command& command : commands()) {
    CAPTURE(command.name);
    CHECK(names.insert(command.name).second);
    CHECK(find_command(command.name) == &command);
    const bool is_said_by_others = command.name.ends_with("_fine") || command.name.starts_with("orbit_") ||
                                   command.where == Command::Where::kAtSummary;
    CHECK((command.keys.empty() || !command.card.empty() || is_said_by_others));
  }
  CHECK(find_command("turn:gravity")->name == "turn:");
  CHECK(find_command("turn") == nullptr);
  CHECK(find_command("") == nullptr);
}

TEST_CASE("keys are shown as people read them") {
  CHECK(shown_key(find_command("undo")->keys) == "Ctrl Z");
  CHECK(shown_key(find_command("play")->keys) == "Space");
  CHECK(shown_key("Ctrl+Shift+PageDown") == "Ctrl Shift PgDn");
  CHECK(shown_key("+ =") == "+");
  CHECK(shown_key("").empty());
  const std::vector<KeyRow> rows = key_rows();
  CHECK(rows.front().keys == "→  ←");
  CHECK(rows.front().words == "next, previous");
  CHECK(std::any_of(rows.begin(), rows.end(), [](const KeyRow& row) { return row.keys == "+  −  0"; }));
}

}  // namespace snug::app
