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
#include "fit/obb/obb_sphere_axis.hpp"

namespace snug::fit {
namespace {

constexpr auto kAabb = [](auto p, const Options&, auto& o) { return obb_aabb(p, o); };
constexpr auto kSphereAxis = [](auto p, const Options&, auto& o) { return obb_sphere_axis(p, o); };
constexpr auto kPca = [](auto p, const Options&, auto& o) { return obb_pca(p, o); };
constexpr auto kPcaHull = [](auto p, const Options&, auto& o) { return obb_pca_hull(p, o); };
constexpr auto kPcaHullArea = [](auto p, const Options&, auto& o) { return obb_pca_hull_area(p, o); };
constexpr auto kPcaRectangle = [](auto p, const Options&, auto& o) { return obb_pca_rectangle(p, o); };
constexpr auto kFaceAligned = [](auto p, const Options&, auto& o) { return obb_face_aligned(p, o); };
constexpr auto kDito = [](auto p, const Options&, auto& o) { return obb_dito(p, o); };
constexpr auto kExact = [](auto p, const Options&, auto& o) { return obb_exact(p, o); };

constexpr std::string_view kRomanick = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::string_view kGottschalk = "S. Gottschalk, Collision queries using oriented bounding boxes, 2000";

constexpr std::array kObbRows{
    row<kAabb>(
        {"obb", "aabb", "Axis-aligned box", "C. Ericson, Real-Time Collision Detection, 2005", kObbAabbPseudocode}),
    row<kSphereAxis>({"obb", "sphere_axis", "Axis of the bounding sphere", kRomanick, kObbSphereAxisPseudocode}),
    row<kPca>({"obb", "pca", "PCA of the points", kGottschalk, kObbPcaPseudocode}),
    row<kPcaHull>({"obb", "pca_hull", "PCA of the hull", kGottschalk, kObbPcaHullPseudocode}),
    row<kPcaHullArea>({"obb", "pca_hull_area", "PCA of the hull's surface", kGottschalk, kObbPcaHullAreaPseudocode}),
    row<kPcaRectangle>({"obb", "pca_rectangle", "PCA and smallest rectangle", kRomanick, kObbPcaRectanglePseudocode}),
    row<kFaceAligned>({"obb", "face_aligned", "Aligned with a face", kRomanick, kObbFaceAlignedPseudocode}),
    row<kDito>({"obb", "dito", "DiTO-14",
                "T. Larsson, L. Källberg, Fast computation of tight-fitting oriented bounding boxes, 2011",
                kObbDitoPseudocode}),
    row<kExact, true>(
        {"obb", "exact", "Exact minimum",
         "branch and bound on the theorem of J. O'Rourke, Finding minimal enclosing boxes, 1985; in 2-D each edge of "
         "the hull: H. Freeman, R. Shapira, Determining the minimum-area encasing rectangle, 1975",
         kObbExactPseudocode}),
};

}  // namespace

std::span<const Algorithm> obb_rows() { return kObbRows; }

}  // namespace snug::fit
