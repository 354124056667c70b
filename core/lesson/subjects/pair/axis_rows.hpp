// The formulas of the table of axes, row by row, and the numbers that each takes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::lesson {

/// What a row is computed from: bit 3 i + j for the entry R_ij, bit i for a number of t or for a half extent.
struct RowEntries {
  std::uint16_t rotation = 0;
  std::uint16_t rotation_a = 0, rotation_b = 0;  // those of them that r_A and r_B take
  std::uint8_t translation = 0, half_a = 0, half_b = 0;
};

/// A row's formulas as TeX, with indices counted from 1, times the length of the axis where two edges span it.
struct RowFormulas {
  std::string distance, radius_a, radius_b;
};

/// place: the row's index in axis_names(dim).
[[nodiscard]] RowEntries row_entries(int dim, int place);
[[nodiscard]] RowFormulas row_formulas(int dim, int place);

/// The row that a mark of the prose names, as the table does: "A x × B z". -1 for any other mark.
[[nodiscard]] int axis_of_mark(int dim, std::string_view mark);
/// Whether it is such a mark on this subject.
[[nodiscard]] bool is_axis_mark(const Subject& subject, std::string_view mark);

}  // namespace snug::lesson
