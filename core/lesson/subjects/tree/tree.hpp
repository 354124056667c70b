// Boxes in the plane, the bounding volume hierarchy over them, and queries that go through it.
#pragma once

#include "lesson/subjects/tree/tree_run.hpp"
#include "lesson/subjects/tree/tree_times.hpp"

namespace snug::lesson {

extern const SubjectRow kTreeRow;

class TreeSubject final : public Subject, public HasVolumes {
 public:
  static constexpr const SubjectRow& kRow = kTreeRow;
  /// clock: times the ways to build; null for none.
  TreeSubject(const TreeTables& tables, std::uint64_t seed, Clock clock = nullptr);
  [[nodiscard]] const TreeStage& stage() const { return stage_; }
  /// What a method of building, refitting or rebuilding costs with a crowd in place of each box.
  [[nodiscard]] TreeTime timed(const Method& method) const;
  [[nodiscard]] Index boxes() const { return static_cast<Index>(stage_.boxes.size()); }

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<TreeSubject>(*this); }
  [[nodiscard]] int dim() const override { return 2; }
  /// The boxes' centres, and the query's places.
  [[nodiscard]] Index size() const override { return boxes() + (stage_.query ? 2 : 0); }
  [[nodiscard]] Point3 at(Index i) const override;
  [[nodiscard]] std::string name_of(Index i) const override;
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override { return {"box", "boxes"}; }
  [[nodiscard]] std::vector<fit::Volume3> on_paper() const override;
  [[nodiscard]] std::string_view stage_says() const override { return "boxes and the nodes around them"; }
  [[nodiscard]] Tools tools() const override { return {"Boxes", "Boxes"}; }
  [[nodiscard]] std::vector<NumberGroup> numbers() const override;
  Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values) override;
  [[nodiscard]] Rows rows() const override { return rows_of(stage_); }
  Done set_rows(const Rows& rows) override;
  Done move(Index i, const Point3& to) override;
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  /// The trees with their costs.
  [[nodiscard]] std::vector<Rival> rivals(const Lesson& lesson, const View& view) const override;
  [[nodiscard]] std::optional<double> result_size(const Method& method, bool by_measure,
                                                  const View& view) const override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.volumes = this}; }

 private:
  Done become(TreeStage next);
  [[nodiscard]] std::span<const HandPair> mergers() const;
  [[nodiscard]] std::span<const Index> choices() const;

  Clock clock_;
  std::uint64_t lesson_seed_;
  BoxRecipe recipe_;
  std::string rule_;
  TreeStage stage_;
};

}  // namespace snug::lesson
