// The methods by which students fit a volume themselves: they set its axes or its core, and the rest follows from the
// points.
#pragma once

#include <span>
#include <string_view>

#include "fit/catalogue.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// A volume whose axes or core are set by hand; and a box beside the covariance whose eigenvector its first axis may
/// be.
inline constexpr std::string_view kFitByHand = "by_hand", kEigenByHand = "eigen_by_hand";

/// Sorted by volume, as in the catalogue, which has none of them: they need a hand.
[[nodiscard]] std::span<const Method> hand_methods();

/// Runs one of them but the k-DOP's (axes_by_hand.hpp). hand: a volume of its kind, of which only the axes, the segment
/// or the rectangle count.
[[nodiscard]] fit::Recording record_by_hand(const Method& method, const fit::Volume3& hand, const AnyPointSet& points,
                                            fit::Recording room = {});
/// The volume alone.
[[nodiscard]] fit::Volume3 fit_by_hand(const fit::Volume3& hand, const AnyPointSet& points);

/// A direction, and where a covariance matrix takes it.
struct DirectionImage {
  Point3 mean, direction, image;  // unit; in scene units squared
  double degrees = 0;             // between both; 0 for an image of 0
  double spread = 0;              // the largest that an image can be, which is the largest eigenvalue
};
/// The first axis of a run by kEigenByHand after some of its steps; none until the covariance is known.
[[nodiscard]] std::optional<DirectionImage> image_after(const fit::Recording& recording, int steps);

}  // namespace snug::lesson
