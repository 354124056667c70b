// Distances of points, segments and rectangles against 300 bits. Each family is what was hard for somebody's test.
#include "query/distance/distance.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <string>

#include "core/query/distance_oracle.hpp"
#include "geometry/random.hpp"
#include "query/distance/distance_rectangles.hpp"

using namespace snug;
using query::Rectangle;
using query::Segment;
using test::BigPatch;

namespace {

template <class Scalar>
using Point = Vector<Scalar, 3>;

/// A point, a segment or a rectangle as corner and edges; no coordinate above 1.
template <class Scalar>
struct Patch {
  Point<Scalar> corner = Point<Scalar>::Zero();
  std::array<Point<Scalar>, 2> edges{Point<Scalar>::Zero(), Point<Scalar>::Zero()};

  [[nodiscard]] BigPatch big() const {
    return {test::big<Scalar, 3>(corner), {test::big<Scalar, 3>(edges[0]), test::big<Scalar, 3>(edges[1])}};
  }
  [[nodiscard]] Segment<Scalar> segment() const { return {corner, edges[0]}; }
  [[nodiscard]] Rectangle<Scalar> rectangle() const { return query::rectangle_of<Scalar>(corner, edges); }
  [[nodiscard]] Point<Scalar> at(double s, double t) const {
    return corner + Scalar(s) * edges[0] + Scalar(t) * edges[1];
  }
};

template <class Scalar>
class Maker {
 public:
  explicit Maker(std::uint64_t seed) : random(seed) {}

  Random random;

  Scalar between(double low, double high) { return static_cast<Scalar>(random.between(low, high)); }
  Point<Scalar> any(double size = 1) {
    const double s = 0.25 * size;
    return {between(-s, s), between(-s, s), between(-s, s)};
  }
  /// 1 to 10^-most.
  Scalar small(int most) {
    return static_cast<Scalar>(std::pow(10.0, -static_cast<int>(random.below(unsigned(most) + 1))));
  }
  Point<Scalar> across(const Point<Scalar>& v) {
    const Point<double> w = v.template cast<double>();
    const Point<double> side = w.cross(any().template cast<double>());
    return (side * (w.norm() / (side.norm() * 4) * (1 + random.unit()))).template cast<Scalar>();
  }
  Patch<Scalar> rectangle() {
    const Point<Scalar> edge = any();
    return {any(), {edge, across(edge)}};
  }
};

template <class Scalar>
struct PatchPair {
  Patch<Scalar> a, b;
};

template <class Scalar>
struct Family {
  std::string name;
  std::function<PatchPair<Scalar>(Maker<Scalar>&)> make;
};

template <class Scalar>
std::vector<Family<Scalar>> rectangle_families() {
  using Make = Maker<Scalar>&;
  using Result = PatchPair<Scalar>;
  const int digits = sizeof(Scalar) == 8 ? 17 : 8;
  /// The second, moved so that a point of it is at that place of the first, and from there a way off it.
  const auto put = [](Make make, const Patch<Scalar>& a, Patch<Scalar> b, const Point<Scalar>& off) {
    const Point<Scalar> target = a.at(make.random.between(-0.3, 1.3), make.random.between(-0.3, 1.3)) + off;
    b.corner += target - b.at(make.random.unit(), make.random.unit());
    return Result{a, b};
  };
  return {
      {"any",
       [](Make make) {
         return Result{make.rectangle(), make.rectangle()};
       }},
      {"touching or nearly",
       [=](Make make) { return put(make, make.rectangle(), make.rectangle(), make.any(make.small(digits))); }},
      {"parallel planes",
       [=](Make make) {
         const Patch<Scalar> a = make.rectangle();
         Patch<Scalar> b = make.rectangle();
         b.edges = {Point<Scalar>(a.edges[0] * make.between(0.1, 1)), Point<Scalar>(a.edges[1] * make.between(-1, 1))};
         return put(make, a, b, make.any(make.small(digits)));
       }},
      {"almost parallel",
       [=](Make make) {
         const Patch<Scalar> a = make.rectangle();
         Patch<Scalar> b = a;
         b.edges[0] += make.any(make.small(digits));
         b.edges[1] -= b.edges[0] * (b.edges[1].dot(b.edges[0]) / b.edges[0].squaredNorm());
         return put(make, a, b, make.any(make.small(digits)));
       }},
      {"in one plane",
       [=](Make make) {
         Patch<Scalar> a = make.rectangle(), b = make.rectangle();
         for (Patch<Scalar>* patch : {&a, &b}) {
           patch->corner[2] = patch->edges[0][2] = 0;
           patch->edges[1] = Point<Scalar>(-patch->edges[0][1], patch->edges[0][0], 0) * make.between(0, 1);
         }
         return Result{a, b};
       }},
      {"zero edges",
       [=](Make make) {
         Patch<Scalar> a = make.rectangle(), b = make.rectangle();
         for (Patch<Scalar>* patch : {&a, &b})
           for (auto& edge : patch->edges)
             if (make.random.below(2) == 0) edge.setZero();
         return put(make, a, b, make.any(make.small(digits)));
       }},
      {"tiny and long edges",
       [=](Make make) {
         Patch<Scalar> a = make.rectangle(), b = make.rectangle();
         for (Patch<Scalar>* patch : {&a, &b})
           for (auto& edge : patch->edges)
             edge *= make.random.below(20) == 0 ? std::numeric_limits<Scalar>::min() : make.small(2 * digits);
         return put(make, a, b, make.any(make.small(digits)));
       }},
      {"whole numbers",
       [](Make make) {
         const auto whole = [&] { return static_cast<Scalar>(static_cast<int>(make.random.below(5)) - 2) / 8; };
         const auto rectangle = [&] {
           const int axis = static_cast<int>(make.random.below(3));
           Patch<Scalar> patch{{whole(), whole(), whole()}};
           patch.edges[0][axis] = whole(), patch.edges[1][(axis + 1) % 3] = whole();
           return patch;
         };
         return Result{rectangle(), rectangle()};
       }},
  };
}

/// That the squared distance is right, and that of the points named too.
template <class Scalar>
void check_closest(const query::ClosestPoints<Scalar>& found, const Patch<Scalar>& a, const Patch<Scalar>& b) {
  const auto exact = static_cast<double>(test::distance(a.big(), b.big()));
  CHECK(std::abs(std::sqrt(static_cast<double>(found.square)) - exact) <=
        static_cast<double>(tolerance::kTouching<Scalar>));
  CHECK(std::abs(static_cast<double>((found.b - found.a).norm()) - exact) <=
        static_cast<double>(tolerance::kTouching<Scalar>));
  CHECK((found.between - (found.b - found.a)).norm() <= tolerance::kTouching<Scalar>);
}

/// The same with fewer edges: of rectangles segments, and points.
template <class Scalar>
Patch<Scalar> with_edges(Patch<Scalar> patch, int edges) {
  for (int i = edges; i < 2; ++i) patch.edges[i].setZero();
  return patch;
}

}  // namespace

TEST_CASE_TEMPLATE("points, segments and rectangles have the exact distance, whatever their position", Scalar, float,
                   double) {
  Maker<Scalar> make(1);
  for (const auto& family : rectangle_families<Scalar>()) {
    CAPTURE(family.name);
    int near = 0;
    for (int round = 0; round < 60; ++round) {
      CAPTURE(round);
      const auto [a, b] = family.make(make);
      const auto found = query::closest_points(a.rectangle(), b.rectangle());
      check_closest(found, a, b);
      near += found.square < Scalar(1e-6) ? 1 : 0;

      const Patch<Scalar> s = with_edges(a, 1), t = with_edges(b, 1), p = with_edges(a, 0);
      check_closest(query::closest_points(p.corner, t.segment()), p, t);
      check_closest(query::closest_points(s.segment(), t.segment()), s, t);
      check_closest(query::closest_points(t.segment(), s.segment()), t, s);
      check_closest(query::closest_points(p.corner, b.rectangle()), p, b);
      check_closest(query::closest_points(s.segment(), b.rectangle()), s, b);
    }
    CHECK(near >= (family.name == "any" || family.name == "whole numbers" ? 1 : 10));
  }
}
