#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/sphere/aabb_center.hpp"
#include "fit/sphere/brute_force.hpp"
#include "fit/sphere/certify_sphere.hpp"
#include "fit/sphere/pca_sphere.hpp"
#include "fit/sphere/pivot.hpp"
#include "fit/sphere/ritter.hpp"
#include "fit/sphere/ritter_iterative.hpp"
#include "fit/sphere/tiny.hpp"
#include "fit/sphere/welzl.hpp"
#include "fit/sphere/welzl_naive.hpp"
#include "fit/sphere/welzl_recursive.hpp"

namespace snug::fit {
namespace {

constexpr auto kAabbCenter = [](auto p, const Options&, auto& o) { return aabb_center(p, o); };
constexpr auto kRitter = [](auto p, const Options&, auto& o) { return ritter(p, o); };
constexpr auto kRitterIterative = [](auto p, const Options& options, auto& o) {
  return ritter_iterative(p, options, o);
};
constexpr auto kPcaSphere = [](auto p, const Options&, auto& o) { return pca_sphere(p, o); };
constexpr auto kWelzl = [](auto p, const Options& options, auto& o) { return welzl(p, options, o); };
constexpr auto kWelzlRecursive = [](auto p, const Options& options, auto& o) { return welzl_recursive(p, options, o); };
constexpr auto kWelzlNaive = [](auto p, const Options& options, auto& o) {
  return welzl_naive<NoEpsilon>(p, options, o);
};
constexpr auto kWelzlEpsilon = [](auto p, const Options& options, auto& o) {
  return welzl_naive<AbsoluteEpsilon>(p, options, o);
};
constexpr auto kPivot = [](auto p, const Options& options, auto& o) { return pivot(p, options, o); };
constexpr auto kBruteForce = [](auto p, const Options&, auto& o) { return brute_force(p, o); };
constexpr auto kBruteForceSlide = [](auto p, const Options&, auto& o) { return brute_force_slide(p, o); };

constexpr Theory kAllSubsets{"O(n^5)", growth::fifth, false, kRomanick, "O(n^4)", growth::fourth};

constexpr std::string_view kWelzlPaper = "E. Welzl, Smallest enclosing disks (balls and ellipsoids), 1991";

// Its passes visit the points in random order: each access takes longer once they no longer fit into the caches.
constexpr Theory kRandomOrder{"O(n)", growth::linear, false, kFixedPasses.source};

constexpr Theory kStoppedInTime{"O(n) expected", growth::linear, false, kWelzlPaper};

constexpr std::array kSphereRows{
    sphere_row<kAabbCenter>({"sphere", "aabb_center", "AABB centre", kEricson, kFixedPasses, kAabbCenterPseudocode}),
    sphere_row<kRitter>({"sphere", "ritter", "Ritter", "J. Ritter, An efficient bounding sphere, 1990", kFixedPasses,
                         kRitterPseudocode}),
    sphere_row<kRitterIterative>(
        {"sphere", "ritter_iterative", "Iterative Ritter", kEricson, kRandomOrder, kRitterIterativePseudocode}),
    sphere_row<kPcaSphere>({"sphere", "pca", "PCA (Wu)", "X. Wu, A linear-time simple bounding volume algorithm, 1992",
                            kFixedPasses, kPcaSpherePseudocode}),
    sphere_row<kWelzl, true>(
        {"sphere",
         "welzl",
         "Welzl",
         kWelzlPaper,
         {"O(n) expected", growth::linear, false, kWelzlPaper},  // and a constant amount at the start
         kWelzlPseudocode}),
    sphere_row<kPivot, true>({.volume = "sphere",
                              .name = "pivot",
                              .title = "Farthest-point pivoting",
                              .source = "B. Gärtner, Fast and robust smallest enclosing balls, 1999",
                              .theory = kFewPasses,
                              .pseudocode = kPivotPseudocode}),
    row<kBruteForce, true>({.volume = "sphere",
                            .name = "brute_force",
                            .title = "Brute force",
                            .source = kRomanick,
                            .theory = kAllSubsets,
                            .pseudocode = kBruteForcePseudocode,
                            .max_points = kBruteForceLimit}),
    sphere_row<kWelzlRecursive, true>({.volume = "sphere",
                                       .name = "welzl_recursive",
                                       .title = "Welzl, as printed",
                                       .source = kRomanick,
                                       .theory = {"O(n) expected", growth::linear, false, kWelzlPaper},
                                       .pseudocode = kWelzlRecursivePseudocode,
                                       .max_points = kWelzlRecursiveLimit,
                                       .most_finished = kWelzlDepthLimit - 1}),
    row<kBruteForceSlide>({.volume = "sphere",
                           .name = "brute_force_slide",
                           .title = "Largest subsets only",
                           .source = kRomanick,
                           .theory = kAllSubsets,
                           .pseudocode = kBruteForceSlidePseudocode,
                           .max_points = kBruteForceLimit}),
    row<kWelzlNaive>({.volume = "sphere",
                      .name = "welzl_naive",
                      .title = "Welzl, no epsilon (naive)",
                      .source = kWelzlPaper,
                      .theory = kStoppedInTime,
                      .pseudocode = kWelzlNaivePseudocode,
                      .max_points = kWelzlNaiveLimit,
                      .naive = true,
                      .loses_points = true}),
    row<kWelzlEpsilon>({.volume = "sphere",
                        .name = "welzl_epsilon",
                        .title = "Welzl, epsilon (naive)",
                        .source = kWelzlPaper,
                        .theory = kStoppedInTime,
                        .pseudocode = kWelzlEpsilonPseudocode,
                        .max_points = kWelzlNaiveLimit,
                        .naive = true,
                        .loses_points = true}),
};

}  // namespace

std::span<const Algorithm> rows_of(const Sphere<double, 3>*) { return kSphereRows; }

}  // namespace snug::fit
