// Quickhull's vertices are the extreme points, all of them and no others: against the definition in rational arithmetic
// where points are few, by proof where they are many, and against sets whose hull is known.
#include "fit/hull/quickhull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/exact_hull.hpp"
#include "core/point_clouds.hpp"
#include "fit/hull/certify_hull.hpp"

using namespace snug;

namespace {

template <class Scalar, int Dim>
using HullFit = fit::Fit<ConvexHull<Scalar, Dim>>;

template <class Scalar, int Dim>
HullFit<Scalar, Dim> hull_of(const test::Cloud<Scalar, Dim>& cloud) {
  return fit::quickhull(test::set_of<Scalar, Dim>(cloud).span());
}

std::vector<Index> sorted(std::vector<Index> indices) {
  std::sort(indices.begin(), indices.end());
  return indices;
}

template <class Scalar, int Dim>
void check_proof(const std::string& name, const test::Cloud<Scalar, Dim>& cloud) {
  INFO(name << ", " << cloud.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(cloud);
  const auto fit = fit::quickhull(set.span());
  const fit::HullProof proof = fit::prove_hull(fit.volume, set.span());
  CHECK(proof.of_points);
  CHECK(proof.convex);
  CHECK(proof.extreme);
  CHECK(proof.outside == 0);
  CHECK(fit.support == fit.volume.indices);
  if (Dim == 3 && fit.volume.affine_dim == 3) CHECK(fit.volume.facets.size() == 2 * fit.volume.vertices.size() - 4);
}

template <class Scalar, int Dim>
test::Cloud<Scalar, Dim> moved(test::Cloud<Scalar, Dim> cloud, Scalar scale, Scalar offset) {
  for (auto& p : cloud) p = p * scale + Vector<Scalar, Dim>::Constant(offset);
  return cloud;
}

test::Cloud<double, 3> lattice(int side) {
  test::Cloud<double, 3> cloud;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) cloud.push_back({double(x), double(y), double(z)});
  return cloud;
}

}  // namespace

// -- Sets whose hull is known -----------------------------------------------------------------------------------------

TEST_CASE("one point, two, the same again: hulls of no dimension and of one") {
  CHECK(hull_of<double, 3>({{1, 2, 3}}).volume.affine_dim == 0);
  CHECK(hull_of<double, 3>({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).support == std::vector<Index>{0});
  CHECK(hull_of<double, 2>({{1, 2}, {1, 2}}).support == std::vector<Index>{0});
  const auto segment = hull_of<double, 3>({{1, 1, 1}, {2, 2, 2}, {0, 0, 0}, {0, 0, 0}, {2, 2, 2}});
  CHECK(segment.volume.affine_dim == 1);
  CHECK(sorted(segment.support) == std::vector<Index>{1, 2});
  CHECK(sorted(hull_of<double, 2>({{0, 1}, {0, 3}, {0, 2}, {0, 3}}).support) == std::vector<Index>{0, 1});
  CHECK(hull_of<double, 2>({{0, 0}, {-0.0, 0.0}}).volume.affine_dim == 0);
}

TEST_CASE("a square with points on its edges and inside keeps its corners, counter-clockwise") {
  const auto fit = hull_of<double, 2>({{1, 1}, {0, 1}, {2, 2}, {2, 0}, {1, 0}, {0, 0}, {0, 2}, {2, 0}, {2, 1}, {1, 2}});
  CHECK(fit.support == std::vector<Index>{5, 3, 2, 6});
  CHECK(fit.volume.facets == std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}});
}

TEST_CASE("a flat polygon in space keeps its corners in their order, in any plane") {
  const std::vector<Vector<double, 2>> grid{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  const Vector<double, 3> origin(3, 5, 7);
  for (const auto& [e, f] : std::vector<std::pair<Vector<double, 3>, Vector<double, 3>>>{
           {{1, 0, 0}, {0, 1, 0}}, {{0, 1, 0}, {0, 0, 1}}, {{0, 0, 1}, {1, 0, 0}}, {{1, 2, 3}, {-3, 1, 2}}}) {
    test::Cloud<double, 3> cloud;
    for (const auto& p : grid) cloud.push_back(origin + p[0] * e + p[1] * f);
    const auto fit = hull_of<double, 3>(cloud);
    CHECK(fit.volume.affine_dim == 2);
    CHECK(fit.volume.facets.empty());
    CHECK(sorted(fit.support) == std::vector<Index>{0, 2, 4, 6});
    for (std::size_t i = 0; i < 4; ++i) {
      const Index step = std::abs(fit.support[i] - fit.support[(i + 1) % 4]);
      CHECK((step == 2 || step == 6));  // a side, not a diagonal
    }
  }
}

TEST_CASE("of a lattice just the eight corners stay, and twelve triangles") {
  for (const int side : {2, 3, 5, 12}) {
    const auto fit = hull_of<double, 3>(lattice(side));
    CHECK(fit.support.size() == 8);
    CHECK(fit.volume.facets.size() == 12);
    check_proof<double, 3>("lattice", lattice(side));
  }
}

TEST_CASE("of points in one place the first is the vertex") {
  Random random(4);
  for (const int n : {40, 400}) {
    auto cloud = test::generated<double, 3>("sphere", 20, 9);
    for (int i = 0; i < n; ++i) cloud.push_back(cloud[random.below(20)]);
    for (std::size_t i = cloud.size() - 1; i > 0; --i)
      std::swap(cloud[i], cloud[random.below(static_cast<std::uint32_t>(i + 1))]);
    const auto fit = hull_of<double, 3>(cloud);
    CHECK(fit.support.size() == 20);
    for (const Index i : fit.support) CHECK(std::find(cloud.begin(), cloud.end(), cloud[i]) - cloud.begin() == i);
  }
}

TEST_CASE("whole numbers on a sphere are all corners of its faces") {
  for (const int square : {9, 17, 41, 101, 329}) {
    test::Cloud<double, 3> cloud;
    for (int x = -20; x <= 20; ++x)
      for (int y = -20; y <= 20; ++y)
        for (int z = -20; z <= 20; ++z)
          if (x * x + y * y + z * z == square) cloud.push_back({double(x), double(y), double(z)});
    REQUIRE(cloud.size() >= 24);
    CHECK(hull_of<double, 3>(cloud).support.size() == cloud.size());
    check_proof<double, 3>("whole numbers", cloud);
  }
}

TEST_CASE("every point of a parabola, a moment curve, a cone's rim is a vertex, and no stack runs out") {
  test::Cloud<double, 2> parabola;
  for (int i = 0; i < 50000; ++i) parabola.push_back({double(i), double(i) * i});
  CHECK(hull_of<double, 2>(parabola).support.size() == parabola.size());
  test::Cloud<double, 3> curve, cone{{0, 0, 1e9}};
  for (int i = 0; i < 700; ++i) curve.push_back({double(i), double(i) * i, double(i) * i * i});
  CHECK(hull_of<double, 3>(curve).support.size() == curve.size());
  check_proof<double, 3>("moment curve", curve);
  for (int i = -1500; i < 1500; ++i) cone.push_back({double(i), double(i) * i, 0});
  const auto fit = hull_of<double, 3>(cone);
  CHECK(fit.support.size() == cone.size());
  check_proof<double, 3>("cone", cone);
}

// -- Against the definition -------------------------------------------------------------------------------------------

TEST_CASE_TEMPLATE("degenerate clouds keep just the points that are in no hull of the others", Scalar, float, double) {
  int flat = 0, dropped = 0;
  const auto check = [&](const auto& name, const auto& points) {
    constexpr int kDim = std::decay_t<decltype(points)>::value_type::RowsAtCompileTime;
    INFO(name << ", dim " << kDim << ", " << sizeof(Scalar) << " bytes");
    const auto fit = hull_of<Scalar, kDim>(points);
    CHECK(sorted(fit.support) == exact::extreme_points(points));
    flat += fit.volume.affine_dim < kDim;
    dropped += fit.support.size() < points.size();
  };
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    for (const int n : {3, 5, 9})
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n)) check(name, points);
    for (const int n : {4, 7})
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n)) check(name, points);
  }
  CHECK(flat > 40);
  CHECK(dropped > 60);
}

// -- By proof ---------------------------------------------------------------------------------------------------------

TEST_CASE_TEMPLATE("larger degenerate clouds are proven", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    for (const int n : {20, 60, 400}) {
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(seed, n))
        check_proof<Scalar, 2>(name, points);
      for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(seed, n))
        check_proof<Scalar, 3>(name, points);
    }
}

TEST_CASE("clouds of any size and any place are proven") {
  for (const auto kind : generator_kinds()) {
    const std::string name(kind);
    for (const double scale : {1e-150, 1e-75, 1.0, 1e75, 1e150}) {
      check_proof<double, 2>(name, test::generated<double, 2>(name.c_str(), 300, 3, scale));
      check_proof<double, 3>(name, test::generated<double, 3>(name.c_str(), 300, 3, scale));
    }
    for (const double offset : {1e3, 1e8, 1e15}) {
      check_proof<double, 2>(name, test::generated<double, 2>(name.c_str(), 300, 4, 1, offset));
      check_proof<double, 3>(name, test::generated<double, 3>(name.c_str(), 300, 4, 1, offset));
    }
    for (const double scale : {1e-15, 1e15})
      check_proof<float, 3>(name, test::generated<float, 3>(name.c_str(), 300, 5, scale));
    check_proof<float, 3>(name, test::generated<float, 3>(name.c_str(), 300, 6, 1, 1e4));
    check_proof<float, 3>(name, test::generated<float, 3>(name.c_str(), 300, 6, 1, 1e6));
  }
}

TEST_CASE("near-flat clouds keep just their extreme points") {
  // In a tilted plane but for some roundings: nearly every question is about the last digits.
  Random random(7);
  int misled = 0, solid = 0;
  for (const int ulps : {0, 1, 8})
    for (int turn = 0; turn < 12; ++turn) {
      test::Cloud<double, 3> cloud;
      for (int i = 0; i < 60; ++i) {
        const double s = random.between(-1, 1), t = random.between(-1, 1);
        Vector<double, 3> p(s, t, 0.3 * s - 0.7 * t);
        for (int k = 0; k < ulps; ++k) p[2] = std::nextafter(p[2], random.below(2) == 0 ? -2.0 : 2.0);
        cloud.push_back(p);
      }
      check_proof<double, 3>("near-flat", cloud);
      solid += hull_of<double, 3>(cloud).volume.affine_dim == 3;
      const auto minus = [&](std::size_t i, std::size_t j) -> Vector<double, 3> { return cloud[i] - cloud[j]; };
      for (std::size_t i = 3; i < cloud.size(); ++i) {
        const Vector<double, 3> e = minus(1, 0), f = minus(2, 0), g = minus(i, 0);
        const double rounded = (e[1] * f[2] - e[2] * f[1]) * g[0] + (e[2] * f[0] - e[0] * f[2]) * g[1] +
                               (e[0] * f[1] - e[1] * f[0]) * g[2];
        misled += (rounded > 0) - (rounded < 0) != orient3d(cloud[0], cloud[1], cloud[2], cloud[i]);
      }
    }
  CHECK(misled > 100);
  CHECK(solid == 36);
}

TEST_CASE("of 100,000 points on a sphere none is lost") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("sphere", 100000, 1));
  const auto fit = fit::quickhull(set.span());
  CHECK(fit.support.size() == 100000);
  CHECK(fit.volume.facets.size() == 2 * 100000 - 4);
  CHECK(fit::prove_hull(fit.volume, set.span()).holds());
}

TEST_CASE("of 1,000 points on a sphere that stands a million away none is lost") {
  const auto far = test::generated<double, 3>("sphere", 1000, 1, 1, 1e6);
  CHECK(hull_of<double, 3>(far).support.size() == 1000);
  check_proof<double, 3>("far sphere", far);
  // So far out that coordinates are a few whole numbers apart, many points are inside or on faces: those are no
  // vertices.
  for (const double offset : {1e10, 1e13, 1e14, 1e15, 1e16}) {
    const auto rounded = test::generated<double, 3>("sphere", 1000, 1, 10, offset);
    check_proof<double, 3>("sphere of whole numbers", rounded);
    if (offset >= 1e15) CHECK(hull_of<double, 3>(rounded).support.size() < 800);
  }
  // Few enough to ask the definition.
  const auto few = test::generated<double, 3>("sphere", 9, 2, 3, 1e15);
  CHECK(hull_of<double, 3>(few).support == exact::extreme_points(few));
}

// -- Steps ------------------------------------------------------------------------------------------------------------

namespace {

/// The hull as the steps say it, and nothing else.
template <int Dim>
struct Rebuilt {
  std::map<Index, std::array<Index, Dim>> facets;
  Index outside = 0;  // how many points have been assigned and not yet taken or dropped
  std::map<Index, Index> counts;
  int replaced = 0;

  void operator()(const fit::SimplexChosen& fact) {
    REQUIRE(fact.vertices.size() % Dim == 0);
    for (std::size_t i = 0; i < fact.vertices.size(); ++i)
      facets[static_cast<Index>(i / Dim)][i % Dim] = fact.vertices[i];
  }
  void operator()(const fit::PointsAssigned& fact) {
    REQUIRE(fact.facets.size() == fact.counts.size());
    std::size_t given = 0;
    for (std::size_t i = 0; i < fact.facets.size(); ++i) {
      counts[fact.facets[i]] = fact.counts[i];
      given += static_cast<std::size_t>(fact.counts[i]);
    }
    CHECK(fact.points.size() == given);
    CHECK(fact.inside.size() == static_cast<std::size_t>(fact.dropped));
  }
  void operator()(const fit::EyeChosen& fact) {
    CHECK(counts.at(fact.facet) == fact.of);
    CHECK(fact.distance >= 0);
  }
  void operator()(const fit::EdgeSplit& fact) {
    if constexpr (Dim == 2) {
      CHECK(facets.at(fact.edge) == std::array{fact.a, fact.b});
      facets.erase(fact.edge);
      facets[fact.first] = {fact.a, fact.point};
      facets[fact.second] = {fact.point, fact.b};
      ++replaced;
    }
  }
  void operator()(const fit::FacetsReplaced& fact) {
    if constexpr (Dim == 3) {
      for (const Index f : fact.removed) CHECK(facets.erase(f) == 1);
      for (std::size_t i = 0; i < fact.added.size(); ++i) {
        CHECK(!facets.contains(fact.added[i]));
        facets[fact.added[i]] = {fact.horizon[i], fact.horizon[(i + 1) % fact.horizon.size()], fact.eye};
      }
      ++replaced;
    }
  }
  void operator()(const auto&) {}

  /// Each edge of the surface once in either direction; in 2-D each vertex once as a start and once as an end.
  [[nodiscard]] bool closed() const {
    std::set<std::pair<Index, Index>> ways;
    for (const auto& [id, vertices] : facets)
      for (std::size_t i = 0; i < Dim; ++i) {
        if constexpr (Dim == 3) {
          if (!ways.insert({vertices[i], vertices[(i + 1) % Dim]}).second) return false;
        } else {
          if (!ways.insert({vertices[i], static_cast<Index>(i)}).second) return false;
        }
      }
    if constexpr (Dim == 3)
      for (const auto& [from, to] : ways)
        if (!ways.contains({to, from})) return false;
    return true;
  }
};

template <class Scalar, int Dim>
void check_steps(const std::string& name, const test::Cloud<Scalar, Dim>& cloud) {
  INFO(name << ", " << cloud.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(cloud);
  Recorder<fit::HullStep<Scalar, Dim>> recorder;
  const auto fit = fit::quickhull(set.span(), recorder);
  const auto unwatched = fit::quickhull(set.span());
  CHECK(unwatched.support == fit.support);
  CHECK(unwatched.volume.facets == fit.volume.facets);

  Rebuilt<Dim> rebuilt;
  for (const auto& entry : recorder.entries) {
    REQUIRE(static_cast<std::size_t>(entry.step.line) < fit::kQuickhullPseudocode<Dim>.size());
    const bool last = &entry == &recorder.entries.back();
    CHECK(std::holds_alternative<fit::Finished>(entry.step.fact) == last);
    CHECK(entry.step.has_volume == last);
    std::visit(rebuilt, entry.step.fact);
    CHECK(rebuilt.closed());
  }
  CHECK(recorder.entries.back().step.volume.indices == fit.support);
  if (fit.volume.affine_dim < Dim) return;

  // The facets left are those of the hull, but for what was merged at the end: the same vertices at least.
  std::set<Index> seen;
  for (const auto& [id, vertices] : rebuilt.facets) seen.insert(vertices.begin(), vertices.end());
  for (const auto& entry : recorder.entries)
    if (const auto* merged = std::get_if<fit::FacesMerged>(&entry.step.fact))
      for (const Index i : merged->dropped) CHECK(seen.erase(i) == 1);
  CHECK(std::vector<Index>(seen.begin(), seen.end()) == sorted(fit.support));
  CHECK(rebuilt.replaced + Dim + 1 >= static_cast<int>(fit.support.size()));
}

}  // namespace

TEST_CASE_TEMPLATE("from its steps alone the hull can be rebuilt", Scalar, float, double) {
  for (const int n : {1, 4, 9, 60}) {
    for (const auto& [name, points] : test::degenerate_clouds<Scalar, 2>(2, n)) check_steps<Scalar, 2>(name, points);
    for (const auto& [name, points] : test::degenerate_clouds<Scalar, 3>(2, n)) check_steps<Scalar, 3>(name, points);
  }
  check_steps<Scalar, 2>("gaussian", test::generated<Scalar, 2>("gaussian", 3000, 1));
  check_steps<Scalar, 3>("gaussian", test::generated<Scalar, 3>("gaussian", 3000, 1));
  check_steps<Scalar, 3>("lattice", test::generated<Scalar, 3>("lattice", 200, 1));
}

TEST_CASE("a step says how far the farthest point lies from its facet, whatever the scale") {
  for (const double scale : {1e-150, 1.0, 1e150}) {
    Recorder<fit::HullStep<double, 3>> recorder;
    test::Cloud<double, 3> cloud{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    fit::quickhull(test::set_of<double, 3>(moved<double, 3>(cloud, scale, 0)).span(), recorder);
    int eyes = 0;
    for (const auto& entry : recorder.entries)
      if (const auto* eye = std::get_if<fit::EyeChosen>(&entry.step.fact)) {
        ++eyes;
        CHECK(eye->distance > 0.5 * scale);
        CHECK(eye->distance < 1.2 * scale);
      }
    CHECK(eyes == 2);
  }
}

TEST_CASE("what is spent is counted, and less than n times the hull") {
  const auto set = test::set_of<double, 3>(test::generated<double, 3>("ball", 5000, 1));
  Counter counter;
  const auto fit = fit::quickhull(set.span(), counter);
  const auto tests = counter.counts[static_cast<std::size_t>(Operation::kOrientationTests)];
  CHECK(tests > 5000);
  CHECK(tests < 5000 * 40);
  CHECK(fit.support.size() > 100);
}
