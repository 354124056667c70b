#include "app/commands.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace snug::app {

TEST_CASE("arrow keys step, and move the selected point where there is one") {
  CHECK(command_for("ArrowRight", false, false, false) == "step");
  CHECK(command_for("ArrowLeft", false, false, false) == "back");
  CHECK(command_for("ArrowRight", false, false, true) == "move_right");
  CHECK(command_for("ArrowUp", true, false, true) == "move_up_fine");
  CHECK(command_for("ArrowUp", false, true, true) == "orbit_up");
}

TEST_CASE("the player's keys, and the lecturer's clicker") {
  CHECK(command_for(" ", false, false, true) == "play");
  CHECK(command_for("Home", false, false, false) == "first");
  CHECK(command_for("End", false, false, false) == "last");
  CHECK(command_for("PageDown", false, false, true) == "next_mark");
  CHECK(command_for("PageUp", false, false, true) == "previous_mark");
}

TEST_CASE("undo and redo, with Caps Lock on as well; unknown keys mean nothing") {
  CHECK(command_for("z", false, true, false) == "undo");
  CHECK(command_for("Z", false, true, false) == "undo");
  CHECK(command_for("Z", true, true, false) == "redo");
  CHECK(command_for("z", true, true, false) == "redo");
  CHECK(command_for("y", false, true, false) == "redo");
  CHECK(command_for("z", false, false, false).empty());
  CHECK(command_for("F5", false, false, false).empty());
  CHECK(command_for("Delete", false, false, true) == "delete_point");
  CHECK(command_for("Escape", false, false, true) == "select_none");
}

TEST_CASE("The card of keys has every command that a key runs, and a menu finds its key") {
  for (const std::string_view command : commands_with_keys()) {
    CAPTURE(command);
    CHECK(std::any_of(std::begin(kKeyHelp), std::end(kKeyHelp), [&](const KeyHelp& row) {
      return (' ' + std::string(row.commands) + ' ').find(' ' + std::string(command) + ' ') != std::string::npos;
    }));
  }
  CHECK(key_of("undo") == "Ctrl z");
  CHECK(key_of("play") == " ");
  CHECK(key_of("reset_points").empty());
}

}  // namespace snug::app
