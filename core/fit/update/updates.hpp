// The updates by name, on any body: what the command line and measurements call.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "fit/any_step.hpp"
#include "fit/update/update.hpp"
#include "geometry/point_set.hpp"
#include "geometry/pose.hpp"
#include "trace/observer.hpp"

namespace snug::fit {

/// A step of any update, lifted. Its facts are the same in every scalar and dimension.
struct UpdateStep3 {
  using Fact = UpdateStep<Sphere3>::Fact;
  int line = 0;  // of the strategy's pseudocode, counted from 0
  bool has_volume = false;
  Volume3 volume;
  Fact fact;
};
using SeeUpdateStep = std::function<void(const UpdateStep3& step)>;

/// One step as one line of JSON, without a line feed.
[[nodiscard]] std::string json_of(const UpdateStep3& step, int dim);

/// A body's volume at its current pose.
struct UpdatedFrame {
  Volume3 volume;         // in the world
  double measure = 0;     // its area (2-D) or volume (3-D)
  double tightest = 0;    // the measure of the tightest of its kind; for an OBB, of the box that rotates with the body
  double hull = 0;        // the measure of the points' convex hull, the same in every pose; only if observed
  bool contains = false;  // whether it contains every placed point, in exact arithmetic
  OperationCounts counts{};
  std::int64_t steps = 0;
};

/// Moves the body to a pose. see: empty if only the figures are wanted. The first frame may cost more than later
/// ones.
using UpdateBody = std::function<UpdatedFrame(const Pose<double, 3>& pose, const SeeUpdateStep& see)>;
/// A body with one update, and what that update keeps from frame to frame.
class MovingBody {
 public:
  virtual ~MovingBody() = default;
  [[nodiscard]] virtual UpdatedFrame watched(const Pose<double, 3>& pose, const SeeUpdateStep& see) = 0;
  [[nodiscard]] virtual UpdatedFrame unwatched(const Pose<double, 3>& pose) = 0;
  /// Takes the body once through poses given before, by the updates alone. The number is the x of the last volume's
  /// anchor.
  virtual void give(std::span<const Pose<double, 3>> poses) = 0;
  [[nodiscard]] virtual double bare() = 0;
};

/// A way to update the volume of a moving body.
struct UpdateStrategy {
  std::string_view volume;  // of kVolumeNames
  std::string_view name;    // as scripts say it: "hill_climb"
  std::string_view title;   // as people say it
  std::string_view source;  // author, title, year
  std::span<const std::string_view> pseudocode;
  int k = 0;  // of a k-DOP; 0 for any other volume
  bool plane = true, space = true;
  std::shared_ptr<MovingBody> (*start)(const UpdateStrategy& own, const AnyPointSet& points) = nullptr;
};

/// Sorted by volume, in kVolumeNames' order.
[[nodiscard]] std::span<const UpdateStrategy> update_strategies();
/// Null where there is none of that volume and name.
[[nodiscard]] const UpdateStrategy* find_update(std::string_view volume, std::string_view name);

/// Prepares a body to move, with the volume in its local frame that the strategy starts from: the AABB of its points,
/// their smallest ball, the oriented box of pca_rectangle (in 2-D pca), or their hull to climb over. points: in the
/// local frame, about whose origin the body rotates; they must outlive the result.
[[nodiscard]] UpdateBody start_updates(const UpdateStrategy& strategy, const AnyPointSet& points);

/// The same without an observer: neither counts nor steps, nor the hull's measure.
[[nodiscard]] std::function<UpdatedFrame(const Pose<double, 3>& pose)>
start_unwatched_updates(const UpdateStrategy& strategy, const AnyPointSet& points);

/// The body taken through the poses by the updates alone, without observer or checks: this is timed. Each call does all
/// poses, and returns the x of the last volume's anchor.
[[nodiscard]] std::function<double()> start_bare_updates(const UpdateStrategy& strategy, const AnyPointSet& points,
                                                         std::span<const Pose<double, 3>> poses);

}  // namespace snug::fit
