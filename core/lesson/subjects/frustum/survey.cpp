#include "lesson/subjects/frustum/survey.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

constexpr std::int64_t kPortion = 500;  // spheres: less than a millisecond

template <int Dim>
std::optional<cost::SphereSurvey<Dim>> survey_in(const BoxPair& pair, std::uint64_t seed) {
  const auto frustum = frustum_of<Dim>(pair);
  if (!frustum) return std::nullopt;
  return cost::SphereSurvey<Dim>::make(*frustum, pair.boxes[0].half_extents[0], seed);
}

}  // namespace

std::optional<FrustumSurvey> FrustumSurvey::make(const BoxPair& pair, std::uint64_t seed) {
  if (pair.dim == 2) {
    if (auto flat = survey_in<2>(pair, seed)) return FrustumSurvey(*std::move(flat), rows_of(pair), seed);
  } else if (auto solid = survey_in<3>(pair, seed)) {
    return FrustumSurvey(*std::move(solid), rows_of(pair), seed);
  }
  return std::nullopt;
}

const cost::SurveyCounts& FrustumSurvey::counts() const {
  return std::visit([](const auto& run) -> const cost::SurveyCounts& { return run.counts(); }, run_);
}

void FrustumSurvey::step() {
  std::visit([](auto& run) { run.run(std::min(kPortion, kSurveySpheres - run.counts().spheres)); }, run_);
}

}  // namespace snug::lesson
