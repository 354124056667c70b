// The commands of keys and buttons, and the keys for them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snug::app {

/// The command of a key, as the browser names keys; empty for none. has_selection: whether a point is selected, so that
/// arrow keys move it.
[[nodiscard]] std::string_view command_for(std::string_view key, bool shift, bool control, bool has_selection);

/// The commands that have a key.
[[nodiscard]] std::vector<std::string_view> commands_with_keys();
/// The key of a command as doors name it in menus: "z" with Control is "Ctrl z"; empty if no key has it.
[[nodiscard]] std::string key_of(std::string_view command);

/// The help card: keys and words, in order; and the commands that they are the keys of, so that a test finds a key that
/// the card lacks.
struct KeyHelp {
  std::string_view keys, does, commands = {};
};
inline constexpr KeyHelp kKeyHelp[] = {
    {"→  ←", "next, previous", "step back"},
    {"Space", "play or pause", "play"},
    {"Home  End", "the first step, the last step", "first last"},
    {"PgDn  PgUp", "the next mark, the previous one; at a question, PgDn twice skips it", "next_mark previous_mark"},
    {"<  >", "slower, faster", "slower faster"},
    {"[  ]", "select the previous or the next point; in a question, those that can be the answer",
     "select_previous select_next"},
    {"↑ ↓ ← →", "move the selected point; with Shift by a tenth",
     "move_left move_right move_up move_down move_left_fine move_right_fine move_up_fine move_down_fine"},
    {",  .", "move it farther away or nearer (3-D)", "move_farther move_nearer move_farther_fine move_nearer_fine"},
    {"A", "add a point", "add_point"},
    {"Delete", "delete the selected point", "delete_point"},
    {"Esc", "select nothing", "select_none"},
    {"Ctrl Z  Ctrl Y", "undo, redo", "undo redo"},
    {"+  −  0", "zoom in, zoom out, show everything", "zoom_in zoom_out reset_view"},
    {"Ctrl + arrows", "orbit (3-D)", "orbit_left orbit_right orbit_up orbit_down"},
    {"P", "push a body of the scene", "push"},
    {"O", "show the smallest volume", "toggle_optimum"},
    {"1  2  3", "choose an answer to the question; press again to give it"},
    {"Enter", "give the chosen answer; continue", "commit_answer"},
    {"S", "skip the question", "skip_question"},
    {"M  C  V", "cost chart: measure, show the chart or the shape, the next chart"},
    {"Ctrl S", "cost chart: save the result as CSV"},
};

}  // namespace snug::app
