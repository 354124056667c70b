#include "fit/hull/quickhull_surface.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/orientation.hpp"
#include "geometry/tolerance.hpp"
#include "number/power_of_two.hpp"
#include "number/tuple.hpp"

namespace snug::fit {
namespace {

/// The mark on a facet that was tested against an eye.
std::uint32_t mark_of(Index eye, bool sees) { return 2 * static_cast<std::uint32_t>(eye) + (sees ? 3 : 2); }

}  // namespace

template <class Scalar>
HullSurface<Scalar>::HullSurface(PointSpan<Scalar, 3> points) : points_(points) {
  Vector<Scalar, 3> least = points[0], greatest = points[0];
  for (const auto& p : points) {
    least = least.cwiseMin(p);
    greatest = greatest.cwiseMax(p);
  }
  const Vector<double, 3> low = least.template cast<double>(), high = greatest.template cast<double>();
  const Vector<double, 3> middle = low / 2 + high / 2;
  Vector<double, 3> scale;
  for (int axis = 0; axis < 3; ++axis) {
    const double reach = std::max(high[axis] - middle[axis], middle[axis] - low[axis]);
    scale[axis] = reach == 0 ? 1 : to_unit_size(reach) / 2;
  }
  sites_.resize(points.size());
  for (Index i = 0; i < points.size(); ++i)
    site(i).position = (points[i].template cast<double>() - middle).cwiseProduct(scale);
}

template <class Scalar>
void HullSurface<Scalar>::put_plane(Facet& facet) const {
  const Vector<double, 3>& a = site(facet.vertices[0]).position;
  const Vector<double, 3> e = site(facet.vertices[1]).position - a;
  const Vector<double, 3> f = site(facet.vertices[2]).position - a;
  facet.normal = cross(e, f);
  facet.offset = -(facet.normal[0] * a[0] + facet.normal[1] * a[1] + facet.normal[2] * a[2]);
  const double size = e.cwiseAbs().maxCoeff() + f.cwiseAbs().maxCoeff();
  facet.error_bound = tolerance::kFacetPlane * (size + tolerance::kRoundoff<double>);
}

template <class Scalar>
double HullSurface<Scalar>::height(const Facet& facet, Index point) const {
  const Vector<double, 3>& p = site(point).position;
  return facet.normal[0] * p[0] + facet.normal[1] * p[1] + facet.normal[2] * p[2] + facet.offset;
}

template <class Scalar>
bool HullSurface<Scalar>::sees(const Facet& facet, double height, Index point) const {
  if (height > facet.error_bound) return true;
  return height >= -facet.error_bound && side_exact(facet, point) > 0;
}

template <class Scalar>
int HullSurface<Scalar>::side_exact(const Facet& facet, Index point) const {
  const auto at = [this](Index i) -> Vector<double, 3> { return points_[i].template cast<double>(); };
  return orient3d(at(facet.vertices[0]), at(facet.vertices[1]), at(facet.vertices[2]), at(point));
}

template <class Scalar>
bool HullSurface<Scalar>::flat(Index f, int edge) const {
  const Index g = facet(f).across[edge];
  const auto& corners = facet(g).vertices;
  const Index from = facet(f).vertices[edge];
  const auto at = static_cast<std::size_t>(facet(g).corner_of(from));
  const Index apex = corners[(at + 1) % 3];  // g has the edge the other way round, ending at from
  return height(facet(f), apex) >= -facet(f).error_bound && side_exact(facet(f), apex) == 0;
}

template <class Scalar>
Index HullSurface<Scalar>::add_facet(const std::array<Index, 3>& vertices) {
  Index place = static_cast<Index>(facets_.size());
  if (free_.empty()) {
    facets_.emplace_back();
  } else {
    place = free_.back();
    free_.pop_back();
  }
  Facet& fresh = facet(place);
  fresh.vertices = vertices;
  fresh.height = 0;
  fresh.farthest = kNoIndex;
  fresh.count = 0;
  fresh.seen = 0;
  put_plane(fresh);
  return place;
}

/// Assigns the point to the first of the facets that sees it; drops it if none does. A list's head is its farthest
/// point (of equally far ones, the first in the set), so that of coincident points the first is taken.
template <class Scalar>
void HullSurface<Scalar>::give(Index point, const std::vector<Index>& to) {
  for (const Index f : to) {
    Facet& owner = facet(f);
    const double h = height(owner, point);
    ++tests_;
    if (!sees(owner, h, point)) continue;
    if (owner.count++ == 0) queue_.push_back(f);
    const bool leads = owner.farthest == kNoIndex || h > owner.height || (h == owner.height && point < owner.farthest);
    if (leads) {
      site(point).next = owner.farthest;
      owner.farthest = point;
      owner.height = h;
    } else {
      site(point).next = site(owner.farthest).next;
      site(owner.farthest).next = point;
    }
    return;
  }
  dropped_.push_back(point);
}

template <class Scalar>
void HullSurface<Scalar>::append_outside(Index f, std::vector<Index>& list) const {
  for (Index i = facet(f).farthest; i != kNoIndex; i = site(i).next) list.push_back(i);
}

template <class Scalar>
void HullSurface<Scalar>::start(std::array<Index, 4>& simplex) {
  const auto at = [&](std::size_t i) -> Vector<double, 3> { return points_[simplex[i]].template cast<double>(); };
  if (orient3d(at(0), at(1), at(2), at(3)) > 0) std::swap(simplex[2], simplex[3]);
  const auto [a, b, c, d] = simplex;
  // Facet i leaves out vertex i, so the facet across an edge is the one that leaves out the third vertex.
  const std::array<std::array<Index, 3>, 4> vertices{{{b, d, c}, {a, c, d}, {a, d, b}, {a, b, c}}};
  const std::array<std::array<Index, 3>, 4> across{{{2, 1, 3}, {3, 0, 2}, {1, 0, 3}, {2, 0, 1}}};
  added_.clear();
  for (std::size_t i = 0; i < 4; ++i) {
    added_.push_back(add_facet(vertices[i]));
    facets_[i].across = across[i];
  }
  dropped_.clear();
  for (Index i = 0; i < points_.size(); ++i)
    if (i != a && i != b && i != c && i != d) give(i, added_);
}

template <class Scalar>
Index HullSurface<Scalar>::next_open() {
  while (queue_at_ < queue_.size()) {
    const Index f = queue_[queue_at_++];
    if (facet(f).farthest != kNoIndex) return f;
  }
  return kNoIndex;
}

template <class Scalar>
void HullSurface<Scalar>::find_horizon(Index seeing) {
  eye_ = facet(seeing).farthest;
  visible_.assign(1, seeing);
  border_.clear();
  facet(seeing).seen = mark_of(eye_, true);
  for (std::size_t i = 0; i < visible_.size(); ++i) {
    const Facet& from = facet(visible_[i]);
    for (std::size_t e = 0; e < 3; ++e) {
      const Index g = from.across[e];
      Facet& neighbor = facet(g);
      if (neighbor.seen == mark_of(eye_, true)) continue;
      if (neighbor.seen != mark_of(eye_, false)) {
        const bool sees_eye = sees(neighbor, height(neighbor, eye_), eye_);
        ++tests_;
        neighbor.seen = mark_of(eye_, sees_eye);
        if (sees_eye) {
          visible_.push_back(g);
          continue;
        }
      }
      const Index to = from.vertices[(e + 1) % 3];
      border_.push_back({from.vertices[e], to, g, neighbor.corner_of(to)});
    }
  }
  order_border();
}

/// The horizon is one ring: each of its points starts one edge.
template <class Scalar>
void HullSurface<Scalar>::order_border() {
  for (std::size_t i = 0; i < border_.size(); ++i) site(border_[i].from).border = static_cast<Index>(i);
  border_scratch_.clear();
  Index at = 0;
  do {
    border_scratch_.push_back(border_[at]);
    at = site(border_scratch_.back().to).border;
  } while (at != 0);
  border_.swap(border_scratch_);
}

template <class Scalar>
std::vector<Index> HullSurface<Scalar>::horizon() const {
  std::vector<Index> ring;
  for (const BorderEdge& edge : border_) ring.push_back(edge.from);
  return ring;
}

template <class Scalar>
void HullSurface<Scalar>::gather_points() {
  orphans_.clear();
  for (const Index f : visible_)
    for (Index i = facet(f).farthest; i != kNoIndex; i = site(i).next)
      if (i != eye_) orphans_.push_back(i);
}

template <class Scalar>
void HullSurface<Scalar>::remove_visible() {
  for (const Index f : visible_) {
    facet(f).vertices[0] = kNoIndex;
    facet(f).farthest = kNoIndex;
    free_.push_back(f);
  }
}

template <class Scalar>
void HullSurface<Scalar>::raise_cone() {
  gather_points();
  remove_visible();
  added_.clear();
  for (const BorderEdge& edge : border_) {
    const Index f = add_facet({edge.from, edge.to, eye_});
    facet(f).across[0] = edge.beyond;
    facet(edge.beyond).across[edge.edge] = f;
    added_.push_back(f);
  }
  const std::size_t n = added_.size();
  for (std::size_t i = 0; i < n; ++i) {
    facet(added_[i]).across[1] = added_[(i + 1) % n];
    facet(added_[i]).across[2] = added_[(i + n - 1) % n];
  }
  dropped_.clear();
  for (const Index point : orphans_) give(point, added_);
}

template class HullSurface<float>;
template class HullSurface<double>;

}  // namespace snug::fit
