// Families of queries that are hard to decide, each answer held to an oracle in exact arithmetic; counted as those of
// core/fit/family_checks.hpp are.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace snug::test {

struct QueryTally {
  std::int64_t sets = 0;
  std::int64_t hard = 0;                  // rounded numbers could not decide them
  std::array<std::int64_t, 3> answers{};  // how often each was right: apart, overlapping; inside, intersecting, outside
  std::int64_t wrong = 0;                 // zero is promised
  std::uint64_t hash = 0xcbf29ce484222325u;
};

inline constexpr std::array<std::string_view, 3> kQueryFamilies{
    "boxes that touch", "volumes that touch a frustum's plane", "frusta with near at 1e-6 of far"};

/// Adds a family's query to the tally. family: an index of kQueryFamilies.
template <class Scalar, int Dim>
void add_query(QueryTally& tally, std::size_t family, std::uint64_t seed);

}  // namespace snug::test
