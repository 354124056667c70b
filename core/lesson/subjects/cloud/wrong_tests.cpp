#include "lesson/subjects/cloud/wrong_tests.hpp"

#include <optional>

#include "geometry/orientation.hpp"
#include "lesson/subjects/cloud/sphere_through.hpp"

namespace snug::lesson {
namespace {

/// Judges each test against the exact sphere through the support set that the ball was computed from.
class TestsJudged {
 public:
  TestsJudged(const AnyPointSet& points, std::vector<WrongTest>& wrong) : points_(points), wrong_(wrong) {}

  void operator()(const fit::BoundaryForced& fact) { sphere_.emplace(points_, fact.boundary); }
  void operator()(const fit::PointExamined& fact) {
    const auto side = sphere_ ? sphere_->side(fact.point) : std::nullopt;
    if (!side || (*side > 0) == fact.outside) return;
    wrong_.push_back({step, fact.point,
                      *side > 0    ? WrongTest::Truth::kOutside
                      : *side == 0 ? WrongTest::Truth::kOnBoundary
                                   : WrongTest::Truth::kInside});
  }
  void operator()(const auto&) {}
  int step = 0;

 private:
  const AnyPointSet& points_;
  std::vector<WrongTest>& wrong_;
  std::optional<SphereThrough> sphere_;
};

/// Follows the edges of a hull in the plane, and judges how points are shared between them.
class SharesJudged {
 public:
  SharesJudged(const AnyPointSet& points, std::vector<WrongTest>& wrong) : points_(points), wrong_(wrong) {}

  void operator()(const fit::SimplexChosen& fact) {
    a_ = b_ = fact.points.front();
    middle_ = fact.points.back();
  }
  void operator()(const fit::EdgeSplit& fact) { a_ = fact.a, middle_ = fact.point, b_ = fact.b; }
  void operator()(const fit::PointsAssigned& fact) {
    for (const Index i : fact.points) judge(i, true);
    for (const Index i : fact.inside) judge(i, false);
  }
  void operator()(const auto&) {}
  int step = 0;

 private:
  void judge(Index i, bool taken) {
    const bool outside = side(a_, middle_, i) < 0 || side(middle_, b_, i) < 0;
    if (outside == taken) return;
    wrong_.push_back({step, i, outside ? WrongTest::Truth::kOutside : WrongTest::Truth::kNotOutside});
  }
  [[nodiscard]] int side(Index from, Index to, Index i) const {
    const auto at = [&](Index point) -> Vector<double, 2> { return fit::point_of(points_, point).head<2>(); };
    return orient2d(at(from), at(to), at(i));
  }

  const AnyPointSet& points_;
  std::vector<WrongTest>& wrong_;
  Index a_ = 0, middle_ = 0, b_ = 0;
};

}  // namespace

std::vector<WrongTest> wrong_tests(const fit::Recording& recording, const AnyPointSet& points) {
  std::vector<WrongTest> wrong;
  TestsJudged tests(points, wrong);
  SharesJudged shares(points, wrong);
  for (const auto& entry : recording.steps) {
    std::visit(tests, entry.step.fact);
    if (fit::dim_of(points) == 2) std::visit(shares, entry.step.fact);
    ++tests.step, ++shares.step;
  }
  return wrong;
}

}  // namespace snug::lesson
