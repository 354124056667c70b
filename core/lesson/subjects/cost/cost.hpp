// A chart of what methods cost and how tight their volumes are, on a cloud of points. The measurement, with a row for
// each method, decides the answers.
#pragma once

#include "lesson/on_cloud.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "measure/rows.hpp"

namespace snug::lesson {

extern const SubjectRow kCostRow;

using Costs = std::span<const cost::CostRow>;

/// The figure that a task is about: by how many per cent a volume is smaller than that of the task's algorithm.
inline constexpr std::string_view kTighterFigure = "tighter";

class CostSubject final : public OnCloud {
 public:
  static constexpr const SubjectRow& kRow = kCostRow;
  CostSubject(std::unique_ptr<Subject> cloud, std::vector<const Method*> methods)
      : OnCloud(std::move(cloud)), methods_(std::move(methods)) {}

  /// Takes the measurement on the current points, a row for each algorithm: it decides the predictions.
  void measured(std::vector<cost::CostRow> rows) { rows_ = std::move(rows); }
  /// Null if these points have not been measured.
  [[nodiscard]] const std::vector<cost::CostRow>* costs() const { return rows_ ? &*rows_ : nullptr; }
  /// The lesson's methods, in order.
  [[nodiscard]] const std::vector<const Method*>& methods() const { return methods_; }

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<CostSubject>(*this); }
  [[nodiscard]] Grade grade(const Lesson& lesson, const Task& task, const View& view) const override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] std::string_view stage_says() const override { return "the chart of costs, or the points"; }

 private:
  void points_changed() override { rows_.reset(); }

  std::vector<const Method*> methods_;
  std::optional<std::vector<cost::CostRow>> rows_;
};

/// Null if there is no chart, or if its points have not been measured.
[[nodiscard]] const std::vector<cost::CostRow>* costs_of(const Session& session);

/// chosen: the method shown on the stage, "k8", or "kdop/k8" where the rows are of several volumes. rows: those
/// measured on the task's points.
[[nodiscard]] Grade grade_costs(const Task& task, Costs rows, std::string_view chosen);
/// The name of the fastest algorithm whose volume is smaller by as much as the task asks; empty if there is none.
[[nodiscard]] std::string cheapest_of(const Task& task, Costs rows);

/// Rows with operations instead of nanoseconds, and no repeats, for checks of the lesson without a clock. All
/// algorithms run on all points. Answers and grades that are based on them mention operations.
[[nodiscard]] std::vector<cost::CostRow> counted_costs(const Lesson& lesson, const AnyPointSet& points);

}  // namespace snug::lesson
