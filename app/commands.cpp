#include "app/commands.hpp"

#include <array>

namespace snug::app {
namespace {

struct Row {
  std::string_view key, command;
};

constexpr std::array kAlways{Row{" ", "play"},
                             Row{"Home", "first"},
                             Row{"End", "last"},
                             Row{"PageDown", "next_mark"},
                             Row{"PageUp", "previous_mark"},
                             Row{"Delete", "delete_point"},
                             Row{"Backspace", "delete_point"},
                             Row{"Escape", "select_none"},
                             Row{"a", "add_point"},
                             Row{"A", "add_point"},
                             Row{"+", "zoom_in"},
                             Row{"=", "zoom_in"},
                             Row{"-", "zoom_out"},
                             Row{"0", "reset_view"},
                             Row{"<", "slower"},
                             Row{">", "faster"},
                             Row{"[", "select_previous"},
                             Row{"]", "select_next"},
                             Row{"p", "push"},
                             Row{"P", "push"},
                             Row{"o", "toggle_optimum"},
                             Row{"O", "toggle_optimum"},
                             Row{"Enter", "commit_answer"},
                             Row{"s", "skip_question"},
                             Row{"S", "skip_question"}};
constexpr std::array kWithControl{Row{"z", "undo"},
                                  Row{"y", "redo"},
                                  Row{"Y", "redo"},
                                  Row{"Z", "redo"},
                                  Row{"ArrowLeft", "orbit_left"},
                                  Row{"ArrowRight", "orbit_right"},
                                  Row{"ArrowUp", "orbit_up"},
                                  Row{"ArrowDown", "orbit_down"}};
constexpr std::array kStepping{Row{"ArrowRight", "step"}, Row{"ArrowLeft", "back"}, Row{"ArrowDown", "step"},
                               Row{"ArrowUp", "back"}};
constexpr std::array kMoving{Row{"ArrowLeft", "move_left"}, Row{"ArrowRight", "move_right"}, Row{"ArrowUp", "move_up"},
                             Row{"ArrowDown", "move_down"}, Row{".", "move_nearer"},         Row{",", "move_farther"}};
constexpr std::array kMovingFine{Row{"ArrowLeft", "move_left_fine"}, Row{"ArrowRight", "move_right_fine"},
                                 Row{"ArrowUp", "move_up_fine"},     Row{"ArrowDown", "move_down_fine"},
                                 Row{">", "move_nearer_fine"},       Row{"<", "move_farther_fine"}};

std::string_view found(const auto& rows, std::string_view key) {
  for (const Row& row : rows)
    if (row.key == key) return row.command;
  return {};
}

}  // namespace

std::string_view command_for(std::string_view key, bool shift, bool control, bool has_selection) {
  // Shift and Z usually give "Z", but with Caps Lock on they give "z".
  if (control) return key == "z" && shift ? "redo" : key == "Z" && !shift ? "undo" : found(kWithControl, key);
  if (has_selection) {
    const std::string_view move = shift ? found(kMovingFine, key) : found(kMoving, key);
    if (!move.empty()) return move;
  } else if (const std::string_view step = found(kStepping, key); !step.empty()) {
    return step;
  }
  return found(kAlways, key);
}

std::vector<std::string_view> commands_with_keys() {
  std::vector<std::string_view> all;
  const auto take = [&](const auto& rows) {
    for (const Row& row : rows) all.push_back(row.command);
  };
  take(kAlways), take(kWithControl), take(kStepping), take(kMoving), take(kMovingFine);
  return all;
}

std::string key_of(std::string_view command) {
  for (const Row& row : kWithControl)
    if (row.command == command) return "Ctrl " + std::string(row.key);
  for (const Row& row : kAlways)
    if (row.command == command) return std::string(row.key);
  return {};
}

}  // namespace snug::app
