#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/hull/certify_hull.hpp"
#include "fit/hull/quickhull.hpp"

namespace snug::fit {
namespace {

constexpr auto kQuickhull = [](auto p, const Options&, auto& o) { return quickhull(p, o); };

constexpr std::array kHullRows{
    row<kQuickhull, true>({"hull", "quickhull", "Quickhull", kBalancedHull.source, kBalancedHull, kQuickhull3Pseudocode,
                           kQuickhull2Pseudocode}),
};

}  // namespace

std::span<const Algorithm> rows_of(const ConvexHull<double, 3>*) { return kHullRows; }

}  // namespace snug::fit
