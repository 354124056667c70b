// A run of one way to cull a field. Its steps do not follow single boxes, of which there are thousands: each is about a
// plane, or a level of the tree, for all boxes together.
#pragma once

#include "lesson/facts.hpp"
#include "lesson/subjects/field/field_stage.hpp"
#include "trace/fields.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// A plane was tested against all boxes that were to be tested against it. left: without an answer yet.
struct PlaneSwept {
  static constexpr std::string_view kName = "plane_swept";
  int plane = 0;
  std::int64_t tested = 0, rejected = 0, left = 0;
  SNUG_FIELDS(plane, tested, rejected, left);
};

/// The spheres around all boxes were tested, against so many planes.
struct SpheresTested {
  static constexpr std::string_view kName = "spheres_tested";
  std::int64_t planes = 0, outside = 0, inside = 0, left = 0;
  SNUG_FIELDS(planes, outside, inside, left);
};

/// Each box that was rejected in the frame before was tested against the plane that rejected it.
struct LastPlanesTested {
  static constexpr std::string_view kName = "last_planes_tested";
  std::int64_t tested = 0, rejected = 0, left = 0;
  SNUG_FIELDS(tested, rejected, left);
};

/// On a level of the tree, planes were skipped because the parent is inside of them. planes: those that were tested.
struct PlanesSkipped {
  static constexpr std::string_view kName = "planes_skipped";
  int level = 0;
  std::int64_t skipped = 0, planes = 0;
  SNUG_FIELDS(level, skipped, planes);
};

/// The volumes of a level of the tree were tested: nodes, and on the lowest levels boxes.
struct LevelTested {
  static constexpr std::string_view kName = "level_tested";
  int level = 0;
  std::int64_t volumes = 0, planes = 0, left_out = 0, taken = 0, left = 0;
  SNUG_FIELDS(level, volumes, planes, left_out, taken, left);
};

/// All boxes were tested at once, so many in the lanes of a vector. empty: groups whose boxes are all outside.
struct LanesTested {
  static constexpr std::string_view kName = "lanes_tested";
  std::int64_t groups = 0, empty = 0, products = 0;
  SNUG_FIELDS(groups, empty, products);
};

/// The end.
struct FieldCulled {
  static constexpr std::string_view kName = "field_culled";
  std::int64_t inside = 0, intersecting = 0, outside = 0, planes = 0;
  SNUG_FIELDS(inside, intersecting, outside, planes);
};

struct FieldStep {
  using Fact =
      std::variant<PlaneSwept, SpheresTested, LastPlanesTested, PlanesSkipped, LevelTested, LanesTested, FieldCulled>;
  int line = 0;
  Fact fact;
};

/// What is known after some steps.
struct FieldTally {
  std::int64_t planes = 0, products = 0, skipped = 0;
  std::array<std::int64_t, 3> known{};  // boxes inside, intersecting, outside
};

class FieldRun final : public FactRun<FieldRun, FieldStep> {
 public:
  FieldRun(std::shared_ptr<const hierarchy::Field> field, const FieldStage& stage, hierarchy::FieldWay way);

  [[nodiscard]] std::span<const Recorder<FieldStep>::Entry> trace() const { return trace_; }
  [[nodiscard]] const hierarchy::Field& field() const { return *field_; }
  [[nodiscard]] hierarchy::FieldWay way() const { return way_; }
  [[nodiscard]] std::int64_t objects() const { return static_cast<std::int64_t>(verdicts_.size()); }
  [[nodiscard]] std::span<const query::Culling> verdicts() const { return verdicts_; }
  /// Whether a box has its answer after so many steps.
  [[nodiscard]] bool knows(std::size_t box, int steps) const { return decided_[box] <= steps; }
  [[nodiscard]] const FieldTally& tally(int steps) const { return tallies_[steps]; }

  struct Where {
    const FieldRun& run;
    int i;
    const Untold* untold;
  };

 private:
  void tell(const hierarchy::FieldRecord& record, const hierarchy::FieldCost& cost);
  void tell_spheres(const hierarchy::FieldRecord& record);
  void tell_last_planes(const hierarchy::FieldRecord& record);
  void tell_sweeps(const hierarchy::FieldRecord& record);
  void tell_levels(const hierarchy::FieldRecord& record);
  void tell_lanes(const hierarchy::FieldCost& cost);
  void add(int line, FieldStep::Fact fact, std::int64_t planes, std::int64_t products, std::int64_t skipped = 0);
  void decide(std::size_t box) { decided_[box] = next_step(), --left_; }
  [[nodiscard]] bool is_open(std::size_t box) const { return decided_[box] == kOpen; }
  [[nodiscard]] std::uint8_t next_step() const { return static_cast<std::uint8_t>(trace_.size() + 1); }

  static constexpr std::uint8_t kOpen = 255;
  std::shared_ptr<const hierarchy::Field> field_;
  hierarchy::FieldWay way_;
  std::vector<query::Culling> verdicts_;
  std::vector<std::uint8_t> decided_;  // for each box, the step that gives its answer, counted from 1
  std::int64_t left_ = 0;              // boxes without an answer
  std::vector<Recorder<FieldStep>::Entry> trace_;
  std::vector<FieldTally> tallies_;  // before the first step, and after each
};

extern template class FactRun<FieldRun, FieldStep>;

[[nodiscard]] inline const FieldRun& field_run(const Run& run) { return static_cast<const FieldRun&>(run); }

}  // namespace snug::lesson
