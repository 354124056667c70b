// libFuzzer: volumes of any two kinds, fitted round points that they share or do not share, and a frustum round some of
// them. What has a point in common overlaps, in either order; what has a point in the frustum is not outside of it, and
// what is inside has none outside. Boxes may miss that by the rounding of their axes: see "boxes may be apart although
// they share a point".
#include "core/exact.hpp"
#include "fit/catalogue.hpp"
#include "fuzz/bytes.hpp"
#include "geometry/tolerance.hpp"
#include "query/classify.hpp"
#include "query/overlaps.hpp"

namespace {

using namespace snug;
using fuzz::require;
using Point = Vector<double, 3>;
using Cloud = std::vector<Point>;

constexpr unsigned kMostPoints = 8;

/// Fitted by one of the algorithms whose result is sure to contain the points.
fit::Volume3 fitted(fuzz::Bytes& bytes, const Cloud& points) {
  std::vector<const fit::Algorithm*> fitting;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (algorithm.space && !algorithm.naive) fitting.push_back(&algorithm);
  const fit::Algorithm& algorithm = *fitting[bytes.below(static_cast<unsigned>(fitting.size()))];
  return algorithm.fit(*PointSet<double, 3>::make(points), {}).volume;
}

/// How far a point within a box's slabs may be from every sum of its edges.
double axes_off(const fit::Volume3& volume) {
  const auto* box = std::get_if<Obb<double, 3>>(&volume);
  return box == nullptr ? 0 : 2 * tolerance::kObbAxes<double> * box->half_extents.sum();
}

void check_pair(const fit::Volume3& a, const fit::Volume3& b, bool shared) {
  const auto one = query::test_overlap(a, b), other = query::test_overlap(b, a);
  require(one.overlap == other.overlap);
  require(!shared || one.overlap || one.separating_axis->gap <= axes_off(a) + axes_off(b));
  if (one.distance) require(*one.distance >= 0 && (one.overlap ? *one.distance == 0 : true));
}

/// The sign of normal . p + d, after p was moved by so much of the normal's coordinates' sizes against its direction.
int exact_side(const Plane<double, 3>& plane, const Point& p, double moved) {
  exact::Rational sum = plane.d;
  for (int i = 0; i < 3; ++i)
    sum += exact::Rational(plane.normal[i]) * exact::Rational(p[i]) -
           abs(exact::Rational(plane.normal[i])) * exact::Rational(moved);
  return sum.sign();
}

void check_cull(fuzz::Bytes& bytes, const fit::Volume3& volume, const Cloud& points) {
  Frustum<double, 3>::Planes planes;
  for (auto& plane : planes) plane = {bytes.point<double, 3>(), bytes.number<double>()};
  const auto frustum = Frustum<double, 3>::make(planes);
  if (!frustum) return;
  const auto inside = [&](double moved) {
    return [&planes, moved](const Point& p) {
      return std::all_of(planes.begin(), planes.end(),
                         [&](const auto& plane) { return exact_side(plane, p, moved) <= 0; });
    };
  };
  const auto verdict = query::classify_volume(*frustum, volume).verdict;
  const double off = axes_off(volume);
  if (std::any_of(points.begin(), points.end(), inside(-off))) require(verdict != query::Culling::kOutside);
  if (verdict == query::Culling::kInside) require(std::all_of(points.begin(), points.end(), inside(off)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const Cloud first = bytes.cloud<double, 3>(kMostPoints);
  Cloud second = bytes.cloud<double, 3>(kMostPoints);
  const bool shared = bytes.below(2) == 0;
  if (shared) second.front() = first.back();
  const fit::Volume3 a = fitted(bytes, first), b = fitted(bytes, second);
  check_pair(a, b, shared);
  check_cull(bytes, a, first);
  return 0;
}
