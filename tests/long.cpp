// snug_long [SETS] [MINUTES]: so many members of each family (50,000 unless told), or as many as go into so many
// minutes, a quarter each in float and double, in the plane and in space, held to every promise. The tables go to
// standard output as Markdown; `./run test --long` puts them into tests/RESULTS.md. Exit status 1: a promise was
// broken.
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "core/fit/family_checks.hpp"
#include "core/query/query_families.hpp"

namespace {

using namespace snug;
using namespace snug::test;

constexpr int kBlock = 100;             // seeds of one family in a row
constexpr std::uint64_t kThorough = 8;  // one member in so many is transformed as well
constexpr std::array<const char*, 2> kScalars{"float", "double"};

struct Run {
  std::array<std::vector<FamilyTally>, 2> fits;  // by scalar and family
  std::array<std::array<QueryTally, kQueryFamilies.size()>, 2> queries;
  std::int64_t seeds = 0;
};

template <class Scalar>
void add(Run& run, std::uint64_t from, std::uint64_t to) {
  const std::size_t scalar = sizeof(Scalar) == 4 ? 0 : 1;
  for (std::size_t family = 0; family < families().size(); ++family)
    for (std::uint64_t seed = from; seed < to; ++seed) {
      if (seed % static_cast<std::uint64_t>(families()[family].rarer) != 0) continue;
      const bool thorough = seed % kThorough == 0;
      if (families()[family].plane) add_member<Scalar, 2>(run.fits[scalar][family], family, seed, thorough);
      add_member<Scalar, 3>(run.fits[scalar][family], family, seed, thorough);
    }
  for (std::size_t family = 0; family < kQueryFamilies.size(); ++family)
    for (std::uint64_t seed = from; seed < to; ++seed) {
      add_query<Scalar, 2>(run.queries[scalar][family], family, seed);
      add_query<Scalar, 3>(run.queries[scalar][family], family, seed);
    }
}

double percent(std::int64_t part, std::int64_t of) {
  return of == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(of);
}

std::int64_t print_families(const Run& run) {
  std::int64_t broken = 0;
  std::puts(
      "Every set of a family was fitted in float and double, in the plane and in space. Hard: sets in which what the "
      "family is named for happened. The columns from \"outside\" to \"pairs wrong\" are promised to be 0. The first "
      "four count, over all fitters, results with a point outside (exactly), with a number that is not finite, with a "
      "support point off the boundary, and smallest volumes without a proof. One set in eight was fitted again: "
      "scaled by a power of two (the same bits, scaled); in another order, mirrored with its coordinates exchanged, "
      "and moved (the same promises and size); and, what is in float, once more in double (the same size, within "
      "float's rounding). Pairs: two volumes of any kinds around two sets. Wrong are those whose answer depends on "
      "their order or scale, changes as they turn, or calls volumes apart that share a point.\n");
  std::puts("| family | scalar | sets | hard | outside | not finite | off boundary | not proven | scaled | moved | "
            "in double | pairs wrong | of pairs | overlapping | hash |");
  std::puts("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|");
  for (std::size_t family = 0; family < families().size(); ++family)
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      const FamilyTally& tally = run.fits[scalar][family];
      FitterTally all;
      for (const FitterTally& one : tally.fitters) {
        all.outside += one.outside, all.not_finite += one.not_finite, all.off_boundary += one.off_boundary;
        all.unproven += one.unproven, all.unlike += one.unlike, all.moved += one.moved;
        all.other_scalar += one.other_scalar;
      }
      const bool easy = static_cast<double>(tally.hard) < families()[family].share * static_cast<double>(tally.sets);
      broken += all.broken() + tally.pairs.broken() + (easy && tally.sets >= 100);
      std::printf("| %s | %s | %" PRId64 " | %.0f %% |", families()[family].name.data(), kScalars[scalar], tally.sets,
                  percent(tally.hard, tally.sets));
      for (const std::int64_t count : {all.outside, all.not_finite, all.off_boundary, all.unproven, all.unlike,
                                       all.moved, all.other_scalar, tally.pairs.broken()})
        std::printf(" %" PRId64 " |", count);
      std::printf(" %" PRId64 " | %.0f %% | %016" PRIx64 " |\n", tally.pairs.pairs,
                  percent(tally.pairs.overlapping, tally.pairs.pairs), tally.hash);
    }
  return broken;
}

std::int64_t print_queries(const Run& run) {
  std::int64_t broken = 0;
  std::puts("\n## Queries\n\nEach answer was checked against an oracle in rational arithmetic. Hard: rounded numbers "
            "could not decide.");
  std::puts("\n| queries | scalar | sets | hard | answers | wrong | hash |\n|---|---|--:|--:|---|--:|---|");
  for (std::size_t family = 0; family < kQueryFamilies.size(); ++family)
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      const QueryTally& tally = run.queries[scalar][family];
      broken += tally.wrong;
      const auto& n = tally.answers;
      std::printf("| %s | %s | %" PRId64 " | %.0f %% | ", kQueryFamilies[family].data(), kScalars[scalar], tally.sets,
                  percent(tally.hard, tally.sets));
      if (family == 0) std::printf("apart %" PRId64 ", overlapping %" PRId64, n[0], n[1]);
      else std::printf("inside %" PRId64 ", intersecting %" PRId64 ", outside %" PRId64, n[0], n[1], n[2]);
      std::printf(" | %" PRId64 " | %016" PRIx64 " |\n", tally.wrong, tally.hash);
    }
  return broken;
}

/// Of a kind of volume: worst excess in ulps of what claims to be smallest, and the most steps.
void print_fitters(const Run& run, std::string_view volume) {
  std::vector<std::size_t> columns;
  const auto algorithms = fit::algorithms();
  for (std::size_t i = 0; i < algorithms.size(); ++i)
    if (!algorithms[i].loses_points && algorithms[i].volume == volume) columns.push_back(i);
  std::printf("\n| %s | scalar |", std::string(volume).c_str());
  for (const std::size_t i : columns) std::printf(" %s |", std::string(algorithms[i].name).c_str());
  std::puts("");
  std::printf("|---|---|");
  for (std::size_t i = 0; i < columns.size(); ++i) std::printf("--:|");
  std::puts("");
  for (std::size_t family = 0; family < families().size(); ++family)
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      std::printf("| %s | %s |", families()[family].name.data(), kScalars[scalar]);
      for (const std::size_t i : columns) {
        if (run.fits[scalar][family].fitters.empty() || run.fits[scalar][family].fitters[i].sets == 0) {
          std::printf(" |");
          continue;
        }
        const FitterTally& tally = run.fits[scalar][family].fitters[i];
        if (algorithms[i].exact) std::printf(" %.2g;", tally.excess);
        std::printf(" %" PRId64 " |", tally.steps);
      }
      std::puts("");
    }
}

/// The fitters' steps in parts of what is stated: none may reach 1.
std::int64_t print_stated(const Run& run) {
  std::int64_t broken = 0;
  std::puts("\n## Steps\n\nThe most steps as a part of stated_steps (tests/core/fit/family_checks.cpp), which must not "
            "exceed 1.\n\n| fitter | part |\n|---|--:|");
  const auto algorithms = fit::algorithms();
  for (std::size_t i = 0; i < algorithms.size(); ++i) {
    double most = 0;
    for (const auto& scalar : run.fits)
      for (const FamilyTally& tally : scalar)
        if (!tally.fitters.empty()) most = std::max(most, tally.fitters[i].of_stated_steps);
    if (most == 0) continue;
    broken += most > 1;
    std::printf("| %s %s | %.2f |\n", std::string(algorithms[i].volume).c_str(),
                std::string(algorithms[i].name).c_str(), most);
  }
  return broken;
}

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const std::int64_t sets = argc > 1 ? std::atoll(argv[1]) : 50'000;
  const double minutes = argc > 2 ? std::atof(argv[2]) : 1e9;
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double, std::ratio<60>>(Clock::now() - start).count(); };
  Run run;
  for (auto& scalar : run.fits) scalar.resize(families().size());
  const std::int64_t seeds = (sets + 3) / 4;
  while (run.seeds < seeds && passed() < minutes) {
    const auto from = static_cast<std::uint64_t>(run.seeds);
    const auto to = static_cast<std::uint64_t>(std::min<std::int64_t>(seeds, run.seeds + kBlock));
    add<float>(run, from, to);
    add<double>(run, from, to);
    run.seeds = static_cast<std::int64_t>(to);
    std::fprintf(stderr, "%" PRId64 " of %" PRId64 " sets a family, minute %.1f\n", 4 * run.seeds, 4 * seeds, passed());
  }
  std::printf("# What the long run found\n\n`./run test --long` wrote this: %" PRId64 " of %" PRId64
              " sets a family (of a prism of 64 one in a hundred), in %.0f minutes on one core.\n\n## Families\n\n",
              4 * run.seeds, 4 * seeds, std::ceil(passed()));
  std::int64_t broken = print_families(run) + print_queries(run);
  std::puts(
      "\n## Fitters\n\nEach cell has the most steps that a run took. Before them, for a fitter that guarantees the "
      "smallest volume, it has the worst excess over the proven lower bound, in ulps (epsilon times the largest "
      "coordinate and the smallest sphere's radius, summed): for a sphere, of its radius; for a box, of each edge. A "
      "box's proof in double is itself known only within tolerance::kBoxProof, which is most of that excess. An AABB, "
      "k-DOP or hull has a point on each bound.");
  for (const std::string_view volume : kVolumeNames) print_fitters(run, volume);
  broken += print_stated(run);
  return broken == 0 ? 0 : 1;
}
