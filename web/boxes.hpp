// A lesson's two boxes, for the page to read and write.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "lesson/session.hpp"

namespace snug::web {

/// [{center, half_extents, degrees}] for A and B; null if there are points. degrees: in 2-D, of the first axis.
[[nodiscard]] emscripten::val boxes_object(const lesson::Session& session);

/// The boxes for an address, exact to the last bit: a row for each box, with its centre, its half extents, and its axes
/// (in 2-D only the first).
[[nodiscard]] emscripten::val box_rows(const lesson::Session& session);

/// Sets the boxes from an address. Returns an error as a sentence, or "".
[[nodiscard]] std::string set_box_rows(lesson::Session& session, const emscripten::val& rows);

/// Sets a box's numbers. values: as long as the centre or the half extents.
[[nodiscard]] std::string set_box(lesson::Session& session, int box, const std::string& what,
                                  const emscripten::val& values);

/// Rotates a box counter-clockwise about a world axis (0 … 2; in 2-D 2), by some degrees or, in 2-D, to an angle.
[[nodiscard]] std::string turn_box(lesson::Session& session, int box, int axis, double degrees, bool to);

}  // namespace snug::web
