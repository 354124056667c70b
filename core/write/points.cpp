// The covariance of points, the farthest point from an edge of a hull that grows, and the smallest enclosing sphere.
#include <algorithm>

#include "fit/fit.hpp"
#include "fit/obb/principal_axes.hpp"
#include "fit/sphere/welzl.hpp"
#include "geometry/orientation.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace points {
namespace {

/// Their number comes first.
std::vector<Vector3> take_points(Take& take) {
  std::vector<Vector3> points(static_cast<std::size_t>(take.number()));
  for (Vector3& p : points) p = take.vector();
  return points;
}

Numbers points_input(const std::vector<Vector3>& points, const Scale& scale) {
  Numbers input{static_cast<double>(points.size())};
  for (const Vector3& p : points) put(input, scale(p));
  return input;
}

double spread(const std::vector<Vector3>& points) {
  double most = 0;
  for (const Vector3& p : points) most = std::max(most, (p - points.front()).cwiseAbs().maxCoeff());
  return most;
}

bool has_points(const Numbers& input) { return input[0] >= 1; }

// ---- covariance --------------------------------------------------------------------------------------------------

enum CovarianceKind { kRandom, kSingle, kFlat, kTiny, kFar };
constexpr std::array kCovarianceKinds{
    Kind{"random", "random points"},
    Kind{"single", "one point, or the same point more than once"},
    Kind{"flat", "points in a plane or on a line"},
    Kind{"tiny", "points very near to each other"},
    Kind{"far", "points far from the origin"},
};

void make_covariance(Cases& cases) {
  each_kind(kCovarianceKinds, [&](int kind, int i) {
    const Scale scale = kind == kTiny ? kTinyScale : kind == kFar ? kFarScale : kPlain;
    std::vector<Vector3> points(2 + cases.random.below(6));
    const Vector3 line = whole_point(cases, 4);
    for (Vector3& p : points) {
      p = whole_point(cases, 9);
      if (kind == kFlat) p = i % 2 == 0 ? Vector3(p[0], p[1], 3) : Vector3(p[0] * line);
    }
    const Vector3 first = points.front();
    if (kind == kSingle) points.assign(1 + cases.random.below(3), first);
    cases.add(kind, points_input(points, scale));
  });
}

Numbers covariance(const Numbers& input) {
  Take take(input);
  const auto points = PointSet<double, 3>::make(take_points(take));
  Ignore ignore;
  const auto mean = fit::mean_of(points->span(), ignore);
  const auto found = fit::covariance_of<double, 3>(mean.mean, points->span(), ignore);
  return numbers_of(found.covariance);
}

bool is_covariance(const Numbers& input, const Numbers& answer) {
  constexpr double kNearEnough = 1e-9;  // the mean rounds where the points are far away
  Take take(input);
  const double size = spread(take_points(take));
  const Numbers right = covariance(input);
  for (std::size_t i = 0; i < right.size(); ++i)
    if (!(std::abs(answer[i] - right[i]) <= kNearEnough * size * size)) return false;
  return true;
}

// ---- the farthest point from an edge -----------------------------------------------------------------------------

enum EdgeKind { kAnyEdge, kNone, kLine, kTie, kEdgeTiny, kEdgeFar };
constexpr std::array kEdgeKinds{
    Kind{"random", "random points"},
    Kind{"none", "edges with no point on their left"},
    Kind{"line", "points on the edge's line"},
    Kind{"tie", "points that are equally far, and points behind that are farther"},
    Kind{"tiny", "points very near to each other"},
    Kind{"far", "points far from the origin"},
};

std::vector<Point2> edge_points(Cases& cases, int kind, bool some) {
  const Point2 a = whole_point2(cases, 9);
  const double along = cases.whole(1, 5);
  const Point2 edge(along, cases.whole(-5, 5)), b = a + edge;
  std::vector<Point2> points{a, b};
  const std::size_t count = 4 + cases.random.below(5);
  while (points.size() < count) {
    Point2 p = whole_point2(cases, 12);
    if (kind == kNone && orient2d(a, b, p) > 0) continue;
    if (kind == kLine && cases.coin()) p = a + edge * cases.whole(-2, 3);
    if (kind == kLine && !some && orient2d(a, b, p) > 0) continue;
    points.push_back(p);
    if (kind == kTie) points.push_back(p + edge * cases.whole(1, 2));
  }
  return points;
}

void make_edges(Cases& cases) {
  each_kind(kEdgeKinds, [&](int kind, int i) {
    const Scale scale = kind == kEdgeTiny ? kTinyScale : kind == kEdgeFar ? kFarScale : kPlain;
    std::vector<Point2> points = edge_points(cases, kind, i % 2 == 0);
    std::size_t a = 0, b = 1;
    for (std::size_t* end : {&a, &b}) {  // anywhere in the list
      const std::size_t to = cases.random.below(static_cast<std::uint32_t>(points.size()));
      std::swap(points[*end], points[to]);
      const std::size_t from = *end;
      for (std::size_t* one : {&a, &b})
        if (*one == from) *one = to;
        else if (*one == to) *one = from;
    }
    Numbers input{static_cast<double>(points.size())};
    for (const Point2& p : points) put(input, scale(p));
    input.insert(input.end(), {static_cast<double>(a), static_cast<double>(b)});
    cases.add(kind, std::move(input));
  });
}

struct EdgeInput {
  std::vector<Point2> points;
  std::size_t a, b;
};
EdgeInput edge_of(const Numbers& input) {
  Take take(input);
  EdgeInput own{std::vector<Point2>(static_cast<std::size_t>(take.number())), 0, 0};
  for (Point2& p : own.points) p = take.point();
  own.a = static_cast<std::size_t>(take.number());
  own.b = static_cast<std::size_t>(take.number());
  return own;
}

/// Every comparison is that of exact arithmetic.
Numbers farthest(const Numbers& input) {
  const auto [points, a, b] = edge_of(input);
  double best = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2& than = best < 0 ? points[a] : points[static_cast<std::size_t>(best)];
    if (cross_sign(points[a], points[b], than, points[i]) > 0) best = static_cast<double>(i);
  }
  return {best};
}

/// Any of several points that are equally far is right.
bool is_farthest(const Numbers& input, const Numbers& answer) {
  const double right = farthest(input)[0];
  if (answer[0] == right) return true;
  const auto [points, a, b] = edge_of(input);
  if (right < 0 || !is_index(answer[0], points.size())) return false;
  const auto place = [](double index) { return static_cast<std::size_t>(index); };
  return cross_sign(points[a], points[b], points[place(right)], points[place(answer[0])]) == 0;
}

bool is_edge_input(const Numbers& input) {
  const std::size_t n = static_cast<std::size_t>(input[0]);
  for (const double end : {input[input.size() - 2], input[input.size() - 1]})
    if (!is_index(end, n)) return false;
  const auto [points, a, b] = edge_of(input);
  return points[a] != points[b];
}

// ---- the smallest enclosing sphere -------------------------------------------------------------------------------

enum SphereKind { kAnyPoints, kOne, kFew, kOnSphere, kSphereTiny, kSphereFar };
constexpr std::array kSphereKinds{
    Kind{"random", "random points"},
    Kind{"one", "one point, or the same point more than once"},
    Kind{"few", "points that two or three of them support, also on a line"},
    Kind{"on sphere", "more than four points on the sphere, also with one just outside it"},
    Kind{"tiny", "points very near to each other"},
    Kind{"far", "points far from the origin"},
};

void make_spheres(Cases& cases) {
  each_kind(kSphereKinds, [&](int kind, int i) {
    const Scale scale = kind == kSphereTiny ? kTinyScale : kind == kSphereFar ? kFarScale : kPlain;
    const Vector3 at = whole_point(cases, 9), edge = whole_point(cases, 5);
    std::vector<Vector3> points(kind == kOnSphere ? 8 : 1 + cases.random.below(6));
    for (Vector3& p : points) p = whole_point(cases, 9);
    if (kind == kOne) points.assign(1 + cases.random.below(3), at);
    if (kind == kFew)
      for (Vector3& p : points) p = i % 2 == 0 ? Vector3(at + edge * cases.whole(-3, 3)) : Vector3(p[0], p[1], 0);
    if (kind == kOnSphere) {
      const WholeVector way = whole_vector(cases);
      for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t k = 0; k < 3; ++k) {
          const auto axis = static_cast<Eigen::Index>(k);
          points[corner][axis] = at[axis] + ((corner >> k & 1) != 0 ? 1 : -1) * way.vector[axis];
        }
      constexpr double kJustOutside = 1e-7;  // far more than rounding, and than a contract's billionth
      if (i % 4 == 0) points.emplace_back(at[0] + way.length * (1 + kJustOutside), at[1], at[2]);
    }
    cases.add(kind, points_input(points, scale));
  });
}

Numbers smallest(const Numbers& input) {
  Take take(input);
  const auto points = PointSet<double, 3>::make(take_points(take));
  const auto fitted = fit::welzl(points->span(), fit::Options{.seed = 1});
  return numbers_of(fitted.volume.center, fitted.volume.radius);
}

/// Contains all points and is as small, both nearly.
bool is_smallest(const Numbers& input, const Numbers& answer) {
  constexpr double kNearEnough = 1e-9;  // circumspheres are solved for
  Take take(input), given(answer);
  const std::vector<Vector3> points = take_points(take);
  const Vector3 center = given.vector();
  const double radius = given.number(), size = spread(points);
  const double doubt = kNearEnough * size + kLastDigits * points.front().cwiseAbs().maxCoeff();
  if (!(radius >= 0) || !(radius <= smallest(input)[3] + doubt)) return false;
  return std::all_of(points.begin(), points.end(),
                     [&](const Vector3& p) { return (p - center).norm() <= radius + doubt; });
}

constexpr std::array kFunctions{
    Function{"covariance", "covariance", "{points:*3n}", "33n", "obb/pca", kCovarianceKinds, make_covariance,
             covariance, is_covariance, has_points},
    Function{"farthest-from-edge", "farthest", "{points:*2n,a:i,b:i}", "i", "hull/quickhull", kEdgeKinds, make_edges,
             farthest, is_farthest, is_edge_input},
    Function{"smallest-sphere", "smallest", "{points:*3n}", "{center:3n,radius:n}", "sphere/welzl", kSphereKinds,
             make_spheres, smallest, is_smallest, has_points},
};

}  // namespace
}  // namespace points

std::span<const Function> point_functions() { return points::kFunctions; }

}  // namespace snug::write
