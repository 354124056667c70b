// Two boxes and the tests of whether they overlap.
#pragma once

#include "lesson/boxes.hpp"
#include "lesson/facts.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::lesson {

extern const SubjectRow kPairRow;

/// The facts that tests of two boxes, and of any two volumes, report; and what can be asked about them.
[[nodiscard]] std::vector<std::string_view> pair_facts();
[[nodiscard]] std::vector<AskingOf> pair_askings();

/// The volume of a lesson about two boxes.
inline constexpr std::string_view kBoxPair = "box_pair";

/// A vertex of a volume's core: its name, and its handle; kNoIndex if it has none.
struct CoreVertex {
  std::string name;
  Index handle = kNoIndex;
};

class PairRun final : public FactRun<PairRun, PairStep> {
 public:
  /// The vertices of A and of B, for tests that mention them.
  using Vertices = std::array<std::vector<CoreVertex>, 2>;

  PairRun(int dim, PairTrace trace) : dim_(dim), trace_(std::move(trace)) {}
  PairRun(int dim, PairTrace trace, Vertices vertices)
      : dim_(dim), trace_(std::move(trace)), vertices_(std::move(vertices)) {}
  [[nodiscard]] std::span<const PairTrace::value_type> trace() const { return trace_; }
  [[nodiscard]] std::vector<Index> candidates(int i) const override;
  struct Where {
    const PairRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] int dim() const { return run.dim_; }
    /// place: kNoIndex for a point of a smooth core, which is no vertex.
    [[nodiscard]] CoreVertex vertex(int side, Index place) const {
      if (place == kNoIndex) return {side == 0 ? "a point of A" : "a point of B"};
      return run.vertices_[side][place];
    }
  };

 private:
  int dim_;
  PairTrace trace_;
  Vertices vertices_;
};

extern template class FactRun<PairRun, PairStep>;

[[nodiscard]] inline const PairRun& pair_run(const Run& run) { return static_cast<const PairRun&>(run); }

class PairSubject final : public BoxSubject {
 public:
  static constexpr const SubjectRow& kRow = kPairRow;
  PairSubject(const BoxPair& pair, std::uint64_t seed) : BoxSubject(pair, seed) {}
  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<PairSubject>(*this); }
  [[nodiscard]] std::optional<std::array<Point3, 2>> gap() const override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] bool reaches(std::string_view goal) const override;
  [[nodiscard]] std::string goal_says(std::string_view goal) const override;
};

/// "extents_only", "corners_only": boxes on which that test is wrong; "only_edges", "last_axis": boxes that only edge
/// axes, or only the last axis, separate.
inline constexpr std::array<std::string_view, 4> kPairGoals{"extents_only", "corners_only", "only_edges", "last_axis"};

}  // namespace snug::lesson
