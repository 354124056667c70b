// The commands of keys and buttons, and the keys for them.
#pragma once

#include <string_view>

namespace snug::app {

/// The command of a key, as the browser names keys; empty for none. has_selection: whether a point is selected, so that
/// arrow keys move it.
[[nodiscard]] std::string_view command_for(std::string_view key, bool shift, bool control, bool has_selection);

/// The help card: pairs of keys and words, in order.
struct KeyHelp {
  std::string_view keys, does;
};
inline constexpr KeyHelp kKeyHelp[] = {
    {"→  ←", "next, previous"},
    {"Space", "play or pause"},
    {"Home  End", "the first step, the last step"},
    {"PgDn  PgUp", "the next mark, the previous one; at a question, PgDn twice skips it"},
    {"<  >", "slower, faster"},
    {"[  ]", "select the previous or the next point; in a question, those that can be the answer"},
    {"↑ ↓ ← →", "move the selected point; with Shift by a tenth"},
    {",  .", "move it farther away or nearer (3-D)"},
    {"A", "add a point"},
    {"Delete", "delete the selected point"},
    {"Esc", "select nothing"},
    {"Ctrl Z  Ctrl Y", "undo, redo"},
    {"+  −  0", "zoom in, zoom out, show everything"},
    {"Ctrl + arrows", "orbit (3-D)"},
    {"O", "show the smallest volume"},
    {"1  2  3", "choose an answer to the question; press again to give it"},
    {"Enter", "give the chosen answer; continue"},
    {"S", "skip the question"},
    {"M  C  V", "cost chart: measure, show the chart or the shape, the next chart"},
    {"Ctrl S", "cost chart: save the result as CSV"},
};

}  // namespace snug::app
