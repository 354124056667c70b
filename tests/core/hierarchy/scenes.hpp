// Bodies for trees, in scenes named by what is hard about them; and what every tree must be.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/fit/exact_holds.hpp"
#include "geometry/random.hpp"
#include "hierarchy/build.hpp"

namespace snug::test {

template <class Scalar, int Dim>
struct Scene {
  std::string name;
  std::vector<Aabb<Scalar, Dim>> boxes;
};

template <class Scalar, int Dim>
Aabb<Scalar, Dim> box_at(const Vector<double, Dim>& low, const Vector<double, Dim>& widths) {
  Aabb<Scalar, Dim> box{low.template cast<Scalar>(), (low + widths).template cast<Scalar>()};
  return {box.min, box.max.cwiseMax(box.min)};
}

template <int Dim>
Vector<double, Dim> any_in(Random& random, double low, double high) {
  Vector<double, Dim> v;
  for (int i = 0; i < Dim; ++i) v[i] = random.between(low, high);
  return v;
}

/// Boxes of about unit size in a cube of that width.
template <class Scalar, int Dim>
std::vector<Aabb<Scalar, Dim>> spread(int n, std::uint64_t seed, double width) {
  Random random(seed);
  std::vector<Aabb<Scalar, Dim>> boxes;
  for (int i = 0; i < n; ++i) {
    const auto low = any_in<Dim>(random, 0, width);
    boxes.push_back(box_at<Scalar, Dim>(low, any_in<Dim>(random, 0, 1)));
  }
  return boxes;
}

template <class Scalar, int Dim>
std::vector<Scene<Scalar, Dim>> hard_scenes(int n) {
  using Point = Vector<double, Dim>;
  Random random(5);
  std::vector<Scene<Scalar, Dim>> scenes{{"none", {}},
                                         {"one body", spread<Scalar, Dim>(1, 1, 1)},
                                         {"two bodies", spread<Scalar, Dim>(2, 2, 3)},
                                         {"three bodies", spread<Scalar, Dim>(3, 2, 3)},
                                         {"spread", spread<Scalar, Dim>(n, 3, 20)},
                                         {"crowded", spread<Scalar, Dim>(n, 4, 0.5)}};
  const auto make = [&](const char* name, auto&& box) {
    auto& scene = scenes.emplace_back();
    scene.name = name;
    for (int i = 0; i < n; ++i) scene.boxes.push_back(box(i));
  };
  const auto at = [](const Point& low, double width) { return box_at<Scalar, Dim>(low, Point::Constant(width)); };
  const Point place = any_in<Dim>(random, -1, 1);
  make("all equal", [&](int) { return at(place, 1); });
  make("all one point", [&](int) { return at(place, 0); });
  make("two places", [&](int i) { return at(place * (i % 2), 0.1); });
  make("points on an axis", [&](int i) { return at(Point::Unit(1) * i, 0); });
  make("boxes on a line, in order", [&](int i) { return at(Point::Ones() * i, 1); });
  make("boxes on a line, backwards", [&](int i) { return at(-Point::Ones() * i, 0.5); });
  make("around one centre", [&](int i) { return at(Point::Constant(-i), 2 * i); });
  make("flat", [&](int) {
    Point low = any_in<Dim>(random, 0, 10);
    low[Dim - 1] = 3;
    Point widths = any_in<Dim>(random, 0, 1);
    widths[Dim - 1] = 0;
    return box_at<Scalar, Dim>(low, widths);
  });
  const bool is_double = sizeof(Scalar) == 8;
  make("far", [&](int) { return at(any_in<Dim>(random, 0, 10) + Point::Constant(is_double ? 1e12 : 1e5), 1); });
  make("huge",
       [&](int) { return at(any_in<Dim>(random, -1, 1) * (is_double ? 1e152 : 1e17), is_double ? 1e150 : 1e15); });
  make("tiny",
       [&](int) { return at(any_in<Dim>(random, -1, 1) * (is_double ? 1e-310 : 1e-42), is_double ? 1e-312 : 1e-44); });
  make("one far away, the rest together", [&](int i) {
    return at(any_in<Dim>(random, 0, 1) * 1e-3 + Point::Constant(i == 7 ? (is_double ? 1e12 : 1e5) : 0), 1e-5);
  });
  make("each twice as far as the last", [&](int i) {
    const int e = is_double ? i * 5 - 500 : i - 60;
    return at(Point::Ones() * std::ldexp(1.0, std::clamp(e, is_double ? -1000 : -100, is_double ? 500 : 55)), 0);
  });
  make("a large one among small ones", [&](int i) { return at(any_in<Dim>(random, 0, 10), i % 50 == 0 ? 20 : 0.1); });
  return scenes;
}

/// Every body once; children after their parents, side by side; leaves by rising index; bodies below a node side by
/// side.
template <class VolumeType>
void check_shape(const hierarchy::Tree<VolumeType>& tree, std::size_t bodies, Index most_in_leaf) {
  REQUIRE(tree.bodies.size() == bodies);
  std::vector<int> seen(bodies, 0);
  for (const Index body : tree.bodies) {
    REQUIRE(body >= 0);
    REQUIRE(static_cast<std::size_t>(body) < bodies);
    ++seen[body];
  }
  REQUIRE(std::all_of(seen.begin(), seen.end(), [](int times) { return times == 1; }));
  REQUIRE(tree.nodes.empty() == (bodies == 0));
  if (bodies == 0) return;
  std::vector<int> parents(tree.nodes.size(), 0);
  std::size_t in_leaves = 0;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto& node = tree.nodes[i];
    const auto below = tree.bodies_below(static_cast<Index>(i));
    if (node.is_leaf()) {
      REQUIRE(node.count <= most_in_leaf);
      REQUIRE(std::is_sorted(below.begin(), below.end()));
      REQUIRE(static_cast<Index>(below.size()) == node.count);
      in_leaves += below.size();
      continue;
    }
    const auto left = static_cast<std::size_t>(node.first);
    REQUIRE(left > i);
    REQUIRE(left + 1 < tree.nodes.size());
    ++parents[left], ++parents[left + 1];
    const auto of_left = tree.bodies_below(node.first), of_right = tree.bodies_below(node.first + 1);
    REQUIRE(of_left.data() == below.data());
    REQUIRE(of_left.data() + of_left.size() == of_right.data());
    REQUIRE(of_left.size() + of_right.size() == below.size());
  }
  REQUIRE(in_leaves == bodies);
  REQUIRE(tree.bodies_below(0).size() == bodies);
  REQUIRE(parents[0] == 0);
  REQUIRE(std::all_of(parents.begin() + 1, parents.end(), [](int times) { return times == 1; }));
}

template <class Scalar, int Dim>
bool holds_body(const Aabb<Scalar, Dim>& outer, const Aabb<Scalar, Dim>& inner) {
  return (outer.min.array() <= inner.min.array()).all() && (outer.max.array() >= inner.max.array()).all();
}
template <template <class, int> class Kind, class Scalar, int Dim>
bool holds_body(const Kind<Scalar, Dim>& outer, const Kind<Scalar, Dim>& inner) {
  return exact::holds(Volume<Scalar, Dim>(outer), Volume<Scalar, Dim>(inner));
}

/// Each node's volume holds, exactly, those of all bodies below it; or where that takes long, of its children and
/// bodies.
template <class VolumeType>
void check_volumes(const hierarchy::Tree<VolumeType>& tree, std::type_identity_t<std::span<const VolumeType>> volumes,
                   bool all_below) {
  const auto volume = [&](Index body) -> const VolumeType& { return volumes[body]; };
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto& node = tree.nodes[i];
    if (all_below || node.is_leaf()) {
      for (const Index body : tree.bodies_below(static_cast<Index>(i))) REQUIRE(holds_body(node.volume, volume(body)));
    } else {
      const auto left = static_cast<std::size_t>(node.first);
      REQUIRE(holds_body(node.volume, tree.nodes[left].volume));
      REQUIRE(holds_body(node.volume, tree.nodes[left + 1].volume));
    }
  }
}

template <class VolumeType>
struct NamedTree {
  const char* name;
  hierarchy::Tree<VolumeType> tree;
  Index most_in_leaf;
};

/// By every builder.
template <class VolumeType>
std::vector<NamedTree<VolumeType>> all_trees(const std::vector<VolumeType>& volumes) {
  std::vector<NamedTree<VolumeType>> trees;
  trees.push_back({"median", hierarchy::build_median<VolumeType>(volumes), 4});
  trees.push_back({"median, one in a leaf", hierarchy::build_median<VolumeType>(volumes, {1}), 1});
  trees.push_back({"surface area", hierarchy::build_surface_area<VolumeType>(volumes), 4});
  trees.push_back({"surface area, one in a leaf", hierarchy::build_surface_area<VolumeType>(volumes, {1}), 1});
  trees.push_back({"bottom up", hierarchy::build_bottom_up<VolumeType>(volumes), 1});
  trees.push_back({"insertion", hierarchy::build_by_insertion<VolumeType>(volumes), 1});
  return trees;
}

/// The ball through a box's corners, about.
template <class Scalar, int Dim>
std::vector<Sphere<Scalar, Dim>> balls_of(const std::vector<Aabb<Scalar, Dim>>& boxes) {
  std::vector<Sphere<Scalar, Dim>> balls;
  for (const auto& box : boxes) {
    const Vector<Scalar, Dim> half = (box.max - box.min) / 2;
    balls.push_back({box.min + half, scaled_norm<Scalar, Dim>(half)});
  }
  return balls;
}

}  // namespace snug::test
