// A held volume as a row of numbers, for an address that restores it.
#pragma once

#include <span>

#include "lesson/held_volume.hpp"

namespace snug::lesson {

/// Everything that hands can change: the volume's fields; for a k-DOP the bounds in use, for a hull its points.
[[nodiscard]] std::vector<double> row_of(const HeldVolume& held);

/// The volume with the numbers of a row, exact to the last bit. Errors: a wrong number of them; an impossible volume.
[[nodiscard]] tl::expected<HeldVolume, InputError> with_row(const HeldVolume& like, std::span<const double> row);

}  // namespace snug::lesson
