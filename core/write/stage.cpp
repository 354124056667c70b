#include "write/stage.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "fit/obb/obb_frame.hpp"
#include "fit/obb/principal_axes.hpp"
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
  // An answer may be inside out.
  return "{ aabb = { min = " + list(Vector3(min.cwiseMin(max))) + ", max = " + list(Vector3(min.cwiseMax(max))) +
         " } }";
}
template <int Dim>
std::string sphere_at(const Vector<double, Dim>& center, double radius = 0) {
  return "{ sphere = { center = " + list(center) + ", radius = " + number(radius) + " } }";
}
std::string sphere(Take& take) {
  const Vector3 center = take.vector();
  return sphere_at<3>(center, take.number());
}
std::string point(Take& take) { return sphere_at<3>(take.vector()); }
template <int Dim>
std::string capsule_at(const Vector<double, Dim>& a, const Vector<double, Dim>& b, double radius = 0) {
  return "{ capsule = { a = " + list(a) + ", b = " + list(b) + ", radius = " + number(radius) + " } }";
}
std::string capsule(Take& take) {
  const Vector3 a = take.vector(), b = take.vector();
  return capsule_at<3>(a, b, take.number());
}
std::string kdop(Take& take) {
  std::vector<double> min(7), max(7);
  for (double& one : min) one = take.number();
  for (double& one : max) one = take.number();
  return "{ kdop = { k = 14, min = " + list(min) + ", max = " + list(max) + " } }";
}
std::string obb_at(const Vector3& center, const Matrix<double, 3>& axes, const Vector3& half_extents) {
  return "{ obb = { center = " + list(center) + ", half_extents = " + list(half_extents) +
         ", turn = " + list(degrees_of(axes)) + " } }";
}
std::string obb(Take& take) {
  const Vector3 center = take.vector();
  const Matrix<double, 3> axes = take.rows().transpose();
  const Vector3 half_extents = take.vector();
  const bool quarter_turns = (axes.array() == 0 || axes.array().abs() == 1).all();
  if (!quarter_turns) return obb_at(center, axes, half_extents);
  // Degrees would round: boxes that only touch would not.
  return obb_at(center, Matrix<double, 3>::Identity(), axes.cwiseAbs() * half_extents);
}

/// The volumes that numbers may be, by their shapes.
struct VolumeShape {
  std::string_view shape;
  std::string (*written)(Take&);
};
constexpr std::array kVolumes{
    VolumeShape{"3n", point},
    VolumeShape{"{center:3n,radius:n}", sphere},
    VolumeShape{"{min:3n,max:3n}", aabb<Form::kMinMax>},
    VolumeShape{"{min:3n,widths:3n}", aabb<Form::kMinWidths>},
    VolumeShape{"{center:3n,half_extents:3n}", aabb<Form::kCenterRadius>},
    VolumeShape{"{center:3n,axes:33n,half_extents:3n}", obb},
    VolumeShape{"{a:3n,b:3n,radius:n}", capsule},
    VolumeShape{"{min:7n,max:7n}", kdop},
};
/// Empty if they are none.
std::string volume(std::string_view shape, Take& take) {
  for (const VolumeShape& one : kVolumes)
    if (one.shape == shape) return one.written(take);
  return {};
}

struct Field {
  std::string_view name, shape;
};
/// The fields of an object's shape; none of another.
std::vector<Field> fields_of(std::string_view shape) {
  std::vector<Field> fields;
  int depth = 0;
  std::size_t from = 1, colon = 0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    depth += shape[i] == '{' ? 1 : shape[i] == '}' ? -1 : 0;
    if (depth == 1 && shape[i] == ':') colon = i;
    if (depth != (shape[i] == '}' ? 0 : 1) || (shape[i] != ',' && shape[i] != '}')) continue;
    fields.push_back({shape.substr(from, colon - from), shape.substr(colon + 1, i - colon - 1)});
    from = i + 1;
  }
  return fields;
}

std::string pair(const std::string& a, const std::string& b) {
  return "[volumes]\ndim = 3\na = " + a + "\nb = " + b + '\n';
}

/// What stands beside. is: "right", "yours" or "given".
std::string beside(std::string_view is, const std::string& name, const std::string& volume) {
  return "[[beside]]\nis = \"" + std::string(is) + '"' + (name.empty() ? "" : "\nname = \"" + name + '"') +
         "\nvolume = " + volume + '\n';
}

/// The first two of what a function takes, and along the axis between them that may follow a line.
std::string volumes(const Function& function, const Numbers& input) {
  const auto fields = fields_of(function.takes);
  Take take(input);
  const std::string first = volume(fields[0].shape, take);
  const std::string text = pair(first, volume(fields[1].shape, take));
  if (fields.size() < 3) return text;
  const Vector3 axis = take.vector(), a(input.data()),
                b(input.data() + (input.size() - 3) / 2);  // a volume's centre is first
  const Vector3 middle = (a + b) / 2, half = axis * (b - a).norm();
  return text + beside("given", "axis", capsule_at<3>(middle - half, middle + half));
}

std::string point_and_segment(const Function&, const Numbers& input) {
  Take take(input);
  const std::string p = point(take);
  const Vector3 a = take.vector();
  const std::string segment = capsule_at<3>(a, take.vector());
  return pair(p, segment) + beside("given", "", segment);
}
std::string segment_names(const Numbers&) { return "A is the point p, and the ends of B are a and b."; }
std::string sphere_names(const Numbers&) { return "A is the sphere, and B the point."; }

// ---- points ------------------------------------------------------------------------------------------------------

template <int Dim>
std::string points(const Function&, const Numbers& input) {
  Take take(input);
  std::string text = "[points]\ndim = " + std::to_string(Dim) + "\nlist = [";
  for (double left = take.number(); left > 0; --left) {
    std::vector<double> p(Dim);
    for (double& one : p) one = take.number();
    text += list(p) + (left > 1 ? ", " : "");
  }
  return text + "]\n";
}

Point2 point_at(const Numbers& input, std::size_t i) { return Point2(input.data() + 1 + 2 * i); }
std::string point_named(const Numbers& input, std::size_t i) { return sphere_at<2>(point_at(input, i)); }

std::string points_and_edge(const Function& function, const Numbers& input) {
  const auto a = static_cast<std::size_t>(input[input.size() - 2]), b = static_cast<std::size_t>(input.back());
  return points<2>(function, input) + beside("given", "a", point_named(input, a)) +
         beside("given", "b", point_named(input, b)) +
         beside("given", "", capsule_at<2>(point_at(input, a), point_at(input, b)));
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

std::string culled(const Function&, const Numbers& input) {
  const CullInput own = cull_input_of(input);
  const Camera camera = *camera_of(own.planes);
  return box_and_frustum(own.box, camera, camera.far);
}

/// A camera that looks along the normal. Its far plane cuts the box, which is within the others: so this plane has the
/// p-vertex outside and the n-vertex inside.
std::string vertices(const Function&, const Numbers& input) {
  Take take(input);
  Aabb<double, 3> box;
  box.min = take.vector(), box.max = take.vector();
  const Vector3 view = take.vector().stableNormalized(), center = box.min + (box.max - box.min) / 2;
  const double radius = (box.max - box.min).norm() / 2, size = radius > 0 ? radius : 1;
  const Camera camera{.apex = center - 3 * size * view, .view = view, .near = 2 * size, .far = 3 * size};
  return box_and_frustum(box, camera, 1.5 * size) +
         beside("given", "normal", capsule_at<3>(center, center + 1.5 * size * view));
}
std::string normal_names(const Numbers&) { return "The frustum's far plane has this normal."; }

// ---- a body that has rotated ---------------------------------------------------------------------------------------

std::string rotated(const Function&, const Numbers& input) {
  Take take(input);
  const Vector3 center = take.vector(), extents = take.vector();
  std::string vertices;
  for (int bits = 0; bits < 8; ++bits)
    vertices += (bits > 0 ? ", " : "") + list(query::corner_of(AabbCenterExtents<double, 3>{center, extents}, bits));
  return "[points]\ndim = 3\nlist = [" + vertices + "]\n\n[body]\nturn = " + list(degrees_of(take.rows())) + '\n';
}

// ---- a tree and a ray ----------------------------------------------------------------------------------------------

std::string tree_and_ray(const Function&, const Numbers& input) {
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

/// "Node 1 is called A, node 2 is called B."
std::string leaf_names(const Numbers& input) {
  const auto nodes = ray_input_of(input).nodes;
  std::string text;
  char name = 'A';
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].left >= 0) continue;
    text += (text.empty() ? "Node " : ", node ") + std::to_string(i) + " is called " + name;
    ++name;
  }
  return text + '.';
}

std::string leaf(const Numbers& input, std::size_t i) {
  const auto box = ray_input_of(input).nodes[i].box;
  return "{ aabb = { min = " + list(box.min) + ", max = " + list(box.max) + " } }";
}

/// How inputs that are no two volumes are shown.
struct Row {
  std::string_view takes;
  std::string (*table)(const Function& function, const Numbers& input);
  std::string (*element)(const Numbers& input, std::size_t i) = nullptr;  // the one that an index means
  std::string (*names)(const Numbers& input) = nullptr;  // what the stage calls what the function was given
};
constexpr std::array kRows{
    Row{"{p:3n,a:3n,b:3n}", point_and_segment, nullptr, segment_names},
    Row{"{sphere:{center:3n,radius:n},point:3n}", volumes, nullptr, sphere_names},
    Row{"{points:*3n}", points<3>},
    Row{"{points:*2n,a:i,b:i}", points_and_edge, point_named},
    Row{"{box:{center:3n,half_extents:3n},rotation:33n}", rotated},
    Row{"{box:{min:3n,max:3n},normal:3n}", vertices, nullptr, normal_names},
    Row{"{planes:*{normal:3n,d:n},box:{min:3n,max:3n}}", culled},
    Row{"{nodes:*{min:2n,max:2n,parent:i,left:i,right:i},ray:{origin:2n,direction:2n}}", tree_and_ray, leaf,
        leaf_names},
    Row{"", volumes},
};
const Row& row_of(const Function& function) {
  return *std::find_if(kRows.begin(), kRows.end() - 1, [&](const Row& row) { return row.takes == function.takes; });
}

/// Whether a lesson takes it: it is no farther off than any case, and a radius is not negative.
bool can_stand(const Function& function, const Numbers& answer) {
  constexpr double kFarthest = 1e12, kLargest = 1e6;
  const bool has_radius = function.gives.find("radius") != std::string_view::npos;
  return std::all_of(answer.begin(), answer.end(), [](double one) { return std::abs(one) <= kFarthest; }) &&
         (!has_radius || (answer.back() >= 0 && answer.back() <= kLargest));
}

// ---- answers that are no volumes themselves -----------------------------------------------------------------------

/// A covariance as a box around the points' mean, along its eigenvectors. Empty if it is no covariance.
std::string deviations(const Numbers& input, const Numbers& answer, const std::string& is) {
  constexpr double kNearEnough = 1e-9;  // of the largest entry
  Take take(answer), points(input);
  const Matrix<double, 3> matrix = take.rows();
  const double enough = kNearEnough * matrix.cwiseAbs().maxCoeff();
  if ((matrix - matrix.transpose()).cwiseAbs().maxCoeff() > enough) return {};
  const double n = points.number();
  const Vector3 first = points.vector();
  Vector3 mean = first;
  for (double i = 1; i < n; ++i) mean += (points.vector() - first) / n;
  const auto found = fit::principal_axes<double, 3>({mean, matrix});
  if (found.variances.minCoeff() < -enough) return {};
  const Vector3 half = (found.variances.array() > enough).select(found.variances.cwiseSqrt(), 0);
  const Matrix<double, 3> axes = fit::right_handed<double, 3>(found.axes);
  const auto flat = (half.array() == 0).count();
  if (flat == 3) return beside(is, is, sphere_at<3>(mean));
  // The edges of a box without width would fill the gaps between each other's dashes.
  const Vector3 along = axes * half;
  return beside(is, is, flat == 2 ? capsule_at<3>(mean - along, mean + along) : obb_at(mean, axes, half));
}

/// "right p", "your p"
std::string named(const std::string& is, std::string_view part) {
  return (is == "yours" ? "your" : is) + ' ' + std::string(part);
}

/// A row's projections of A and B as segments along the axis, beside the boxes: what is right next to them, then yours.
std::string projections(const Numbers& input, const Numbers& answer, const std::string& is) {
  struct Box {
    Vector3 center, half_extents;
    Matrix<double, 3> axes;
    [[nodiscard]] double radius(const Vector3& way) const {
      return (axes.transpose() * way).cwiseAbs().dot(half_extents);
    }
  };
  Take take(input);
  std::array<Box, 2> boxes;
  for (auto& [center, half_extents, axes] : boxes)
    center = take.vector(), axes = take.rows().transpose(), half_extents = take.vector();
  const auto& [a, b] = boxes;
  const Vector3 axis = take.vector(), between = b.center - a.center;
  const Vector3 up = std::abs(axis[1]) < 0.9 ? Vector3::UnitY() : Vector3::UnitX();
  const Vector3 down = (axis * axis.dot(up) - up).normalized();
  const double size = std::max({a.half_extents.norm(), b.half_extents.norm(), between.norm()});
  const double below = std::max(a.radius(down), between.dot(down) + b.radius(down)),
               step = 0.12 * (size > 0 ? size : 1);
  std::string text;
  for (const int side : {0, 1}) {
    const double row = (is == "right" ? 2 : 4.5) + side, radius = answer[1 + side];
    const double along = side == 0 ? 0 : between.dot(axis) < 0 ? -answer[0] : answer[0];
    const Vector3 middle = a.center + down * (below + row * step) + axis * along;
    text += beside(is, named(is, side == 0 ? "A" : "B"),
                   radius == 0 ? sphere_at<3>(middle) : capsule_at<3>(middle - axis * radius, middle + axis * radius));
  }
  return text;
}

/// How answers that are no volumes themselves are drawn.
struct Drawn {
  std::string_view gives;
  std::string (*beside)(const Numbers& input, const Numbers& answer, const std::string& is);
  std::string_view says;   // what it is that is drawn
  std::string_view both;   // how right and yours stand there
  std::string_view lacks;  // why yours is not there
};
constexpr std::array kDrawn{
    Drawn{"33n", deviations,
          "A matrix is drawn as a box around the mean, along its eigenvectors, as far as one standard deviation", "",
          ": it is not symmetric, or a variance is negative"},
    Drawn{"{distance:n,r_a:n,r_b:n}", projections, "Beside the boxes stand the projections of A and B on the axis",
          ", first as they are and then as you have them", ""},
};
/// Null for other answers.
const Drawn* drawn_of(const Function& function) {
  const auto* found =
      std::find_if(kDrawn.begin(), kDrawn.end(), [&](const Drawn& one) { return one.gives == function.gives; });
  return found == kDrawn.end() ? nullptr : found;
}

/// Whether it is made of numbers that a lesson takes.
bool is_of_numbers(const Function& function, const Answered& answer) {
  return answer && fits(function.gives, *answer) && can_stand(function, *answer);
}

/// What an answer is on the stage; empty if it is nothing there. is: "right" or "yours".
std::string answers_beside(const Function& function, const Row& row, const Numbers& input, const Answered& answer,
                           const std::string& is) {
  if (!is_of_numbers(function, answer)) return {};
  if (function.gives == "i") {
    const double i = answer->front();
    const bool is_one = row.element != nullptr && is_index(i, static_cast<std::size_t>(input[0]));
    return is_one ? beside(is, is, row.element(input, static_cast<std::size_t>(i))) : "";
  }
  if (const Drawn* drawn = drawn_of(function)) return drawn->beside(input, *answer, is);
  std::string text;
  Take take(*answer);
  if (const std::string whole = volume(function.gives, take); !whole.empty()) return beside(is, is, whole);
  for (const auto& [name, shape] : fields_of(function.gives))
    if (const std::string part = volume(shape, take); !part.empty()) text += beside(is, named(is, name), part);
  return text;
}

/// How right and yours are told apart on the stage; empty if neither stands there.
std::string told_apart(const Function& function, const Answered& answer, bool right, bool yours) {
  const std::string how = "yours has dots or a cross.";
  if (!right && !yours) return {};
  if (!right) return (function.gives == "i" ? "What is right is -1: none. On the stage " : "On the stage ") + how;
  const std::string text = "On the stage what is right has dashes or a ring; ";
  if (yours) return text + how;
  const bool is_drawable = is_of_numbers(function, answer);
  if (function.gives == "i" && is_drawable && answer->front() == -1) return text + "yours is -1: none.";
  const Drawn* drawn = drawn_of(function);
  return text + "yours cannot be drawn" + std::string(drawn != nullptr && is_drawable ? drawn->lacks : "") + '.';
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

std::string words_of(const Function& function, const Numbers& input, const Answered& answer) {
  const stage::Row& row = stage::row_of(function);
  const bool right = !stage::answers_beside(function, row, input, function.right(input), "right").empty();
  const bool yours = !stage::answers_beside(function, row, input, answer, "yours").empty();
  std::string text = stage::told_apart(function, answer, right, yours);
  if (const stage::Drawn* drawn = stage::drawn_of(function); drawn != nullptr && (right || yours))
    text += ' ' + std::string(drawn->says) + std::string(right && yours ? drawn->both : "") + '.';
  return row.names != nullptr ? text + (text.empty() ? "" : " ") + row.names(input) : text;
}

std::string lesson_of(const Function& function, const Numbers& input, const Answered& answer, std::string_view told) {
  const stage::Row& row = stage::row_of(function);
  const std::string table = row.table(function, input), method = '"' + std::string(function.stage) + '"';
  // What the stage computes is no smallest volume to compare with: right and yours stand there.
  const bool fits = table.starts_with("[points]") && table.find("[body]") == std::string::npos;
  return "version = 2\ntitle = \"A case on which your function differs\"\n"
         "summary = \"What it was given, on the stage.\"\nminutes = 1\nalgorithms = [" +
         method + "]\n" + (fits ? "reference = " + method + '\n' : "") + '\n' + table +
         stage::answers_beside(function, row, input, function.right(input), "right") +
         stage::answers_beside(function, row, input, answer, "yours") +
         "\n[[section]]\ntitle = \"What your function was given\"\ntext = \"\"\"\n" + stage::plain(told) + "\n\n" +
         words_of(function, input, answer) + "\n\"\"\"\n";
}

}  // namespace snug::write
