// Two boxes and the tests of whether they overlap.
#pragma once

#include "lesson/boxes.hpp"
#include "lesson/facts.hpp"
#include "lesson/subjects/pair/naive_tests.hpp"
#include "measure/axis_counts.hpp"

namespace snug::lesson {

extern const SubjectRow kPairRow;

/// The facts that tests of two boxes, and of any two volumes, report; and what can be asked about them.
[[nodiscard]] std::vector<std::string_view> pair_facts();
[[nodiscard]] std::vector<FactQuestionKind> pair_question_kinds();

/// The volume of a lesson about two boxes.
inline constexpr std::string_view kBoxPair = "box_pair";

/// What a lesson's file says about two boxes that are tested against each other.
struct PairTables : BoxTables {
  int random_pairs = 0;  // over how many random pairs the axes are counted; 0 for none
};

/// A vertex of a volume's core: its name, and its handle; kNoIndex if it has none.
struct CoreVertex {
  std::string name;
  Index handle = kNoIndex;
};

class PairRun final : public FactRun<PairRun, PairStep> {
 public:
  /// The vertices of A and of B, for tests that mention them.
  using Vertices = std::array<std::vector<CoreVertex>, 2>;

  PairRun(int dim, PairTrace trace, std::vector<RowTruth> truths)
      : dim_(dim), trace_(std::move(trace)), truths_(std::move(truths)) {}
  /// compared: what a distance of the trace is between, as "cores".
  PairRun(int dim, PairTrace trace, Vertices vertices, std::string_view compared)
      : dim_(dim), trace_(std::move(trace)), vertices_(std::move(vertices)), compared_(compared) {}
  [[nodiscard]] std::span<const PairTrace::value_type> trace() const { return trace_; }
  [[nodiscard]] std::vector<Index> candidates(int i) const override;
  struct Where {
    const PairRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] int dim() const { return run.dim_; }
    /// What the row should have said; null where the test's own word is to be trusted.
    [[nodiscard]] const RowTruth* truth() const { return run.truth(i); }
    [[nodiscard]] std::string compared() const { return std::string(run.compared_); }
    /// place: kNoIndex for a point of a smooth core, which is no vertex.
    [[nodiscard]] CoreVertex vertex(int side, Index place) const {
      if (place == kNoIndex) return {side == 0 ? "a point of A" : "a point of B"};
      return run.vertices_[side][place];
    }
  };

  [[nodiscard]] const RowTruth* truth(int i) const { return truths_.empty() ? nullptr : &truths_[i]; }

 private:
  int dim_;
  PairTrace trace_;
  std::vector<RowTruth> truths_;  // of a naive test, one for each step
  Vertices vertices_;
  std::string_view compared_;
};

extern template class FactRun<PairRun, PairStep>;

[[nodiscard]] inline const PairRun& pair_run(const Run& run) { return static_cast<const PairRun&>(run); }

class PairSubject final : public BoxSubject, public HasVolumes, public HasGoals {
 public:
  static constexpr const SubjectRow& kRow = kPairRow;
  /// random_pairs: over how many random pairs the axes are counted; 0 for none.
  PairSubject(const BoxPair& pair, std::uint64_t seed, int random_pairs = 0)
      : BoxSubject(pair, seed), random_pairs_(random_pairs) {}
  /// Counts over random pairs by its seed; null if the lesson wants none.
  [[nodiscard]] const cost::AxisCounts* random_counts() const;
  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<PairSubject>(*this); }
  [[nodiscard]] std::optional<std::array<Point3, 2>> gap() const override;
  [[nodiscard]] std::vector<fit::Volume3> volumes() const override { return {boxes().boxes[0], boxes().boxes[1]}; }
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  /// Besides the number fields, "scale", and in space "angle": B's axes are A's, rotated by so many radians about a
  /// slanting line, so that three pairs of edges are nearly parallel.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;
  [[nodiscard]] bool reaches(std::string_view goal) const override;
  [[nodiscard]] std::string goal_says(std::string_view goal) const override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.volumes = this, .scalar = this, .goals = this}; }

 private:
  struct Counted {
    std::uint64_t seed;
    cost::AxisCounts counts;
  };
  int random_pairs_;
  mutable std::shared_ptr<const Counted> counted_;  // those of the last seed
};

/// The figures of counts over random pairs begin with it.
inline constexpr std::string_view kRandomFigure = "random_";

/// "only_edges", "last_axis": boxes that only edge axes, or only the last axis, separate; any other: boxes on which the
/// wrong or naive test of that name is wrong; with kInFloatAlone after the name: wrong in float, and right in double.
inline constexpr std::string_view kInFloatAlone = "_in_float_alone";
inline constexpr std::array<std::string_view, 17> kPairGoals{"extents_only",
                                                             "corners_only",
                                                             "only_edges",
                                                             "last_axis",
                                                             "faces_only",
                                                             "no_epsilon",
                                                             "no_epsilon_float",
                                                             "epsilon_on_r",
                                                             "epsilon_on_r_float",
                                                             "absolute_epsilon",
                                                             "absolute_epsilon_float",
                                                             "relative_epsilon",
                                                             "relative_epsilon_float",
                                                             "no_epsilon_in_float_alone",
                                                             "epsilon_on_r_in_float_alone",
                                                             "absolute_epsilon_in_float_alone",
                                                             "relative_epsilon_in_float_alone"};

}  // namespace snug::lesson
