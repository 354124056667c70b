#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/hull/certify_hull.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/hull/quickhull_naive.hpp"

namespace snug::fit {
namespace {

constexpr auto kQuickhull = [](auto p, const Options&, auto& o) { return quickhull(p, o); };

constexpr auto kRounded = [](auto p, const Options&, auto& o) { return quickhull_naive<RoundedSides>(p, o); };
constexpr auto kEpsilon = [](auto p, const Options&, auto& o) { return quickhull_naive<EpsilonSides>(p, o); };

constexpr std::string_view kEddy = "W. F. Eddy, A new convex hull algorithm for planar sets, 1977";

constexpr std::array kHullRows{
    row<kQuickhull, true>({"hull", "quickhull", "Quickhull", kBalancedHull.source, kBalancedHull, kQuickhull3Pseudocode,
                           kQuickhull2Pseudocode}),
    row<kRounded>({.volume = "hull",
                   .name = "quickhull_rounded",
                   .title = "Quickhull, rounded (naive)",
                   .source = kEddy,
                   .theory = kBalancedHull,
                   .pseudocode = kQuickhullRoundedPseudocode,
                   .space = false,
                   .max_points = kQuickhullNaiveLimit,
                   .naive = true,
                   .loses_points = true}),
    row<kEpsilon>({.volume = "hull",
                   .name = "quickhull_epsilon",
                   .title = "Quickhull, epsilon (naive)",
                   .source = kEddy,
                   .theory = kBalancedHull,
                   .pseudocode = kQuickhullEpsilonPseudocode,
                   .space = false,
                   .max_points = kQuickhullNaiveLimit,
                   .naive = true,
                   .loses_points = true}),
};

}  // namespace

std::span<const Algorithm> rows_of(const ConvexHull<double, 3>*) { return kHullRows; }

}  // namespace snug::fit
