#include "lesson/subjects/frustum/frustum_tests.hpp"

#include <array>

#include "fit/lift.hpp"
#include "query/classify.hpp"
#include "query/classify_corners.hpp"
#include "query/frustum_sat.hpp"
#include "query/wrong_corners_outside.hpp"

namespace snug::lesson {
namespace {

template <int Dim>
FrustumStep in_space(const query::ClassifyStep<double, Dim>& step) {
  if constexpr (Dim == 3) return step;
  else {
    const auto lifted = [](const auto& v) { return fit::lift<double, Dim>(v); };
    if (const auto* end = std::get_if<query::Classified>(&step.fact)) return {step.line, *end};
    if (const auto* corner = std::get_if<query::CornerTested<double, Dim>>(&step.fact))
      return {step.line, query::CornerTested<double, 3>{corner->corner, corner->plane, lifted(corner->point),
                                                        corner->distance, corner->outside}};
    const auto& f = *std::get_if<query::PlaneTested<double, Dim>>(&step.fact);
    return {step.line,
            query::PlaneTested<double, 3>{f.plane, f.skipped, lifted(f.normal), f.signs, f.p_vertex, f.n_vertex,
                                          f.p_corners, f.n_corners, lifted(f.p_point), lifted(f.n_point), f.p_distance,
                                          f.n_distance, f.doubt, f.looked_closer, f.side, f.so_far}};
  }
}

/// A lesson's box has no parent, so no plane is ever skipped: this leaves out the line about skipping.
constexpr auto kOneBoxPseudocode = [] {
  std::array<std::string_view, query::kClassifyBoxPseudocode.size() - 1> lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = query::kClassifyBoxPseudocode[i < query::ClassifyLine::kSkip ? i : i + 1];
  return lines;
}();
int without_skip(int line) { return line > query::ClassifyLine::kSkip ? line - 1 : line; }

constexpr std::string_view kWrongCorners = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::array kFrustumTests{
    Method{kFrustumBox, "p_n_vertex", "P- and n-vertex",
           "U. Assarsson, T. Möller, Optimized View Frustum Culling, 2000", kOneBoxPseudocode},
    Method{kFrustumBox, "corners_per_plane", "All vertices, plane by plane", kWrongCorners,
           query::kClassifyCornersPseudocode},
    Method{kFrustumBox, "corners_outside", "All vertices outside (wrong)", kWrongCorners,
           query::kCornersOutsidePseudocode},
};

template <int Dim>
Obb<double, Dim> box_of(const BoxPair& pair) {
  if constexpr (Dim == 2) return flat(pair.boxes[0]);
  else return pair.boxes[0];
}

template <int Dim>
FrustumTrace record_in(std::string_view test, const BoxPair& pair) {
  FrustumTrace trace;
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return trace;
  const Obb<double, Dim> box = box_of<Dim>(pair);
  query::ClassifyRecorder<double, Dim> recorder;
  if (test == "corners_per_plane") query::classify_corners(*frustum, box, recorder);
  else if (test == "corners_outside") query::corners_outside(*frustum, box, recorder);
  else query::classify(*frustum, box, {}, recorder);
  for (const auto& [step, counts] : recorder.entries) {
    trace.push_back({in_space(step), counts});
    if (test == "p_n_vertex") trace.back().step.line = without_skip(step.line);
  }
  return trace;
}

template <int Dim>
std::optional<bool> share_in(const BoxPair& pair) {
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return std::nullopt;
  const auto exact = query::FrustumSat<double, Dim>::make(*frustum);
  if (!exact) return std::nullopt;
  return exact->overlaps(box_of<Dim>(pair));
}

}  // namespace

std::span<const Method> frustum_tests() { return kFrustumTests; }

FrustumTrace record_frustum(std::string_view test, const BoxPair& pair) {
  return pair.dim == 2 ? record_in<2>(test, pair) : record_in<3>(test, pair);
}

query::Culling says_of_box(std::string_view test, const BoxPair& pair) {
  const FrustumTrace trace = record_frustum(test, pair);
  const auto* end = trace.empty() ? nullptr : std::get_if<query::Classified>(&trace.back().step.fact);
  return end != nullptr ? end->result.verdict : query::Culling::kIntersecting;
}

std::optional<bool> share_a_point(const BoxPair& pair) { return pair.dim == 2 ? share_in<2>(pair) : share_in<3>(pair); }

}  // namespace snug::lesson
