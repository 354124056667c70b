// A run of an algorithm that fits a volume to points, as a lesson presents it.
#pragma once

#include <optional>

#include "fit/catalogue.hpp"
#include "lesson/facts.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/fit_asks.hpp"
#include "lesson/subjects/cloud/wrong_tests.hpp"

namespace snug::lesson {

using FitTrace = std::span<const Recorder<fit::Step3>::Entry>;

class FitRun final : public FactRun<FitRun, fit::Step3> {
 public:
  /// points: those of the run; they must outlive it. names: the lesson's own for them. points_alone: whether the
  /// subject has other handles than points, which are no answers. axes: the directions of the slabs, if they were set
  /// by hand; otherwise a k-DOP has its own. naive: whether its tests are judged in exact arithmetic.
  FitRun(const AnyPointSet& points, bool exact, fit::Recording recording, NamesOfPoints names = {},
         bool points_alone = false, std::vector<Point3> axes = {}, bool naive = false)
      : points_(points), exact_(exact), points_alone_(points_alone), recording_(std::move(recording)),
        names_(std::move(names)), axes_(std::move(axes)) {
    if (naive) wrong_ = wrong_tests(recording_, points_);
  }

  [[nodiscard]] FitTrace trace() const { return recording_.steps; }
  [[nodiscard]] const fit::Recording& recording() const { return recording_; }
  /// Gives up the recording for its memory: the run cannot be used afterwards.
  [[nodiscard]] fit::Recording give_up() { return std::move(recording_); }
  [[nodiscard]] const AnyPointSet& points() const { return points_; }
  [[nodiscard]] int dim() const { return fit::dim_of(points_); }
  [[nodiscard]] bool exact() const { return exact_; }
  [[nodiscard]] const std::vector<Point3>& axes_by_hand() const { return axes_; }
  /// The tests of a naive algorithm that are wrong, in order; null if the algorithm is a careful one.
  [[nodiscard]] const std::vector<WrongTest>* wrong() const { return wrong_ ? &*wrong_ : nullptr; }
  /// Those of step i.
  [[nodiscard]] std::span<const WrongTest> wrong_at(int i) const;
  /// How many points the volume of step i leaves outside by more than rounding. It is kept, for it is asked for by all
  /// that is told of a step, and takes every point.
  [[nodiscard]] Index outside_at(int i) const;
  /// The direction across a slab of step i's k-DOP: small whole numbers, or unit where it was set by hand; and its
  /// name.
  [[nodiscard]] Point3 slab_axis(int i, int slab) const;
  [[nodiscard]] std::string slab_name(int i, int slab) const;
  /// How far a point lies beyond the boundary of a ball, scene units.
  [[nodiscard]] double gap_to(Index point, const fit::Sphere3& ball) const;
  /// Whether a ball grew by no more than rounding.
  [[nodiscard]] bool is_rounding(int i) const override;
  [[nodiscard]] std::vector<Index> support(int steps) const override;
  [[nodiscard]] std::vector<Index> candidates(int i) const override;

  /// A step in the run.
  struct Where {
    const FitRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] const fit::Step3& step() const { return run.trace()[i].step; }
    /// The step after it and the one before it; null if there is none.
    [[nodiscard]] const fit::Step3* next() const { return i + 1 < run.steps() ? &run.trace()[i + 1].step : nullptr; }
    [[nodiscard]] const fit::Step3* before() const { return i > 0 ? &run.trace()[i - 1].step : nullptr; }
    [[nodiscard]] int dim() const { return run.dim(); }
    /// Whether it is the first step with a wrong test.
    [[nodiscard]] bool is_first_wrong() const {
      return run.wrong() != nullptr && !run.wrong()->empty() && run.wrong()->front().step == i;
    }
    /// What exact arithmetic says against the step's tests; empty for nothing.
    [[nodiscard]] std::string contradiction() const;
    [[nodiscard]] std::string name(Index point) const { return point_name(point, run.names_); }
    [[nodiscard]] std::string names(std::span<const Index> points) const { return point_names(points, run.names_); }
    /// Whether it brings the first volume.
    [[nodiscard]] bool is_first_volume() const {
      return step().has_volume && (before() == nullptr || !before()->has_volume);
    }
    [[nodiscard]] std::string ball() const;  // "circle", "sphere"
    [[nodiscard]] double radius() const;     // that of the step's ball; 0 if it has none
    [[nodiscard]] std::string size() const;  // "radius 2.1", "area 3.4"
    [[nodiscard]] std::string size_word() const { return dim() == 2 ? "area " : "volume "; }
    [[nodiscard]] std::string outline_word() const { return dim() == 2 ? "outline" : "surface"; }
  };

 private:
  const AnyPointSet& points_;
  bool exact_, points_alone_;
  fit::Recording recording_;
  NamesOfPoints names_;
  std::vector<Point3> axes_;
  std::optional<std::vector<WrongTest>> wrong_;
  struct Outside {
    int step = -1;
    Index points = 0;
  };
  mutable Outside outside_;  // of the step that was asked for last
};

extern template class FactRun<FitRun, fit::Step3>;

/// The run of a subject whose methods fit volumes.
[[nodiscard]] inline const FitRun& fit_run(const Run& run) { return static_cast<const FitRun&>(run); }
/// The fact that a question about it is asked of.
template <class Fact>
const Fact& fact_of(const Asked& asked, const Run& run) {
  return *std::get_if<Fact>(&fit_run(run).trace()[asked.fact].step.fact);
}

/// Defaults for the entries of fitters' facts: the only question is whether the volume grows, the support set stays as
/// it was, and a step is a mark if it brings the first volume.
struct FitEntry : EntryDefaults {
  static std::string predicate(const auto&, const FitRun::Where& where, bool plural) {
    return (plural ? "support the " : "supports the ") + where.ball();
  }
  static std::optional<Mark::Kind> mark(const auto&, const FitRun::Where& where) { return first(where); }
  /// The support set that the fact states; none if it stays as it was.
  static std::optional<std::vector<Index>> support(const auto&) { return std::nullopt; }
  /// The points that join it.
  static std::vector<Index> adds_to_support(const auto&) { return {}; }
  static constexpr std::array kQuestionKinds{kGrows};

  static std::optional<Mark::Kind> first(const FitRun::Where& where) {
    return where.is_first_volume() ? std::optional(Mark::Kind::kGrew) : std::nullopt;
  }
  static std::optional<Mark::Kind> best_if(bool better, const FitRun::Where& where) {
    return better ? std::optional(Mark::Kind::kBest) : first(where);
  }
};

}  // namespace snug::lesson
