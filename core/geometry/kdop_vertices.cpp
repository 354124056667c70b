// Each edge is the line where two boundary planes meet (in 2-D, a boundary line), clipped by all other slabs. The
// vertices are the ends of the edges. Source of the clipping: M. Cyrus, J. Beck, "Generalized two- and
// three-dimensional clipping", 1978.
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/kdop.hpp"
#include "geometry/tolerance.hpp"
#include "number/double_double.hpp"

namespace snug {
namespace {

template <int Dim>
using SlabAxis = std::array<int, Dim>;

template <int Dim>
double along(const SlabAxis<Dim>& axis, const Vector<double, Dim>& v) {
  double sum = 0;
  for (std::size_t i = 0; i < Dim; ++i) sum += axis[i] * v[static_cast<int>(i)];
  return sum;
}

template <int Dim>
Vector<double, Dim> vector_of(const SlabAxis<Dim>& axis) {
  Vector<double, Dim> v;
  for (std::size_t i = 0; i < Dim; ++i) v[static_cast<int>(i)] = axis[i];
  return v;
}

/// The boundary planes that determine a line. A plane's index is twice that of its axis, plus one for max.
template <int Dim>
using Planes = std::array<int, Dim - 1>;

template <int Dim>
struct Line {
  Vector<double, Dim> point;
  Vector<double, Dim> direction;  // small integers
};

template <class Scalar, int Dim>
class VertexSearch {
 public:
  VertexSearch(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& origin) : axes_(kdop_axes<Dim>(kdop.k)) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      DoubleDouble moved;
      for (std::size_t j = 0; j < Dim; ++j) moved += axes_[i][j] * static_cast<double>(origin[static_cast<int>(j)]);
      for (const std::size_t side : {0u, 1u}) {
        const auto bound = static_cast<double>(side == 0 ? kdop.min[i] : kdop.max[i]);
        bounds_[2 * i + side] = (DoubleDouble(bound) - moved).value();
        size_ = std::max(size_, std::abs(bounds_[2 * i + side]));
        given_size_ = std::max(given_size_, std::abs(bound));
      }
    }
  }

  std::vector<Vector<double, Dim>> find() {
    clip_all(tolerance::kKdopCorner<double> * size_);
    // The slabs of a flat k-DOP are rounded one by one, and may miss each other by that much.
    if (corners_.empty()) clip_all(static_cast<double>(tolerance::kKdopCorner<Scalar>) * given_size_);
    return std::move(corners_);
  }

 private:
  [[nodiscard]] const SlabAxis<Dim>& axis(int plane) const { return axes_[plane / 2]; }
  [[nodiscard]] double bound(int plane) const { return bounds_[plane]; }

  /// The line where the planes meet: its point nearest to the origin, and its direction.
  [[nodiscard]] Line<Dim> line_of(const Planes<Dim>& planes) const {
    const Vector<double, Dim> n = vector_of<Dim>(axis(planes[0]));
    if constexpr (Dim == 2) {
      return {n * (bound(planes[0]) / n.squaredNorm()), {-n[1], n[0]}};
    } else {
      const Vector<double, 3> m = vector_of<Dim>(axis(planes[1]));
      const Vector<double, 3> direction = n.cross(m);
      const Vector<double, 3> point = bound(planes[0]) * m.cross(direction) + bound(planes[1]) * direction.cross(n);
      return {point / direction.squaredNorm(), direction};
    }
  }

  void clip_all(double slack) {
    slack_ = slack;
    const int planes = 2 * static_cast<int>(axes_.size());
    for (int i = 0; i < planes; ++i) {
      if constexpr (Dim == 2) {
        clip({i});
      } else {
        for (int j = 2 * (i / 2) + 2; j < planes; ++j) clip({i, j});
      }
    }
  }

  void clip(const Planes<Dim>& planes) {
    const Line<Dim> line = line_of(planes);
    double from = -std::numeric_limits<double>::infinity();
    double to = -from;
    for (int slab = 0; slab < static_cast<int>(axes_.size()); ++slab) {
      if (std::any_of(planes.begin(), planes.end(), [&](int plane) { return plane / 2 == slab; })) continue;
      const double speed = along<Dim>(axis(2 * slab), line.direction);
      const double place = along<Dim>(axis(2 * slab), line.point);
      double enter = bound(2 * slab) - place;
      double leave = bound(2 * slab + 1) - place;
      if (speed == 0) {
        if (enter > slack_ || leave < -slack_) return;
        continue;
      }
      enter /= speed;
      leave /= speed;
      from = std::max(from, std::min(enter, leave));
      to = std::min(to, std::max(enter, leave));
      if (from > to + slack_) return;
    }
    if (from > to) from = to = from + (to - from) / 2;
    add(line.point + from * line.direction);
    add(line.point + to * line.direction);
  }

  void add(const Vector<double, Dim>& corner) {
    for (const auto& known : corners_)
      if ((known - corner).cwiseAbs().maxCoeff() <= slack_) return;
    corners_.push_back(corner);
  }

  std::span<const SlabAxis<Dim>> axes_;
  std::array<double, 2 * kMostSlabs<Dim>> bounds_{};
  double size_ = 0, given_size_ = 0;  // the largest bound, relative to the origin and as given
  double slack_ = 0;                  // what rounding may amount to
  std::vector<Vector<double, Dim>> corners_;
};

}  // namespace

template <class Scalar, int Dim>
Corners<Dim> kdop_vertices(const Kdop<Scalar, Dim>& kdop, const Vector<Scalar, Dim>& origin) {
  return VertexSearch<Scalar, Dim>(kdop, origin).find();
}

template Corners<2> kdop_vertices(const Kdop<float, 2>&, const Vector<float, 2>&);
template Corners<3> kdop_vertices(const Kdop<float, 3>&, const Vector<float, 3>&);
template Corners<2> kdop_vertices(const Kdop<double, 2>&, const Vector<double, 2>&);
template Corners<3> kdop_vertices(const Kdop<double, 3>&, const Vector<double, 3>&);

}  // namespace snug
