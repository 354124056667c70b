// A lesson's two boxes as the page reads and writes them.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "lesson/session.hpp"

namespace snug::web {

/// [{center, half_extents, degrees}] of A and B; null where there are points. degrees: in 2-D, of the first axis.
[[nodiscard]] emscripten::val boxes_object(const lesson::Session& session);

/// For an address, so that it leads to the same bits: a row for each box, of its centre, its half extents, and its axes
/// (in 2-D of the first alone).
[[nodiscard]] emscripten::val box_rows(const lesson::Session& session);

/// What an address says. An error is a sentence; "" is none.
[[nodiscard]] std::string set_box_rows(lesson::Session& session, const emscripten::val& rows);

/// Sets a box's numbers. values: as long as the centre or the half extents.
[[nodiscard]] std::string set_box(lesson::Session& session, int box, const std::string& what,
                                  const emscripten::val& values);

/// Counter-clockwise about a world axis (0 … 2; in 2-D 2): by so many degrees, or in 2-D to so many.
[[nodiscard]] std::string turn_box(lesson::Session& session, int box, int axis, double degrees, bool to);

}  // namespace snug::web
