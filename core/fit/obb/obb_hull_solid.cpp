#include "fit/obb/obb_hull_solid.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <tuple>

#include "geometry/orientation.hpp"
#include "number/double_double.hpp"
#include "number/dyadic.hpp"
#include "number/tuple.hpp"

namespace snug::fit {
namespace {

using Point = Vector<double, 3>;

/// (b - a) x (c - a), in any number type that has +, - and *.
template <class Number>
Tuple<Number, 3> cross_of(const Point& a, const Point& b, const Point& c) {
  const auto from = tuple_of<Number, 3>(a);
  return cross(tuple_of<Number, 3>(b) - from, tuple_of<Number, 3>(c) - from);
}

/// An edge with the facets on its left and right, as seen from outside on the way from its first vertex to its second,
/// and the right facet's third vertex.
struct SharedEdge {
  HullSolid::Edge edge;
  Index left, right, beyond;
};

/// The edges, sorted by their vertices. facets: a closed surface, counter-clockwise as seen from outside.
std::vector<SharedEdge> edges_of(const std::vector<std::array<Index, 3>>& facets) {
  struct Half {
    Index low, high, facet, third;
    bool rising;
  };
  std::vector<Half> halves;
  for (std::size_t f = 0; f < facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index u = facets[f][i], v = facets[f][(i + 1) % 3];
      halves.push_back({std::min(u, v), std::max(u, v), static_cast<Index>(f), facets[f][(i + 2) % 3], u < v});
    }
  std::sort(halves.begin(), halves.end(), [](const Half& g, const Half& h) {
    return std::tuple(g.low, g.high, !g.rising) < std::tuple(h.low, h.high, !h.rising);
  });
  std::vector<SharedEdge> edges;
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2)
    edges.push_back({{halves[i].low, halves[i].high}, halves[i].facet, halves[i + 1].facet, halves[i + 1].third});
  return edges;
}

/// The triangle's normal, of unit length within a few roundings however thin the triangle is. Coordinates of about 1.
Point unit_normal(const Point& a, const Point& b, const Point& c) {
  const auto wide = cross_of<DoubleDouble>(a, b, c);
  const Point normal(wide[0].value(), wide[1].value(), wide[2].value());
  if (normal.norm() > tolerance::kThinTriangle * (b - a).norm() * (c - a).norm()) return unit<3>(normal);
  const auto exact = cross_of<Dyadic>(a, b, c);
  return unit<3>(Point(exact[0].approximate(), exact[1].approximate(), exact[2].approximate()));
}

}  // namespace

template <class Count>
void HullSolid::build(Corners corners, const std::vector<Triangle>& facets, Count& count) {
  // Faces and edges come from the vertices as they are: moving the origin to the first would round, scaling does not.
  for (Point& p : corners)
    for (int i = 0; i < 3; ++i) p[i] = std::ldexp(p[i], -local_.exponent);
  const std::vector<SharedEdge> edges = edges_of(facets);
  link_neighbours(edges);
  make_table(count);
  const auto corner = [&](Index i) -> const Point& { return corners[i]; };
  for (const Triangle& f : facets) normals_.push_back(unit_normal(corner(f[0]), corner(f[1]), corner(f[2])));
  count.count(Operation::kSquareRoots, 4 * static_cast<std::int64_t>(facets.size()));
  count.count(Operation::kOrientationTests, static_cast<std::int64_t>(edges.size()));
  for (const SharedEdge& e : edges) {
    const Triangle& f = facets[e.left];
    if (orient3d(corner(f[0]), corner(f[1]), corner(f[2]), corner(e.beyond)) == 0) continue;
    edges_.push_back(e.edge);
    count.count(Operation::kSquareRoots, 1);
    add_arc(unit<3>(corner(e.edge[1]) - corner(e.edge[0])), e.left, e.right, count);
  }
}

template <class Edges>
void HullSolid::link_neighbours(const Edges& edges) {
  neighbours_from_.assign(vertices().size() + 1, 0);
  for (const SharedEdge& e : edges)
    for (const Index v : e.edge) ++neighbours_from_[v + 1];
  std::partial_sum(neighbours_from_.begin(), neighbours_from_.end(), neighbours_from_.begin());
  neighbours_.resize(2 * edges.size());
  std::vector<std::size_t> next(neighbours_from_.begin(), neighbours_from_.end() - 1);
  for (const SharedEdge& e : edges)
    for (const auto& [v, other] : {e.edge, HullSolid::Edge{e.edge[1], e.edge[0]}})
      neighbours_[next[v]++] = {other, e.left, e.right};
}

Vector<double, 3> HullSolid::table_direction(int face, int row, int column) const {
  const auto place = [&](int cell) { return (2 * cell + 1) / static_cast<double>(cells_) - 1; };
  Point direction;
  direction[face / 2] = face % 2 == 0 ? 1 : -1;
  direction[(face / 2 + 1) % 3] = place(row);
  direction[(face / 2 + 2) % 3] = place(column);
  return direction;
}

template <class Count>
void HullSolid::make_table(Count& count) {
  // About as many cells as vertices, so that few vertices share a cell.
  cells_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(vertices().size()))), 8, 64);
  table_.reserve(6 * cells_ * cells_);
  Index at = 0;
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < cells_; ++row)
      for (int column = 0; column < cells_; ++column)
        table_.push_back(at = farthest(table_direction(face, row, column), at, count));
}

template <class Count>
void HullSolid::add_arc(const Point& along, Index from, Index to, Count& count) {
  const Point a = normals_[from], b = normals_[to];
  const double cosine = a.dot(b);
  count.count(Operation::kDotProducts, 1);
  count.count(Operation::kSquareRoots, 1);
  if (cosine < 0.5) {
    // If the normals are nearly opposite, their difference gives the middle more precisely than their sum.
    normals_.push_back(unit<3>(cosine > 0 ? Point(a + b) : Point(along.cross(a - b))));
    const auto middle = static_cast<Index>(normals_.size() - 1);
    add_arc(along, from, middle, count);
    add_arc(along, middle, to, count);
    return;
  }
  const auto edge = static_cast<Index>(edges_.size() - 1);
  const Index opposite = farthest(-(a + b), far(-(a + b)), count);
  const Index first = edges_.back()[0];
  arcs_.push_back({edge, from, to, a, b, (b - a).norm(), opposite, at(first) - at(opposite)});
}

template <class Count>
Index HullSolid::farthest(const Point& direction, Index near, Count& count) const {
  double most = direction.dot(at(near));
  count.count(Operation::kPointsTouched, 1);
  count.count(Operation::kDotProducts, 1);
  for (bool climbing = true; climbing;) {
    climbing = false;
    const std::span<const Neighbour> around = neighbours(near);
    for (const Operation each : {Operation::kPointsTouched, Operation::kDotProducts, Operation::kComparisons})
      count.count(each, std::ssize(around));
    for (const Neighbour& next : around) {
      const double reach = direction.dot(at(next.vertex));
      if (!(reach > most)) continue;
      most = reach;
      near = next.vertex;
      climbing = true;
    }
  }
  return near;
}

// The outline is a closed curve, so all its vertices can be reached from one of them along its edges and the sides of
// faces parallel to the direction.
template <class Count>
std::vector<Index> HullSolid::outline(const Point& direction, Count& count) const {
  const auto turned = [&](Index facet) { return direction.dot(normals_[facet]); };
  const Point across = direction.cross(axis_across<3>(direction));
  std::vector<Index> found{farthest(across, far(across), count)};
  std::vector<bool> seen(vertices().size());
  seen[found[0]] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::span<const Neighbour> around = neighbours(found[i]);
    count.count(Operation::kPointsTouched, std::ssize(around));
    count.count(Operation::kDotProducts, 2 * std::ssize(around));
    count.count(Operation::kComparisons, 2 * std::ssize(around));
    for (const Neighbour& next : around) {
      const double left = turned(next.left), right = turned(next.right);
      if (std::min(left, right) > tolerance::kOnOutline || std::max(left, right) < -tolerance::kOnOutline) continue;
      if (seen[next.vertex]) continue;
      seen[next.vertex] = true;
      found.push_back(next.vertex);
    }
  }
  return found;
}

Index HullSolid::far(const Point& direction) const {
  int axis = 0;
  const double largest = direction.cwiseAbs().maxCoeff(&axis);
  if (!(largest > 0)) return table_.front();  // (0, 0, 0): any vertex will do
  const auto cell = [&](int side) {
    const double place = (direction[(axis + side) % 3] / largest + 1) / 2 * cells_;
    return std::clamp(static_cast<int>(place), 0, cells_ - 1);
  };
  const int face = 2 * axis + (direction[axis] > 0 ? 0 : 1);
  return table_[(face * cells_ + cell(1)) * cells_ + cell(2)];
}

#define SNUG_INSTANTIATE(Count)                                                                                        \
  template void HullSolid::build(Corners, const std::vector<Triangle>&, Count&);                                       \
  template Index HullSolid::farthest(const Vector<double, 3>&, Index, Count&) const;                                   \
  template std::vector<Index> HullSolid::outline(const Vector<double, 3>&, Count&) const;
SNUG_INSTANTIATE(Ignore)
SNUG_INSTANTIATE(PartCounter)
#undef SNUG_INSTANTIATE

}  // namespace snug::fit
