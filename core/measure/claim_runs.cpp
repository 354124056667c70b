#include "measure/claim_runs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "geometry/generate.hpp"
#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "measure/claims.hpp"
#include "measure/growth.hpp"
#include "measure/hard_cloud.hpp"
#include "measure/sample.hpp"
#include "measure/trials.hpp"
#include "measure/volume_cost.hpp"

namespace snug::cost {
namespace {

constexpr std::string_view kHolds = "holds", kTypical = "typical", kFalse = "false";

/// If the student has more points than this, they are sampled, because the exact box is fitted again and again.
constexpr Index kMostPoints = 20'000;

__attribute__((format(printf, 1, 2))) std::string said(const char* format, ...) {
  std::array<char, 512> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  return text.data();
}

const fit::Algorithm& row_of(std::string_view volume, std::string_view name) {
  return *fit::find_algorithm(volume, name);
}

// ---- within so many per cent of the smallest

void within(const char* algorithm, double claimed, const ClaimContext& context, ClaimRow& row) {
  const fit::Algorithm& own = row_of("sphere", algorithm);
  const Excess excess = excess_of(own, context.seed);
  const double here = excess_on(own, context.points, context.seed);
  row.figure = std::max({excess.most, excess.found, here});
  if (row.figure <= claimed) row.verdict = kHolds;
  else row.verdict = excess.median <= claimed ? kTypical : kFalse;
  row.measured = said(
      "radius above the smallest: %.1f %% on these points; %.1f %% in the median and at most %.1f %% on %d clouds of "
      "every kind; %.1f %% on eight points that were moved %d times to make it worse",
      100 * here, 100 * excess.median, 100 * excess.most, excess.clouds, 100 * excess.found, excess.tried);
}
void ritter(const ClaimContext& context, ClaimRow& row) { within("ritter", 0.10, context, row); }
void iterative(const ClaimContext& context, ClaimRow& row) { within("ritter_iterative", 0.05, context, row); }

// ---- powers of n

/// Times on points on a sphere: all of them are on the hull, which is the most work for algorithms that use the hull.
std::vector<GrowthRow> growth_of(std::string_view volume, std::string_view algorithm, Index most,
                                 const ClaimContext& context) {
  const fit::Options options{.seed = context.seed};
  const auto points = std::make_shared<PointStock>("sphere", 3, false, context.seed);
  GrowthRun run({workload_of(row_of(volume, algorithm), 3, most, points, options)},
                {.repeats = 3, .batch = 1e6, .enough = context.longest}, context.longest, context.clock);
  while (!run.done()) run.step();
  return run.rows();
}

/// claimed: the power of n, without any logarithm. A time that grows more slowly is within the bound.
void power(std::string_view volume, std::string_view algorithm, Index most, double claimed, const char* what,
           const ClaimContext& context, ClaimRow& row) {
  constexpr double kNoise = 0.15;
  const std::vector<GrowthRow> rows = growth_of(volume, algorithm, most, context);
  if (!rows.back().exponent) {
    row.measured = std::string(kTooFewToTell) + (rows.back().stopped.empty() ? "" : ": " + rows.back().stopped);
    return;
  }
  row.figure = *rows.back().exponent;
  row.verdict = row.figure <= claimed + kNoise ? kHolds : kFalse;
  row.measured = said("%s: time grows as n^%.2f up to %d points on a sphere, where one run takes %.3g ms",
                      row.verdict == kHolds ? what : "above the bound in this measurement", row.figure,
                      static_cast<int>(rows.back().points), rows.back().time.median / 1e6);
}
void brute_force(const ClaimContext& context, ClaimRow& row) {
  power("sphere", "brute_force", 40, 5,
        "within the bound, because a candidate that is no smaller is never tested against the points", context, row);
}
void orourke(const ClaimContext& context, ClaimRow& row) {
  power("obb", "exact", 10'000, 3, "within the bound, because most pairs of edges are ruled out at once", context, row);
}

// ---- Welzl's stack

/// How deep the recursion of welzl_recursive.hpp goes, and what a call takes of this build's stack: its calls report to
/// an observer, which looks at the address of a local variable of its own.
struct RecursionDepth {
  int deepest = 0;
  std::uintptr_t lowest = std::numeric_limits<std::uintptr_t>::max(), highest = 0;

  void see(int depth) {
    volatile char here = 0;
    const auto place = reinterpret_cast<std::uintptr_t>(&here);
    lowest = std::min(lowest, place);
    highest = std::max(highest, place);
    deepest = std::max(deepest, depth);
  }
  [[nodiscard]] double bytes_per_call() const {
    return static_cast<double>(highest - lowest) / std::max(deepest - 1, 1);
  }
};

void stack(const ClaimContext& context, ClaimRow& row) {
  constexpr int kPoints = 1000;                 // fewer than the depth at which the recursion is stopped
  constexpr double kUsual = 8.0 * 1024 * 1024;  // a main thread's stack on Linux; other systems give less
  RecursionDepth depth;
  const auto set = PointSet<double, 3>::make(*generate("cube", kPoints, 3, context.seed));
  (void)row_of("sphere", "welzl_recursive")
      .watch(*set, {.seed = context.seed}, [&](const fit::Step3& step, const OperationCounts&) {
        if (const auto* call = std::get_if<fit::CallEntered>(&step.fact)) depth.see(call->depth);
      });
  row.figure = depth.bytes_per_call();
  row.verdict = depth.deepest >= kPoints ? kHolds : kFalse;
  row.measured = said("the printed recursion reaches a call depth of %d on %d points, at %.0f bytes a call: a stack of "
                      "8 MiB is full at about %.0f points. The loop that this program runs has a call depth of five at "
                      "most, however many points there are",
                      depth.deepest, kPoints, row.figure, kUsual / row.figure);
}

// ---- 14-DOPs beside oriented boxes

/// The vertices of a cube, rotated so that no axis of a 14-DOP lies along it.
AnyPointSet rotated_cube() {
  const Matrix<double, 3> rotation = turn(Vector<double, 3>(1, 2, 3), 0.7);
  std::vector<Vector<double, 3>> corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.push_back(turned<double, 3>(
        rotation, Vector<double, 3>((corner & 1) - 0.5, (corner >> 1 & 1) - 0.5, (corner >> 2) - 0.5)));
  return *PointSet<double, 3>::make(std::move(corners));
}

void storage(const ClaimContext& context, ClaimRow& row) {
  const auto bytes = [&](std::string_view volume, std::string_view algorithm) {
    return static_cast<int>(
        bytes_of(row_of(volume, algorithm).fit(rotated_cube(), {.seed = context.seed}).volume, 3, true));
  };
  const int kdop = bytes("kdop", "k14"), box = bytes("obb", "exact");
  row.figure = static_cast<double>(kdop) / box;
  row.verdict = std::abs(row.figure - 1) <= 0.1 ? kHolds : kFalse;
  row.measured = said(
      "%d bytes in float, against %d for a box by centre, axes and half extents; with a quaternion in place of the "
      "axes the box takes 20 fewer",
      kdop, box);
}

void tighter(const ClaimContext& context, ClaimRow& row) {
  int tighter = 0, clouds = 0;
  std::string kinds;
  for (const CensusRow& counted : census()) {
    tighter += counted.tighter();
    clouds += static_cast<int>(counted.ratios.size());
    kinds += said("%s%s %d of %d", kinds.empty() ? "" : ", ", std::string(counted.kind).c_str(), counted.tighter(),
                  static_cast<int>(counted.ratios.size()));
  }
  const Claim& claim = *find_claim("kdop_tighter");
  const double here = claim.measure(claim, context.points, context.seed);
  const double cube = claim.measure(claim, rotated_cube(), context.seed);
  row.figure = here;
  if (tighter == clouds && cube < 1 && here < 1) row.verdict = kHolds;
  else row.verdict = 2 * tighter > clouds || here < 1 ? kTypical : kFalse;
  row.measured = said("volume over the smallest box's: %.3f on these points; below 1 on %d of %d clouds (%s); %.3f "
                      "on a rotated cube, where the box is the cube itself",
                      here, tighter, clouds, kinds.c_str(), cube);
}

// ---- boxes

/// A cube's vertices, and a cluster along one of its diagonals, which pulls the longest axis to that diagonal.
AnyPointSet clustered_diagonal(std::uint64_t seed) {
  Random random(seed);
  std::vector<Vector<double, 3>> points;
  for (int corner = 0; corner < 8; ++corner) points.emplace_back(corner & 1, corner >> 1 & 1, corner >> 2);
  for (int i = 0; i < 400; ++i) points.push_back(Vector<double, 3>::Constant(random.unit()));
  return *PointSet<double, 3>::make(std::move(points));
}

void pca_boxes(const ClaimContext& context, ClaimRow& row) {
  const fit::Algorithm& pca = row_of("obb", "pca");
  const double here = 1 + excess_on(pca, context.points, context.seed);
  const double cluster = 1 + excess_on(pca, clustered_diagonal(context.seed), context.seed);
  const double hull = 1 + excess_on(row_of("obb", "pca_hull"), context.points, context.seed);
  const double hull_cluster = 1 + excess_on(row_of("obb", "pca_hull"), clustered_diagonal(context.seed), context.seed);
  row.figure = std::max(here, cluster);
  row.verdict = row.figure > 1.01 ? kHolds : kFalse;
  row.measured = said("volume over the smallest box's: %.3f on these points, %.2f on a cube with a cluster along its "
                      "diagonal; by PCA of the hull %.3f and %.2f",
                      here, cluster, hull, hull_cluster);
}

void faces(const ClaimContext& context, ClaimRow& row) {
  const fit::Algorithm& aligned = row_of("obb", "face_aligned");
  const double here = 1 + excess_on(aligned, context.points, context.seed);
  const auto tetrahedron = PointSet<double, 3>::make({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
  const double four = 1 + excess_on(aligned, *tetrahedron, context.seed);
  const std::vector<GrowthRow> rows = growth_of("obb", "face_aligned", 3000, context);
  row.says += ": O(n^2 log n)";  // clouds say nothing about time, which is measured here alone
  row.figure = std::max(here, four);
  row.verdict = row.figure > 1 + 1e-9 ? kFalse : kHolds;
  row.measured = said("volume of the best box on a face over the smallest: %.4f on these points, %.2f on a regular "
                      "tetrahedron",
                      here, four);
  if (const auto power = rows.back().exponent)
    row.measured +=
        said(". Time grows as n^%.2f up to %d points on a sphere", *power, static_cast<int>(rows.back().points));
}

constexpr std::array kMeasured{
    MeasuredClaim{"ritter_ten_per_cent", ritter},
    MeasuredClaim{"iterative_five_per_cent", iterative},
    MeasuredClaim{"brute_force_fifth_power", brute_force},
    MeasuredClaim{"welzl_stack", stack},
    MeasuredClaim{"kdop_storage", storage},
    MeasuredClaim{"kdop_tighter", tighter},
    MeasuredClaim{"pca_not_optimal", pca_boxes},
    MeasuredClaim{"box_on_a_face", faces},
    MeasuredClaim{"orourke_cube", orourke},
};

}  // namespace

std::span<const MeasuredClaim> measured_claims() { return kMeasured; }

ClaimRow run_claim(const MeasuredClaim& measured, const ClaimContext& context) {
  const Claim& claim = *find_claim(measured.name);
  ClaimRow row{.claim = std::string(claim.name),
               .lecture = std::string(claim.lecture),
               .slide = std::string(claim.slide),
               .says = std::string(claim.says)};
  if (fit::count_of(context.points) <= kMostPoints) {
    measured.run(context, row);
  } else {
    const AnyPointSet fewer = sample(context.points, kMostPoints, context.seed);
    measured.run({fewer, context.seed, context.clock, context.longest}, row);
  }
  return row;
}

}  // namespace snug::cost
