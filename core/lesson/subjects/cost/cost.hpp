// A chart of what methods cost and how tight their volumes are, on a cloud of points. The measurement, with a row for
// each method, decides the answers.
#pragma once

#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "measure/rows.hpp"

namespace snug::lesson {

extern const SubjectRow kCostRow;

using Costs = std::span<const cost::CostRow>;

/// The figure that a task is about: by how many per cent a volume is smaller than that of the task's algorithm.
inline constexpr std::string_view kTighterFigure = "tighter";

class CostSubject final : public Subject {
 public:
  static constexpr const SubjectRow& kRow = kCostRow;
  CostSubject(std::unique_ptr<Subject> cloud, std::vector<const Method*> methods)
      : cloud_(std::move(cloud)), methods_(std::move(methods)) {
    origin_ = cloud_->origin();
  }
  CostSubject(const CostSubject& other)
      : Subject(other), cloud_(other.cloud_->clone()), methods_(other.methods_), rows_(other.rows_) {}

  /// Takes the measurement on the current points, a row for each algorithm: it decides the predictions.
  void measured(std::vector<cost::CostRow> rows) { rows_ = std::move(rows); }
  /// Null if these points have not been measured.
  [[nodiscard]] const std::vector<cost::CostRow>* costs() const { return rows_ ? &*rows_ : nullptr; }
  /// The lesson's methods, in order.
  [[nodiscard]] const std::vector<const Method*>& methods() const { return methods_; }

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<CostSubject>(*this); }
  [[nodiscard]] const Subject& shape() const override { return *cloud_; }
  [[nodiscard]] Grade grade(const Lesson& lesson, const Task& task, const View& view) const override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;

  // The cloud's; an edit discards the measurement.
  void set_origin(Origin origin) override { cloud_->set_origin(origin), origin_ = std::move(origin); }
  [[nodiscard]] std::vector<Drive> drives() const override { return cloud_->drives(); }
  Done drive(std::string_view name, double from, double to) override { return edited(cloud_->drive(name, from, to)); }
  [[nodiscard]] int dim() const override { return cloud_->dim(); }
  [[nodiscard]] Index size() const override { return cloud_->size(); }
  [[nodiscard]] Point3 at(Index i) const override { return cloud_->at(i); }
  [[nodiscard]] std::string name_of(Index i) const override { return cloud_->name_of(i); }
  [[nodiscard]] std::string_view stage_says() const override { return "the chart of costs, or the points"; }
  [[nodiscard]] Tools tools() const override { return cloud_->tools(); }
  [[nodiscard]] Rows rows() const override { return cloud_->rows(); }
  Done set_rows(const Rows& rows) override { return edited(cloud_->set_rows(rows)); }
  [[nodiscard]] const AnyPointSet* points() const override { return cloud_->points(); }
  [[nodiscard]] std::span<const std::array<Index, 3>> triangles() const override { return cloud_->triangles(); }
  Done move(Index i, const Point3& to) override { return edited(cloud_->move(i, to)); }
  Done add(const Point3& at) override { return edited(cloud_->add(at)); }
  Done remove(Index i) override { return edited(cloud_->remove(i)); }
  Done load(const io::PointFile& file, std::string_view name) override { return edited(cloud_->load(file, name)); }
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override {
    return edited(cloud_->set_generator(kind, count, dim, seed, own.shape()));
  }
  void scatter(std::uint64_t seed, const Subject& own) override {
    cloud_->scatter(seed, own.shape());
    static_cast<void>(edited({}));
  }
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override {
    return cloud_->run(method, std::move(earlier));
  }
  [[nodiscard]] std::string opening(const Method& method) const override { return cloud_->opening(method); }
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override { return cloud_->figures(view); }
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override { return cloud_->proofs(view); }

 private:
  Done edited(Done done);

  std::unique_ptr<Subject> cloud_;
  std::vector<const Method*> methods_;
  std::optional<std::vector<cost::CostRow>> rows_;
};

/// Null if there is no chart, or if its points have not been measured.
[[nodiscard]] const std::vector<cost::CostRow>* costs_of(const Session& session);

/// chosen: the method shown on the stage. rows: those measured on the task's points.
[[nodiscard]] Grade grade_costs(const Task& task, Costs rows, std::string_view chosen);
/// The fastest algorithm whose volume is smaller by as much as the task asks; empty if there is none.
[[nodiscard]] std::string_view cheapest_of(const Task& task, Costs rows);

/// Rows with operations instead of nanoseconds, and no repeats, for checks of the lesson without a clock. All
/// algorithms run on all points. Answers and grades that are based on them mention operations.
[[nodiscard]] std::vector<cost::CostRow> counted_costs(const Lesson& lesson, const AnyPointSet& points);

}  // namespace snug::lesson
