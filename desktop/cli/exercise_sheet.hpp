// An exercise on paper: an instance as an SVG page, with lines for the answers, or with the solution.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "lesson/exercise/instance.hpp"

namespace snug::desktop {

/// A page of A4. solved: with the right answers in place of the lines. Errors: the instance is in space, or has neither
/// points nor volumes, so that it cannot be drawn flat.
[[nodiscard]] tl::expected<std::string, InputError>
sheet_of(const lesson::Exercise& exercise, const lesson::Session& session, std::uint64_t seed, bool solved);

}  // namespace snug::desktop
