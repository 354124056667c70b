#include "core/fit/families.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

#include "core/query/box_pairs.hpp"

namespace snug::test {
namespace {

/// 10^exponent, rounded once; std::pow differs between C libraries.
double ten_to(int exponent) { return std::strtod(("1e" + std::to_string(exponent)).c_str(), nullptr); }

/// Draws members in double; they are rounded to their scalar in the end. An expression draws once at most: compilers
/// evaluate operands and arguments in orders of their own, and the members shall be the same everywhere.
template <int Dim>
struct Draw {
  using Point = Vector<double, Dim>;
  using Points = std::vector<Point>;

  Random random;
  bool is_float;

  /// A part of the set's size that is 1e-exponent in double.
  [[nodiscard]] double part(int exponent) const { return is_float ? std::sqrt(ten_to(-exponent)) : ten_to(-exponent); }
  int whole(int most) { return static_cast<int>(random.below(2u * static_cast<unsigned>(most) + 1)) - most; }
  int count(int least = 3, int most = 8) {
    return least + static_cast<int>(random.below(static_cast<unsigned>(most - least + 1)));
  }
  bool coin() { return random.below(2) == 0; }
  Point any(double size = 1) { return any_vector<Dim>(random, size); }
  Point any_whole(int most) {
    Point p;
    for (int i = 0; i < Dim; ++i) p[i] = whole(most);
    return p;
  }
  Point on_sphere() {
    for (;;) {
      const Point p = any();
      if (p.squaredNorm() > 0.01 && p.squaredNorm() < 1) return p / p.norm();
    }
  }
  /// So many points, each drawn anew.
  Points points(int n, auto&& point) {
    Points all;
    for (int i = 0; i < n; ++i) all.push_back(point());
    return all;
  }
  Points points(auto&& point) { return points(count(), point); }
  Points turned(Points all, double size = 1) {
    const Matrix<double, Dim> turn = any_turn<Dim>(random);
    for (Point& p : all) p = turn * p * size;
    return all;
  }
  void shuffle(Points& all) {
    for (std::size_t i = all.size(); i > 1; --i)
      std::swap(all[i - 1], all[random.below(static_cast<std::uint32_t>(i))]);
  }
  /// The corners of a box, some left out.
  Points box(const Point& half_extents) {
    Points all;
    for (unsigned corner = 0; corner < 1u << Dim; ++corner) {
      if (all.size() > Dim && random.below(8) == 0) continue;
      Point p = half_extents;
      for (int i = 0; i < Dim; ++i)
        if ((corner >> i & 1) != 0) p[i] = -p[i];
      all.push_back(p);
    }
    shuffle(all);
    return all;
  }
  Points jittered(Points all, double by) {
    for (Point& p : all) p += any(by);
    return all;
  }
  Points near_line(double by) {
    const Point from = any(), along = any();
    return jittered(points([&] { return Point(from + along * random.between(-1, 1)); }), by);
  }
  /// Whole numbers in any order and with any signs: all as far from the origin, exactly.
  Points cospherical(int n) {
    constexpr int kSides[4][3] = {{7, 4, 4}, {1, 4, 8}, {8, 1, 4}, {0, 0, 9}};  // 81 in space
    constexpr int kLegs[4][2] = {{25, 0}, {15, 20}, {7, 24}, {24, 7}};          // 625 in the plane
    const Point about = any_whole(3);
    return points(n, [&] {
      Point p;
      const auto row = random.below(4);
      for (int i = 0; i < Dim; ++i) {
        if constexpr (Dim == 3) p[i] = kSides[row][i];
        else p[i] = kLegs[row][i];
        if (coin()) p[i] = -p[i];
      }
      std::swap(p[0], p[static_cast<int>(random.below(Dim))]);
      return Point(p + about);
    });
  }
  Points circle(int n) {
    Matrix<double, Dim> turn = Matrix<double, Dim>::Identity();
    if constexpr (Dim == 3) turn = any_turn<3>(random);
    return points(n, [&] {
      Vector<double, 2> p;
      do p = any_vector<2>(random);
      while (p.squaredNorm() > 1 || p.squaredNorm() < 0.01);
      p /= p.norm();
      return Point(turn.col(0) * p[0] + turn.col(1) * p[1]);
    });
  }
  Points cap(double angle) {
    const Matrix<double, Dim> turn = any_turn<Dim>(random);
    return points(count(Dim + 1, 8), [&] {
      Point p = any(angle);
      p[Dim - 1] = 0;
      p[Dim - 1] = 1 - p.squaredNorm() / 2;
      return Point(turn * p);
    });
  }
  Points far_sphere(double away) {
    const Point about = on_sphere() * away;
    return points([&] { return Point(about + on_sphere()); });
  }
  Points regular(int corners) {
    Points all;
    for (int i = 0; i < corners; ++i) {
      const Matrix<double, 2> turn = snug::turn(2 * std::numbers::pi * i / corners);
      Point p = Point::Zero();
      p[0] = turn(0, 0), p[1] = turn(1, 0);
      all.push_back(p);
    }
    return all;
  }
  Points platonic() {
    const double size = random.between(0.5, 2);
    if constexpr (Dim == 2) return turned(regular(count(3, 12)), size);
    else {
      const double golden = (1 + std::sqrt(5.0)) / 2;
      Points all;
      const auto add = [&](double x, double y, double z) {  // with all signs, in cyclic order
        for (unsigned signs = 0; signs < 8; ++signs) {
          if ((x == 0 && (signs & 1) != 0) || (y == 0 && (signs & 2) != 0) || (z == 0 && (signs & 4) != 0)) continue;
          const Point p((signs & 1) != 0 ? -x : x, (signs & 2) != 0 ? -y : y, (signs & 4) != 0 ? -z : z);
          all.emplace_back(p);
          if (x == y && y == z) continue;
          all.emplace_back(p[1], p[2], p[0]);
          all.emplace_back(p[2], p[0], p[1]);
        }
      };
      switch (random.below(5)) {
        case 0: all = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; break;
        case 1: add(1, 1, 1); break;
        case 2: add(1, 0, 0); break;
        case 3: add(0, 1, golden); break;
        default: add(1, 1, 1), add(0, 1 / golden, golden); break;
      }
      return turned(std::move(all), size);
    }
  }
  Points prism() {
    Points all = regular(32);
    const std::size_t sides = all.size();
    for (std::size_t i = 0; i < sides; ++i) {
      all.push_back(all[i]);
      all[i][Dim - 1] -= 1, all.back()[Dim - 1] += 1;
    }
    return turned(std::move(all));
  }
  Points scaled() {
    const int exponent = is_float ? static_cast<int>(random.below(54)) - 37 : static_cast<int>(random.below(459)) - 307;
    const double size = ten_to(exponent);
    return points([&] { return any(size); });
  }
};

/// As thin as a part of the size that is 1e-exponent in double, but not flat.
template <int exponent>
bool thin(const Traits& t, bool is_float) {
  return t.hull_dim == t.dim && t.thickness < std::pow(10.0, is_float ? -exponent / 2.0 : -exponent);
}
bool round_to_ulps(const Traits& t, bool) { return t.on_sphere > t.support; }
bool nearly_round(const Traits& t, bool) { return t.near_sphere > t.support; }

constexpr std::array kFamilies{
    Family{"all equal", true, 1, 1, [](const Traits& t, bool) { return t.radius == 0 && t.hull_vertices == 1; }},
    Family{"two points", true, 1, 0.9, [](const Traits& t, bool) { return t.hull_vertices == 2 && t.support == 2; }},
    Family{"collinear", true, 1, 0.9, [](const Traits& t, bool) { return t.hull_dim == 1 && t.hull_vertices == 2; }},
    Family{"within 1e-9 of a line", true, 1, 0.7, thin<8>},
    Family{"within 1e-16 of a line", true, 1, 0.5,
           [](const Traits& t, bool f) {
             return t.hull_dim >= 2 &&
                    thin<14>({.dim = t.hull_dim, .hull_dim = t.hull_dim, .thickness = t.thickness}, f);
           }},
    Family{"coplanar, tilted", false, 1, 0.8, [](const Traits& t, bool) { return t.hull_dim == 2; }},
    Family{"within 1e-16 of a plane", false, 1, 0.5, thin<14>},
    Family{"cospherical", true, 1, 0.5, round_to_ulps},
    Family{"cospherical within 1e-12", true, 1, 0.5, nearly_round},
    Family{"cospherical within 1e-15", true, 1, 0.5, round_to_ulps},
    Family{"on a circle", true, 1, 0.3, round_to_ulps},
    Family{"corners of a cube, twice each", true, 1, 0.9, round_to_ulps},
    Family{"whole numbers from -2 to 2", true, 1, 0.2,
           [](const Traits& t, bool) {
             return t.on_sphere > t.support || t.hull_dim < t.dim || t.hull_vertices < t.points;
           }},
    Family{"antipodal pairs", true, 1, 0.9, round_to_ulps},
    Family{"two clusters 1e-8 wide", true, 1, 0.8,
           [](const Traits& t, bool f) { return t.thickness < (f ? 1e-3 : 1e-7); }},
    Family{"a cap of 1e-4", true, 1, 0.9, [](const Traits& t, bool f) { return t.thickness < (f ? 1e-1 : 1e-3); }},
    Family{"a cap of 1e-7", true, 1, 0.9, [](const Traits& t, bool f) { return t.thickness < (f ? 1e-2 : 1e-6); }},
    Family{"a unit sphere 1e6 away", true, 1, 1,
           [](const Traits& t, bool f) { return t.farthest > (f ? 5e2 : 5e5) * t.radius; }},
    Family{"a unit sphere 1e9 away", true, 1, 1,
           [](const Traits& t, bool f) { return t.farthest > (f ? 1.5e4 : 5e8) * t.radius; }},
    // A PointSet takes coordinates up to 2^508, about 8e152; normal numbers end at 2e-308.
    Family{"scales from 1e-307 to 1e151", true, 1, 0.8,
           [](const Traits& t, bool f) { return t.radius < (f ? 1e-2 : 1e-20) || t.radius > (f ? 1e2 : 1e20); }},
    Family{"one far outlier", true, 1, 0.9, [](const Traits& t, bool) { return t.support == 2 && t.farthest > 100; }},
    Family{"platonic solids", true, 1, 0.6, round_to_ulps},
    Family{"a prism of 64", false, 100, 1, round_to_ulps},
    Family{"needles", true, 1, 0.9, [](const Traits& t, bool) { return t.thickness < 1e-4; }},
    Family{"flat boxes", true, 1, 0.9, [](const Traits& t, bool) { return t.thickness < 1e-5; }},
    Family{"slivers", true, 1, 0.9, [](const Traits& t, bool f) { return t.thickness < (f ? 1e-3 : 1e-7); }},
};

template <int Dim>
std::vector<Vector<double, Dim>> drawn(std::size_t family, Draw<Dim>& d) {
  using Point = Vector<double, Dim>;
  const auto extents = [](double y, double z) {
    Point half = Point::Constant(z);
    half[0] = 1;
    if constexpr (Dim == 3) half[1] = y;
    return half;
  };
  switch (family) {
    case 0: {
      const int n = d.count(2);
      return std::vector<Point>(static_cast<std::size_t>(n), d.any());
    }
    case 1: {
      const Point a = d.any(), b = d.any();
      auto all = d.points([&] { return d.coin() ? a : b; });
      all.front() = a, all.back() = b;
      return all;
    }
    case 2: {
      const Point from = d.any_whole(9);
      Point along = d.any_whole(5);
      if (along.isZero()) along[0] = 1;
      auto all = d.points([&] { return Point(from + along * d.whole(6)); });
      all.front() = from - along * 7;
      return all;
    }
    case 3: return d.near_line(d.part(9));
    case 4: return d.near_line(d.part(16));
    case 5: {
      const Point from = d.any_whole(9), u = d.any_whole(5), v = d.any_whole(5);
      return d.points(d.count(4, 8), [&] {
        const int along_u = d.whole(6), along_v = d.whole(6);
        return Point(from + u * along_u + v * along_v);
      });
    }
    case 6: {
      const Point from = d.any(), u = d.any(), v = d.any();
      const auto flat = d.points(d.count(5, 8), [&] {
        const double along_u = d.random.between(-1, 1), along_v = d.random.between(-1, 1);
        return Point(from + u * along_u + v * along_v);
      });
      return d.jittered(flat, d.part(16));
    }
    case 7: return d.cospherical(d.count(6, 10));
    case 8: return d.jittered(d.points(d.count(6, 10), [&] { return d.on_sphere(); }), d.part(12));
    case 9: return d.jittered(d.points(d.count(6, 10), [&] { return d.on_sphere(); }), d.part(15));
    case 10: return d.circle(d.count(5, 9));
    case 11: {
      auto all = d.box(Point::Constant(d.random.between(0.5, 2)));
      const auto once = all;
      all.insert(all.end(), once.begin(), once.end());
      d.shuffle(all);
      return all;
    }
    case 12: return d.points(d.count(3, 10), [&] { return d.any_whole(2); });
    case 13: {
      std::vector<Point> all;
      for (int i = d.count(2, 4); i > 0; --i) {
        all.push_back(d.on_sphere());
        all.emplace_back(-all.back());
      }
      d.shuffle(all);
      return all;
    }
    case 14: {
      const Point a = d.any(), b = d.any();
      return d.points(d.count(4, 8), [&] {
        const Point& cluster = d.coin() ? a : b;
        return Point(cluster + d.any(d.part(8)));
      });
    }
    case 15: return d.cap(d.part(4));
    case 16: return d.cap(d.part(7));
    case 17: return d.far_sphere(1 / d.part(6));
    case 18: return d.far_sphere(1 / d.part(9));
    case 19: return d.scaled();
    case 20: {
      auto all = d.points(d.count(4, 8), [&] { return d.any(); });
      Point& outlier = all[d.random.below(static_cast<std::uint32_t>(all.size()))];
      outlier = d.on_sphere();
      outlier *= ten_to(3 + static_cast<int>(d.random.below(9)));
      return all;
    }
    case 21: return d.platonic();
    case 22: return d.prism();
    case 23: return d.turned(d.box(extents(1e-6, 1e-6)));
    case 24: return d.turned(d.box(extents(0.5, 0)));
    default: return d.turned(d.box(extents(1e-4, d.part(9))));
  }
}
static_assert(kFamilies.size() == 26);

}  // namespace

std::span<const Family> families() { return kFamilies; }

template <class Scalar, int Dim>
Cloud<Scalar, Dim> member(std::size_t family, std::uint64_t seed) {
  constexpr bool kFloat = sizeof(Scalar) == 4;
  Draw<Dim> draw{Random(seed * 64 + family), kFloat};
  Cloud<Scalar, Dim> points;
  for (const auto& p : drawn<Dim>(family, draw)) points.push_back(p.template cast<Scalar>());
  return points;
}

template Cloud<float, 2> member(std::size_t, std::uint64_t);
template Cloud<float, 3> member(std::size_t, std::uint64_t);
template Cloud<double, 2> member(std::size_t, std::uint64_t);
template Cloud<double, 3> member(std::size_t, std::uint64_t);

}  // namespace snug::test
