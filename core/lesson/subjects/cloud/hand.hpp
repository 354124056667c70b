// What students set by hand beside the points: the axes of a box, the segment of a capsule, the rectangle of a lozenge.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point_set.hpp"
#include "lesson/held_volume.hpp"

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

  // ---- the handles, of all volumes one after the other ----
  [[nodiscard]] Index size() const { return static_cast<Index>(grips_.size()); }
  [[nodiscard]] Point3 at(Index i) const;
  /// "Box turn", "Capsule a".
  [[nodiscard]] std::string name_of(Index i) const;
  /// The volume that a handle sets, of kVolumeNames.
  [[nodiscard]] std::string_view volume_of(Index i) const { return parts_[grips_[i].part].volume; }
  [[nodiscard]] const Handle& handle(Index i) const { return grips_[i].handle; }
  /// Errors: those of moved.
  Done move(Index i, const Point3& to, const AnyPointSet& points);

  /// Null where no volume of that kind is set by hand.
  [[nodiscard]] const HeldVolume* held(std::string_view volume) const;

  /// A row for each volume, which is longer than a point's.
  [[nodiscard]] Rows rows() const;
  [[nodiscard]] static bool is_row(const std::vector<double>& row) { return row.size() > 3; }
  /// rows: for each volume one, or none at all. Errors: these are not the rows of such volumes.
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

  std::vector<Part> parts_;
  std::vector<Grip> grips_;
};

}  // namespace snug::lesson
