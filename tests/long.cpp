// snug_long [SETS [MINUTES [NAME]]]: so many members of each family (50,000 unless told; NAME: of those alone whose
// name has that in it), or as many as go into so many minutes, a quarter each in float and double, in the plane and in
// space, held to every promise, on all of the machine's cores. The tables go to standard output as Markdown, the same
// whatever the cores; `./run test --long` puts them into tests/RESULTS.md. Exit status 1: a promise was broken.
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "core/fit/family_checks.hpp"
#include "core/query/query_families.hpp"

namespace {

using namespace snug;
using namespace snug::test;

constexpr int kBlock = 100;             // seeds of one family in a row
constexpr std::uint64_t kThorough = 8;  // one member in so many is transformed as well
constexpr std::array<const char*, 2> kScalars{"float", "double"};

/// Whether a family is to be run.
struct Chosen {
  std::string_view part;
  bool operator()(std::string_view name) const { return name.find(part) != std::string_view::npos; }
};

struct Run {
  std::array<std::vector<FamilyTally>, 2> fits;  // by scalar and family
  std::array<std::array<QueryTally, kQueryFamilies.size()>, 2> queries;
  std::int64_t seeds = 0;

  Run() {
    for (auto& scalar : fits) scalar.resize(families().size());
  }
  void add(const Run& other) {
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      for (std::size_t i = 0; i < families().size(); ++i) fits[scalar][i].add(other.fits[scalar][i]);
      for (std::size_t i = 0; i < kQueryFamilies.size(); ++i) queries[scalar][i].add(other.queries[scalar][i]);
    }
    seeds += other.seeds;
  }
};

template <class Scalar>
void add(Run& run, const Chosen& chosen, std::uint64_t from, std::uint64_t to) {
  const std::size_t scalar = sizeof(Scalar) == 4 ? 0 : 1;
  for (std::size_t family = 0; family < families().size(); ++family)
    for (std::uint64_t seed = from; seed < to; ++seed) {
      if (!chosen(families()[family].name) || seed % static_cast<std::uint64_t>(families()[family].rarer) != 0)
        continue;
      const bool thorough = seed % kThorough == 0;
      if (families()[family].plane) add_member<Scalar, 2>(run.fits[scalar][family], family, seed, thorough);
      add_member<Scalar, 3>(run.fits[scalar][family], family, seed, thorough);
    }
  for (std::size_t family = 0; family < kQueryFamilies.size(); ++family)
    for (std::uint64_t seed = from; seed < to && chosen(kQueryFamilies[family].name); ++seed) {
      add_query<Scalar, 2>(run.queries[scalar][family], family, seed);
      add_query<Scalar, 3>(run.queries[scalar][family], family, seed);
    }
}

/// Runs blocks of seeds on every core until they or the minutes are used up, and adds them up.
class LongRun {
 public:
  LongRun(std::int64_t seeds, double minutes, Chosen chosen) : seeds_(seeds), minutes_(minutes), chosen_(chosen) {}

  [[nodiscard]] double passed() const {
    return std::chrono::duration<double, std::ratio<60>>(Clock::now() - start_).count();
  }
  Run run(unsigned cores) {
    std::vector<std::thread> threads;
    for (unsigned core = 0; core < cores; ++core) threads.emplace_back([this] { take_blocks(); });
    for (std::thread& thread : threads) thread.join();
    return std::move(all_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void take_blocks() {
    for (;;) {
      Run block;
      std::int64_t from = 0;
      {
        const std::scoped_lock lock(mutex_);
        if (taken_ == seeds_ || passed() >= minutes_) return;
        from = taken_;
        taken_ = std::min<std::int64_t>(seeds_, taken_ + kBlock);
        block.seeds = taken_ - from;
      }
      const auto first = static_cast<std::uint64_t>(from), end = static_cast<std::uint64_t>(from + block.seeds);
      add<float>(block, chosen_, first, end);
      add<double>(block, chosen_, first, end);
      const std::scoped_lock lock(mutex_);
      all_.add(block);
      std::fprintf(stderr, "%" PRId64 " of %" PRId64 " sets a family, minute %.1f\n", 4 * all_.seeds, 4 * seeds_,
                   passed());
    }
  }

  std::int64_t seeds_;
  double minutes_;
  Chosen chosen_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  std::int64_t taken_ = 0;
  Run all_;
};

double percent(std::int64_t part, std::int64_t of) {
  return of == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(of);
}

std::int64_t print_families(const Run& run) {
  std::int64_t broken = 0;
  std::puts(
      "Every set of a family was fitted in float and double, in the plane and in space. Hard: sets that have what "
      "the family is named for. The columns from \"outside\" to \"pairs wrong\" are promised to be 0. The first "
      "four count, over all fitters, results with a point outside (exactly), with a number that is not finite, with a "
      "support point off the boundary, and smallest volumes without a proof. One set in eight was fitted again: "
      "scaled by a power of two, and by one that leaves its smallest numbers just normal (the same bits, scaled; "
      "there, boxes and lozenges the same promises); in "
      "another order, mirrored with its coordinates exchanged, "
      "and moved (the same promises and size); and, if in float, once more in double (the same size, within "
      "float's rounding). Pairs: two volumes of any kinds around two sets. A pair is wrong if its answer depends on "
      "order or scale, changes as the volumes turn, or calls volumes apart that share a point. GJK: the most "
      "simplices that it tried on a pair, which must not exceed 64.\n");
  std::puts("| family | scalar | sets | hard | outside | not finite | off boundary | not proven | scaled | moved | "
            "in double | pairs wrong | of pairs | overlapping | GJK | hash |");
  std::puts("|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|");
  for (std::size_t family = 0; family < families().size(); ++family)
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      const FamilyTally& tally = run.fits[scalar][family];
      if (tally.sets == 0) continue;
      FitterTally all;
      for (const FitterTally& one : tally.fitters) {
        all.outside += one.outside, all.not_finite += one.not_finite, all.off_boundary += one.off_boundary;
        all.unproven += one.unproven, all.unlike += one.unlike, all.moved += one.moved;
        all.other_scalar += one.other_scalar;
      }
      const bool easy = static_cast<double>(tally.hard) < families()[family].share * static_cast<double>(tally.sets);
      broken += all.broken() + tally.pairs.broken() + (tally.pairs.turns > kStatedTurns) + (easy && tally.sets >= 100);
      std::printf("| %s | %s | %" PRId64 " | %.0f %% |", families()[family].name.data(), kScalars[scalar], tally.sets,
                  percent(tally.hard, tally.sets));
      for (const std::int64_t count : {all.outside, all.not_finite, all.off_boundary, all.unproven, all.unlike,
                                       all.moved, all.other_scalar, tally.pairs.broken()})
        std::printf(" %" PRId64 " |", count);
      std::printf(" %" PRId64 " | %.0f %% | %d | %016" PRIx64 " |\n", tally.pairs.pairs,
                  percent(tally.pairs.overlapping, tally.pairs.pairs), tally.pairs.turns, tally.hash);
    }
  return broken;
}

std::int64_t print_queries(const Run& run) {
  std::int64_t broken = 0;
  std::puts("\n## Queries\n\nEach answer was checked against exact arithmetic. Hard: rounded numbers could not decide; "
            "on a lattice: the volumes only touch, or none of their axes separates them although they are apart.");
  std::puts("\n| queries | scalar | sets | hard | answers | wrong | hash |\n|---|---|--:|--:|---|--:|---|");
  for (std::size_t family = 0; family < kQueryFamilies.size(); ++family)
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
      const QueryTally& tally = run.queries[scalar][family];
      if (tally.sets == 0) continue;
      const bool easy =
          static_cast<double>(tally.hard) < kQueryFamilies[family].share * static_cast<double>(tally.sets);
      broken += tally.wrong + (easy && tally.sets >= 100);
      const auto& n = tally.answers;
      std::printf("| %s | %s | %" PRId64 " | %.0f %% | ", kQueryFamilies[family].name.data(), kScalars[scalar],
                  tally.sets, percent(tally.hard, tally.sets));
      if (!kQueryFamilies[family].culls) std::printf("apart %" PRId64 ", overlapping %" PRId64, n[0], n[1]);
      else std::printf("inside %" PRId64 ", intersecting %" PRId64 ", outside %" PRId64, n[0], n[1], n[2]);
      std::printf(" | %" PRId64 " | %016" PRIx64 " |\n", tally.wrong, tally.hash);
    }
  return broken;
}

/// Prints, for the fitters of a kind of volume, the worst excess in ulps of what claims to be smallest, and the most
/// steps. Returns how many excesses are above what is stated.
std::int64_t print_fitters(const Run& run, std::string_view volume) {
  std::int64_t broken = 0;
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
      if (run.fits[scalar][family].sets == 0) continue;
      std::printf("| %s | %s |", families()[family].name.data(), kScalars[scalar]);
      for (const std::size_t i : columns) {
        if (run.fits[scalar][family].fitters.empty() || run.fits[scalar][family].fitters[i].sets == 0) {
          std::printf(" |");
          continue;
        }
        const FitterTally& tally = run.fits[scalar][family].fitters[i];
        const double stated = scalar == 0 ? stated_excess<float>(algorithms[i]) : stated_excess<double>(algorithms[i]);
        broken += tally.excess > stated;
        if (algorithms[i].exact) std::printf(" %.2g;", tally.excess);
        std::printf(" %" PRId64 " |", tally.steps);
      }
      std::puts("");
    }
  return broken;
}

/// The fitters' steps as fractions of what is stated: none may exceed 1.
std::int64_t print_stated(const Run& run) {
  std::int64_t broken = 0;
  std::puts(
      "\n## Steps\n\nThe most steps as a fraction of stated_steps (tests/core/fit/family_checks.cpp), which must not "
      "exceed 1.\n\n| fitter | fraction |\n|---|--:|");
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
  const std::int64_t sets = argc > 1 ? std::atoll(argv[1]) : 50'000;
  const double minutes = argc > 2 ? std::atof(argv[2]) : 1e9;
  const std::int64_t seeds = (sets + 3) / 4;
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  LongRun long_run(seeds, minutes, {argc > 3 ? argv[3] : ""});
  const Run run = long_run.run(cores);
  std::printf("# What the long run found\n\n`./run test --long` wrote this: %" PRId64 " of %" PRId64
              " sets a family (of a prism of 64 one in a hundred), in %.0f minutes on %u cores.\n\n## Families\n\n",
              4 * run.seeds, 4 * seeds, std::ceil(long_run.passed()), cores);
  std::int64_t broken = print_families(run) + print_queries(run);
  std::puts(
      "\n## Fitters\n\nEach cell has the most steps that a run took. Before them, for a fitter that guarantees the "
      "smallest volume, it has the worst excess over the proven lower bound, in ulps (epsilon times the largest "
      "coordinate and the smallest sphere's radius, summed): for a sphere, of its radius; for a box, of each edge. A "
      "box's proof in double is itself known only within tolerance::kBoxProof, which is most of that excess. It must "
      "not "
      "exceed 4, or 64 for a box in double. An AABB, k-DOP or hull has a point on each bound.");
  for (const std::string_view volume : kVolumeNames) broken += print_fitters(run, volume);
  broken += print_stated(run);
  return broken == 0 ? 0 : 1;
}
