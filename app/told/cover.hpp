// What can cover the stage: its controls, its table in words, its files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cover.hpp"
#include "app/told/words.hpp"

namespace snug::app::told {

using CoverFormat = Word<"csv", "json", "svg", "png">;

/// See app::Cover. any: whether there is something to save.
struct Cover {
  std::vector<CoverButton> choices;
  std::array<CoverButton, 2> work;  // begin, end
  CoverButton button;
  bool shown = false, running = false;
  double progress = 0;
  bool decided = false;
  std::string says;
  WordTable table;
  std::vector<CoverFormat> formats;
  bool any = false;
  SNUG_FIELDS(choices, work, button, shown, running, progress, decided, says, table, formats, any);
};

struct Covers {
  std::optional<Cover> cover;  // none if the lesson has none
  SNUG_FIELDS(cover);
};

[[nodiscard]] Covers cover_of(App& app);

}  // namespace snug::app::told
