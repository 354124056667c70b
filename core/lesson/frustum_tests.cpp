#include "lesson/frustum_tests.hpp"

#include <array>
#include <limits>

#include "fit/lift.hpp"
#include "query/classify.hpp"
#include "query/classify_corners.hpp"
#include "query/frustum_sat.hpp"
#include "query/wrong_corners_outside.hpp"

namespace snug::lesson {
namespace {

constexpr fit::Algorithm frustum_row(std::string_view name, std::string_view title, std::string_view source,
                                     std::span<const std::string_view> pseudocode) {
  return {kFrustumBox, name,       title, false,   true,   true, std::numeric_limits<Index>::max(),
          source,      pseudocode, {},    nullptr, nullptr};
}

/// A lesson's box has no parent, so no plane is ever skipped: the line that says so is left out.
constexpr auto kOneBoxPseudocode = [] {
  std::array<std::string_view, query::kClassifyBoxPseudocode.size() - 1> lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
    lines[i] = query::kClassifyBoxPseudocode[i < query::ClassifyLine::kSkip ? i : i + 1];
  return lines;
}();
int without_skip(int line) { return line > query::ClassifyLine::kSkip ? line - 1 : line; }

constexpr std::string_view kWrongCorners = "I. D. Romanick, Data Structures & Algorithms for Geometry, 2007";
constexpr std::array kFrustumTests{
    frustum_row("p_n_vertex", "P- and n-vertex", "U. Assarsson, T. Möller, Optimized View Frustum Culling, 2000",
                kOneBoxPseudocode),
    frustum_row("corners_per_plane", "All vertices, plane by plane", kWrongCorners, query::kClassifyCornersPseudocode),
    frustum_row("corners_outside", "All vertices outside (wrong)", kWrongCorners, query::kCornersOutsidePseudocode),
};

template <int Dim>
Obb<double, Dim> box_of(const BoxPair& pair) {
  if constexpr (Dim == 2) return flat(pair.boxes[0]);
  else return pair.boxes[0];
}

template <int Dim>
fit::Recording record_in(std::string_view test, const BoxPair& pair) {
  fit::Recording recording;
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return recording;
  const Obb<double, Dim> box = box_of<Dim>(pair);
  query::ClassifyRecorder<double, Dim> recorder;
  if (test == "corners_per_plane") query::classify_corners(*frustum, box, recorder);
  else if (test == "corners_outside") query::corners_outside(*frustum, box, recorder);
  else query::classify(*frustum, box, {}, recorder);
  for (const auto& [step, counts] : recorder.entries) {
    recording.steps.push_back({fit::lift(step), counts});
    if (test == "p_n_vertex") recording.steps.back().step.line = without_skip(step.line);
  }
  recording.counts = recorder.counts;
  return recording;
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

std::span<const fit::Algorithm> frustum_tests() { return kFrustumTests; }

fit::Recording record_frustum(const fit::Algorithm& test, const BoxPair& pair) {
  return pair.dim == 2 ? record_in<2>(test.name, pair) : record_in<3>(test.name, pair);
}

query::Culling says_of_box(const fit::Algorithm& test, const BoxPair& pair) {
  const fit::Recording recording = record_frustum(test, pair);
  const auto* end =
      recording.steps.empty() ? nullptr : std::get_if<query::Classified>(&recording.steps.back().step.fact);
  return end != nullptr ? end->result.verdict : query::Culling::kIntersecting;
}

std::optional<bool> share_a_point(const BoxPair& pair) { return pair.dim == 2 ? share_in<2>(pair) : share_in<3>(pair); }

}  // namespace snug::lesson
