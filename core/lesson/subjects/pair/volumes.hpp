// Any two volumes and the test that decides whether they overlap.
#pragma once

#include "lesson/held_volume.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "measure/pair_cost.hpp"
#include "query/overlap/overlap_table.hpp"

namespace snug::lesson {

extern const SubjectRow kVolumesRow;

/// The volume of a lesson about any two volumes.
inline constexpr std::string_view kVolumePair = "volume_pair";

/// Two volumes; in 2-D z is 0. A's kind does not come after B's in kVolumeNames, so that the tests take A first.
struct VolumePair {
  int dim = 2;
  std::array<HeldVolume, 2> held;
  bool any = false;        // whether students choose the kinds
  bool cylinders = false;  // whether the cylinders on the axes of these two capsules stand beside them
  bool in_float = false;   // whether the volumes are rounded to float, and tested in float
};

/// The kinds of both, as indices of kVolumeNames.
using Kinds = std::array<std::size_t, 2>;
[[nodiscard]] inline Kinds kinds_of(const VolumePair& pair) {
  return {pair.held[0].volume.index(), pair.held[1].volume.index()};
}
/// The pair with volumes of usual shape and size where a kind changes. kinds: in the order of the table.
[[nodiscard]] VolumePair with_kinds(VolumePair pair, const Kinds& kinds);

/// The pair's own test.
[[nodiscard]] inline query::PairTest test_of(const VolumePair& pair) {
  return query::kPairTests[pair.held[0].volume.index()][pair.held[1].volume.index()];
}

/// The rows of both volumes (Subject::rows); where students choose the kinds, each begins with its kind.
[[nodiscard]] Rows rows_of(const VolumePair& pair);
/// The pair with those rows. Errors: these are not the numbers of such volumes.
[[nodiscard]] tl::expected<VolumePair, InputError> with_rows(VolumePair pair, const Rows& rows);

/// A method for each query::PairTest, with its name, and one for each representation of two axis-aligned boxes.
[[nodiscard]] std::span<const Method> volume_tests();
/// The names of those that suit a pair: its own test, those of two axis-aligned boxes, and GJK, which suits every pair.
[[nodiscard]] std::vector<std::string_view> tests_of(const VolumePair& pair);
/// Whether it tests two axis-aligned boxes in one of their representations.
[[nodiscard]] bool is_of_boxes(std::string_view test);
/// Records one of these.
[[nodiscard]] PairTrace record(std::string_view test, const VolumePair& pair);
/// How many operations these steps took, all kinds together.
[[nodiscard]] std::int64_t operations_in(PairSteps steps);
/// The largest lower bound on the distance of the cores that these steps have proved; none before the first.
[[nodiscard]] std::optional<double> proved_distance(PairSteps steps);

/// The vertices of a volume's core, as GJK knows them; none of a smooth one.
[[nodiscard]] std::vector<Point3> core_of(const HeldVolume& held);
/// How far along a unit direction the volume reaches.
[[nodiscard]] double reach_along(const HeldVolume& held, const Point3& way);
/// The radius around the core.
[[nodiscard]] double radius_of(const HeldVolume& held);
/// What the distance that a test finds is between: the "centres" of two spheres, the "cores" of volumes that a sphere
/// sweeps, or the "volumes" themselves.
[[nodiscard]] std::string_view compared_in(const VolumePair& pair);
/// The nearest points of both; none if they overlap.
[[nodiscard]] std::optional<query::Separation<double, 3>> separation_of(const VolumePair& pair);
/// The same for the cores alone, without the radii.
[[nodiscard]] std::optional<query::Separation<double, 3>> core_separation_of(const VolumePair& pair);

/// What GJK says of the cylinders on the axes of two capsules, with their radii.
struct AsCylinders {
  bool overlap = false;
  double gap = 0;     // 0 where they overlap
  int simplices = 0;  // that GJK took
};
/// pair: two capsules. None where the ends of an axis are one point.
[[nodiscard]] std::optional<AsCylinders> as_cylinders(const VolumePair& pair);

/// "only_last_axis": axis-aligned boxes that only the last coordinate axis separates; "touch_on_one_axis": those whose
/// intervals have just one number in common along one axis, and more along every other; "sum_of_squares": spheres that
/// overlap, and that would not if their squared radii were added instead of squaring their sum; "cylinders_apart":
/// capsules that overlap while the cylinders on their axes do not; "overlap": any two volumes that overlap.
inline constexpr std::array<std::string_view, 5> kVolumeGoals{"only_last_axis", "touch_on_one_axis", "sum_of_squares",
                                                              "cylinders_apart", "overlap"};

class VolumesSubject final : public Subject, public HasVolumes, public HasScalar, public HasGoals {
 public:
  static constexpr const SubjectRow& kRow = kVolumesRow;
  VolumesSubject(VolumePair pair, std::uint64_t seed, Clock clock = nullptr);
  [[nodiscard]] const VolumePair& pair() const { return pair_; }
  /// Where students choose the kinds: puts others on the stage, as with_kinds.
  void choose_kinds(const Kinds& kinds);
  /// Begins to measure what the tests of all pairs cost. Nothing without a clock.
  void measure_costs();
  [[nodiscard]] bool can_measure() const { return clock_ != nullptr; }
  /// What was measured, or is being measured; null for nothing yet.
  [[nodiscard]] cost::PairCostRun* costs() const { return costs_.get(); }
  /// Goes on measuring for so many nanoseconds.
  void work_on_costs(double budget);
  [[nodiscard]] const Handle& handle(Index i) const { return handles_[i].handle; }
  [[nodiscard]] int side(Index i) const { return handles_[i].side; }

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<VolumesSubject>(*this); }
  [[nodiscard]] int dim() const override { return pair_.dim; }
  [[nodiscard]] Index size() const override { return static_cast<Index>(handles_.size()); }
  [[nodiscard]] Point3 at(Index i) const override;
  [[nodiscard]] std::string name_of(Index i) const override;
  [[nodiscard]] std::optional<std::array<Point3, 2>> gap() const override;
  [[nodiscard]] std::vector<fit::Volume3> volumes() const override {
    return {pair_.held[0].volume, pair_.held[1].volume};
  }
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override { return {"vertex", "vertices"}; }
  [[nodiscard]] std::vector<std::vector<Index>> things() const override;
  [[nodiscard]] std::string_view stage_says() const override { return "two volumes"; }
  [[nodiscard]] Tools tools() const override { return {"Volumes", "Volumes"}; }
  /// Each volume's centre, and if its kind can rotate, its turn: in space one about each axis.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;
  [[nodiscard]] Rows rows() const override;
  Done set_rows(const Rows& rows) override;
  Done move(Index i, const Point3& to) override;
  Done set_float(bool in_float) override;
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] std::string refusal(const Method& method) const override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] bool reaches(std::string_view goal) const override;
  [[nodiscard]] std::string goal_says(std::string_view goal) const override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.volumes = this, .scalar = this, .goals = this}; }

 private:
  struct Own {
    int side;
    Handle handle;
  };
  [[nodiscard]] PairRun::Vertices vertices() const;
  /// The volumes before they were rounded to float; in double, the volumes.
  [[nodiscard]] const VolumePair& unrounded() const { return unrounded_ ? *unrounded_ : pair_; }
  /// Puts volumes on the stage, rounded if the runs are in float. Errors: a volume that float cannot hold.
  Done hold(VolumePair pair, bool in_float);
  /// The same, as an edit.
  Done become(VolumePair pair);
  void show(VolumePair pair);
  /// The same in double, if float cannot hold them. Returns whether the runs are in float.
  bool hold_in_float_if_possible(VolumePair pair, bool in_float);

  std::uint64_t lesson_seed_;
  Clock clock_;
  std::shared_ptr<cost::PairCostRun> costs_;
  VolumePair pair_;
  std::optional<VolumePair> unrounded_;
  std::vector<Own> handles_;  // those of A, then those of B
};

}  // namespace snug::lesson
