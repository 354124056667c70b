// What the separating-axis test of two oriented boxes returns, and its steps.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <variant>

#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug::query {

/// Where an axis of the test comes from: the normal of a face of either box, or an edge of A x an edge of B (3-D only).
enum class AxisKind : std::uint8_t { kNone, kFaceA, kFaceB, kEdgeEdge };
inline constexpr std::array<std::string_view, 4> kAxisKindNames{"none", "face_a", "face_b", "edge_edge"};

/// How many axes the test has: 4 in 2-D, 15 in 3-D.
template <int Dim>
inline constexpr int kSatAxes = Dim == 2 ? 4 : 15;

/// One axis of the test, and how far apart the boxes are along it.
template <class Scalar, int Dim>
struct SatAxis {
  AxisKind kind = AxisKind::kNone;
  int i = -1;                                                   // A's face or edge; -1 where B's face is meant
  int j = -1;                                                   // B's face or edge; -1 where A's face is meant
  Vector<Scalar, Dim> direction = Vector<Scalar, Dim>::Zero();  // unit, in the world, from A towards B
  Scalar gap = 0;                                               // scene units; where the projections overlap, <= 0
  SNUG_FIELDS(kind, i, j, direction, gap);
};

template <class Scalar, int Dim>
struct SatResult {
  bool overlap = false;
  int tests = 0;              // axes tested, including those that parallel edges leave out
  SatAxis<Scalar, Dim> axis;  // if apart, one that separates; if overlapping, that of least penetration, or kNone
};

/// B in A's frame: its axes as columns, its centre, and the error bound of the gaps, scene units.
template <class Scalar, int Dim>
struct FramesRelated {
  static constexpr std::string_view kName = "frames_related";
  Matrix<Scalar, Dim> rotation = Matrix<Scalar, Dim>::Identity();
  Vector<Scalar, Dim> translation = Vector<Scalar, Dim>::Zero();
  Scalar doubt = 0;
  SNUG_FIELDS(rotation, translation, doubt);
};

/// Both boxes were projected onto an axis. Values are in scene units along the unit direction; Ericson's table 4.1
/// has them times length, the sine of the angle between the edges (1 for a face). gap = distance - radius_a - radius_b.
template <class Scalar, int Dim>
struct AxisTested {
  static constexpr std::string_view kName = "axis_tested";
  SatAxis<Scalar, Dim> axis;  // its direction is zero if skipped
  Scalar length = 0;
  Scalar distance = 0;  // between the projected centres
  Scalar radius_a = 0;
  Scalar radius_b = 0;
  Scalar doubt = 0;        // the error bound of the gap
  bool separates = false;  // gap > doubt
  bool skipped = false;    // the edges are parallel: there is no such axis, and none is needed
  /// The vertices that face each other along the axis: bit c for the vertex with the bits c, 1 for +x, 2 for +y, 4 for
  /// +z.
  int near_a = 0;
  int near_b = 0;
  static constexpr std::array<std::string_view, 14> kFields{"kind",      "i",        "j",        "direction", "gap",
                                                            "length",    "distance", "radius_a", "radius_b",  "doubt",
                                                            "separates", "skipped",  "near_a",   "near_b"};
  static auto tie(auto& own) {
    return std::tuple_cat(SatAxis<Scalar, Dim>::tie(own.axis),
                          std::tie(own.length, own.distance, own.radius_a, own.radius_b, own.doubt, own.separates,
                                   own.skipped, own.near_a, own.near_b));
  }
};

/// Rounding hid whether some axes separate, so they were tested again in exact arithmetic.
struct LookedCloser {
  static constexpr std::string_view kName = "looked_closer";
  int axes = 0;  // how many
  bool overlap = false;
  SNUG_FIELDS(axes, overlap);
};

/// The end.
template <class Scalar, int Dim>
struct Verdict {
  static constexpr std::string_view kName = "verdict";
  SatResult<Scalar, Dim> result;
  static constexpr std::array<std::string_view, 7> kFields{"overlap", "tests", "kind", "i", "j", "direction", "gap"};
  static auto tie(auto& own) {
    return std::tuple_cat(std::tie(own.result.overlap, own.result.tests), SatAxis<Scalar, Dim>::tie(own.result.axis));
  }
};

template <class Scalar, int Dim>
struct SatStep {
  using Fact = std::variant<FramesRelated<Scalar, Dim>, AxisTested<Scalar, Dim>, LookedCloser, Verdict<Scalar, Dim>>;
  int line = 0;  // of kSatPseudocode<Dim>, counted from 0
  Fact fact;
};

}  // namespace snug::query
