// libFuzzer: volumes of any two kinds, fitted round points that they share or do not share, and a frustum round some of
// them; in float and double, in the plane and in space. What has a point in common overlaps, in either order; what has
// a point in the frustum is not outside of it, and what is inside has none outside. Boxes may miss that by the rounding
// of their axes: see "boxes may be apart although they share a point".
#include "core/exact.hpp"
#include "fuzz/volumes.hpp"
#include "query/cull/classify.hpp"
#include "query/overlap/overlaps.hpp"

namespace {

using namespace snug;
using fuzz::require;

constexpr unsigned kMostPoints = 8;
constexpr int kMostTurns = 64;  // of GJK, as in tests/core/fit/family_checks.hpp

template <class Scalar, int Dim>
void check_pair(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, bool shared) {
  const auto one = query::test_overlap<Scalar, Dim>(a, b), other = query::test_overlap<Scalar, Dim>(b, a);
  require(one.overlap == other.overlap);
  require(query::overlaps<Scalar, Dim>(a, b) == one.overlap && query::overlaps<Scalar, Dim>(b, a) == one.overlap);
  require(!shared || one.overlap ||
          static_cast<double>(one.separating_axis->gap) <=
              fuzz::axes_off<Scalar, Dim>(a) + fuzz::axes_off<Scalar, Dim>(b));
  if (one.distance) require(*one.distance >= 0 && (one.overlap ? *one.distance == 0 : true));
  const auto separation = query::gjk<Scalar, Dim>(a, b);
  require(separation && separation->turns <= kMostTurns);
}

/// The sign of normal . p + d, after p was moved by so much of the normal's coordinates' sizes against its direction.
template <class Scalar, int Dim>
int exact_side(const Plane<Scalar, Dim>& plane, const Vector<Scalar, Dim>& p, double moved) {
  const auto exact = [](Scalar x) { return exact::Rational(static_cast<double>(x)); };
  exact::Rational sum = exact(plane.d);
  for (int i = 0; i < Dim; ++i)
    sum += exact(plane.normal[i]) * exact(p[i]) - abs(exact(plane.normal[i])) * exact::Rational(moved);
  return sum.sign();
}

template <class Scalar, int Dim>
void check_cull(fuzz::Bytes& bytes, const Volume<Scalar, Dim>& volume, const fuzz::Cloud<Scalar, Dim>& points) {
  const auto frustum = fuzz::any_frustum<Scalar, Dim>(bytes);
  if (!frustum) return;
  const auto& planes = frustum->planes();
  const auto inside = [&](double moved) {
    return [&planes, moved](const Vector<Scalar, Dim>& p) {
      return std::all_of(planes.begin(), planes.end(),
                         [&](const auto& plane) { return exact_side<Scalar, Dim>(plane, p, moved) <= 0; });
    };
  };
  const auto verdict = query::classify_volume(*frustum, volume).verdict;
  const double off = fuzz::axes_off<Scalar, Dim>(volume);
  if (std::any_of(points.begin(), points.end(), inside(-off))) require(verdict != query::Culling::kOutside);
  if (verdict == query::Culling::kInside) require(std::all_of(points.begin(), points.end(), inside(off)));
}

template <class Scalar, int Dim>
void check(fuzz::Bytes& bytes) {
  const auto first = bytes.cloud<Scalar, Dim>(kMostPoints);
  auto second = bytes.cloud<Scalar, Dim>(kMostPoints);
  const bool shared = bytes.below(2) == 0;
  if (shared) second.front() = first.back();
  const auto any = [](const fit::Algorithm&) { return true; };
  const auto a = fuzz::fitted<Scalar, Dim>(bytes, first, any), b = fuzz::fitted<Scalar, Dim>(bytes, second, any);
  check_pair<Scalar, Dim>(a, b, shared);
  check_cull<Scalar, Dim>(bytes, a, first);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  switch (bytes.below(4)) {
    case 0: check<double, 2>(bytes); break;
    case 1: check<double, 3>(bytes); break;
    case 2: check<float, 2>(bytes); break;
    default: check<float, 3>(bytes); break;
  }
  return 0;
}
