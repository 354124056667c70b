// Spheres, Ritter's growing step, segments and capsules.
#include <algorithm>

#include "fit/sphere/grow.hpp"
#include "query/distance/distance.hpp"
#include "query/overlap/overlaps.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace round {
namespace {

// ---- two spheres -------------------------------------------------------------------------------------------------

enum SphereKind { kRandom, kTouching, kInside, kPoints, kTiny, kFar };
constexpr std::array kSphereKinds{
    Kind{"random", "random spheres"},
    Kind{"touching", "spheres that only touch, or almost"},
    Kind{"inside", "spheres of which one contains the other"},
    Kind{"points", "spheres of radius zero"},
    Kind{"tiny", "very small spheres"},
    Kind{"far", "spheres far from the origin"},
};

/// The radii of two spheres at a distance.
std::array<double, 2> radii_at(Cases& cases, int kind, double distance, bool overlap) {
  if (kind == kPoints) return {0, overlap ? distance + (cases.coin() ? 0 : 1) : distance - 1};
  if (kind == kInside && overlap) return {distance + 2, 1};
  const double a = cases.whole(0, static_cast<int>(distance) - 1), b = distance - a;  // touching
  if (kind == kTouching) return {a, overlap ? b : b - kAlmost};
  return {a, overlap ? b + cases.whole(1, 4) : std::max(b - cases.whole(1, 4), 0.0)};
}

void make_spheres(Cases& cases) {
  each_kind(kSphereKinds, [&](int kind, int i) {
    const Scale scale = kind == kTiny ? kTinyScale : kind == kFar ? kFarScale : kPlain;
    const WholeVector way = whole_vector(cases);
    const double times = cases.whole(1, 4);
    const bool same = kind == kPoints && i % 8 == 0;  // the same point twice
    auto [a, b] = radii_at(cases, kind, way.length * times, i % 2 == 0);
    if (kind == kRandom && i % 2 == 1 && a + b >= way.length * times) a = b = 0;
    if (same) b = 0;
    const Vector3 at = whole_point(cases, 12), other = same ? at : Vector3(at + times * way.vector);
    if (cases.coin()) std::swap(a, b);
    cases.add(kind, numbers_of(scale(at), a * scale.factor, scale(other), b * scale.factor));
  });
}

Numbers spheres_overlap(const Numbers& input) {
  Take take(input);
  std::array<Sphere<double, 3>, 2> pair;
  for (auto& [center, radius] : pair) center = take.vector(), radius = take.number();
  return {query::overlaps(pair[0], pair[1]) ? 1.0 : 0.0};
}

bool have_radii(const Numbers& input) { return input[3] >= 0 && input[7] >= 0; }

// ---- Ritter's growing step ---------------------------------------------------------------------------------------

enum GrowKind { kAnyPoint, kOn, kZero, kPointTiny, kPointFar };
constexpr std::array kGrowKinds{
    Kind{"random", "random points"},
    Kind{"on", "points on the sphere"},
    Kind{"zero", "spheres of radius zero, also at the point itself"},
    Kind{"tiny", "very small spheres"},
    Kind{"far", "spheres far from the origin"},
};

void make_growing(Cases& cases) {
  each_kind(kGrowKinds, [&](int kind, int i) {
    const Scale scale = kind == kPointTiny ? kTinyScale : kind == kPointFar ? kFarScale : kPlain;
    const WholeVector way = whole_vector(cases);
    double radius = way.length;
    if (kind == kZero) radius = 0;
    else if (kind != kOn)
      radius = i % 3 == 0 ? radius + cases.whole(1, 9) : cases.whole(0, static_cast<int>(radius) - 1);
    const Vector3 at = whole_point(cases, 12);
    const Vector3 point = kind == kZero && i % 2 == 0 ? at : Vector3(at + way.vector);
    cases.add(kind, numbers_of(scale(at), radius * scale.factor, scale(point)));
  });
}

struct Growing {
  Sphere<double, 3> sphere;
  Vector3 point;
};
Growing growing_of(const Numbers& input) {
  Take take(input);
  Growing growing;
  growing.sphere.center = take.vector();
  growing.sphere.radius = take.number();
  growing.point = take.vector();
  return growing;
}

Numbers grown(const Numbers& input) {
  auto [sphere, point] = growing_of(input);
  Ignore ignore;
  fit::grow_to_hold(sphere, point, 0, 0, ignore);
  return numbers_of(sphere.center, sphere.radius);
}

bool is_grown(const Numbers& input, const Numbers& answer) {
  const auto [sphere, point] = growing_of(input);
  return are_near(answer, grown(input), sphere.radius + (point - sphere.center).norm());
}

bool has_radius(const Numbers& input) { return input[3] >= 0; }

// ---- the closest point on a segment ------------------------------------------------------------------------------

enum SegmentKind { kAnySegment, kEnds, kNoLength, kSegmentTiny, kSegmentFar };
constexpr std::array kSegmentKinds{
    Kind{"random", "random points and segments"}, Kind{"ends", "points beyond the ends of the segment"},
    Kind{"zero", "segments of length zero"},      Kind{"tiny", "very small segments"},
    Kind{"far", "segments far from the origin"},
};

void make_segments(Cases& cases) {
  each_kind(kSegmentKinds, [&](int kind, int i) {
    const Scale scale = kind == kSegmentTiny ? kTinyScale : kind == kSegmentFar ? kFarScale : kPlain;
    const Vector3 a = whole_point(cases, 10);
    Vector3 edge = whole_point(cases, 8);
    if (edge.isZero()) edge = Vector3(1, 2, 3);
    Vector3 point = whole_point(cases, 14);
    if (kind == kEnds) point = a + edge * (i % 2 == 0 ? 2 : -1) + whole_point(cases, 1);
    cases.add(kind, numbers_of(scale(point), scale(a), scale(kind == kNoLength ? a : Vector3(a + edge))));
  });
}

struct PointAndSegment {
  Vector3 p, a, b;
};
PointAndSegment segment_of(const Numbers& input) {
  Take take(input);
  PointAndSegment all;
  for (Vector3* one : {&all.p, &all.a, &all.b}) *one = take.vector();
  return all;
}

/// The core's closest point. It is computed about a nearby point, with coordinates of size 1.
Numbers closest(const Numbers& input) {
  const auto [p, a, b] = segment_of(input);
  const double size = std::max((b - a).cwiseAbs().maxCoeff(), (p - a).cwiseAbs().maxCoeff());
  if (size == 0) return numbers_of(a);
  const query::Segment<double> segment{Vector3::Zero(), (b - a) / size};
  const double t = query::nearest_place<double>((p - a) / size, segment);
  return numbers_of(t == 1 ? b : Vector3(a + t * (b - a)));
}

bool is_closest(const Numbers& input, const Numbers& answer) {
  const auto [p, a, b] = segment_of(input);
  return are_near(answer, closest(input), (p - a).norm() + (b - a).norm());
}

// ---- two capsules ------------------------------------------------------------------------------------------------

enum CapsuleKind {
  kAnyCapsules,
  kCapsulesTouching,
  kParallel,
  kCapsuleEnds,
  kCapsulePoints,
  kCapsulesTiny,
  kCapsulesFar
};
constexpr std::array kCapsuleKinds{
    Kind{"random", "random capsules"},
    Kind{"touching", "capsules that only touch, or almost"},
    Kind{"parallel", "parallel capsules"},
    Kind{"ends", "capsules that are nearest at an end"},
    Kind{"points", "capsules whose segment is a point"},
    Kind{"tiny", "very small capsules"},
    Kind{"far", "capsules far from the origin"},
};

using Capsules = std::array<Capsule<double, 3>, 2>;

Capsules random_capsules(Cases& cases) {
  Capsules pair;
  for (auto& [a, b, radius] : pair) a = whole_point(cases, 8), b = whole_point(cases, 8), radius = cases.whole(1, 4);
  return pair;
}

/// Two capsules along one direction, beside each other or one after the other. The distance between them never rounds.
Capsules parallel_capsules(Cases& cases, bool overlap, double apart) {
  const int axis = static_cast<int>(cases.random.below(3));
  const Vector3 along = Vector3::Unit(axis), across = Vector3::Unit((axis + 1) % 3);
  const double a_length = 4 * cases.whole(1, 3), b_length = cases.whole(1, 10) * (cases.coin() ? 1 : -1);
  const double radius = cases.whole(1, 3), other = cases.whole(1, 3);
  const double distance = radius + other + (overlap ? -apart : apart);
  Capsules pair;
  pair[0] = {whole_point(cases, 6), Vector3::Zero(), radius};
  pair[0].b = pair[0].a + a_length * along;
  const bool after = cases.coin();  // one after the other
  const Vector3 from = after ? Vector3(pair[0].b + distance * along)
                             : Vector3(pair[0].a + distance * across + along * cases.whole(1, 4));
  pair[1] = {from, from + along * (after ? std::abs(b_length) : b_length), other};
  return pair;
}

Capsules end_capsules(Cases& cases, bool overlap) {
  const WholeVector way = whole_vector(cases);
  const double radius = cases.whole(1, 2), rest = way.length + (overlap ? 1 : -1) - radius;
  Capsules pair;
  pair[0] = {whole_point(cases, 6), Vector3::Zero(), radius};
  pair[0].b = pair[0].a - way.vector * cases.whole(1, 2);
  const Vector3 from = pair[0].a + way.vector;
  // It leads away from the first one, at a right angle or less.
  Vector3 away = whole_point(cases, 6);
  if (away.dot(way.vector) < 0) away = -away;
  pair[1] = {from, from + away, std::max(rest, 0.0)};
  return pair;
}

Capsules capsules_of(const Numbers& input) {
  Take take(input);
  Capsules pair;
  for (auto& [a, b, radius] : pair) a = take.vector(), b = take.vector(), radius = take.number();
  return pair;
}

bool overlap(const Capsules& pair) { return query::overlaps(pair[0], pair[1]); }

/// Whether rounding cannot change the answer.
bool is_clear(Capsules pair) {
  constexpr double kClear = 1e-6;
  const double by = kClear * ((pair[1].a - pair[0].a).norm() + pair[0].radius + pair[1].radius);
  Capsules smaller = pair;
  for (std::size_t i = 0; i < 2; ++i) {
    pair[i].radius += by;
    smaller[i].radius = std::max(smaller[i].radius - by, 0.0);
  }
  return overlap(pair) == overlap(smaller);
}

Capsules capsule_pair(Cases& cases, int kind, bool overlaps) {
  if (kind == kCapsulesTouching) return parallel_capsules(cases, overlaps, overlaps ? 0 : kAlmost);
  if (kind == kParallel) return parallel_capsules(cases, overlaps, 1);
  Capsules pair;
  do {
    pair = kind == kCapsuleEnds ? end_capsules(cases, overlaps) : random_capsules(cases);
    if (kind == kCapsulePoints) pair[0].b = pair[0].a;
    if (kind == kCapsulePoints && cases.coin()) pair[1].b = pair[1].a;
  } while (!is_clear(pair) || overlap(pair) != overlaps);
  return pair;
}

void make_capsules(Cases& cases) {
  each_kind(kCapsuleKinds, [&](int kind, int i) {
    const Scale scale = kind == kCapsulesTiny ? kTinyScale : kind == kCapsulesFar ? kFarScale : kPlain;
    Capsules pair = capsule_pair(cases, kind, i % 2 == 0);
    if (cases.coin()) std::swap(pair[0], pair[1]);
    for (auto& one : pair)
      if (cases.coin()) std::swap(one.a, one.b);
    const auto& [a, b] = pair;
    cases.add(kind, numbers_of(scale(a.a), scale(a.b), a.radius * scale.factor, scale(b.a), scale(b.b),
                               b.radius * scale.factor));
  });
}

Numbers capsules_overlap(const Numbers& input) { return {overlap(capsules_of(input)) ? 1.0 : 0.0}; }

bool are_capsules(const Numbers& input) { return input[6] >= 0 && input[13] >= 0 && is_clear(capsules_of(input)); }

constexpr std::array kFunctions{
    Function{"overlap-spheres", "overlap", "{a:{center:3n,radius:n},b:{center:3n,radius:n}}", "b",
             "volume_pair/spheres", kSphereKinds, make_spheres, spheres_overlap, nullptr, have_radii},
    Function{"grow-sphere", "grow", "{sphere:{center:3n,radius:n},point:3n}", "{center:3n,radius:n}",
             "volume_pair/spheres", kGrowKinds, make_growing, grown, is_grown, has_radius},
    Function{"closest-on-segment", "closest", "{p:3n,a:3n,b:3n}", "3n", "volume_pair/swept_spheres", kSegmentKinds,
             make_segments, closest, is_closest},
    Function{"overlap-capsules", "overlap", "{a:{a:3n,b:3n,radius:n},b:{a:3n,b:3n,radius:n}}", "b",
             "volume_pair/swept_spheres", kCapsuleKinds, make_capsules, capsules_overlap, nullptr, are_capsules},
};

}  // namespace
}  // namespace round

std::span<const Function> round_functions() { return round::kFunctions; }

}  // namespace snug::write
