#include "measure/signed_distance.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "fit/hull/quickhull.hpp"
#include "fit/obb/obb_frame.hpp"
#include "geometry/point_set.hpp"
#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"
#include "query/distance/gjk.hpp"

namespace snug::proximity {
namespace {

constexpr double kCoresTouch = 4 * tolerance::kTouching<double>;
constexpr int kMostTurns = 1000;

/// A move of b that parts the cores, and the points that it brings together.
template <int Dim>
struct Parting {
  double depth = std::numeric_limits<double>::infinity();
  double surely = 0;  // a lower bound on the depth
  Vector<double, Dim> direction = Vector<double, Dim>::Unit(0);
  Vector<double, Dim> on_a = Vector<double, Dim>::Zero(), on_b = Vector<double, Dim>::Zero();
};

/// The polytope that grows within the difference of two cores, all points a - b, of coordinates up to 2.
template <int Dim>
class ExpandingPolytope {
 public:
  using Point = Vector<double, Dim>;

  ExpandingPolytope(const query::SupportMapping& a, const query::SupportMapping& b) : a_(a), b_(b) {
    for (int i = 0; i < Dim; ++i)
      for (const double side : {1.0, -1.0}) add(farthest(side * Point::Unit(i)));
    make_hull();
    while (hull_.affine_dim < Dim)
      if (!thickened()) break;
  }

  /// A flat difference has no depth: the cores part across it. Their points in common are then not known here.
  [[nodiscard]] bool is_flat() const { return hull_.affine_dim < Dim; }
  [[nodiscard]] Point across() const { return flat_normals().front(); }

  Parting<Dim> least_parting() {
    Parting<Dim> best;
    std::set<Facet> settled;  // facets that no point of the difference lies beyond
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const auto [facet, normal, height] = nearest_facet(settled);
      if (!(height < best.depth - tolerance::kTouching<double>)) break;
      const Point beyond = farthest(normal);
      const double depth = beyond.dot(normal);
      if (depth < best.depth) {
        best.depth = depth;
        best.direction = normal;
      }
      if (depth > height + tolerance::kTouching<double> && add(beyond)) make_hull();
      else settled.insert(facet);
    }
    best.surely = nearest_facet({}).height;
    return best;
  }

 private:
  using Facet = std::array<Index, Dim>;  // sorted indices of points

  /// The point of the difference farthest along a direction.
  [[nodiscard]] Point farthest(const Point& direction) const {
    Vector<double, 3> towards = Vector<double, 3>::Zero();
    towards.template head<Dim>() = direction;
    return (a_.farthest(a_.core, towards).at - b_.farthest(b_.core, -towards).at).template head<Dim>();
  }

  /// Returns false if it is there already.
  bool add(const Point& point) {
    if (std::find(points_.begin(), points_.end(), point) != points_.end()) return false;
    points_.push_back(point);
    return true;
  }

  void make_hull() { hull_ = fit::quickhull(PointSet<double, Dim>::make(points_)->span()).volume; }

  /// Adds what lies off the flat hull. Returns whether there was anything.
  bool thickened() {
    const int before = hull_.affine_dim;
    bool added = false;
    for (const Point& normal : flat_normals())
      for (const double side : {1.0, -1.0}) added = add(farthest(side * normal)) || added;
    if (added) make_hull();
    return hull_.affine_dim > before;
  }

  /// Directions across a flat hull: one for each dimension that it lacks.
  [[nodiscard]] std::vector<Point> flat_normals() const {
    std::vector<Point> normals;
    const auto at = [&](std::size_t i) { return hull_.vertices[i]; };
    if (hull_.affine_dim == 0) {
      for (int i = 0; i < Dim; ++i) normals.push_back(Point::Unit(i));
    } else if constexpr (Dim == 2) {
      normals.push_back(fit::frame(Point(at(1) - at(0))).col(1));
    } else if (hull_.affine_dim == 1) {
      const Matrix<double, 3> axes = fit::frame(Point(at(1) - at(0)), Point::Zero());
      normals = {axes.col(1), axes.col(2)};
    } else {
      const std::size_t last = hull_.vertices.size() - 1;
      normals.push_back(normal_of({at(0), at(last / 2), at(last)}));
    }
    return normals;
  }

  /// Unit, or zero of a facet without area. The edges of a sliver are all but parallel: it takes twice the digits.
  [[nodiscard]] static Point normal_of(const std::array<Point, Dim>& corners) {
    if constexpr (Dim == 2) {
      const Point along = corners[1] - corners[0];
      return Point(along[1], -along[0]).stableNormalized();
    } else {
      const auto wide = [](const Point& p) { return tuple_of<DoubleDouble, 3>(p); };
      const auto first = wide(corners[0]);
      const auto normal = cross(wide(corners[1]) - first, wide(corners[2]) - first);
      return Point(normal[0].value(), normal[1].value(), normal[2].value()).stableNormalized();
    }
  }

  [[nodiscard]] std::array<Point, Dim> corners_of(const std::array<Index, Dim>& facet) const {
    std::array<Point, Dim> corners;
    for (std::size_t i = 0; i < Dim; ++i) corners[i] = hull_.vertices[facet[i]];
    return corners;
  }

  struct Near {
    Facet facet{};
    Point normal = Point::Zero();
    double height = std::numeric_limits<double>::infinity();  // the origin's distance from its plane
  };

  [[nodiscard]] Near nearest_facet(const std::set<Facet>& settled) const {
    Near near;
    for (const auto& facet : hull_.facets) {
      const Point normal = normal_of(corners_of(facet));
      const double height = normal.dot(hull_.vertices[facet[0]]);
      if (!(height < near.height) || normal.isZero(0)) continue;
      Facet sorted;
      for (std::size_t i = 0; i < Dim; ++i) sorted[i] = hull_.indices[facet[i]];
      std::sort(sorted.begin(), sorted.end());
      if (settled.count(sorted) == 0) near = {sorted, normal, height};
    }
    return near;
  }

  query::SupportMapping a_, b_;
  std::vector<Point> points_;
  ConvexHull<double, Dim> hull_;
};

query::GrownCore moved(query::GrownCore core, const Vector<double, 3>& by) {
  for (auto& corner : core.corners) corner += by;
  if (core.farthest)
    core.farthest = [whole = std::move(core.farthest), by](const Vector<double, 3>& direction) {
      return Vector<double, 3>(whole(direction) + by);
    };
  return core;
}

/// Finds the points that the move brings together: where a and the moved b touch.
template <int Dim>
void find_ends(Parting<Dim>& parting, const query::GrownCore& a, const query::GrownCore& b) {
  Vector<double, 3> move = Vector<double, 3>::Zero();
  move.template head<Dim>() = parting.depth * parting.direction;
  const query::GrownCore there = moved(b, move);
  Ignore ignore;
  query::Gjk<Ignore> gjk(query::support_mapping(a), query::support_mapping(there), 1, ignore);
  gjk.run(std::nullopt);
  parting.on_a = gjk.on_a.template head<Dim>();
  parting.on_b = (gjk.on_b - move).template head<Dim>();
}

/// The least move that parts two cores. No coordinate of theirs is above 1.
template <int Dim>
Parting<Dim> parting_of(const query::GrownCore& a, const query::GrownCore& b) {
  const query::SupportMapping of_a = query::support_mapping(a), of_b = query::support_mapping(b);
  Ignore ignore;
  query::Gjk<Ignore> gjk(of_a, of_b, 1, ignore);
  gjk.run(std::nullopt);
  const Vector<double, Dim> on_a = gjk.on_a.template head<Dim>(), on_b = gjk.on_b.template head<Dim>();
  if (gjk.most > kCoresTouch) return {-gjk.least, -gjk.most, gjk.direction.template head<Dim>(), on_a, on_b};
  ExpandingPolytope<Dim> polytope(of_a, of_b);
  if (polytope.is_flat()) return {0, 0, polytope.across(), on_a, on_b};
  Parting<Dim> parting = polytope.least_parting();
  find_ends(parting, a, b);
  return parting;
}

}  // namespace

template <int Dim>
DistanceBounds bounds_between(const query::GrownCore& a, const query::GrownCore& b) {
  const Parting<Dim> parting = parting_of<Dim>(a, b);
  return {-parting.depth, -parting.surely};
}
template DistanceBounds bounds_between<2>(const query::GrownCore&, const query::GrownCore&);
template DistanceBounds bounds_between<3>(const query::GrownCore&, const query::GrownCore&);

template <class Scalar, int Dim>
std::optional<SignedDistance<Dim>> signed_distance(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  auto [first, second, middle] = query::cores_of(a, b);
  if (first.is_empty() || second.is_empty()) return std::nullopt;
  const double unit = query::scale_to_unit(first, second);
  const Parting<Dim> parting = parting_of<Dim>(first, second);
  const auto in_scene = [&, origin = middle](const Vector<double, Dim>& p) {
    return Vector<double, Dim>(origin.template cast<double>() + p * unit);
  };
  // The distance of the points is known better where the cores are apart, the depth of the plane elsewhere.
  const double depth = parting.surely < 0 ? parting.surely : parting.depth;
  return SignedDistance<Dim>{-(depth + first.radius + second.radius) * unit, parting.direction,
                             in_scene(parting.on_a + first.radius * parting.direction),
                             in_scene(parting.on_b - second.radius * parting.direction)};
}

template std::optional<SignedDistance<2>> signed_distance(const Volume<float, 2>&, const Volume<float, 2>&);
template std::optional<SignedDistance<3>> signed_distance(const Volume<float, 3>&, const Volume<float, 3>&);
template std::optional<SignedDistance<2>> signed_distance(const Volume<double, 2>&, const Volume<double, 2>&);
template std::optional<SignedDistance<3>> signed_distance(const Volume<double, 3>&, const Volume<double, 3>&);

}  // namespace snug::proximity
