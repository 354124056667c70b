// The nearest box of a tree that a ray hits.
#include <algorithm>
#include <limits>

#include "fit/merge/merge.hpp"
#include "geometry/sort.hpp"
#include "query/overlap/ray_aabb.hpp"
#include "write/inputs.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace trees {
namespace {

enum RayKind { kRandom, kNearer, kZeros, kBehind, kWithin, kTiny };
constexpr std::array kRayKinds{
    Kind{"random", "random rays"},
    Kind{"nearer", "rays whose nearest leaf is in the child that they enter later"},
    Kind{"zeros", "rays along an axis, whose direction has zeros"},
    Kind{"behind", "rays with boxes behind their origin"},
    Kind{"inside", "rays that begin inside a box"},
    Kind{"tiny", "a very small tree"},
};

using Box = Aabb<double, 2>;

/// Puts the leaves from first to last under a node, halved along x. Returns the node's index.
double add_node(std::vector<Node>& nodes, const std::vector<Box>& leaves, std::size_t first, std::size_t last,
                double parent) {
  const std::size_t at = nodes.size();
  nodes.push_back({leaves[first], parent});
  for (std::size_t i = first; i < last; ++i) nodes[at].box = fit::merge(nodes[at].box, leaves[i]);
  if (last - first == 1) return static_cast<double>(at);
  const std::size_t middle = (first + last) / 2;
  const double left = add_node(nodes, leaves, first, middle, static_cast<double>(at));
  const double right = add_node(nodes, leaves, middle, last, static_cast<double>(at));
  nodes[at].left = left, nodes[at].right = right;
  return static_cast<double>(at);
}

std::vector<Node> random_tree(Cases& cases) {
  std::vector<Box> leaves(2 + cases.random.below(7));
  for (Box& leaf : leaves) {
    leaf.min = whole_point2(cases, 10);
    for (int i = 0; i < 2; ++i) leaf.max[i] = leaf.min[i] + cases.whole(2, 8);
  }
  sort_stably(leaves, [](const Box& a, const Box& b) { return a.min[0] < b.min[0]; });
  std::vector<Node> nodes;
  add_node(nodes, leaves, 0, leaves.size(), -1);
  return nodes;
}

Ray<double, 2> random_ray(Cases& cases, int kind) {
  Ray<double, 2> ray{whole_point2(cases, kind == kBehind || kind == kWithin ? 8 : 24), whole_point2(cases, 8)};
  ray.origin.array() += 0.5;  // on no face
  if (kind == kZeros) {
    const int axis = static_cast<int>(cases.random.below(2));
    ray.direction[1 - axis] = std::copysign(0.0, ray.direction[1 - axis]);
    if (ray.direction[axis] == 0) ray.direction[axis] = 1;
  }
  if (ray.direction.isZero(0)) ray.direction = Point2(1, 1);
  return ray;
}

struct Hit {
  double leaf = -1, t = std::numeric_limits<double>::infinity();
};

/// Searches all leaves. grown: how much larger each leaf is made.
Hit nearest(const std::vector<Node>& nodes, const Ray<double, 2>& ray, double grown = 0) {
  Hit hit;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].left >= 0) continue;
    const Box box{nodes[i].box.min.array() - grown, nodes[i].box.max.array() + grown};
    const auto t = query::ray_enters(box, ray);
    if (t && *t < hit.t) hit = {static_cast<double>(i), *t};
  }
  return hit;
}

/// Whether rounding cannot change the answer, scaled or not.
bool is_clear(const std::vector<Node>& nodes, const Ray<double, 2>& ray) {
  const double size = (nodes[0].box.max - nodes[0].box.min).maxCoeff();
  const double leaf = nearest(nodes, ray).leaf;
  return leaf == nearest(nodes, ray, 1e-6 * size).leaf && leaf == nearest(nodes, ray, -1e-6 * size).leaf;
}

/// Whether the leaf that is nearest is not in the child that the ray enters first.
bool is_in_later_child(const std::vector<Node>& nodes, const Ray<double, 2>& ray) {
  if (nodes[0].left < 0) return false;
  const double leaf = nearest(nodes, ray).leaf, right = nodes[0].right;
  const auto enters = [&](double child) { return query::ray_enters(nodes[static_cast<std::size_t>(child)].box, ray); };
  const auto left_t = enters(nodes[0].left), right_t = enters(right);
  return left_t && right_t && (*left_t < *right_t) == (leaf >= right);
}

bool is_of(int kind, const std::vector<Node>& nodes, const Ray<double, 2>& ray, bool hits) {
  const Hit hit = nearest(nodes, ray);
  if (!is_clear(nodes, ray)) return false;
  if (kind == kNearer) return hit.leaf >= 0 && is_in_later_child(nodes, ray);
  if (kind == kWithin) return hit.t == 0;
  if (kind == kBehind && nearest(nodes, {ray.origin, -ray.direction}).leaf < 0) return false;
  return (hit.leaf >= 0) == hits;
}

void make_rays(Cases& cases) {
  each_kind(kRayKinds, [&](int kind, int i) {
    const Scale scale = kind == kTiny ? kTinyScale : kPlain;
    std::vector<Node> nodes;
    Ray<double, 2> ray;
    do {
      nodes = random_tree(cases);
      ray = random_ray(cases, kind);
    } while (!is_of(kind, nodes, ray, i % 4 != 0));
    Numbers input{static_cast<double>(nodes.size())};
    for (const auto& [box, parent, left, right] : nodes) {
      put(input, scale(box.min));
      put(input, scale(box.max));
      input.insert(input.end(), {parent, left, right});
    }
    put(input, scale(ray.origin));
    put(input, ray.direction);
    cases.add(kind, std::move(input));
  });
}

Numbers first_hit(const Numbers& input) {
  const auto [nodes, ray] = ray_input_of(input);
  return {nearest(nodes, ray).leaf};
}

/// Any of several leaves that the ray enters at the same parameter is right.
bool is_first_hit(const Numbers& input, const Numbers& answer) {
  const auto [nodes, ray] = ray_input_of(input);
  const Hit hit = nearest(nodes, ray);
  if (answer[0] == hit.leaf) return true;
  if (hit.leaf < 0 || !is_index(answer[0], nodes.size())) return false;
  const Node& given = nodes[static_cast<std::size_t>(answer[0])];
  const auto t = query::ray_enters(given.box, ray);
  return given.left < 0 && t && *t <= hit.t * (1 + kNear);
}

/// A tree stays as it is: only the ray and the ends of boxes may become simpler, while each box contains its children.
bool is_ray_input(const Numbers& input) {
  if (input[0] < 3) return false;  // a stage has two boxes at least
  const auto [nodes, ray] = ray_input_of(input);
  const auto n = static_cast<double>(nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if ((node.box.max - node.box.min).minCoeff() < 0) return false;
    if ((node.left < 0) != (node.right < 0) || node.left >= n || node.right >= n) return false;
    if (i == 0 ? node.parent != -1 : !(node.parent >= 0 && node.parent < static_cast<double>(i))) return false;
    for (const double child : {node.left, node.right}) {
      if (child < 0) continue;
      if (child != std::floor(child) || child <= static_cast<double>(i)) return false;
      const Node& own = nodes[static_cast<std::size_t>(child)];
      if (own.parent != static_cast<double>(i)) return false;
      if ((own.box.min - node.box.min).minCoeff() < 0 || (node.box.max - own.box.max).minCoeff() < 0) return false;
    }
  }
  return !ray.direction.isZero(0) && is_clear(nodes, ray);
}

constexpr std::array kFunctions{
    Function{"first-hit", "first_hit", "{nodes:*{min:2n,max:2n,parent:i,left:i,right:i},ray:{origin:2n,direction:2n}}",
             "i", "bvh_query/ray_nearest", kRayKinds, make_rays, first_hit, is_first_hit, is_ray_input},
};

}  // namespace
}  // namespace trees

RayInput ray_input_of(const Numbers& input) {
  Take take(input);
  RayInput own;
  own.nodes.resize(static_cast<std::size_t>(take.number()));
  for (auto& [box, parent, left, right] : own.nodes) {
    box.min = take.point();
    box.max = take.point();
    parent = take.number(), left = take.number(), right = take.number();
  }
  own.ray.origin = take.point();
  own.ray.direction = take.point();
  return own;
}

std::span<const Function> tree_functions() { return trees::kFunctions; }

}  // namespace snug::write
