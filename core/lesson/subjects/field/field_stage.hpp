// What a lesson about a field of boxes has on its stage: the field, and the camera that flies over it.
#pragma once

#include <array>
#include <memory>

#include "geometry/frustum_corners.hpp"
#include "hierarchy/field.hpp"
#include "lesson/lesson.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

inline constexpr int kFewestObjects = 8, kMostObjects = 100'000;

/// Where the camera is, and a point that it looks at; up is the world's y.
struct CameraPose {
  Point3 position = Point3::Zero(), aim = Point3::Zero();
};

/// How boxes are scattered, and what the camera sees.
struct FieldRecipe {
  int objects = 10'000;
  double reach = 50, height = 20;             // x and z from -reach to reach, y from 0 to height; scene units
  std::array<double, 2> size{0.2, 0.8};       // the least and the greatest half extent
  std::array<double, 2> tangents{0.75, 0.5};  // of half the angle of view, sideways and upwards
  double near = 1, far = 50;                  // of the frustum, scene units
};

struct FieldStage {
  FieldRecipe recipe;
  CameraPose now, before;  // in this frame, and in the one before
};

/// What a lesson's file says about it.
struct FieldTables : Tables {
  FieldStage stage;
};

/// The frustum of a pose. Errors: the camera aims at its own place, or straight up or down; what frustum_of_camera
/// refuses.
[[nodiscard]] tl::expected<Frustum<double, 3>, InputError> frustum_of(const FieldRecipe& recipe,
                                                                      const CameraPose& pose);
/// The camera of a pose that has a frustum.
[[nodiscard]] FrustumCamera<double, 3> camera_of(const FieldRecipe& recipe, const CameraPose& pose);

/// The boxes of a recipe by a seed.
[[nodiscard]] std::shared_ptr<const hierarchy::Field> field_by(const FieldRecipe& recipe, std::uint64_t seed);

/// Whether it can be shown. Errors: too few or too many objects; a coordinate out of reach; those of frustum_of.
[[nodiscard]] Done check_stage(const FieldStage& stage);

/// Three rows: position and aim now, the same before, and how many objects there are (Subject::rows).
[[nodiscard]] Rows rows_of(const FieldStage& stage);
/// Errors: these are not such rows; those of check_stage.
[[nodiscard]] tl::expected<FieldStage, InputError> with_rows(const FieldStage& like, const Rows& rows);

/// Reads [field].
void read_field(TomlTable& table, Lesson& lesson, Complaints& complaints);
/// Reads a task's "model": a camera and its aim, to which the lesson's own camera goes in one frame.
[[nodiscard]] Rows read_field_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);

}  // namespace snug::lesson
