// What a panel beside the stage tells, in words, and what its button does: for people who do not see the canvas.
#pragma once

#include <optional>
#include <string>

#include "app/cover.hpp"

namespace snug::app {

struct PanelWords {
  WordTable table;
  std::string says = {};                   // below the table
  std::optional<CoverButton> button = {};  // runs one of the view's commands
};

}  // namespace snug::app
