// One body, and one update of the volume around it, step by step. A scene counts frames; here a step of the player is a
// step of the update, so that a climb can be watched from vertex to vertex.
#pragma once

#include "lesson/held_volume.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/update/update_run.hpp"

namespace snug::lesson {

extern const SubjectRow kUpdateRow;

/// The volume of a lesson about an update.
inline constexpr std::string_view kUpdateVolume = "update";

/// The body's pose, and that in the frame before.
struct BodySet : Tables {
  Pose3 now, was;
};

class UpdateSubject final : public PointSubject {
 public:
  static constexpr const SubjectRow& kRow = kUpdateRow;
  UpdateSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh, const BodySet& set);

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<UpdateSubject>(*this); }
  [[nodiscard]] std::string_view stage_says() const override {
    return "a body that is rotated, and the volume around it";
  }

  // The points first, where they are in the world; then the body itself, and the knobs that rotate it.
  [[nodiscard]] Index size() const override { return count() + static_cast<Index>(grips_.size()); }
  [[nodiscard]] Point3 at(Index i) const override;
  /// "P3"; "Body", "Body turn", in space "Body roll".
  [[nodiscard]] std::string name_of(Index i) const override;
  [[nodiscard]] std::vector<std::vector<Index>> things() const override;
  [[nodiscard]] Rows rows() const override;
  Done set_rows(const Rows& rows) override;
  Done move(Index i, const Point3& to) override;
  Done add(const Point3& at) override;
  Done remove(Index i) override;
  Done load(const io::PointFile& file, std::string_view name) override;
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  /// Besides those of points "turn", in degrees; in space about z.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;

  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] std::vector<Rival> rivals(const Lesson& lesson, const View& view) const override;
  [[nodiscard]] std::optional<double> result_size(const Method& method, bool by_measure,
                                                  const View& view) const override;
  [[nodiscard]] std::int64_t operations(const Method& method) const override;

  [[nodiscard]] const Pose3& pose() const { return pose_; }
  /// The AABB that a method's update ends with.
  [[nodiscard]] Aabb<double, 3> box_of(const Method& method) const;
  /// The distance of the farthest point from the pivot; 1 if all points are there.
  [[nodiscard]] double reach() const { return reach_; }
  /// What a handle after the points does.
  [[nodiscard]] const Handle& grip(Index i) const { return grips_[i - count()]; }
  /// In the plane, how far the body is rotated, in (-180, 180].
  [[nodiscard]] double degrees() const;
  /// The looseness of a method's volume over a whole turn, from -180 to 180 degrees in so many equal steps: by how much
  /// it is larger than the tightest, 0.1 for 10 per cent. In the plane the body is rotated by that; in space it is
  /// rotated about z by that much further than now.
  [[nodiscard]] std::vector<double> slack_over_turn(const Method& method, int steps) const;

 protected:
  void points_changed() override;

 private:
  [[nodiscard]] HeldVolume held() const;
  Done take_held(const HeldVolume& next);
  /// Puts the body back into the lesson's pose, after other points were taken.
  Done begun(Done done);
  [[nodiscard]] fit::UpdatedFrame updated(const Method& method) const;

  Pose3 start_, pose_, was_;
  std::vector<Handle> grips_;
  double reach_ = 1;
};

/// The subject of a session that is about an update.
[[nodiscard]] inline const UpdateSubject& body_of(const Subject& subject) {
  return static_cast<const UpdateSubject&>(subject);
}

}  // namespace snug::lesson
