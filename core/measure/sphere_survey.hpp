// How often the test of a sphere against planes that are moved out by its radius keeps a sphere that touches nothing:
// counted over random spheres around a frustum, so many at a time.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/frustum.hpp"
#include "geometry/random.hpp"
#include "geometry/volume.hpp"

namespace snug::cost {

struct SurveyCounts {
  std::int64_t spheres = 0;
  std::int64_t inside = 0, intersecting = 0, outside = 0;  // as the test says
  /// Called intersecting, although they share no point with the frustum: of two planes that they cross, near the edge
  /// where these meet (in the plane, near the vertex); of more, near a vertex.
  std::int64_t false_at_two = 0, false_at_more = 0;
  [[nodiscard]] std::int64_t false_positives() const { return false_at_two + false_at_more; }
  friend bool operator==(const SurveyCounts&, const SurveyCounts&) = default;
};

/// A survey of one frustum with spheres of one radius, whose centres are spread evenly over the box around the frustum
/// and all spheres that touch it. In whatever portions it is run, a seed gives the same counts.
template <int Dim>
class SphereSurvey {
 public:
  /// None if the frustum is so thin that it has no vertices. radius: >= 0.
  [[nodiscard]] static std::optional<SphereSurvey> make(const Frustum<double, Dim>& frustum, double radius,
                                                        std::uint64_t seed);
  /// Tests so many more. Where the test says intersecting, query::gjk decides, within rounding, on the vertices as
  /// rounded.
  void run(std::int64_t spheres);
  [[nodiscard]] const SurveyCounts& counts() const { return counts_; }

 private:
  SphereSurvey(const Frustum<double, Dim>& frustum, Volume<double, Dim> hull, double radius, std::uint64_t seed)
      : frustum_(frustum), hull_(std::move(hull)), radius_(radius), random_(seed) {}
  void add(const Sphere<double, Dim>& sphere);

  Frustum<double, Dim> frustum_;
  Volume<double, Dim> hull_;  // its vertices
  double radius_;
  Random random_;
  Vector<double, Dim> low_, high_;  // of the centres
  SurveyCounts counts_;
};

extern template class SphereSurvey<2>;
extern template class SphereSurvey<3>;

}  // namespace snug::cost
