// Families of queries that are hard to decide, each answer held to an oracle in exact arithmetic; counted as those of
// core/fit/family_checks.hpp are.
#pragma once

#include <algorithm>
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

  void count(int answer, bool right, bool is_hard) {
    ++sets;
    ++answers[answer];
    wrong += !right;
    hard += is_hard;
    hash = (hash ^ static_cast<std::uint64_t>(answer)) * 0x100000001b3u;
  }
  /// Adds the tally of other queries. The order does not matter, not even to the hash.
  void add(const QueryTally& other) {
    sets += other.sets, hard += other.hard, wrong += other.wrong, hash += other.hash;
    for (std::size_t i = 0; i < answers.size(); ++i) answers[i] += other.answers[i];
  }
};

struct QueryFamily {
  std::string_view name;
  bool culls = true;    // answers: inside, intersecting, outside; or apart, overlapping
  double share = 0.25;  // of its sets are hard, at least
};
inline constexpr std::array kQueryFamilies{QueryFamily{"boxes that touch", false},
                                           QueryFamily{"volumes that touch a frustum's plane"},
                                           QueryFamily{"frusta with near at 1e-6 of far"},
                                           QueryFamily{"spheres, AABBs and k-DOPs on a lattice", false, 0.05},
                                           QueryFamily{"AABBs and spheres culled by their tree", true, 0.1},
                                           QueryFamily{"fields of AABBs, culled in six ways", true, 0.1}};

/// Adds a family's queries to the tally: one, or where they are cheap so many that 50,000 sets have a million. family:
/// an index of kQueryFamilies. Fields are in double and in space alone.
template <class Scalar, int Dim>
void add_query(QueryTally& tally, std::size_t family, std::uint64_t seed);

}  // namespace snug::test
