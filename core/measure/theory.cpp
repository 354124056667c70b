#include "measure/theory.hpp"

#include <array>
#include <cmath>

namespace snug::cost {
namespace {

double linear(double n) { return n; }
double sorting(double n) { return n * std::log(n); }
double square(double n) { return n * n; }
double fourth(double n) { return n * n * n * n; }
double fifth(double n) { return fourth(n) * n; }

constexpr std::string_view kPasses = "a fixed number of passes over the points, as the code shows";
constexpr std::string_view kEricson = "C. Ericson, Real-Time Collision Detection, 2005";
constexpr std::string_view kWelzl = "E. Welzl, Smallest enclosing disks (balls and ellipsoids), 1991";
constexpr std::string_view kGaertner =
    "no bound on the passes is proven; B. Gärtner, Fast and robust smallest enclosing balls, 1999";
constexpr std::string_view kQuickhull =
    "C. B. Barber, D. P. Dobkin, H. Huhdanpaa, The Quickhull algorithm for convex hulls, 1996";
constexpr std::string_view kRomanick = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::string_view kKlosowski = "J. T. Klosowski and others, Efficient collision detection using k-DOPs, 1998";
constexpr std::string_view kDito =
    "T. Larsson, L. Kallberg, Fast computation of tight-fitting oriented bounding boxes, 2011";
constexpr std::string_view kEdges =
    "pairs of hull edges, as the code shows; J. O'Rourke, Finding minimal enclosing boxes, 1985, for O(h^3)";

constexpr std::array kTheories{
    Theory{"sphere", "aabb_center", "O(n)", linear, true, kPasses},
    Theory{"sphere", "ritter", "O(n)", linear, true, kPasses},
    // Its passes go over the points in random order: once they no longer fit the caches, each access takes longer.
    Theory{"sphere", "ritter_iterative", "O(n)", linear, false, kPasses},
    Theory{"sphere", "pca", "O(n)", linear, true, kPasses},
    Theory{"sphere", "welzl", "O(n) expected", linear, false, kWelzl},  // and a constant part at the start
    Theory{"sphere", "pivot", "O(n) a pass, few passes", linear, false, kGaertner},
    Theory{"sphere", "brute_force", "O(n^5)", fifth, false, kRomanick, "O(n^4)", fourth},
    Theory{"aabb", "min_max", "O(n)", linear, true, kEricson},
    Theory{"obb", "aabb", "O(n)", linear, true, kPasses},
    Theory{"obb", "sphere_axis", "O(n) a pass, few passes", linear, false, kGaertner},
    Theory{"obb", "pca", "O(n)", linear, true, kPasses},
    Theory{"obb", "pca_hull", "O(n log n) if balanced", sorting, false, kQuickhull},
    Theory{"obb", "pca_hull_area", "O(n log n) if balanced", sorting, false, kQuickhull},
    Theory{"obb", "pca_rectangle", "O(n log n) if balanced", sorting, false, kQuickhull},
    Theory{"obb", "face_aligned", "O(n log n + h^2)", square, false,
           "each face with each vertex of the hull, as the code shows", "O(n log n)", sorting},
    Theory{"obb", "dito", "O(n)", linear, true, kDito},
    Theory{"obb", "exact", "O(n log n + h^2)", square, false, kEdges, "O(n log n)", sorting},
    Theory{"capsule", "pca", "O(n) a pass, few passes", linear, false, kGaertner},
    Theory{"lozenge", "pca", "O(n)", linear, true, kPasses},
    Theory{"kdop", "k4", "O(k n)", linear, true, kKlosowski},
    Theory{"kdop", "k6", "O(k n)", linear, true, kKlosowski},
    Theory{"kdop", "k8", "O(k n)", linear, true, kKlosowski},
    Theory{"kdop", "k14", "O(k n)", linear, true, kKlosowski},
    Theory{"kdop", "k18", "O(k n)", linear, true, kKlosowski},
    Theory{"kdop", "k26", "O(k n)", linear, true, kKlosowski},
    Theory{"hull", "quickhull", "O(n log n) if balanced", sorting, false, kQuickhull},
};

}  // namespace

const Theory* find_theory(std::string_view volume, std::string_view algorithm) {
  for (const Theory& theory : kTheories)
    if (theory.volume == volume && theory.algorithm == algorithm) return &theory;
  return nullptr;
}

}  // namespace snug::cost
