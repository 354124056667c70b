#include "lesson/subjects/scene/read_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/pose.hpp"
#include "lesson/ask.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "lesson/subjects/scene/scene_text.hpp"
#include "scene/effect.hpp"

namespace snug::lesson {
namespace {

using V3 = Vector<double, 3>;

V3 vector_or(TomlTable& table, std::string_view key, const V3& otherwise) {
  if (!table.has(key)) return otherwise;
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  table.wrong(key, "must be three numbers");
  return otherwise;
}

constexpr double kMostLength = 1e9;
double length(TomlTable& table, std::string_view key) { return table.number(key, kMostLength); }

/// Reads half extents; each must be a length, like a radius.
V3 half_extents(TomlTable& table) {
  const V3 half = vector_or(table, "half_extents", V3::Constant(0.5));
  for (int axis = 0; axis < 3; ++axis)
    if (!(half[axis] > 0 && half[axis] <= kMostLength))
      table.wrong("half_extents", "must be above 0 and at most 1000000000");
  return half;
}

/// An orientation from degrees about x, then y, then z.
Quaternion turned_by(const V3& degrees) {
  Quaternion turn;
  for (int axis = 0; axis < 3; ++axis)
    turn = quaternion_about(V3::Unit(axis), degrees[axis] * std::numbers::pi / 180) * turn;
  return turn;
}

/// Reads a shape by its name, about the body's origin.
void read_shape(TomlTable& table, SceneBody& one, bool has_mesh) {
  const std::string shape = table.text("shape");
  if (shape == "sphere") {
    one.body.shape = scene::Volume3(Sphere<double, 3>{V3::Zero(), length(table, "radius")});
  } else if (shape == "box") {
    const V3 half = half_extents(table);
    one.body.shape = scene::Volume3(Aabb<double, 3>{-half, half});
  } else if (shape == "capsule") {
    const double half = table.has("half_length") ? length(table, "half_length") : 0.5;
    one.body.shape = scene::Volume3(Capsule<double, 3>{{-half, 0, 0}, {half, 0, 0}, length(table, "radius")});
  } else if (shape == "points" || shape == "mesh") {
    one.of_points = true;
    if (shape == "mesh" && !has_mesh) table.wrong("shape", "is a mesh, and [points] names none");
  } else {
    for (const std::string_view key : {"half_extents", "radius", "half_length"}) table.allow(key);
    if (!shape.empty()) table.wrong("shape", "is none of sphere, box, capsule, points or mesh: " + shape);
  }
}

int read_color(TomlTable& table) {
  const std::string color = table.text("color");
  check_name(table, "color", color, kBodyColors);
  const auto found = std::find(kBodyColors.begin(), kBodyColors.end(), color);
  return found == kBodyColors.end() ? -1 : static_cast<int>(found - kBodyColors.begin());
}

SceneBody read_body(const toml::table& toml, bool has_mesh, Complaints& complaints) {
  TomlTable table(toml, "[[scene.body]]", complaints);
  SceneBody one;
  one.body.line = table.place().line;
  one.body.name = table.text_or("name", "");
  read_shape(table, one, has_mesh);
  one.at_points = table.flag_or("at_points", false);
  if (table.has("color")) one.color = read_color(table);
  one.body.position = vector_or(table, "position", V3::Zero());
  one.body.orientation = turned_by(vector_or(table, "turn", V3::Zero()));
  one.body.fixed = table.flag_or("fixed", false);
  one.body.velocity = vector_or(table, "velocity", V3::Zero());
  one.body.angular_velocity = vector_or(table, "turning", V3::Zero()) * (std::numbers::pi / 180);
  one.body.mass = table.any_number("mass", one.body.mass);
  if (one.of_points && one.at_points) table.wrong("at_points", "is for bodies of a shape of their own");
  if (one.at_points && !one.body.name.empty()) table.wrong("name", "would be that of several bodies");
  table.allow("color");
  table.refuse_others();
  return one;
}

/// Reads a setting. Places are lists of three numbers, which a setting keeps one after the other.
scene::Setting read_setting(TomlTable& table, const std::string& key, const toml::node& node) {
  const int line = table.place_of(key).line;
  if (node.is_string()) return {key, {}, table.text(key), line};
  if (key != "places") return {key, table.numbers(key), {}, line};
  scene::Setting places{key, {}, {}, line};
  for (const V3& place : table.points(key, 3))
    places.numbers.insert(places.numbers.end(), {place[0], place[1], place[2]});
  return places;
}

/// Reads an effect, and whether the scene calls for it from the start.
std::pair<scene::EffectCall, bool> read_effect(const toml::table& toml, const std::vector<SceneBody>& bodies,
                                               Complaints& complaints) {
  TomlTable table(toml, "[[scene.effect]]", complaints);
  scene::EffectCall call{.name = table.text("effect"), .body = table.text_or("body", ""), .line = table.place().line};
  std::vector<std::string_view> effects, names;
  for (const scene::EffectKind& kind : scene::catalogue()) effects.push_back(kind.name);
  for (const SceneBody& one : bodies)
    if (!one.body.name.empty()) names.push_back(one.body.name);
  check_name(table, "effect", call.name, effects);
  if (!names.empty()) check_name(table, "body", call.body, names);
  const bool called = table.flag_or("called", true);
  for (const auto& [key, node] : toml) {
    const std::string name(key.str());
    if (name == "effect" || name == "body" || name == "called") continue;
    call.settings.push_back(read_setting(table, name, node));
  }
  table.refuse_others();
  return {std::move(call), called};
}

void check_figure(TomlTable& table, const std::string& figure) {
  if (figure != kOverHull) check_name(table, "figure", figure, scene_figure_names());
}

}  // namespace

SceneSet read_scene_of(TomlTable& lesson, int dim, Complaints& complaints) {
  SceneSet set;
  const toml::table* own = lesson.table("scene");
  if (own == nullptr) return lesson.lack("scene", lesson.name() + " lacks [scene]"), set;
  if (dim != 3) complaints.add(file_place(*own), "a scene is in space: \"dim\" of [points] must be 3");
  const toml::table* points = lesson.table("points");
  set = read_scene_table(*own, points != nullptr && points->contains("mesh"), false, complaints);
  set.text = write_scene(*own);
  return set;
}

SceneSet read_scene_table(const toml::table& scene, bool has_mesh, bool graph, Complaints& complaints) {
  SceneSet set;
  TomlTable table(scene, "[scene]", complaints);
  set.frames = static_cast<int>(table.integer_or("frames", 1, 2000, set.frames));
  set.line = table.place().line, set.frames_line = table.place_of("frames").line;
  set.step = table.any_number("step", set.step);
  for (const toml::table* body : table.tables("body")) set.bodies.push_back(read_body(*body, has_mesh, complaints));
  set.graph = table.flag_or("graph", graph);
  for (const toml::table* effect : table.tables("effect")) {
    auto [call, called] = read_effect(*effect, set.bodies, complaints);
    (called ? set.effects : set.spare).push_back(std::move(call));
  }
  if (!set.spare.empty() && !set.graph)
    complaints.add(table.place(), "an effect that is not called for needs \"graph = true\", where students add it");
  if (set.bodies.empty()) complaints.add(table.place(), "[scene] has no [[scene.body]]");
  table.refuse_others();
  return set;
}

void read_ranges(TomlTable& table, Question& question) {
  question.figure = table.text("figure");
  check_figure(table, question.figure);
  read_bounds(table, question);
}

}  // namespace snug::lesson
