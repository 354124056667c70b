// A survey of the test of a sphere, around the frustum on the stage: how many of a million spheres of this radius it
// keeps, and how many of those touch nothing. It is run in small portions, so that no frame waits for it.
#pragma once

#include <variant>

#include "lesson/subjects/frustum/frustum_box.hpp"
#include "measure/sphere_survey.hpp"

namespace snug::lesson {

inline constexpr std::int64_t kSurveySpheres = 1'000'000;

class FrustumSurvey {
 public:
  /// pair: a sphere and a frustum. None if the frustum is so thin that it has no vertices.
  [[nodiscard]] static std::optional<FrustumSurvey> make(const BoxPair& pair, std::uint64_t seed);
  /// Whether it is about these.
  [[nodiscard]] bool is_of(const BoxPair& pair) const { return rows_of(pair) == rows_; }
  [[nodiscard]] const cost::SurveyCounts& counts() const;
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] bool done() const { return counts().spheres >= kSurveySpheres; }
  /// Tests some more.
  void step();

 private:
  using Run = std::variant<cost::SphereSurvey<2>, cost::SphereSurvey<3>>;
  FrustumSurvey(Run run, Rows rows, std::uint64_t seed) : run_(std::move(run)), rows_(std::move(rows)), seed_(seed) {}

  Run run_;
  Rows rows_;
  std::uint64_t seed_;
};

}  // namespace snug::lesson
