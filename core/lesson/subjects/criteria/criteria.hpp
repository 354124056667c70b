// Which volume when: all volumes around the same points, the five criteria of each, and what a program would pay for it
// in all.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/on_cloud.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/criteria/load.hpp"
#include "lesson/subjects/criteria/shape_costs.hpp"

namespace snug::lesson {

extern const SubjectRow kCriteriaRow;

/// What volumes are judged by; of each, less is better.
enum class Criterion : std::uint8_t { kTest, kLooseness, kBuild, kUpdate, kBytes, kTotal };
inline constexpr std::size_t kCriteria = 6;
/// Their names in lesson files and commands.
inline constexpr std::array<std::string_view, kCriteria> kCriterionNames{"test",   "looseness", "build",
                                                                         "update", "bytes",     "total"};

class CriteriaSubject final : public OnCloud {
 public:
  static constexpr const SubjectRow& kRow = kCriteriaRow;
  CriteriaSubject(std::unique_ptr<Subject> cloud, std::vector<const Method*> methods, const Load& load)
      : OnCloud(std::move(cloud)), methods_(std::move(methods)), load_(load), own_load_(load),
        store_(std::make_shared<ShapeStore>()) {}

  /// The volumes around the points, fitted when first asked for, and what was measured of them.
  [[nodiscard]] const ShapeCosts& around() const { return known(); }
  [[nodiscard]] bool is_measured() const { return !known().rows.empty(); }
  /// Whether operations were counted instead, because there was no clock.
  [[nodiscard]] bool is_counted() const { return is_measured() && known().rows.front().costs.time.repeats == 0; }
  /// Takes what was measured of points that are or were on the stage: a row for each of their volumes.
  void measured(const AnyPointSet& points, std::vector<cost::CriteriaRow> rows);
  /// Counts operations around these points, in place of a measurement.
  void count(const AnyPointSet& points);

  /// The load as the sliders stand, and as the situation opens with it: predictions are judged by that.
  [[nodiscard]] const Load& load_now() const { return load_; }
  [[nodiscard]] const Load& own_load() const { return own_load_; }
  /// The value of a criterion under a load; none if it is not measured, or the volume is flat.
  [[nodiscard]] std::optional<double> value(std::size_t volume, Criterion criterion, const Load& load) const;
  [[nodiscard]] std::optional<TotalCost> total(std::size_t volume, const Load& load) const;
  /// Each volume's rank among all, 0 for the best; volumes that measuring cannot tell apart share one. Empty while a
  /// value is unknown.
  [[nodiscard]] std::vector<int> ranks(Criterion criterion, const Load& load) const;

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<CriteriaSubject>(*this); }
  [[nodiscard]] std::string_view stage_says() const override {
    return "small pictures of each volume around the points, or one of them";
  }
  /// The cloud's, and of the load "frames", "pairs" and "hit rate".
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;
  /// The points, and last the load.
  [[nodiscard]] Rows rows() const override;
  Done set_rows(const Rows& rows) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] std::vector<Figure> results(const Method& method, const View& view) const override;
  [[nodiscard]] std::optional<double> result_size(const Method& method, bool by_measure,
                                                  const View& view) const override {
    return cloud().result_size(method, by_measure, view);
  }
  [[nodiscard]] std::int64_t operations(const Method& method) const override { return cloud().operations(method); }
  [[nodiscard]] Grade grade(const Lesson& lesson, const Task& task, const View& view) const override;

 private:
  void points_changed() override { known_.reset(); }
  [[nodiscard]] ShapeCosts& known() const;

  std::vector<const Method*> methods_;
  Load load_, own_load_;
  std::shared_ptr<ShapeStore> store_;
  mutable std::shared_ptr<ShapeCosts> known_;  // of the points, once it is measured
};

/// Null for another subject.
[[nodiscard]] const CriteriaSubject* criteria_of(const Session& session);

}  // namespace snug::lesson
