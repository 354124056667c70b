// An exercise on paper: an instance as an SVG page, with lines for the answers, or with the solution.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "lesson/exercise/instance.hpp"

namespace snug::desktop {

/// A page of A4. solved: with the right answers in place of the lines. In the plane the instance is drawn on squared
/// paper, in space in projection, with a table of coordinates. Errors: what stands on the stage cannot be drawn.
[[nodiscard]] tl::expected<std::string, InputError>
sheet_of(const lesson::Exercise& exercise, const lesson::Session& session, std::uint64_t seed, bool solved);

}  // namespace snug::desktop
