#include "core/query/lattice_pairs.hpp"

#include <optional>
#include <vector>

#include "query/overlap/overlaps_any.hpp"

namespace snug::test {
namespace {

constexpr int kPairs = 20;

using Whole = std::int64_t;
template <int Dim>
using WholePoint = std::array<Whole, Dim>;

/// The points p with min <= normal . p <= max.
template <int Dim>
struct WholeSlab {
  WholePoint<Dim> normal;
  Whole min, max;
};

/// A sphere, or what lies in all of its slabs.
template <int Dim>
struct LatticeVolume {
  WholePoint<Dim> center{};
  Whole radius = 0;
  std::vector<WholeSlab<Dim>> slabs;
};

struct LatticeAnswer {
  bool overlap, hard;
};

template <int Dim>
Whole whole_dot(const WholePoint<Dim>& normal, const WholePoint<Dim>& p) {
  Whole sum = 0;
  for (std::size_t i = 0; i < Dim; ++i) sum += normal[i] * p[i];
  return sum;
}

/// A point in whole numbers over a positive one.
template <int Dim>
struct Quotient {
  WholePoint<Dim> above;
  Whole below;
};

/// The point where lines or planes meet, by Cramer's rule; none where they are parallel.
std::optional<Quotient<2>> meet_of(const std::array<const WholeSlab<2>*, 2>& at, const std::array<Whole, 2>& bounds) {
  const auto& [a, b] = std::pair(at[0]->normal, at[1]->normal);
  const Whole det = a[0] * b[1] - a[1] * b[0];
  if (det == 0) return std::nullopt;
  const Whole sign = det < 0 ? -1 : 1;
  return Quotient<2>{{sign * (bounds[0] * b[1] - bounds[1] * a[1]), sign * (bounds[1] * a[0] - bounds[0] * b[0])},
                     sign * det};
}
WholePoint<3> across(const WholePoint<3>& u, const WholePoint<3>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
std::optional<Quotient<3>> meet_of(const std::array<const WholeSlab<3>*, 3>& at, const std::array<Whole, 3>& bounds) {
  const WholePoint<3>&a = at[0]->normal, &b = at[1]->normal, &c = at[2]->normal;
  const std::array<WholePoint<3>, 3> crosses{across(b, c), across(c, a), across(a, b)};
  const Whole det = whole_dot<3>(a, crosses[0]);
  if (det == 0) return std::nullopt;
  const Whole sign = det < 0 ? -1 : 1;
  Quotient<3> point{{0, 0, 0}, sign * det};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) point.above[i] += sign * bounds[k] * crosses[k][i];
  return point;
}

template <int Dim>
bool lies_in_all(const Quotient<Dim>& point, const std::vector<WholeSlab<Dim>>& slabs) {
  for (const auto& slab : slabs) {
    const Whole at = whole_dot<Dim>(slab.normal, point.above);
    if (at < slab.min * point.below || at > slab.max * point.below) return false;
  }
  return true;
}

/// Whether bounded slabs have a point in common: then they have a vertex, where as many of their bounds meet as there
/// are coordinates.
template <int Dim>
bool have_common_point(const std::vector<WholeSlab<Dim>>& slabs) {
  std::array<const WholeSlab<Dim>*, Dim> chosen{};
  std::array<Whole, Dim> bounds{};
  const auto choose = [&](const auto& self, std::size_t first, std::size_t count) -> bool {
    if (count == Dim) {
      const auto point = meet_of(chosen, bounds);
      return point && lies_in_all<Dim>(*point, slabs);
    }
    for (std::size_t i = first; i < slabs.size(); ++i)
      for (const Whole bound : {slabs[i].min, slabs[i].max}) {
        chosen[count] = &slabs[i], bounds[count] = bound;
        if (self(self, i + 1, count + 1)) return true;
        if (slabs[i].min == slabs[i].max) break;
      }
    return false;
  };
  return choose(choose, 0, 0);
}

template <int Dim>
LatticeAnswer slabs_overlap(std::vector<WholeSlab<Dim>> slabs, const std::vector<WholeSlab<Dim>>& others) {
  for (const auto& other : others) {
    const auto same =
        std::find_if(slabs.begin(), slabs.end(), [&](const auto& slab) { return slab.normal == other.normal; });
    if (same == slabs.end()) slabs.push_back(other);
    else same->min = std::max(same->min, other.min), same->max = std::min(same->max, other.max);
  }
  bool touching = false;
  for (const auto& slab : slabs) {
    if (slab.min > slab.max) return {false, false};
    touching = touching || slab.min == slab.max;
  }
  const bool overlap = have_common_point<Dim>(slabs);
  return {overlap, touching || !overlap};
}

template <int Dim>
LatticeAnswer lattice_overlap(const LatticeVolume<Dim>& a, const LatticeVolume<Dim>& b) {
  if (!a.slabs.empty() && !b.slabs.empty()) return slabs_overlap<Dim>(a.slabs, b.slabs);
  const bool a_is_sphere = a.slabs.empty();
  const LatticeVolume<Dim>&sphere = a_is_sphere ? a : b, &other = a_is_sphere ? b : a;
  const Whole reach = sphere.radius + other.radius;
  Whole square = 0;
  for (std::size_t i = 0; i < Dim; ++i) {  // the slabs of a box are along the axes, in their order
    const Whole at = sphere.center[i], nearest = other.slabs.empty()
                                                     ? other.center[i]
                                                     : std::clamp(at, other.slabs[i].min, other.slabs[i].max);
    square += (at - nearest) * (at - nearest);
  }
  return {square <= reach * reach, square == reach * reach};
}

/// A volume and the same in whole numbers.
template <class Scalar, int Dim>
struct LatticePair {
  Volume<Scalar, Dim> volume;
  LatticeVolume<Dim> whole;
};

enum class LatticeKind { kSphere, kAabb, kKdop };

template <class Scalar, int Dim>
class LatticeMaker {
 public:
  LatticeMaker(Random& random, Whole offset) : random_(random), offset_(offset) {}

  LatticePair<Scalar, Dim> make(LatticeKind kind, Whole spread) {
    WholePoint<Dim> middle;
    for (Whole& x : middle) x = offset_ + any(spread);
    switch (kind) {
      case LatticeKind::kSphere: return sphere(middle);
      case LatticeKind::kAabb: return aabb(middle);
      default: return kdop(middle);
    }
  }

 private:
  Whole any(Whole most) { return static_cast<Whole>(random_.below(static_cast<std::uint32_t>(2 * most + 1))) - most; }

  LatticePair<Scalar, Dim> sphere(const WholePoint<Dim>& center) {
    const Whole radius = random_.below(4);
    Sphere<Scalar, Dim> sphere;
    for (int i = 0; i < Dim; ++i) sphere.center[i] = static_cast<Scalar>(center[i]);
    sphere.radius = static_cast<Scalar>(radius);
    return {sphere, {center, radius, {}}};
  }

  /// Around some points within 3 of the middle; normals: those of its slabs.
  LatticeVolume<Dim> slabs_around(const WholePoint<Dim>& middle, const std::vector<WholePoint<Dim>>& normals) {
    LatticeVolume<Dim> volume;
    for (std::uint32_t points = 1 + random_.below(4), n = 0; n < points; ++n) {
      WholePoint<Dim> p = middle;
      for (Whole& x : p) x += any(3);
      for (std::size_t i = 0; i < normals.size(); ++i) {
        const Whole at = whole_dot<Dim>(normals[i], p);
        if (n == 0) volume.slabs.push_back({normals[i], at, at});
        volume.slabs[i].min = std::min(volume.slabs[i].min, at),
        volume.slabs[i].max = std::max(volume.slabs[i].max, at);
      }
    }
    return volume;
  }

  LatticePair<Scalar, Dim> aabb(const WholePoint<Dim>& middle) {
    std::vector<WholePoint<Dim>> normals(Dim, WholePoint<Dim>{});
    for (std::size_t i = 0; i < Dim; ++i) normals[i][i] = 1;
    const LatticeVolume<Dim> whole = slabs_around(middle, normals);
    Aabb<Scalar, Dim> box;
    for (int i = 0; i < Dim; ++i) {
      const auto& slab = whole.slabs[i];
      box.min[i] = static_cast<Scalar>(slab.min), box.max[i] = static_cast<Scalar>(slab.max);
    }
    return {box, whole};
  }

  LatticePair<Scalar, Dim> kdop(const WholePoint<Dim>& middle) {
    constexpr std::array<int, 3> kOfPlane{4, 6, 8}, kOfSpace{14, 18, 26};
    const int k = (Dim == 2 ? kOfPlane : kOfSpace)[random_.below(3)];
    std::vector<WholePoint<Dim>> normals;
    for (const auto& axis : kdop_axes<Dim>(k)) {
      auto& normal = normals.emplace_back();
      for (std::size_t i = 0; i < Dim; ++i) normal[i] = static_cast<Whole>(axis[i]);
    }
    const LatticeVolume<Dim> whole = slabs_around(middle, normals);
    Kdop<Scalar, Dim> kdop{.k = k};
    for (std::size_t i = 0; i < whole.slabs.size(); ++i)
      kdop.min[i] = static_cast<Scalar>(whole.slabs[i].min), kdop.max[i] = static_cast<Scalar>(whole.slabs[i].max);
    return {kdop, whole};
  }

  Random& random_;
  Whole offset_;
};

}  // namespace

template <class Scalar, int Dim>
void add_lattice_pairs(QueryTally& tally, Random& random) {
  LatticeMaker<Scalar, Dim> maker(random, random.below(2) == 0 ? 0 : 100'000);
  for (int pair = 0; pair < kPairs; ++pair) {
    const auto first = static_cast<LatticeKind>(random.below(3));
    auto second = static_cast<LatticeKind>(random.below(3));
    if (first == LatticeKind::kSphere && second == LatticeKind::kKdop) second = LatticeKind::kAabb;
    if (first == LatticeKind::kKdop && second == LatticeKind::kSphere) second = LatticeKind::kKdop;
    const auto a = maker.make(first, 0), b = maker.make(second, 6);
    const auto [overlap, hard] = lattice_overlap<Dim>(a.whole, b.whole);
    const bool own = query::test_overlap<Scalar, Dim>(a.volume, b.volume).overlap;
    bool right = query::test_overlap<Scalar, Dim>(b.volume, a.volume).overlap == own &&
                 query::overlaps<Scalar, Dim>(a.volume, b.volume) == own &&
                 query::overlaps<Scalar, Dim>(b.volume, a.volume) == own;
    if (query::is_conservative(a.volume.index(), b.volume.index())) {
      Ignore ignore;
      right = right && (own || !overlap) && query::test_slabs_then_gjk(a.volume, b.volume, ignore).overlap == overlap &&
              query::test_slabs_then_gjk(b.volume, a.volume, ignore).overlap == overlap;
    } else {
      right = right && own == overlap;
    }
    tally.count(overlap ? 1 : 0, right, hard);
  }
}

template void add_lattice_pairs<float, 2>(QueryTally&, Random&);
template void add_lattice_pairs<float, 3>(QueryTally&, Random&);
template void add_lattice_pairs<double, 2>(QueryTally&, Random&);
template void add_lattice_pairs<double, 3>(QueryTally&, Random&);

}  // namespace snug::test
