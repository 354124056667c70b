// What students set by hand beside the points: the axes of a box, the segment of a capsule, the rectangle of a lozenge,
// the directions of a k-DOP.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point_set.hpp"
#include "lesson/held_volume.hpp"
#include "lesson/subjects/cloud/axes_by_hand.hpp"

namespace snug::lesson {

/// The volumes that are set by hand, each fitted to the points at any time, and the handles that set them.
class Hand {
 public:
  Hand() = default;
  /// volumes: the kinds, of kVolumeNames.
  Hand(std::span<const std::string_view> volumes, const AnyPointSet& points);

  /// Sets every volume as it is at the start, which depends on the points alone.
  void begin(const AnyPointSet& points);
  /// Fits the volumes to points that have changed; in another dimension, they begin again.
  void follow(const AnyPointSet& points);

  // ---- the handles, of all volumes one after the other, and then those of the directions ----
  [[nodiscard]] Index size() const { return held_handles() + (axes_ ? axes_->size() : 0); }
  [[nodiscard]] Point3 at(Index i) const;
  /// "Box turn", "Capsule a", "Axis 3".
  [[nodiscard]] std::string name_of(Index i) const;
  /// The volume that a handle sets, of kVolumeNames.
  [[nodiscard]] std::string_view volume_of(Index i) const;
  /// For a volume that held() has.
  [[nodiscard]] const Handle& handle(Index i) const { return grips_[i].handle; }
  /// Errors: those of moved, and of AxesByHand.
  Done move(Index i, const Point3& to, const AnyPointSet& points);
  /// Errors: it is no direction; those of AxesByHand.
  Done remove(Index i);

  /// Null where no volume of that kind is held by handles of its own; of a k-DOP the directions are set.
  [[nodiscard]] const HeldVolume* held(std::string_view volume) const;
  /// The directions of a k-DOP; null where none are set by hand.
  [[nodiscard]] const AxesByHand* axes() const { return axes_ ? &*axes_ : nullptr; }
  /// The place of a handle among them.
  [[nodiscard]] Index axis_of(Index i) const { return i - held_handles(); }
  Done resize_axes(int count) { return axes_->resize(count); }

  /// Runs a method by hand, and its volume alone.
  [[nodiscard]] fit::Recording record(const Method& method, const AnyPointSet& points, fit::Recording room) const;
  [[nodiscard]] fit::Volume3 fitted(const Method& method, const AnyPointSet& points) const;

  /// A row for each volume and one for all directions, each longer than a point's.
  [[nodiscard]] Rows rows() const;
  [[nodiscard]] static bool is_row(const std::vector<double>& row) { return row.size() > 3; }
  /// rows: as many as rows() has, or none at all. Errors: these are not the rows of such volumes.
  Done set_rows(std::span<const std::vector<double>> rows, const AnyPointSet& points);

 private:
  struct Part {
    std::string_view volume;
    HeldVolume held;
  };
  struct Grip {
    std::size_t part;
    Handle handle;
  };

  [[nodiscard]] Index held_handles() const { return static_cast<Index>(grips_.size()); }

  std::vector<Part> parts_;
  std::vector<Grip> grips_;
  std::optional<AxesByHand> axes_;
};

}  // namespace snug::lesson
