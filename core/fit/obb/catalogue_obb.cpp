#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/obb/certify_obb.hpp"
#include "fit/obb/obb_aabb.hpp"
#include "fit/obb/obb_dito.hpp"
#include "fit/obb/obb_exact.hpp"
#include "fit/obb/obb_face_aligned.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_pca_hull.hpp"
#include "fit/obb/obb_pca_hull_area.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/obb/obb_pca_sums.hpp"
#include "fit/obb/obb_rotations.hpp"
#include "fit/obb/obb_sphere_axis.hpp"

namespace snug::fit {
namespace {

constexpr auto kAabb = [](auto p, const Options&, auto& o) { return obb_aabb(p, o); };
constexpr auto kSphereAxis = [](auto p, const Options&, auto& o) { return obb_sphere_axis(p, o); };
constexpr auto kPca = [](auto p, const Options&, auto& o) { return obb_pca(p, o); };
constexpr auto kPcaSums = [](auto p, const Options&, auto& o) { return obb_pca_sums(p, o); };
constexpr auto kPcaOnePass = [](auto p, const Options&, auto& o) { return obb_pca_one_pass(p, o); };
constexpr auto kPcaHull = [](auto p, const Options&, auto& o) { return obb_pca_hull(p, o); };
constexpr auto kPcaHullArea = [](auto p, const Options&, auto& o) { return obb_pca_hull_area(p, o); };
constexpr auto kPcaRectangle = [](auto p, const Options&, auto& o) { return obb_pca_rectangle(p, o); };
constexpr auto kFaceAligned = [](auto p, const Options&, auto& o) { return obb_face_aligned(p, o); };
constexpr auto kRotationsTried = [](auto p, const Options&, auto& o) { return obb_rotations(p, o); };
constexpr auto kDito = [](auto p, const Options&, auto& o) { return obb_dito(p, o); };
constexpr auto kExact = [](auto p, const Options&, auto& o) { return obb_exact(p, o); };

constexpr std::string_view kGottschalk = "S. Gottschalk, Collision queries using oriented bounding boxes, 2000";

constexpr std::string_view kAlexa = "M. Alexa, Super-Fibonacci spirals: fast, low-discrepancy sampling of SO(3), 2022";

constexpr std::string_view kLarsson =
    "T. Larsson, L. Källberg, Fast computation of tight-fitting oriented bounding boxes, 2011";

constexpr Theory kFacesTimesVertices{
    "O(n log n + h^2)", growth::square, false, "each face with each vertex of the hull, as the code shows",
    "O(n log n)",       growth::sorting};
constexpr Theory kHullEdges{
    "O(n log n + h^2)",
    growth::square,
    false,
    "pairs of hull edges, as the code shows; J. O'Rourke, Finding minimal enclosing boxes, 1985, for O(h^3)",
    "O(n log n)",
    growth::sorting};

constexpr std::array kObbRows{
    row<kAabb>({"obb", "aabb", "Axis-aligned box", kEricson, kFixedPasses, kObbAabbPseudocode}),
    row<kSphereAxis>(
        {"obb", "sphere_axis", "Axis of the bounding sphere", kRomanick, kFewPasses, kObbSphereAxisPseudocode}),
    row<kPca>({"obb", "pca", "PCA of the points", kGottschalk, kFixedPasses, kObbPcaPseudocode}),
    row<kPcaSums>({"obb", "pca_sums", "PCA, point by point", kGottschalk, kFixedPasses, kObbPcaSumsPseudocode}),
    row<kPcaOnePass>({.volume = "obb",
                      .name = "pca_one_pass",
                      .title = "PCA in one pass (naive)",
                      .source = kRomanick,
                      .theory = kFixedPasses,
                      .pseudocode = kObbPcaOnePassPseudocode,
                      .naive = true}),
    row<kPcaHull>({"obb", "pca_hull", "PCA of the hull", kGottschalk, kBalancedHull, kObbPcaHullPseudocode}),
    row<kPcaHullArea>(
        {"obb", "pca_hull_area", "PCA of the hull's surface", kGottschalk, kBalancedHull, kObbPcaHullAreaPseudocode}),
    row<kPcaRectangle>(
        {"obb", "pca_rectangle", "PCA with smallest rectangle", kRomanick, kBalancedHull, kObbPcaRectanglePseudocode}),
    row<kFaceAligned>(
        {"obb", "face_aligned", "Aligned with a face", kRomanick, kFacesTimesVertices, kObbFaceAlignedPseudocode}),
    row<kRotationsTried>({"obb", "rotations", "Fixed rotations", kAlexa, kBalancedHull, kObbRotationsPseudocode}),
    row<kDito>({"obb", "dito", "DiTO-14", kLarsson, {"O(n)", growth::linear, true, kLarsson}, kObbDitoPseudocode}),
    row<kExact, true>(
        {"obb", "exact", "Exact minimum",
         "J. O'Rourke, Finding minimal enclosing boxes, 1985: branch and bound on his theorem; in 2-D H. Freeman, "
         "R. Shapira, Determining the minimum-area encasing rectangle for an arbitrary closed curve, 1975",
         kHullEdges, kObbExactPseudocode}),
};

}  // namespace

std::span<const Algorithm> rows_of(const Obb<double, 3>*) { return kObbRows; }

}  // namespace snug::fit
