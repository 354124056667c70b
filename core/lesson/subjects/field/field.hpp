// A field of thousands of boxes, and a camera that flies over it: which of them it sees, and what it costs to find out.
#pragma once

#include "lesson/subjects/field/field_measuring.hpp"
#include "lesson/subjects/field/field_methods.hpp"
#include "lesson/subjects/field/field_run.hpp"

namespace snug::lesson {

extern const SubjectRow kFieldRow;

class FieldSubject final : public Subject, public HasVolumes {
 public:
  static constexpr const SubjectRow& kRow = kFieldRow;
  /// clock: times the ways; null for none.
  FieldSubject(const FieldTables& tables, std::uint64_t seed, Clock clock);
  [[nodiscard]] const FieldStage& stage() const { return stage_; }
  [[nodiscard]] const hierarchy::Field& field() const { return *field_; }
  /// What a method costs on what stands on the stage: to be measured in parts, or at once.
  [[nodiscard]] FieldMeasuring measuring(const Method& method) const {
    return {field_, stage_, way_of(method), clock_};
  }
  [[nodiscard]] FieldMeasured measured(const Method& method) const;

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<FieldSubject>(*this); }
  [[nodiscard]] int dim() const override { return 3; }
  /// The camera, and what it looks at.
  [[nodiscard]] Index size() const override { return 2; }
  [[nodiscard]] Point3 at(Index i) const override { return i == 0 ? stage_.now.position : stage_.now.aim; }
  [[nodiscard]] std::string name_of(Index i) const override { return i == 0 ? "Camera" : "Aim"; }
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override { return {"handle", "handles"}; }
  [[nodiscard]] Rows planes() const override;
  [[nodiscard]] std::string_view stage_says() const override { return "a field of boxes and the frustum of a camera"; }
  [[nodiscard]] Tools tools() const override { return {"Camera", "Camera and field"}; }
  [[nodiscard]] std::vector<NumberGroup> numbers() const override;
  Done set_numbers(std::size_t group, std::size_t row, std::span<const double> values) override;
  [[nodiscard]] std::vector<Drive> drives() const override;
  [[nodiscard]] Rows rows() const override { return rows_of(stage_); }
  Done set_rows(const Rows& rows) override;
  /// One frame: the camera as it was becomes that of the frame before.
  Done move(Index i, const Point3& to) override;
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.volumes = this}; }

 private:
  Done become(const FieldStage& next);

  Clock clock_;
  FieldStage stage_;
  std::shared_ptr<const hierarchy::Field> field_;  // of the recipe and the seed; shared, to keep snapshots small
};

}  // namespace snug::lesson
