#include "fit/kdop/kdop_by_hand.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "fit/hull/quickhull.hpp"
#include "geometry/tolerance.hpp"
#include "query/contain/contains_hull.hpp"

namespace snug::fit {
namespace {

constexpr double kNoPoint = 1e-8;  // planes whose determinant is smaller have no point in common that a body needs

/// Calls with every choice of Dim of n things, in rising order.
template <int Dim, class Call>
void each_choice(int n, Call call) {
  std::array<int, Dim> chosen{};
  const auto choose = [&](auto&& self, int place, int from) -> void {
    if (place == Dim) return call(chosen);
    for (int i = from; i < n; ++i) {
      chosen[place] = i;
      self(self, place + 1, i + 1);
    }
  };
  choose(choose, 0, 0);
}

template <int Dim>
Matrix<double, Dim> axes_in_rows(const std::array<int, Dim>& chosen, auto&& axis_at) {
  Matrix<double, Dim> rows;
  for (int i = 0; i < Dim; ++i) rows.row(i) = axis_at(chosen[i]).transpose();
  return rows;
}

/// The points where Dim of the slabs' planes meet and which all slabs contain. widen: how far each bound is moved out.
template <int Dim>
std::vector<Vector<double, Dim>> meeting_points(std::span<const FreeSlab<Dim>> slabs, double widen) {
  std::vector<Vector<double, Dim>> vertices;
  const auto contained = [&](const Vector<double, Dim>& p) {
    return std::all_of(slabs.begin(), slabs.end(), [&](const FreeSlab<Dim>& slab) {
      const double at = slab.axis.dot(p);
      return at >= slab.min - 2 * widen && at <= slab.max + 2 * widen;
    });
  };
  const auto known = [&](const Vector<double, Dim>& p) {
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](const auto& own) { return (own - p).cwiseAbs().maxCoeff() <= 8 * widen; });
  };
  each_choice<Dim>(static_cast<int>(slabs.size()), [&](const std::array<int, Dim>& chosen) {
    const Matrix<double, Dim> rows = axes_in_rows<Dim>(chosen, [&](int i) { return slabs[i].axis; });
    if (!(std::abs(rows.determinant()) > kNoPoint)) return;
    const Matrix<double, Dim> inverse = rows.inverse();
    for (int sides = 0; sides < 1 << Dim; ++sides) {
      Vector<double, Dim> bounds;
      for (int i = 0; i < Dim; ++i) {
        const FreeSlab<Dim>& slab = slabs[chosen[i]];
        bounds[i] = (sides >> i & 1) != 0 ? slab.max + widen : slab.min - widen;
      }
      const Vector<double, Dim> p = inverse * bounds;
      if (contained(p) && !known(p)) vertices.push_back(p);
    }
  });
  return vertices;
}

}  // namespace

template <int Dim>
double enclosing(std::span<const Vector<double, Dim>> axes) {
  double best = 0;
  each_choice<Dim>(static_cast<int>(axes.size()), [&](const std::array<int, Dim>& chosen) {
    best = std::max(best, std::abs(axes_in_rows<Dim>(chosen, [&](int i) { return axes[i]; }).determinant()));
  });
  return best;
}

template <int Dim>
std::optional<ConvexHull<double, Dim>> within_slabs(std::span<const FreeSlab<Dim>> slabs,
                                                    PointSpan<double, Dim> points) {
  std::vector<Vector<double, Dim>> axes;
  for (const FreeSlab<Dim>& slab : slabs) axes.push_back(slab.axis);
  if (enclosing<Dim>(axes) < kLeastEnclosing) return std::nullopt;
  double size = std::numeric_limits<double>::min();
  for (const auto& p : points) size = std::max(size, p.cwiseAbs().maxCoeff());
  // Two planes that are nearly parallel meet in a point that is off by more than the bounds are, so that how far to
  // widen is found by trying.
  for (double widen = tolerance::kKdopCorner<double> * size; widen < size; widen *= 16) {
    auto set = PointSet<double, Dim>::make(meeting_points<Dim>(slabs, widen));
    if (!set) continue;
    ConvexHull<double, Dim> volume = quickhull(set->span()).volume;
    volume.indices.clear();  // its vertices are not points of the set
    if (std::all_of(points.begin(), points.end(), [&](const auto& p) { return query::contains(volume, p); }))
      return volume;
  }
  return quickhull(points).volume;  // a single point at the origin; or vertices too far out for any point set
}

template double enclosing<2>(std::span<const Vector<double, 2>>);
template double enclosing<3>(std::span<const Vector<double, 3>>);
template std::optional<ConvexHull<double, 2>> within_slabs(std::span<const FreeSlab<2>>, PointSpan<double, 2>);
template std::optional<ConvexHull<double, 3>> within_slabs(std::span<const FreeSlab<3>>, PointSpan<double, 3>);

}  // namespace snug::fit
