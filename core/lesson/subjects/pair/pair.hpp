// Two boxes and the tests of whether they overlap.
#pragma once

#include "lesson/boxes.hpp"
#include "lesson/facts.hpp"
#include "lesson/subjects/pair/box_tests.hpp"

namespace snug::lesson {

extern const SubjectRow kPairRow;

/// What tests of two boxes, and of any two volumes, tell, and what can be asked of it.
[[nodiscard]] std::vector<std::string_view> pair_facts();
[[nodiscard]] std::vector<AskingOf> pair_askings();

/// A lesson's volume where it has two boxes.
inline constexpr std::string_view kBoxPair = "box_pair";

/// A vertex of a volume's core: what it is called, and its handle, kNoIndex where it has none.
struct CoreVertex {
  std::string name;
  Index handle = kNoIndex;
};

class PairRun final : public FactRun<PairRun, PairStep> {
 public:
  /// Those of A and of B, of tests that speak of them.
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
    [[nodiscard]] const CoreVertex& vertex(int side, Index place) const { return run.vertices_[side][place]; }
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
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] Grade grade(const Lesson& lesson, const View& view, std::vector<bool>& found) const override;
};

/// "extents_only", "corners_only": a place where that test is wrong; "only_edges", "last_axis": where edge axes alone,
/// or the last axis alone, separate the boxes.
inline constexpr std::array<std::string_view, 4> kPairGoals{"extents_only", "corners_only", "only_edges", "last_axis"};
extern const BoxGoals kReachPairGoals;

}  // namespace snug::lesson
