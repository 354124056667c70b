#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/hull/certify_hull.hpp"
#include "fit/hull/quickhull.hpp"

namespace snug::fit {
namespace {

constexpr auto kQuickhull = [](auto p, const Options&, auto& o) { return quickhull(p, o); };

constexpr std::array kHullRows{
    row<kQuickhull, true>({"hull", "quickhull", "Quickhull",
                           "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, 1996",
                           kQuickhull3Pseudocode, kQuickhull2Pseudocode}),
};

}  // namespace

std::span<const Algorithm> hull_rows() { return kHullRows; }

}  // namespace snug::fit
