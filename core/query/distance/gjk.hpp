// GJK: the distance of two convex volumes, from the point nearest to the origin of the set of all differences of their
// points. A simplex of such differences moves towards the origin until no vertex is nearer.
// Source: E. Gilbert, D. Johnson, S. Keerthi, "A fast procedure for computing the distance between complex objects in
// three-dimensional space", 1988; C. Ericson, Real-Time Collision Detection, 2005, 9.5.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"
#include "query/distance/gjk_simplex.hpp"
#include "query/distance/support_function.hpp"
#include "trace/fields.hpp"
#include "trace/observer.hpp"

namespace snug::query {

inline constexpr std::array<std::string_view, 9> kGjkPseudocode{
    "simplex ← a vertex of a - a vertex of b",  //
    "repeat",
    "  v ← point of the simplex nearest to 0",
    "  keep the vertices that support v",
    "  if |v| is only rounding error: overlap",
    "  w ← vertex of a - b farthest along -v",
    "  if w · v / |v| = |v|: distance found",
    "  add w to the simplex",
    "if v came no nearer: twice the digits",
};

/// The point of the simplex nearest to the origin: its distance is an upper bound on the cores' distance. corners:
/// pairs of vertices, one of the first and one of the second volume.
struct NearestFound {
  static constexpr std::string_view kName = "nearest_found";
  std::vector<Index> corners;
  double distance = 0;
  SNUG_FIELDS(corners, distance);
};

/// The supporting vertices of both cores: gap is a lower bound on the cores' distance.
struct SupportFound {
  static constexpr std::string_view kName = "support_found";
  Index a = kNoIndex, b = kNoIndex;
  double gap = 0;
  SNUG_FIELDS(a, b, gap);
};

/// Rounding stopped v from coming nearer before both bounds met.
struct DigitsDoubled {
  static constexpr std::string_view kName = "digits_doubled";
  double gap = 0, distance = 0;
  SNUG_FIELDS(gap, distance);
};

/// The last step: what is known of the cores' distance.
struct DistanceFound {
  static constexpr std::string_view kName = "distance_found";
  double gap = 0, distance = 0;
  SNUG_FIELDS(gap, distance);
};

/// One step; distances in scene units, without the radii around the cores.
struct GjkStep {
  using Fact = std::variant<NearestFound, SupportFound, DigitsDoubled, DistanceFound>;
  int line = 0;
  Fact fact;
};

/// The point of a core that is farthest in some direction, and the index of the vertex; kNoIndex if it is not a vertex.
struct Supported {
  Vector<double, 3> at = Vector<double, 3>::Zero();
  Index vertex = kNoIndex;
};

/// The simplex on which a run ended: pairs of vertices, one of each core. The next run between the same two polytopes,
/// a little later, starts from it (temporal coherence). Empty before the first.
struct KeptSimplex {
  std::array<std::array<Index, 2>, 4> vertices{};
  int size = 0;
};

/// A convex core, represented by its support mapping. GJK needs nothing else, so smooth cores work as well as
/// polytopes. The core must outlive it.
struct SupportMapping {
  const void* core = nullptr;
  /// direction: unit.
  Supported (*farthest)(const void* core, const Vector<double, 3>& direction) = nullptr;
  Supported some;                 // any of its points, to start from
  std::int64_t dot_products = 1;  // how many a call takes
  /// The vertex with an index; null for a smooth core.
  Supported (*vertex)(const void* core, Index index) = nullptr;
};

/// That of the convex hull of corners, of which there is at least one.
[[nodiscard]] SupportMapping support_mapping(const Corners<3>& corners);

/// One run between two convex cores that are known by their support mappings alone. No coordinate is above 1, and
/// planar cores lie at z = 0. v is the point of the simplex nearest to the origin. Each turn proves two bounds: |v| is
/// an upper one, because v is a point of a - b, and the plane across v through the supporting points gives a lower one.
/// v comes strictly nearer: between polytopes, which have finitely many simplices, the run therefore ends; with smooth
/// cores it ends when the bounds meet. If rounding keeps v from coming nearer before that, the run goes on with twice
/// the digits.
template <class Observer>
class Gjk {
 public:
  using Point = Vector<double, 3>;

  /// scene: the factor that converts lengths to scene units.
  Gjk(const SupportMapping& a, const SupportMapping& b, double scene, Observer& observe)
      : a_(a), b_(b), scene_(scene), observe_(observe) {}

  double least = -1;  // a lower bound on the cores' distance
  double most = 0;    // an upper bound on it: the distance of the nearest points so far
  Point on_a = Point::Zero(), on_b = Point::Zero();
  Point direction = Point::Zero();  // unit, from a to b: the direction that proves `least`
  int turns = 0;                    // simplices tried

  /// Runs until the bounds meet or, if a threshold is given, until both are on the same side of it.
  void run(std::optional<double> threshold, KeptSimplex* kept = nullptr) {
    threshold_ = threshold;
    if (kept == nullptr || !resumed(*kept)) start_anew();
    if (kept != nullptr) keep_for_next(*kept);
    if constexpr (kWatched<Observer>)
      observe_(GjkStep{most > kRounding ? 6 : 4, DistanceFound{least * scene_, most * scene_}});
  }

 private:
  /// Whether the kept simplex, where its vertices are now, leads to an answer. It may have become a sliver.
  bool resumed(const KeptSimplex& kept) {
    if (kept.size == 0 || a_.vertex == nullptr || b_.vertex == nullptr) return false;
    size_ = kept.size;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i)
      pairs_[i] = {a_.vertex(a_.core, kept.vertices[i][0]), b_.vertex(b_.core, kept.vertices[i][1])};
    descend<double>();
    return decided();
  }

  void start_anew() {
    least = -1;
    pairs_ = {Pair{a_.some, b_.some}};
    size_ = 1;
    descend<double>();
    if (!decided()) {
      if constexpr (kWatched<Observer>) observe_(GjkStep{8, DigitsDoubled{least * scene_, most * scene_}});
      descend<DoubleDouble>();
    }
  }

  void keep_for_next(KeptSimplex& kept) const {
    kept.size = size_;
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i)
      kept.vertices[i] = {pairs_[i].a.vertex, pairs_[i].b.vertex};
  }

  struct Pair {
    Supported a, b;
    friend bool operator==(const Pair& p, const Pair& q) { return p.a.at == q.a.at && p.b.at == q.b.at; }
  };
  static constexpr double kRounding = tolerance::kTouching<double>;
  static constexpr int kMostTurns = 1000;

  [[nodiscard]] bool decided() const {
    if (most <= kRounding / 4 || most - least <= kRounding) return true;
    return threshold_ && (least > *threshold_ || most <= *threshold_);
  }

  template <class Real>
  [[nodiscard]] Tuple<Real, 3> corner(const Pair& pair) const {
    return tuple_of<Real, 3>(pair.a.at) - tuple_of<Real, 3>(pair.b.at);
  }

  template <class Real>
  void descend() {
    Simplex<Real> simplex;
    for (; simplex.size < size_; ++simplex.size) simplex.corners[simplex.size] = corner<Real>(pairs_[simplex.size]);
    std::optional<Real> before;
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const Nearest<Real> nearest = simplex.nearest_to_origin();
      if (before && !(nearest.square < *before)) return;
      before = nearest.square;
      keep(simplex, nearest);
      // Four vertices contain the origin: v is 0 except for rounding, which can exceed the tolerance if they form a
      // sliver. There is no room for a fifth. Tested by "k-DOPs about to touch are told apart".
      if (decided() || size_ == 4) return;
      const Pair added = support();
      if (decided() || std::find(pairs_.begin(), pairs_.begin() + size_, added) != pairs_.begin() + size_) return;
      const std::size_t end = size_;
      pairs_[end] = added;
      simplex.corners[end] = corner<Real>(added);
      simplex.size = ++size_;
    }
  }

  static double rounded(double value) { return value; }
  static double rounded(const DoubleDouble& value) { return value.value(); }

  /// Keeps the corners that support the nearest point, and what follows from them.
  template <class Real>
  void keep(Simplex<Real>& simplex, const Nearest<Real>& nearest) {
    const auto pairs = pairs_;
    const auto corners = simplex.corners;
    simplex.size = size_ = nearest.size;
    on_a = on_b = Point::Zero();
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i) {
      const std::size_t place = nearest.corners[i];
      pairs_[i] = pairs[place];
      simplex.corners[i] = corners[place];
      on_a += rounded(nearest.weights[i]) * pairs_[i].a.at;
      on_b += rounded(nearest.weights[i]) * pairs_[i].b.at;
    }
    v_ = {rounded(nearest.point[0]), rounded(nearest.point[1]), rounded(nearest.point[2])};
    most = v_.norm();
    ++turns;
    if constexpr (kWatched<Observer>) observe_(GjkStep{3, nearest_found()});
  }

  /// Finds the vertex of a - b farthest along -v, and the bound that it proves.
  Pair support() {
    const Point n = v_ / most;
    const Pair pair{a_.farthest(a_.core, -n), b_.farthest(b_.core, n)};
    const double gap = std::min(pair.a.at.dot(n) - pair.b.at.dot(n), most);  // larger only by rounding
    if (gap > least) {
      least = gap;
      direction = -n;
    }
    observe_.count(Operation::kDotProducts, a_.dot_products + b_.dot_products);
    if constexpr (kWatched<Observer>) observe_(GjkStep{5, SupportFound{pair.a.vertex, pair.b.vertex, gap * scene_}});
    return pair;
  }

  [[nodiscard]] NearestFound nearest_found() const {
    NearestFound fact{{}, most * scene_};
    for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i)
      fact.corners.insert(fact.corners.end(), {pairs_[i].a.vertex, pairs_[i].b.vertex});
    return fact;
  }

  SupportMapping a_, b_;
  double scene_;
  Observer& observe_;
  std::optional<double> threshold_;
  std::array<Pair, 4> pairs_{};
  int size_ = 0;
  Point v_ = Point::Zero();
};

extern template class Gjk<Ignore>;

/// How far apart two volumes are. Both bounds agree within a few roundings of the volumes' extents about a common
/// point, wherever that is and whatever their size; within some thousands of roundings, if facets are slivers thinner
/// than 1e-8 of that extent.
template <class Scalar, int Dim>
struct Separation {
  bool overlap = false;                                         // whether they are at most kTouching apart
  Scalar distance = 0;                                          // 0 if they overlap, scene units
  Scalar gap = 0;                                               // a lower bound on the distance, proven by direction
  Vector<Scalar, Dim> direction = Vector<Scalar, Dim>::Zero();  // unit, from a to b; zero if they overlap
  Vector<Scalar, Dim> on_a = Vector<Scalar, Dim>::Zero();       // the nearest points, if apart
  Vector<Scalar, Dim> on_b = Vector<Scalar, Dim>::Zero();
  int turns = 0;  // simplices tried
};

/// A volume as GJK sees it, in space and relative to some origin: a convex core grown by a radius. The core is the hull
/// of corners; a smooth one has none, but a support mapping, which refers to the volume.
struct GrownCore {
  Corners<3> corners;
  double radius = 0;
  std::function<Vector<double, 3>(const Vector<double, 3>& direction)> farthest = nullptr;
  double reach = 0;  // of a smooth core: its largest coordinate

  [[nodiscard]] bool is_empty() const { return corners.empty() && farthest == nullptr; }
};

/// The volume has to outlive it.
template <template <class, int> class Kind, class Scalar, int Dim>
[[nodiscard]] GrownCore grown_core(const Kind<Scalar, Dim>& volume, const Vector<Scalar, Dim>& origin) {
  GrownCore core{.radius = static_cast<double>(radius_of(volume))};
  if constexpr (HasCorners<Kind<Scalar, Dim>>) {
    const Corners<Dim> corners = core_corners(volume, origin);
    core.corners.assign(corners.size(), Vector<double, 3>::Zero());
    for (std::size_t i = 0; i < corners.size(); ++i) core.corners[i].template head<Dim>() = corners[i];
  } else {
    core.farthest = [&volume, origin](const Vector<double, 3>& direction) {
      Vector<double, 3> point = Vector<double, 3>::Zero();
      point.template head<Dim>() = core_support(volume, origin, Vector<double, Dim>(direction.template head<Dim>()));
      return point;
    };
    for (int i = 0; i < Dim; ++i)
      for (const double sign : {-1.0, 1.0})
        core.reach = std::max(core.reach, std::abs(core.farthest(sign * Vector<double, 3>::Unit(i))[i]));
  }
  return core;
}

/// Divides both cores by a power of two, so that coordinates and radii are at most 1. Returns that power.
double scale_to_unit(GrownCore& a, GrownCore& b);

/// The core has to outlive it.
[[nodiscard]] SupportMapping support_mapping(const GrownCore& core);

/// The distance between two cores around an origin, in scene units. None if one is empty.
template <class Scalar, int Dim, class Observer>
std::optional<Separation<Scalar, Dim>> separation_of(GrownCore a, GrownCore b, const Vector<Scalar, Dim>& origin,
                                                     bool only_whether, Observer& observe,
                                                     KeptSimplex* kept = nullptr) {
  if (a.is_empty() || b.is_empty()) return std::nullopt;
  const double unit = scale_to_unit(a, b);
  const double radii = a.radius + b.radius;
  const double touching = radii + static_cast<double>(tolerance::kTouching<Scalar>);
  Gjk<Observer> run(support_mapping(a), support_mapping(b), unit, observe);
  run.run(only_whether ? std::optional(touching) : std::nullopt, kept);

  Separation<Scalar, Dim> result{.overlap = run.least <= touching, .turns = run.turns};
  if (result.overlap) return result;
  const auto in_scene = [&](const Vector<double, 3>& p) {
    const Vector<double, Dim> moved = origin.template cast<double>() + p.template head<Dim>() * unit;
    return Vector<Scalar, Dim>(moved.template cast<Scalar>());
  };
  result.distance = static_cast<Scalar>((run.most - radii) * unit);
  result.gap = std::min(result.distance, static_cast<Scalar>((run.least - radii) * unit));  // larger only by rounding
  result.direction = run.direction.template head<Dim>().template cast<Scalar>();
  result.on_a = in_scene(run.on_a + a.radius * run.direction);
  result.on_b = in_scene(run.on_b - b.radius * run.direction);
  return result;
}

// Compiled once, in gjk.cpp.
#define SNUG_GJK(EXTERN, Scalar, Dim)                                                                                  \
  EXTERN template std::optional<Separation<Scalar, Dim>> separation_of(                                                \
      GrownCore, GrownCore, const Vector<Scalar, Dim>&, bool, Ignore&, KeptSimplex*);
SNUG_GJK(extern, float, 2)
SNUG_GJK(extern, float, 3)
SNUG_GJK(extern, double, 2)
SNUG_GJK(extern, double, 3)

/// The distance between two volumes. None if one is empty. only_whether: only the overlap is wanted, not the
/// distance. kept: of the run before between the same two, if they have moved little since then.
template <template <class, int> class A, template <class, int> class B, class Scalar, int Dim,
          StepObserver<GjkStep> Observer = Ignore>
[[nodiscard]] std::optional<Separation<Scalar, Dim>> gjk(const A<Scalar, Dim>& a, const B<Scalar, Dim>& b,
                                                         bool only_whether = false, Observer&& observe = {},
                                                         KeptSimplex* kept = nullptr) {
  const Vector<Scalar, Dim> origin = anchor(a) / 2 + anchor(b) / 2;  // the same for either order
  return separation_of<Scalar, Dim>(grown_core(a, origin), grown_core(b, origin), origin, only_whether, observe, kept);
}

template <class Scalar, int Dim>
[[nodiscard]] Vector<Scalar, Dim> anchor_of(const Volume<Scalar, Dim>& volume) {
  return std::visit([](const auto& own) { return anchor(own); }, volume);
}

/// The cores of two volumes around an origin that is the same for either order.
template <class Scalar, int Dim>
struct Cores {
  GrownCore a, b;
  Vector<Scalar, Dim> origin;
};

template <class Scalar, int Dim>
[[nodiscard]] Cores<Scalar, Dim> cores_of(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

/// The test of any two volumes.
template <class Scalar, int Dim>
[[nodiscard]] std::optional<Separation<Scalar, Dim>> gjk(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b);

}  // namespace snug::query
