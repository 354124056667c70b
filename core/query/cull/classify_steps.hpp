// What the tests of a volume against a frustum return, and their steps.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <variant>

#include "geometry/frustum.hpp"
#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug::query {

/// Where a volume is relative to a frustum, or to one of its planes. A volume that touches from outside is
/// intersecting, one that touches from inside is inside.
enum class Culling : std::uint8_t { kInside, kIntersecting, kOutside };
inline constexpr std::array<std::string_view, 3> kCullingNames{"inside", "intersecting", "outside"};

/// The lines of the pseudocode below that steps name. Every kind of volume has the same.
struct ClassifyLine {
  static constexpr int kSkip = 2, kChoose = 3, kOutside = 4, kIntersects = 5, kVerdict = 6;
};
inline constexpr std::array<std::string_view, 7> kClassifyBoxPseudocode{
    "crosses ← no",
    "for each plane n, d of the frustum",
    "  skip it if the parent is inside it",
    "  p-, n-vertex ← n's signs in the box",
    "  outside if n · n-vertex + d > 0",
    "  crosses ← yes if n · p-vertex + d > 0",
    "intersecting if so, else inside",
};

/// A plane was tested against the volume, or skipped.
template <class Scalar, int Dim>
struct PlaneTested {
  static constexpr std::string_view kName = "plane_tested";
  int plane = 0;                                              // its index in the frustum
  bool skipped = false;                                       // masked out: none of the fields below is set
  Vector<Scalar, Dim> normal = Vector<Scalar, Dim>::Zero();   // in the box's own frame; as given for other volumes
  int signs = 0;                                              // of that normal: bit i if coordinate i is >= 0
  int p_vertex = -1;                                          // a box's corner farthest along the normal: bit 1 for +x,
  int n_vertex = -1;                                          // 2 for +y, 4 for +z; and against it. -1 of other volumes
  int p_corners = 0;                                          // all corners that are as far, within rounding: bit c
  int n_corners = 0;                                          // for the corner c. 0 of other volumes
  Vector<Scalar, Dim> p_point = Vector<Scalar, Dim>::Zero();  // where they are, or any volume's farthest points, in
  Vector<Scalar, Dim> n_point = Vector<Scalar, Dim>::Zero();  // the scene, within rounding
  Scalar p_distance = 0;                                      // signed, scene units, positive outside
  Scalar n_distance = 0;
  Scalar doubt = 0;                   // the error bound of both
  bool looked_closer = false;         // a sign within that doubt was decided exactly
  Culling side = Culling::kInside;    // of this plane
  Culling so_far = Culling::kInside;  // for the planes up to this one
  SNUG_FIELDS(plane, skipped, normal, signs, p_vertex, n_vertex, p_corners, n_corners, p_point, n_point, p_distance,
              n_distance, doubt, looked_closer, side, so_far);
};

/// A vertex of a box was tested against a plane. corner: its bits, 1 for +x, 2 for +y, 4 for +z.
template <class Scalar, int Dim>
struct CornerTested {
  static constexpr std::string_view kName = "corner_tested";
  int corner = 0;
  int plane = -1;                                           // -1: inside all, if all were tested
  Vector<Scalar, Dim> point = Vector<Scalar, Dim>::Zero();  // within rounding
  Scalar distance = 0;                                      // to the plane: signed, scene units, positive outside
  bool outside = false;
  SNUG_FIELDS(corner, plane, point, distance, outside);
};

/// The answer, and what the next test may use.
struct CullResult {
  Culling verdict = Culling::kInside;
  int planes_tested = 0;  // without those skipped
  int rejected_by = -1;   // the first plane found that the volume is outside of; -1 for none
  PlaneSet crossing = 0;  // the planes that the volume crosses, against which its children must be tested; complete
                          // only if the volume is not outside
};

/// The end.
struct Classified {
  static constexpr std::string_view kName = "classified";
  CullResult result;
  static constexpr std::array<std::string_view, 4> kFields{"verdict", "planes_tested", "rejected_by", "crossing"};
  static auto tie(auto& own) {
    return std::tie(own.result.verdict, own.result.planes_tested, own.result.rejected_by, own.result.crossing);
  }
};

template <class Scalar, int Dim>
struct ClassifyStep {
  using Fact = std::variant<PlaneTested<Scalar, Dim>, CornerTested<Scalar, Dim>, Classified>;
  int line = 0;  // of the test's pseudocode, counted from 0
  Fact fact;
};

}  // namespace snug::query
