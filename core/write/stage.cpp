#include "write/stage.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/aabb_forms.hpp"
#include "io/text.hpp"
#include "query/cull/vertices_along.hpp"
#include "write/inputs.hpp"
#include "write/make.hpp"
#include "write/shape.hpp"

namespace snug::write {
namespace stage {
namespace {

std::string number(double value) { return io::shortest_text(value == 0 ? 0 : value); }

std::string list(const std::vector<double>& values) {
  std::string text = "[";
  for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? ", " : "") + number(values[i]);
  return text + ']';
}
template <int Dim>
std::string list(const Vector<double, Dim>& p) {
  return list(std::vector<double>(p.data(), p.data() + Dim));
}

/// The degrees about x, y and z, in this order, that turn the axes of the world into these. For showing alone, as they
/// round.
Vector3 degrees_of(const Matrix<double, 3>& axes) {
  constexpr double kDegree = 180 / std::numbers::pi;
  const double y = std::asin(std::clamp(-axes(2, 0), -1.0, 1.0));
  const bool locked = std::abs(axes(2, 0)) > 1 - 1e-9;
  const double x = locked ? std::atan2(-axes(1, 2), axes(1, 1)) : std::atan2(axes(2, 1), axes(2, 2));
  const double z = locked ? 0 : std::atan2(axes(1, 0), axes(0, 0));
  return kDegree * Vector3(x, y, z);
}

// ---- volumes, as [volumes] has them ------------------------------------------------------------------------------

/// How two numbers an axis stand for a box.
enum class Form : std::uint8_t { kMinMax, kMinWidths, kCenterRadius };

template <Form form>
std::string aabb(Take& take) {
  const Vector3 first = take.vector(), second = take.vector();
  const Vector3 min = form == Form::kCenterRadius ? Vector3(first - second) : first;
  const Vector3 max = form == Form::kMinMax ? second : Vector3(first + second);
  return "{ aabb = { min = " + list(min) + ", max = " + list(max) + " } }";
}
std::string sphere_at(const Vector3& center, double radius) {
  return "{ sphere = { center = " + list(center) + ", radius = " + number(radius) + " } }";
}
std::string sphere(Take& take) {
  const Vector3 center = take.vector();
  return sphere_at(center, take.number());
}
std::string point(Take& take) { return sphere_at(take.vector(), 0); }
std::string capsule_at(const Vector3& a, const Vector3& b, double radius) {
  return "{ capsule = { a = " + list(a) + ", b = " + list(b) + ", radius = " + number(radius) + " } }";
}
std::string capsule(Take& take) {
  const Vector3 a = take.vector(), b = take.vector();
  return capsule_at(a, b, take.number());
}
std::string segment(Take& take) {
  const Vector3 a = take.vector();
  return capsule_at(a, take.vector(), 0);
}
std::string kdop(Take& take) {
  std::vector<double> min(7), max(7);
  for (double& one : min) one = take.number();
  for (double& one : max) one = take.number();
  return "{ kdop = { k = 14, min = " + list(min) + ", max = " + list(max) + " } }";
}
std::string obb(Take& take) {
  const Vector3 center = take.vector();
  const Matrix<double, 3> axes = take.rows().transpose();
  return "{ obb = { center = " + list(center) + ", half_extents = " + list(take.vector()) +
         ", turn = " + list(degrees_of(axes)) + " } }";
}

using Written = std::string (*)(Take&);
template <Written a, Written b>
std::string pair(const Numbers& input) {
  Take take(input);
  const std::string first = a(take);
  return "[volumes]\ndim = 3\na = " + first + "\nb = " + b(take) + '\n';
}

// ---- points ------------------------------------------------------------------------------------------------------

template <int Dim>
std::string points(const Numbers& input) {
  Take take(input);
  std::string text = "[points]\ndim = " + std::to_string(Dim) + "\nlist = [";
  for (double left = take.number(); left > 0; --left) {
    std::vector<double> p(Dim);
    for (double& one : p) one = take.number();
    text += list(p) + (left > 1 ? ", " : "");
  }
  return text + "]\n";
}

// ---- a box and a frustum -------------------------------------------------------------------------------------------

/// The axes of a view: along it, and two across it.
Matrix<double, 3> axes_along(const Vector3& view) {
  int least = 0;
  view.cwiseAbs().minCoeff(&least);
  Matrix<double, 3> axes;
  axes.col(0) = view;
  axes.col(1) = view.cross(Vector3::Unit(least)).normalized();
  axes.col(2) = view.cross(axes.col(1));
  return axes;
}

/// far: half of the far face.
std::string box_and_frustum(const Aabb<double, 3>& box, const Camera& camera, double far) {
  const Vector3 half = (box.max - box.min) / 2, at = camera.apex + camera.view * ((camera.near + camera.far) / 2);
  const Vector3 frustum((camera.far - camera.near) / 2, far, far);
  const Vector3 middle = box.min + half;
  return "[boxes]\ndim = 3\ntaper = " + number(camera.near / camera.far) + "\ncenter = [" + list(middle) + ", " +
         list(at) + "]\nhalf_extents = [" + list(half) + ", " + list(frustum) + "]\nturn = [[0, 0, 0], " +
         list(degrees_of(axes_along(camera.view))) + "]\n";
}

std::string culled(const Numbers& input) {
  const CullInput own = cull_input_of(input);
  const Camera camera = *camera_of(own.planes);
  return box_and_frustum(own.box, camera, camera.far);
}

/// A camera that looks along the normal. Its far plane cuts the box, which is within the others: so this plane has the
/// p-vertex outside and the n-vertex inside.
std::string vertices(const Numbers& input) {
  Take take(input);
  Aabb<double, 3> box;
  box.min = take.vector(), box.max = take.vector();
  const Vector3 view = take.vector().stableNormalized(), center = box.min + (box.max - box.min) / 2;
  const double radius = (box.max - box.min).norm() / 2, size = radius > 0 ? radius : 1;
  const Camera camera{.apex = center - 6 * size * view, .view = view, .near = 3 * size, .far = 6 * size};
  return box_and_frustum(box, camera, 2 * size);
}

// ---- a body that has rotated ---------------------------------------------------------------------------------------

std::string rotated(const Numbers& input) {
  Take take(input);
  const Vector3 center = take.vector(), extents = take.vector();
  std::string vertices;
  for (int bits = 0; bits < 8; ++bits)
    vertices += (bits > 0 ? ", " : "") + list(query::corner_of(AabbCenterExtents<double, 3>{center, extents}, bits));
  return "[points]\ndim = 3\nlist = [" + vertices + "]\n\n[body]\nturn = " + list(degrees_of(take.rows())) + '\n';
}

// ---- a tree and a ray ----------------------------------------------------------------------------------------------

std::string tree_and_ray(const Numbers& input) {
  const auto [nodes, ray] = ray_input_of(input);
  std::string centers, halves;
  for (const Node& node : nodes) {
    if (node.left >= 0) continue;
    const Point2 half = (node.box.max - node.box.min) / 2;
    centers += (centers.empty() ? "" : ", ") + list(Point2(node.box.min + half));
    halves += (halves.empty() ? "" : ", ") + list(half);
  }
  // As long as the tree is wide, so that the place that it goes through is seen beside it.
  const double size = (nodes[0].box.max - nodes[0].box.min).maxCoeff(), length = ray.direction.norm();
  const Point2 through = ray.origin + ray.direction * (size > 0 ? size / length : 1);
  return "[objects]\ncenter = [" + centers + "]\nhalf_extents = [" + halves +
         "]\n\n[query]\nfrom = " + list(ray.origin) + "\nto = " + list(through) + "\ntree = \"top_down_median\"\n";
}

/// "On the stage node 1 is A, node 2 is B."
std::string leaf_names(const Numbers& input) {
  const auto nodes = ray_input_of(input).nodes;
  std::string text;
  char name = 'A';
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].left >= 0) continue;
    text += (text.empty() ? "On the stage node " : ", node ") + std::to_string(i) + " is " + name;
    ++name;
  }
  return text + '.';
}

/// What shows a function's input: a lesson's volume, its algorithm, and the table with what stands on the stage.
struct Row {
  std::string_view function, volume, algorithm;
  std::string (*table)(const Numbers& input);
  std::string (*names)(const Numbers& input) = nullptr;  // what the stage calls what the function was given
  Written answer = nullptr;                              // what the function gives, beside two volumes
};
constexpr std::array kRows{
    Row{"overlap-min-max", "volume_pair", "min_max", pair<aabb<Form::kMinMax>, aabb<Form::kMinMax>>},
    Row{"overlap-min-widths", "volume_pair", "min_widths", pair<aabb<Form::kMinWidths>, aabb<Form::kMinWidths>>},
    Row{"overlap-center-radius", "volume_pair", "center_radius",
        pair<aabb<Form::kCenterRadius>, aabb<Form::kCenterRadius>>},
    Row{"overlap-kdop", "volume_pair", "slabs", pair<kdop, kdop>},
    Row{"overlap-spheres", "volume_pair", "spheres", pair<sphere, sphere>},
    Row{"grow-sphere", "volume_pair", "spheres", pair<sphere, point>, nullptr, sphere},
    Row{"closest-on-segment", "volume_pair", "swept_spheres", pair<point, segment>, nullptr, point},
    Row{"overlap-capsules", "volume_pair", "swept_spheres", pair<capsule, capsule>},
    Row{"sat", "volume_pair", "separating_axes", pair<obb, obb>},
    Row{"sat-row", "volume_pair", "separating_axes", pair<obb, obb>},
    Row{"p-and-n-vertex", "frustum_box", "p_n_vertex", vertices},
    Row{"cull-box", "frustum_box", "p_n_vertex", culled},
    Row{"rotated-aabb", "update", "rotated_box", rotated},
    Row{"first-hit", "bvh_query", "ray_nearest", tree_and_ray, leaf_names},
    Row{"covariance", "obb", "pca", points<3>},
    Row{"farthest-from-edge", "hull", "quickhull", points<2>},
    Row{"smallest-sphere", "sphere", "welzl", points<3>},
};

/// Whether a lesson takes it: it is no farther off than any case, and a radius is not negative.
bool can_stand(const Function& function, const Numbers& answer) {
  constexpr double kFarthest = 1e12, kLargest = 1e6;
  const bool has_radius = function.gives.find("radius") != std::string_view::npos;
  return std::all_of(answer.begin(), answer.end(), [](double one) { return std::abs(one) <= kFarthest; }) &&
         (!has_radius || (answer.back() >= 0 && answer.back() <= kLargest));
}

std::string answers(const Row& row, const Function& function, const Numbers& input, const Answered& answer) {
  std::string text;
  const auto add = [&](std::string_view key, const Numbers& numbers) {
    Take take(numbers);
    if (can_stand(function, numbers)) text += std::string(key) + " = " + row.answer(take) + '\n';
  };
  if (row.answer == nullptr) return text;
  add("right", function.right(input));
  if (answer && fits(function.gives, *answer)) add("yours", *answer);
  return text;
}

/// A paragraph for a lesson's text, without the characters that would be markup there.
std::string plain(std::string_view told) {
  std::string text;
  for (const char c : told)
    if (c == '\n') text += "\n\n";
    else if (std::string_view("{}*[]`\\\"$_").find(c) == std::string_view::npos) text += c;
    else text += c == '[' ? "(" : c == ']' ? ")" : c == '_' ? " " : "";
  return text;
}

}  // namespace
}  // namespace stage

std::string lesson_of(const Function& function, const Numbers& input, const Answered& answer, std::string_view told) {
  for (const stage::Row& row : stage::kRows)
    if (row.function == function.id)
      return "version = 2\ntitle = \"A case on which your function differs\"\n"
             "summary = \"What it was given, on the stage.\"\nminutes = 1\nvolume = \"" +
             std::string(row.volume) + "\"\nalgorithms = [\"" + std::string(row.algorithm) + "\"]\n\n" +
             row.table(input) + stage::answers(row, function, input, answer) +
             "\n[[section]]\ntitle = \"What your function was given\"\ntext = \"\"\"\n" + stage::plain(told) +
             (row.names != nullptr ? "\n\n" + row.names(input) : "") + "\n\"\"\"\n";
  return {};
}

}  // namespace snug::write
