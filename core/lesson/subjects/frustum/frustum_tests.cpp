#include "lesson/subjects/frustum/frustum_tests.hpp"

#include <algorithm>
#include <array>

#include "geometry/convert.hpp"
#include "lesson/subjects/frustum/matrix_planes.hpp"
#include "query/cull/classify.hpp"
#include "query/cull/classify_corners.hpp"
#include "query/cull/classify_sphere.hpp"
#include "query/cull/frustum_sat.hpp"
#include "query/distance/gjk.hpp"
#include "query/exhibits/wrong_corners_outside.hpp"

namespace snug::lesson {
namespace {

template <class Scalar, int Dim>
FrustumStep in_space(const query::ClassifyStep<Scalar, Dim>& step) {
  const auto lifted = [](const auto& fact) -> FrustumStep::Fact {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(fact)>, query::Classified>) return fact;
    else return converted<double, 3>(fact);
  };
  return {step.line, std::visit(lifted, step.fact)};
}

/// A lesson's box has no parent, so no plane is ever skipped: this leaves out the line about skipping.
constexpr auto kOneBoxPseudocode = [] {
  std::array<std::string_view, query::kClassifyBoxPseudocode.size() - 1> lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = query::kClassifyBoxPseudocode[i < query::ClassifyLine::kSkip ? i : i + 1];
  return lines;
}();
int without_skip(int line) { return line > query::ClassifyLine::kSkip ? line - 1 : line; }

constexpr std::array<std::string_view, 4> kPointPseudocode{
    "for each plane n, d of the frustum",
    "  v ← n · p + d",
    "  outside if v > 0",
    "inside",
};
/// The lines of the test of a box, without its first and without the choice of vertices.
int line_of_point(int line) { return line == query::ClassifyLine::kVerdict ? 3 : 2; }

constexpr std::string_view kWrongCorners = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr Method of_matrix(std::string_view name, std::string_view title) {
  return {.volume = kFrustumBox,
          .name = name,
          .title = title,
          .source = "G. Gribb, K. Hartmann, Fast Extraction of Viewing Frustum Planes, 2001",
          .pseudocode = kMatrixPseudocode,
          .plane = false};
}
constexpr std::array kFrustumTests{
    Method{kFrustumBox, "p_n_vertex", "P- and n-vertex",
           "U. Assarsson, T. Möller, Optimized View Frustum Culling, 2000", kOneBoxPseudocode},
    Method{kFrustumBox, "corners_per_plane", "All vertices, plane by plane", kWrongCorners,
           query::kClassifyCornersPseudocode},
    Method{kFrustumBox, "corners_outside", "All vertices outside (wrong)", kWrongCorners,
           query::kCornersOutsidePseudocode},
    of_matrix(kMatrixTests[0], "Matrix planes (naive)"),
    of_matrix(kMatrixTests[1], "Matrix planes, float (naive)"),
    Method{kFrustumSphere, "grown_planes", "Planes moved out by r", kWrongCorners, query::kClassifySpherePseudocode},
    Method{kFrustumSphere, "wrong_sign", "Planes moved in by r (wrong)", kWrongCorners, query::kWrongSignPseudocode},
    Method{kFrustumPoint, "half_spaces", "Half-spaces", kWrongCorners, kPointPseudocode},
};

template <int Dim>
Obb<double, Dim> box_of(const BoxPair& pair) {
  return converted<double, Dim>(pair.boxes[0]);
}

template <class Scalar, int Dim>
Sphere<Scalar, Dim> ball_of(const Obb<Scalar, Dim>& box) {
  return {box.center, box.half_extents[0]};
}

template <class Scalar>
FrustumTrace record_matrix(const BoxPair& pair) {
  query::ClassifyRecorder<Scalar, 3> recorder;
  query::classify(matrix_frustum<Scalar>(pair), converted<Scalar, 3>(pair.boxes[0]), {}, recorder);
  FrustumTrace trace;
  for (const auto& [step, counts] : recorder.entries) {
    trace.push_back({in_space(step), counts});
    trace.back().step.line = without_skip(step.line);
  }
  return trace;
}

template <class Scalar, int Dim>
FrustumTrace record_in(std::string_view test, const BoxPair& pair) {
  FrustumTrace trace;
  const auto in_double = frustum_of<Dim>(pair);
  if (!in_double) return trace;
  const auto frustum = frustum_in<Scalar>(*in_double);
  if (!frustum) return trace;
  const auto box = converted<Scalar, Dim>(pair.boxes[0]);
  query::ClassifyRecorder<Scalar, Dim> recorder;
  if (test == "half_spaces") query::classify(*frustum, box.center, {}, recorder);
  else if (test == "grown_planes") query::classify(*frustum, ball_of(box), {}, recorder);
  else if (test == "wrong_sign") query::wrong_sphere_sign(*frustum, ball_of(box), recorder);
  else if (test == "corners_per_plane") query::classify_corners(*frustum, box, recorder);
  else if (test == "corners_outside") query::corners_outside(*frustum, box, recorder);
  else query::classify(*frustum, box, {}, recorder);
  for (const auto& [step, counts] : recorder.entries) {
    trace.push_back({in_space(step), counts});
    int& line = trace.back().step.line;
    if (test == "p_n_vertex") line = without_skip(step.line);
    if (test == "half_spaces") line = line_of_point(step.line);
    if (test == "grown_planes") line = query::line_of_sphere(step.line);
  }
  return trace;
}

/// GJK on the frustum's rounded vertices.
template <int Dim>
std::optional<bool> shares_with_ball(const Frustum<double, Dim>& frustum, const Sphere<double, Dim>& ball) {
  const auto corners = corners_of(frustum);
  if (!corners) return std::nullopt;
  ConvexHull<double, Dim> hull;
  hull.vertices.assign(corners->begin(), corners->end());
  const auto apart = query::gjk(Volume<double, Dim>(ball), Volume<double, Dim>(hull));
  return !apart || apart->overlap;
}

template <int Dim>
std::optional<bool> share_in(const BoxPair& pair) {
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return std::nullopt;
  if (pair.form == Form::kPoint)
    return query::classify(*frustum, box_of<Dim>(pair).center).verdict != query::Culling::kOutside;
  if (pair.form == Form::kBall) return shares_with_ball<Dim>(*frustum, ball_of(box_of<Dim>(pair)));
  const auto exact = query::FrustumSat<double, Dim>::make(*frustum);
  if (!exact) return std::nullopt;
  return exact->overlaps(box_of<Dim>(pair));
}

}  // namespace

std::span<const Method> frustum_tests(std::string_view volume) {
  const auto own = [&](const Method& test) { return test.volume == volume; };
  const auto first = std::find_if(kFrustumTests.begin(), kFrustumTests.end(), own);
  return {first, std::find_if_not(first, kFrustumTests.end(), own)};
}

FrustumTrace record_frustum(std::string_view test, const BoxPair& pair) {
  if (is_of_matrix(test))
    return pair.in_float || test == kMatrixTests[1] ? record_matrix<float>(pair) : record_matrix<double>(pair);
  if (pair.in_float) return pair.dim == 2 ? record_in<float, 2>(test, pair) : record_in<float, 3>(test, pair);
  return pair.dim == 2 ? record_in<double, 2>(test, pair) : record_in<double, 3>(test, pair);
}

query::Culling verdict_of(std::string_view test, const BoxPair& pair) { return verdict_of(record_frustum(test, pair)); }

query::Culling verdict_of(FrustumSteps trace) {
  const auto* end = trace.empty() ? nullptr : std::get_if<query::Classified>(&trace.back().step.fact);
  return end != nullptr ? end->result.verdict : query::Culling::kIntersecting;
}

std::optional<bool> share_a_point(const BoxPair& pair) { return pair.dim == 2 ? share_in<2>(pair) : share_in<3>(pair); }

}  // namespace snug::lesson
