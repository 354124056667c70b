// The run of an update: what it did once for the body, and then every step of its latest frame.
#pragma once

#include <string>
#include <vector>

#include "lesson/facts.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/update/body_steps.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

using Pose3 = Pose<double, 3>;

struct UpdateRecording {
  std::vector<Recorder<BodyStep>::Entry> steps;
  fit::UpdatedFrame frame;     // its figures
  std::vector<Index> corners;  // the points that are vertices of the hull, rising; only if the update climbs over it
};

/// The updates that a lesson can offer: those of fit/, each under a name of its own.
[[nodiscard]] std::span<const Method> body_update_methods();
[[nodiscard]] const fit::UpdateStrategy& strategy_of(const Method& method);

/// points: in the local frame. was: the pose in the frame before, where climbs begin.
[[nodiscard]] UpdateRecording record_update(const fit::UpdateStrategy& strategy, const AnyPointSet& points,
                                            const Pose3& was, const Pose3& now);

class UpdateRun final : public FactRun<UpdateRun, BodyStep> {
 public:
  /// The points must outlive it.
  UpdateRun(const fit::UpdateStrategy& strategy, const AnyPointSet& points, const Pose3& pose,
            UpdateRecording recording, NamesOfPoints names)
      : strategy_(strategy), points_(points), pose_(pose), recording_(std::move(recording)), names_(std::move(names)) {}

  [[nodiscard]] std::span<const Recorder<BodyStep>::Entry> trace() const { return recording_.steps; }
  [[nodiscard]] const UpdateRecording& recording() const { return recording_; }
  [[nodiscard]] const fit::UpdateStrategy& strategy() const { return strategy_; }
  [[nodiscard]] int dim() const { return fit::dim_of(points_); }
  [[nodiscard]] Point3 placed(Index point) const { return snug::placed(pose_, fit::point_of(points_, point)); }
  /// The direction of a volume's axis, by its index: of a k-DOP small whole numbers, otherwise a coordinate axis.
  [[nodiscard]] Point3 axis(int axis) const;
  /// The extremes that were found by then, or what supports the finished volume.
  [[nodiscard]] std::vector<Index> support(int steps) const override;
  /// The vertices of the hull, if the step is one of a climb.
  [[nodiscard]] std::vector<Index> candidates(int i) const override;

  struct Where {
    const UpdateRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] const BodyStep& step() const { return run.trace()[i].step; }
    [[nodiscard]] std::string name(Index point) const { return point_name(point, run.names_); }
    /// "x", "x+y"; with its side "+x", "−x−y".
    [[nodiscard]] std::string axis(int axis) const;
    [[nodiscard]] std::string side(int axis, bool greatest) const;
    /// "AABB", "14-DOP", "sphere"
    [[nodiscard]] std::string volume() const;
    [[nodiscard]] bool hides(std::string_view figure) const { return untold != nullptr && untold->hides(figure); }
    /// Whether a climb begins at the step.
    [[nodiscard]] bool begins_climb() const;
  };

 private:
  const fit::UpdateStrategy& strategy_;
  const AnyPointSet& points_;
  Pose3 pose_;
  UpdateRecording recording_;
  NamesOfPoints names_;
};

extern template class FactRun<UpdateRun, BodyStep>;

[[nodiscard]] inline const UpdateRun& update_run(const Run& run) { return static_cast<const UpdateRun&>(run); }

}  // namespace snug::lesson
