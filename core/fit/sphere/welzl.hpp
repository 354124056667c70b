// Welzl's smallest enclosing ball, the recursion written as a loop.
// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", 1991, with his move-to-front heuristic.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "fit/sphere/pivoting.hpp"
#include "fit/sphere/random_order.hpp"

namespace snug::fit {

inline constexpr std::array<std::string_view, 11> kWelzlPseudocode{
    "list ← the points in random order",
    "S ← solve(list, none fixed)",
    "test all points, exactly",
    "return S",
    "solve(list, fixed):",
    "  S ← smallest through the fixed points",
    "  for each point p in the list",
    "    if p lies outside S",
    "      S ← solve(before p, fixed + p)",
    "      move p to the front of the list",
    "  return S",
};

/// The state of one run: Welzl's recursion, at most Dim + 2 calls deep, however many points there are.
template <class Scalar, int Dim, class Observer>
class Welzl {
 public:
  Welzl(PointSpan<Scalar, Dim> points, Observer& observe)
      : points_(points), observe_(observe), pivoting_(points, {.tested = 2, .let_in = 2}, observe) {}

  Fit<Sphere<Scalar, Dim>> run(std::uint64_t seed) {
    list_ = random_order(points_.size(), seed);
    recursion();
    pivoting_.drop_idle_support(2);
    // In exact arithmetic no point is outside now. If rounding left one outside, pivoting lets it enter.
    const Fit<Sphere<Scalar, Dim>> fit = pivoting_.finish();
    observe_(Step{3, true, fit.volume, Finished{fit.support.list()}});
    return fit;
  }

 private:
  using Step = SphereStep<Scalar, Dim>;

  [[nodiscard]] bool outside(Index i, int depth) {
    const Scalar square = pivoting_.square_to(i);
    const bool out = !has_ball_ || pivoting_.outside(square);
    observe_.count(Operation::kPointsTouched, 1);
    observe_.count(Operation::kDistanceTests, has_ball_ ? 1 : 0);
    if constexpr (kWatched<Observer>)
      observe_(Step{out ? 7 : 6, has_ball_, pivoting_.current(),
                    PointExamined{i, has_ball_ ? std::sqrt(static_cast<double>(square)) : 0, out, depth}});
    return out;
  }

  // One call for each point fixed on the boundary. A call's list is the part of the list before the point that its
  // caller waits at, so the calls need no lists of their own.
  void recursion() {
    struct Call {
      std::size_t end;
      std::size_t next;
    };
    std::array<Call, Dim + 2> calls;
    std::array<Index, Dim + 1> boundary{};
    calls[0] = {list_.size(), 0};
    int depth = 0;
    for (;;) {
      Call& call = calls[depth];
      if (call.next == call.end || depth == Dim + 1) {
        if (depth == 0) return;
        --depth;
        move_to_front(calls[depth].next++, depth);
        continue;
      }
      const Index point = list_[call.next];
      if (!outside(point, depth)) {
        ++call.next;
        continue;
      }
      boundary[depth] = point;
      Support support;
      for (int i = 0; i <= depth; ++i) support.add(boundary[i]);
      const auto through = ball_through(points_, support);
      if (!through) {  // only rounding can leave a dependent point outside; the last test takes care of it
        ++call.next;
        continue;
      }
      pivoting_.take(*through);
      has_ball_ = true;
      observe_(Step{5, true, pivoting_.current(), BoundaryForced{support, depth + 1}});
      ++depth;
      calls[depth] = {call.next, 0};
    }
  }

  void move_to_front(std::size_t at, int depth) {
    const auto place = list_.begin() + static_cast<std::ptrdiff_t>(at);
    const Index point = *place;
    std::rotate(list_.begin(), place, place + 1);
    observe_(Step{9, true, pivoting_.current(), MovedToFront{point, depth}});
  }

  PointSpan<Scalar, Dim> points_;
  Observer& observe_;
  std::vector<Index> list_;
  Pivoting<Scalar, Dim, Observer> pivoting_;
  bool has_ball_ = false;
};

/// The smallest enclosing ball, by Welzl's move-to-front recursion over the points in random order.
/// points: n >= 1 finite points, scene units. Expected O(n) time; 4 n bytes for the list.
/// Where points are closer together than about 1e-154 (in float 1e-19), squared distances underflow: the sphere then
/// contains them all but need not be the smallest. The catalogue's rows enlarge such points first (tiny.hpp).
template <class Scalar, int Dim, StepObserver<SphereStep<Scalar, Dim>> Observer = Ignore>
Fit<Sphere<Scalar, Dim>> welzl(PointSpan<Scalar, Dim> points, const Options& options, Observer&& observe = {}) {
  return Welzl<Scalar, Dim, std::remove_reference_t<Observer>>(points, observe).run(options.seed);
}

}  // namespace snug::fit
