#include "lesson/subjects/field/field_stage.hpp"

#include <cmath>
#include <string>

#include "geometry/random.hpp"
#include "lesson/names.hpp"

namespace snug::lesson {
namespace {

constexpr double kFarthestPlace = 1e4;  // of the camera and its aim, scene units

tl::unexpected<InputError> no_field(std::string why) { return tl::unexpected(InputError{.what = std::move(why)}); }

/// Reads a place in space.
void read_spot(TomlTable& table, std::string_view key, Point3& place, bool required) {
  if (!required && !table.has(key)) return table.allow(key);
  const std::vector<double> at = table.numbers(key);
  if (at.size() == 3) place = {at[0], at[1], at[2]};
  else if (table.has(key)) table.wrong(key, "must be three numbers");
}

/// Reads two numbers above 0, if they are there.
void read_two(TomlTable& table, std::string_view key, std::array<double, 2>& both, bool rising) {
  if (!table.has(key)) return table.allow(key);
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.size() == 2 && numbers[0] > 0 && numbers[1] > 0 && (!rising || numbers[0] <= numbers[1]))
    both = {numbers[0], numbers[1]};
  else table.wrong(key, rising ? "must be two numbers above 0, the least first" : "must be two numbers above 0");
}

FieldRecipe read_field_recipe(TomlTable& own) {
  FieldRecipe recipe;
  recipe.objects = static_cast<int>(own.integer_or("objects", kFewestObjects, kMostObjects, recipe.objects));
  const auto number = [&](std::string_view key, double& value, double most) {
    if (own.has(key)) value = own.number(key, most);
    else own.allow(key);
  };
  number("reach", recipe.reach, 1000);
  number("height", recipe.height, 1000);
  number("near", recipe.near, 1000);
  number("far", recipe.far, 10'000);
  read_two(own, "size", recipe.size, true);
  read_two(own, "tangents", recipe.tangents, false);
  return recipe;
}

std::vector<double> row_of(const CameraPose& pose) {
  return {pose.position[0], pose.position[1], pose.position[2], pose.aim[0], pose.aim[1], pose.aim[2]};
}
CameraPose pose_of(const std::vector<double>& row) { return {{row[0], row[1], row[2]}, {row[3], row[4], row[5]}}; }

Done check_pose(const FieldRecipe& recipe, const CameraPose& pose) {
  for (const Point3& place : {pose.position, pose.aim})
    if (!(place.cwiseAbs().maxCoeff() <= kFarthestPlace))
      return no_field("the camera and its aim must stay near the field");
  if (auto frustum = frustum_of(recipe, pose); !frustum) return tl::unexpected(std::move(frustum.error()));
  return {};
}

}  // namespace

FrustumCamera<double, 3> camera_of(const FieldRecipe& recipe, const CameraPose& pose) {
  FrustumCamera<double, 3> camera;
  const Point3 back = (pose.position - pose.aim).normalized(), right = Point3(back[2], 0, -back[0]).normalized();
  camera.position = pose.position;
  camera.axes.col(0) = right;
  camera.axes.col(1) = back.cross(right);
  camera.axes.col(2) = back;
  camera.half_tangents = {recipe.tangents[0], recipe.tangents[1]};
  camera.near = recipe.near;
  camera.far = recipe.far;
  return camera;
}

tl::expected<Frustum<double, 3>, InputError> frustum_of(const FieldRecipe& recipe, const CameraPose& pose) {
  const Point3 way = pose.position - pose.aim;
  if (!(way.norm() > 0)) return no_field("the camera's aim is the camera's own position");
  constexpr double kSteepest = 1e-3;  // sideways over the whole length: nearer to upright, left and right mean nothing
  if (!(way[0] * way[0] + way[2] * way[2] > kSteepest * kSteepest * way.squaredNorm()))
    return no_field("the camera must not look straight up or down");
  return frustum_of_camera(camera_of(recipe, pose));
}

std::shared_ptr<const hierarchy::Field> field_by(const FieldRecipe& recipe, std::uint64_t seed) {
  Random random(seed);
  std::vector<hierarchy::Field::Box> boxes(recipe.objects);
  const Point3 low(-recipe.reach, 0, -recipe.reach), high(recipe.reach, recipe.height, recipe.reach);
  for (auto& box : boxes)
    for (int axis = 0; axis < 3; ++axis) {
      const double center = random.between(low[axis], high[axis]);
      const double half = random.between(recipe.size[0], recipe.size[1]);
      box.min[axis] = center - half, box.max[axis] = center + half;
    }
  return std::make_shared<const hierarchy::Field>(std::move(boxes));
}

Done check_stage(const FieldStage& stage) {
  if (stage.recipe.objects < kFewestObjects || stage.recipe.objects > kMostObjects)
    return no_field("there must be " + std::to_string(kFewestObjects) + " to " + count_text(kMostObjects) + " objects");
  for (const CameraPose& pose : {stage.now, stage.before})
    if (Done fine = check_pose(stage.recipe, pose); !fine) return fine;
  return {};
}

Rows rows_of(const FieldStage& stage) {
  return {row_of(stage.now), row_of(stage.before), {static_cast<double>(stage.recipe.objects)}};
}

tl::expected<FieldStage, InputError> with_rows(const FieldStage& like, const Rows& rows) {
  if (rows.size() != 3 || rows[0].size() != 6 || rows[1].size() != 6 || rows[2].size() != 1)
    return no_field("a field must have six numbers for each of two frames, and the number of objects");
  FieldStage next = like;
  next.now = pose_of(rows[0]);
  next.before = pose_of(rows[1]);
  const double objects = rows[2][0];
  if (!(objects >= kFewestObjects && objects <= kMostObjects) || objects != std::floor(objects))
    return no_field("the number of objects must be a whole number in range");
  next.recipe.objects = static_cast<int>(objects);
  if (Done fine = check_stage(next); !fine) return tl::unexpected(std::move(fine.error()));
  return next;
}

void read_field(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<FieldTables>();
  TomlTable own(*table.table("field"), "[field]", complaints);
  lesson.points.dim = 3;
  const std::size_t before = complaints.count();
  FieldStage& stage = tables->stage;
  stage.recipe = read_field_recipe(own);
  read_spot(own, "camera", stage.now.position, true);
  read_spot(own, "aim", stage.now.aim, true);
  stage.before = stage.now;
  read_spot(own, "camera_before", stage.before.position, false);
  read_spot(own, "aim_before", stage.before.aim, false);
  if (own.refuse_others() && complaints.count() == before)
    if (const Done fine = check_stage(stage); !fine) own.wrong("camera", fine.error().what);
  lesson.tables = std::move(tables);
}

Rows read_field_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  const toml::table* model = task.table("model");
  if (model == nullptr) return task.lack("model", "the task lacks [task.model]"), Rows();
  TomlTable own(*model, "[task.model]", complaints);
  const std::size_t before = complaints.count();
  FieldStage stage = static_cast<const FieldTables&>(*lesson.tables).stage;
  stage.before = stage.now;
  read_spot(own, "camera", stage.now.position, false);
  read_spot(own, "aim", stage.now.aim, false);
  if (own.refuse_others() && complaints.count() == before)
    if (const Done fine = check_stage(stage); !fine) own.wrong("camera", fine.error().what);
  return rows_of(stage);
}

}  // namespace snug::lesson
