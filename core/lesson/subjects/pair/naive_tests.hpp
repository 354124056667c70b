// The tests of two boxes that trust rounded numbers, each beside the exact truth about the numbers that it was given.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::lesson {

/// The methods: without an epsilon, with three kinds of it, each in double and in float; and the face axes alone.
[[nodiscard]] std::span<const Method> naive_tests();
[[nodiscard]] bool is_naive(std::string_view test);

/// Runs one of them on the boxes, rounded to float first if it is one in float. Returns what it says.
bool run_naive(std::string_view test, const BoxPair& pair, RecordPair& observe);

/// Whether the boxes that the test is given share a point, exactly: rounded to float for a test in float.
[[nodiscard]] bool overlap_exactly(std::string_view test, const BoxPair& pair);

/// What a row, or the verdict, should have said, in exact arithmetic on the numbers that the test was given.
struct RowTruth {
  bool separates = false;
  double gap = 0;   // scene units
  double ulps = 0;  // the same in units in the last place of the boxes' size, in the test's own kind of number
};
/// One for each step of a naive test's trace; empty for any other test. At the verdict, only `separates` has a meaning:
/// whether the boxes are apart. At a step that is neither a row nor the verdict, nothing has.
[[nodiscard]] std::vector<RowTruth> row_truths(std::string_view test, const BoxPair& pair, PairSteps trace);

/// Whether a row says what is not so.
[[nodiscard]] bool is_wrong(const query::AxisTested<double, 3>& row, const RowTruth& truth);
/// "exactly, the projections overlap by 0.52 (4.7e15 ulps)"
[[nodiscard]] std::string truth_text(const RowTruth& truth);

}  // namespace snug::lesson
