// What subjects with points share: the points, and how they are edited, scattered and loaded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fit/catalogue.hpp"
#include "io/point_file.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The most points that can be generated.
inline constexpr int kMostGenerated = 100000;

/// The names that a lesson gives to its first points; null for none.
using NamesOfPoints = std::shared_ptr<const std::vector<std::string>>;
/// The name of a point, used everywhere: the lesson's own or "P9".
[[nodiscard]] std::string point_name(Index i, const NamesOfPoints& names);
/// "P3", "P3 and P9", "P3, P9 and P12"; "no point" for none.
[[nodiscard]] std::string point_names(std::span<const Index> points, const NamesOfPoints& names);

/// A set in double, or rounded to float. dim: 2 (z is dropped) or 3. Errors: those of PointSet::make.
[[nodiscard]] tl::expected<AnyPointSet, InputError> to_set(const std::vector<Point3>& points, int dim,
                                                           bool in_float = false);

/// Reads "scalar" of a lesson's file: whether it is "float".
[[nodiscard]] bool read_scalar(TomlTable& table);

/// Reads [points] of a lesson's file. may_be_float: whether it may name a scalar.
[[nodiscard]] Points read_points(const toml::table& toml, Complaints& complaints, bool may_be_float = false);

/// The lesson's own points at its seed, or a mesh's vertices. Errors: those of PointSet::make; a missing mesh.
[[nodiscard]] tl::expected<AnyPointSet, InputError> own_points(const Lesson& lesson,
                                                               const std::optional<io::PointFile>& mesh);

/// How many points the subject has; how many handles if it has no points.
[[nodiscard]] Index count_of(const Subject& subject);

/// The points of a set, in double; z = 0 in the plane.
[[nodiscard]] std::vector<Point3> all_points(const AnyPointSet& points);

/// Reads a task's "model", a list of points.
[[nodiscard]] Rows read_point_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);

class PointSubject : public Subject, public HasPoints {
 public:
  [[nodiscard]] int dim() const override { return fit::dim_of(unrounded_); }
  [[nodiscard]] Index size() const override { return fit::count_of(unrounded_); }
  [[nodiscard]] Point3 at(Index i) const override { return fit::point_of(set_of_points(), i); }
  [[nodiscard]] std::string name_of(Index i) const override { return point_name(i, names_); }
  [[nodiscard]] const AnyPointSet& set_of_points() const override { return rounded_ ? *rounded_ : unrounded_; }
  [[nodiscard]] const AnyPointSet& unrounded_points() const override { return unrounded_; }
  [[nodiscard]] std::span<const std::array<Index, 3>> triangles() const override;
  [[nodiscard]] std::string_view stage_says() const override { return "the points and the volume around them"; }
  [[nodiscard]] Tools tools() const override { return {"Points", "Points", true}; }
  [[nodiscard]] Rows rows() const override;
  /// Drops the triangles if the number of points changes. Errors: those of to_set.
  Done set_rows(const Rows& rows) override;

  /// "offset" moves all points along a slanting direction; "jitter" moves each along its own, at most so far in each
  /// coordinate, by the seed; "scale" and "angle" are about their centroid, in space about z; "squeeze" scales their
  /// distances from the slanting line through it; "count" is how many are generated.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;

  Done move(Index i, const Point3& to) override;
  /// Drops the triangles, as remove does.
  Done add(const Point3& at) override;
  /// Errors: the last point cannot be deleted.
  Done remove(Index i) override;
  /// Errors: as of io::to_point_set.
  Done load(const io::PointFile& file, std::string_view name) override;
  /// Errors: an unknown kind, a count outside 1 … kMostGenerated, a dimension other than 2 and 3.
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override;
  /// Scatters points of the same kind as now. Points from a mesh, a file or a list are replaced by the lesson's
  /// generator, as many as the lesson has. The lesson's own seed restores the lesson's own list.
  void scatter(std::uint64_t seed, const Subject& own) override;
  /// Takes the first of the lesson's points, as many as the task is for.
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.points = this}; }
  /// What HasScalar::set_float does in subjects whose runs can be computed in float.
  Done round_to_float(bool in_float);

  using Triangles = std::vector<std::array<Index, 3>>;
  /// How the lesson's points are scattered: by its own generator, or by another kind with as many points.
  struct Recipe {
    std::string kind;
    int count = 0;
    int dim = 2;
    bool own_list = false;   // whether the lesson's own points are a list or a mesh
    std::string mesh;        // its name, if they are a mesh
    std::uint64_t seed = 1;  // the lesson's
    friend bool operator==(const Recipe&, const Recipe&) = default;
  };

  PointSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh);
  PointSubject(const PointSubject&) = default;
  PointSubject& operator=(const PointSubject&) = default;

  [[nodiscard]] const NamesOfPoints& names() const { return names_; }
  /// The number of points: a subject may have more handles.
  [[nodiscard]] Index count() const { return fit::count_of(set_of_points()); }
  /// Called when the points have changed, and cached results are stale.
  virtual void points_changed() {}
  /// Takes over edited points. Errors: those of to_set, and of float where the runs are in float.
  Done take(const std::vector<Point3>& points, int dim, std::shared_ptr<const Triangles> triangles);
  void generate_points(std::string_view kind, int count, int dim, std::uint64_t seed, bool edited);

 private:
  void become(AnyPointSet points, std::shared_ptr<const Triangles> triangles);
  Done drive_count(double to);
  [[nodiscard]] bool is_as_own(std::string_view kind, int count, int dim) const;

  AnyPointSet unrounded_;                       // in double
  std::optional<AnyPointSet> rounded_;          // the same in float, where that is chosen
  std::shared_ptr<const Triangles> triangles_;  // shared, to keep snapshots small
  std::shared_ptr<const Recipe> recipe_;
  NamesOfPoints names_;
};

}  // namespace snug::lesson
