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

/// A step of any update, lifted. All of its facts are the same in every scalar and dimension.
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

/// A body's volume where the body is now.
struct UpdatedFrame {
  Volume3 volume;         // in the world
  double measure = 0;     // its area (2-D) or volume (3-D)
  double tightest = 0;    // that of the tightest of its kind; of an oriented box, of the box that turns with the body
  double hull = 0;        // that of the points' convex hull, which is the same in every pose; where it is watched
  bool contains = false;  // every placed point, in exact arithmetic
  OperationCounts counts{};
  std::int64_t steps = 0;
};

/// Takes the body to a pose. see: none where only the figures are wanted. The first frame may cost more than those
/// after.
using UpdateBody = std::function<UpdatedFrame(const Pose<double, 3>& pose, const SeeUpdateStep& see)>;
/// A body by one update, with what that keeps from frame to frame.
class MovingBody {
 public:
  virtual ~MovingBody() = default;
  [[nodiscard]] virtual UpdatedFrame watched(const Pose<double, 3>& pose, const SeeUpdateStep& see) = 0;
  [[nodiscard]] virtual UpdatedFrame unwatched(const Pose<double, 3>& pose) = 0;
  /// By the updates alone through poses that were given before, once. What it returns says nothing, and keeps the work
  /// from being left out.
  virtual void give(std::span<const Pose<double, 3>> poses) = 0;
  [[nodiscard]] virtual double bare() = 0;
};

/// A way to update the volume of a body that moves.
struct UpdateStrategy {
  std::string_view volume;  // of kVolumeNames
  std::string_view name;    // as scripts say it: "hill_climb"
  std::string_view title;   // as people say it
  std::string_view source;  // author, title, year
  std::span<const std::string_view> pseudocode;
  int k = 0;  // of a k-DOP
  bool plane = true, space = true;
  std::shared_ptr<MovingBody> (*start)(const UpdateStrategy& own, const AnyPointSet& points) = nullptr;
};

/// Sorted by volume, in kVolumeNames' order.
[[nodiscard]] std::span<const UpdateStrategy> update_strategies();
/// Null where there is none of that volume and name.
[[nodiscard]] const UpdateStrategy* find_update(std::string_view volume, std::string_view name);

/// A body about to move, with the volume in its own frame that the strategy starts from: the AABB of its points, their
/// smallest ball, the oriented box of pca_rectangle (in 2-D pca), their hull's edges to climb over.
/// points: in the local frame, about whose origin the body turns; they outlive the result.
[[nodiscard]] UpdateBody start_updates(const UpdateStrategy& strategy, const AnyPointSet& points);

/// The same without anybody watching: neither counts nor steps, nor the hull's measure.
[[nodiscard]] std::function<UpdatedFrame(const Pose<double, 3>& pose)>
start_unwatched_updates(const UpdateStrategy& strategy, const AnyPointSet& points);

/// The same body taken through the poses by the updates alone, unwatched and unchecked: what is timed. Each call goes
/// through all of them; what it returns says nothing, and keeps the work from being left out.
[[nodiscard]] std::function<double()> start_bare_updates(const UpdateStrategy& strategy, const AnyPointSet& points,
                                                         std::span<const Pose<double, 3>> poses);

}  // namespace snug::fit
