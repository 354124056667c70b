#include "measure/sphere_survey.hpp"

#include <bit>

#include "geometry/frustum_corners.hpp"
#include "query/cull/classify.hpp"
#include "query/distance/gjk.hpp"

namespace snug::cost {

template <int Dim>
std::optional<SphereSurvey<Dim>> SphereSurvey<Dim>::make(const Frustum<double, Dim>& frustum, double radius,
                                                         std::uint64_t seed) {
  const auto corners = corners_of(frustum);
  if (!corners) return std::nullopt;
  ConvexHull<double, Dim> hull;
  hull.vertices.assign(corners->begin(), corners->end());
  SphereSurvey survey(frustum, Volume<double, Dim>(hull), radius, seed);
  survey.low_ = survey.high_ = hull.vertices.front();
  for (const Vector<double, Dim>& vertex : hull.vertices) {
    survey.low_ = survey.low_.cwiseMin(vertex);
    survey.high_ = survey.high_.cwiseMax(vertex);
  }
  survey.low_.array() -= radius;
  survey.high_.array() += radius;
  return survey;
}

template <int Dim>
void SphereSurvey<Dim>::run(std::int64_t spheres) {
  for (std::int64_t i = 0; i < spheres; ++i) {
    Sphere<double, Dim> sphere{{}, radius_};
    for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = random_.between(low_[axis], high_[axis]);
    add(sphere);
  }
}

/// A sphere that crosses one plane and is inside of the others touches the frustum: where its centre is nearest to that
/// plane, it is inside of the others too. So only those that cross two or more are looked at, and of these the ones
/// whose centre is outside.
template <int Dim>
void SphereSurvey<Dim>::add(const Sphere<double, Dim>& sphere) {
  ++counts_.spheres;
  const query::CullResult result = query::classify(frustum_, sphere);
  if (result.verdict == query::Culling::kOutside) ++counts_.outside;
  if (result.verdict == query::Culling::kInside) ++counts_.inside;
  if (result.verdict != query::Culling::kIntersecting) return;
  ++counts_.intersecting;
  const int crossed = std::popcount(result.crossing);
  if (crossed < 2 || query::classify(frustum_, sphere.center).verdict != query::Culling::kOutside) return;
  const auto apart = query::gjk(Volume<double, Dim>(sphere), hull_);
  if (apart && !apart->overlap) ++(crossed == 2 ? counts_.false_at_two : counts_.false_at_more);
}

template class SphereSurvey<2>;
template class SphereSurvey<3>;

}  // namespace snug::cost
