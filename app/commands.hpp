// The names of what keys and buttons do, and the keys that say them.
#pragma once

#include <string_view>

namespace snug::app {

/// The command of a key, as the browser names keys; empty for none. has_selection: whether a point is selected that
/// the arrow keys move then.
[[nodiscard]] std::string_view command_for(std::string_view key, bool shift, bool control, bool has_selection);

/// What the keys do, for people: pairs of keys and words, in the order of a help card.
struct KeyHelp {
  std::string_view keys, does;
};
inline constexpr KeyHelp kKeyHelp[] = {
    {"→  ←", "next, previous"},
    {"Space", "play or pause"},
    {"Home  End", "the beginning, the end"},
    {"PgDn  PgUp", "the next mark (past a question as well), the one before"},
    {"<  >", "slower, faster"},
    {"[  ]", "select the point before, the next one; of a question, what can be its answer"},
    {"↑ ↓ ← →", "move the selected point; with Shift by a tenth"},
    {",  .", "move it away, move it nearer (3-D)"},
    {"A", "add a point"},
    {"Delete", "delete the selected point"},
    {"Esc", "select nothing"},
    {"Ctrl Z  Ctrl Y", "undo, redo"},
    {"+  −  0", "nearer, farther, the whole view"},
    {"Ctrl + arrows", "orbit (3-D)"},
    {"O", "show the smallest volume"},
    {"1  2  3", "choose the question's first, second, third choice; once more answers"},
    {"Enter", "answer with what is chosen"},
    {"S", "skip the question"},
    {"M  C  V", "in costs: measure, the chart or the shape, the next chart"},
    {"Ctrl S", "in costs: save what was measured, as CSV"},
};

}  // namespace snug::app
