#include "lesson/subjects/field/field_methods.hpp"

namespace snug::lesson {
namespace {

using hierarchy::FieldWay;

// field_run.cpp says which steps name which lines.
constexpr std::array<std::string_view, 6> kAllVerticesLines{
    "for each object",
    "  for each plane n, d of the frustum",
    "    for each of its eight vertices v",
    "      is n · v + d > 0?",
    "  outside if so for all eight, for one plane",
    "  else intersecting if for any, else inside",
};
constexpr std::array<std::string_view, 5> kPnVertexLines{
    "for each object",
    "  for each plane n, d of the frustum",
    "    outside, and done, if n · n-vertex + d > 0",
    "    crosses ← yes if n · p-vertex + d > 0",
    "  intersecting if crosses, else inside",
};
constexpr std::array<std::string_view, 8> kSpheresFirstLines{
    "for each object, with the sphere c, r around it",
    "  for each plane: v ← n · c + d",
    "    outside, and done, if v − r > 0",
    "    the sphere crosses it if v + r > 0",
    "  inside, and done, if it crosses none",
    "  for each plane that the sphere crosses",
    "    test the box by its p- and n-vertex",
    "  intersecting if it crosses one, else inside",
};
constexpr std::array<std::string_view, 6> kLastPlaneLines{
    "for each object",
    "  first test the plane that rejected it last",
    "  outside, and done, if it rejects it again",
    "  then the others, by p- and n-vertex",
    "  keep the plane that rejects it",
    "  intersecting if it crosses one, else inside",
};
constexpr std::array<std::string_view, 6> kTreeLines{
    "open ← root, with all six planes",  //
    "while a node is open: for each of its planes",
    "  skip it if the parent is inside it",
    "  outside one: leave out all below",
    "  inside all: take all below, untested",
    "  else open its children, or test its objects",
};
constexpr std::array<std::string_view, 5> kAtOnceLines{
    "for every eight objects, one in each lane",  //
    "  low ← largest n · n-vertex + d, of six planes",
    "  outside if low > 0; done if all eight are",  //
    "  high ← largest n · p-vertex + d, of six planes",
    "  intersecting if high > 0, else inside",  //
};

constexpr std::string_view kOptimized = "U. Assarsson, T. Möller, Optimized View Frustum Culling, 2000";
constexpr std::string_view kOfLectures = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";

constexpr Method of_field(FieldWay way, std::string_view title, std::string_view source,
                          std::span<const std::string_view> lines) {
  return {.volume = kFrustumField,
          .name = hierarchy::kFieldWayNames[static_cast<std::size_t>(way)],
          .title = title,
          .source = source,
          .pseudocode = lines,
          .plane = false};
}
constexpr std::array kFieldMethods{
    of_field(FieldWay::kAllVertices, "All vertices, all planes", kOfLectures, kAllVerticesLines),
    of_field(FieldWay::kPnVertex, "P- and n-vertex", kOptimized, kPnVertexLines),
    of_field(FieldWay::kSpheresFirst, "Spheres first", kOfLectures, kSpheresFirstLines),
    of_field(FieldWay::kLastPlane, "Last plane first", kOptimized, kLastPlaneLines),
    of_field(FieldWay::kTree, "Tree with plane masks", kOptimized, kTreeLines),
    of_field(FieldWay::kAtOnce, "Eight at once", kOptimized, kAtOnceLines),
};

}  // namespace

std::span<const Method> field_methods() { return kFieldMethods; }
FieldWay way_of(const Method& method) { return static_cast<FieldWay>(&method - kFieldMethods.data()); }

}  // namespace snug::lesson
