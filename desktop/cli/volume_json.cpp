#include "desktop/cli/volume_json.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "desktop/cli/words.hpp"
#include "fit/hull/quickhull.hpp"
#include "geometry/aabb_forms.hpp"
#include "geometry/convert.hpp"
#include "geometry/kdop.hpp"
#include "geometry/pose.hpp"
#include "geometry/tolerance.hpp"
#include "geometry/volume_fields.hpp"

namespace snug::desktop {
namespace {

using Point = Vector<double, 3>;
using Names = std::span<const std::string_view>;

std::string counted(std::size_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); }

std::string place(std::size_t i) { return "[" + std::to_string(i) + "]"; }

/// Reads the fields of an object, and keeps the first error; what is read after it does not matter. Planar points have
/// z = 0.
class Fields {
 public:
  explicit Fields(const VolumeWanted& wanted) : wanted_(wanted), dim_(wanted.dim), path_(wanted.name) {}

  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] std::string field(std::string_view name) const { return path_ + "." + std::string(name); }

  void fail(std::string what) {
    if (error_.empty()) error_ = std::move(what);
  }

  /// Enters the only volume in an object, and returns its kind. Other fields, such as a name or those of `snug fit`,
  /// are passed over.
  std::string enter(const Json& json) {
    const std::string self = path_.empty() ? "the volume" : path_;
    std::string kind;
    if (json.is_object())
      for (const std::string_view name : kVolumeNames) {
        if (!json.contains(std::string(name))) continue;
        if (!kind.empty()) fail(self + " is of two kinds: " + kind + " and " + std::string(name));
        kind = name;
      }
    if (kind.empty()) {
      const bool named = json.is_object() && json.size() == 1;
      fail(named
               ? self + " is not a known kind: " + Json(json.begin().key()).dump() + "; known: " + joined(kVolumeNames)
               : self + " is not an object with a field that names its kind: " + joined(kVolumeNames));
      return {};
    }
    path_ += (path_.empty() ? "" : ".") + kind;
    object_ = &json[kind];
    if (!object_->is_object()) fail(path_ + " is not an object");
    return kind;
  }

  /// Whether axes may be off by that much. Rough ones are counted, once for each field.
  [[nodiscard]] bool takes_off_by(double off, std::string_view name) {
    if (off <= tolerance::kAxesAsGiven) return true;
    if (wanted_.rough == nullptr || !(off <= tolerance::kAxesRough)) return false;
    if (rough_ == field(name)) return true;
    rough_ = field(name);
    if (++wanted_.rough->count == 1) wanted_.rough->first = rough_;
    return true;
  }

  [[nodiscard]] bool has(const char* name) const { return error_.empty() && object_->contains(name); }

  /// Checks that exactly these fields are there.
  void expect(Names names) {
    if (!error_.empty()) return;
    for (const auto& item : object_->items())
      if (std::find(names.begin(), names.end(), item.key()) == names.end())
        fail(path_ + " has an unknown field " + Json(item.key()).dump() + "; it takes " + joined(names));
    for (const std::string_view name : names)
      if (!object_->contains(std::string(name))) fail(field(name) + " is missing");
  }

  double not_negative(std::string_view name) {
    if (!error_.empty()) return 0;
    const double value = number_of(at(name), field(name));
    if (value < 0) fail(field(name) + " is negative");
    return value;
  }

  Point point(std::string_view name) { return error_.empty() ? point_of(at(name), field(name)) : Point(Point::Zero()); }

  Point not_negative_each(std::string_view name) {
    const Point value = point(name);
    for (int i = 0; i < 3; ++i)
      if (value[i] < 0) fail(field(name) + place(i) + " is negative");
    return value;
  }

  std::vector<Point> points(std::string_view name) {
    std::vector<Point> points;
    if (!error_.empty()) return points;
    const Json& list = at(name);
    if (!list.is_array()) fail(field(name) + " is not a list of points");
    for (std::size_t i = 0; i < list.size() && error_.empty(); ++i)
      points.push_back(point_of(list[i], field(name) + place(i)));
    return points;
  }

  std::vector<double> numbers(std::string_view name) {
    std::vector<double> numbers;
    if (!error_.empty()) return numbers;
    const Json& list = at(name);
    if (!list.is_array()) fail(field(name) + " is not a list of numbers");
    for (std::size_t i = 0; i < list.size() && error_.empty(); ++i)
      numbers.push_back(number_of(list[i], field(name) + place(i)));
    return numbers;
  }

  /// The k of a k-DOP, which determines the dimension if that is not known yet.
  int k() {
    if (!error_.empty()) return 0;
    const Json& json = at("k");
    const double value = json.is_number() ? json.get<double>() : 0;
    const int k = value > 0 && value < 100 && std::floor(value) == value ? static_cast<int>(value) : 0;
    if (dim_ == 0) dim_ = kdop_axes<3>(k).empty() && !kdop_axes<2>(k).empty() ? 2 : 3;
    const bool known = dim_ == 2 ? !kdop_axes<2>(k).empty() : !kdop_axes<3>(k).empty();
    const char* all = wanted_.dim == 2   ? "4, 6, 8 in 2-D"
                      : wanted_.dim == 3 ? "6, 14, 18, 26 in 3-D"
                                         : "6, 14, 18, 26, in 2-D 4, 6, 8";
    if (!known) fail(field("k") + " is not one of " + all);
    return k;
  }

 private:
  [[nodiscard]] const Json& at(std::string_view name) const { return (*object_)[std::string(name)]; }

  double number_of(const Json& json, const std::string& where) {
    if (!json.is_number()) fail(where + " is not a number");
    const double value = json.is_number() ? json.get<double>() : 0;
    if (!(std::abs(value) <= wanted_.largest))
      fail(where + " is larger than this program can take (" + wanted_.largest_said + ")");
    return value;
  }

  Point point_of(const Json& json, const std::string& where) {
    Point point = Point::Zero();
    const std::size_t size = json.is_array() ? json.size() : 0;
    if (!json.is_array()) fail(where + " is not a list of numbers");
    if (dim_ == 0 && (size == 2 || size == 3)) dim_ = static_cast<int>(size);
    if (dim_ == 0 || size != static_cast<std::size_t>(dim_))
      fail(where + " has " + counted(size, "number") + " instead of " + (dim_ == 0 ? "2 or 3" : std::to_string(dim_)));
    for (std::size_t i = 0; i < size && error_.empty(); ++i)
      point[static_cast<int>(i)] = number_of(json[i], where + place(i));
    return point;
  }

  const VolumeWanted& wanted_;
  int dim_;
  std::string path_;
  const Json* object_ = nullptr;
  std::string error_, rough_;
};

/// Reads axes as rows that are unit, perpendicular and right-handed: kept if they are so within rounding, else made so.
Matrix<double, 3> axes_of(Fields& fields, std::string_view field) {
  const std::vector<Point> rows = fields.points(field);
  const std::size_t dim = fields.dim();
  const std::string name = fields.field(field);
  if (rows.size() != dim)
    fields.fail(name + " has " + counted(rows.size(), "row") + " instead of " + std::to_string(dim));
  Matrix<double, 3> axes = Matrix<double, 3>::Identity();
  if (!fields.error().empty()) return axes;
  double most_off = 0;
  for (std::size_t i = 0; i < dim; ++i) {
    axes.col(static_cast<int>(i)) = rows[i];
    for (std::size_t j = 0; j <= i; ++j) {
      const double off = std::abs(rows[i].dot(rows[j]) - (i == j ? 1 : 0));
      if (!fields.takes_off_by(off, field))
        fields.fail(i == j ? name + place(i) + " is not of unit length"
                           : name + place(j) + " and " + place(i) + " are not perpendicular");
      most_off = std::max(most_off, off);
    }
  }
  if (axes.determinant() < 0) fields.fail(name + " are left-handed");
  return most_off <= tolerance::kObbAxes<double> || !fields.error().empty() ? axes : orthonormal<double, 3>(axes);
}

/// Reads a lozenge's edges. Edges that are perpendicular within rounding are kept; otherwise the second is made so.
std::array<Point, 2> edges_of(Fields& fields, std::string_view field) {
  std::vector<Point> edges = fields.points(field);
  if (edges.size() != 2) fields.fail(fields.field(field) + " has " + counted(edges.size(), "row") + " instead of 2");
  edges.resize(2, Point::Zero());
  const double length = scaled_norm<double, 3>(edges[0]);
  const double other = scaled_norm<double, 3>(edges[1]);
  if (length > 0 && other > 0) {
    const Point along = edges[0] / length;
    const double cosine = std::abs(along.dot(edges[1] / other));
    if (!fields.takes_off_by(cosine, field)) fields.fail(fields.field(field) + " are not perpendicular");
    if (cosine > tolerance::kObbAxes<double>) edges[1] -= along * along.dot(edges[1]);
  }
  return {edges[0], edges[1]};
}

/// Reads a volume's fields by their names, each by its kind. A number is a length, and so not negative.
struct FieldReader {
  Fields& fields;
  int k = 0;  // of a k-DOP

  void operator()(std::string_view name, double& length) const { length = fields.not_negative(name); }
  void operator()(std::string_view name, Point& point) const {
    point = name == "half_extents" ? fields.not_negative_each(name) : fields.point(name);
  }
  void operator()(std::string_view name, Matrix<double, 3>& axes) const { axes = axes_of(fields, name); }
  void operator()(std::string_view name, std::array<Point, 2>& edges) const { edges = edges_of(fields, name); }
  void operator()(std::string_view, int& number) { number = k = fields.k(); }
  void operator()(std::string_view name, std::array<double, kMostSlabs<3>>& bounds) const {
    const std::vector<double> numbers = fields.numbers(name);
    const std::size_t slabs = k / 2;
    if (numbers.size() != slabs)
      fields.fail(fields.field(name) + " has " + counted(numbers.size(), "number") + ", and a " + std::to_string(k) +
                  "-DOP has " + counted(slabs, "slab"));
    if (fields.error().empty()) std::copy(numbers.begin(), numbers.end(), bounds.begin());
  }
  void operator()(std::string_view name, std::vector<Point>& vertices) const {
    vertices = fields.points(name);
    if (vertices.empty()) fields.fail(fields.field(name) + " has no points");
  }
};

/// Checks that each min is at most its max.
void check_bounds(Fields& fields, const auto& min, const auto& max, int count) {
  for (int i = 0; i < count; ++i)
    if (min[i] > max[i]) {
      const std::string which = place(i);
      fields.fail(fields.field("min") + which + " is above max" + which);
    }
}

/// Reads the fields of any volume by their names in its header.
void read_into(auto& volume, Fields& fields) {
  std::vector<std::string_view> names;
  fields_to_read(volume, [&](std::string_view name, const auto&) { names.push_back(name); });
  fields.expect(names);
  fields_to_read(volume, FieldReader{fields});
  if constexpr (requires { volume.k; }) check_bounds(fields, volume.min, volume.max, volume.k / 2);
}

/// Reads an AABB in any of its three forms.
void read_into(Aabb<double, 3>& box, Fields& fields) {
  using Form = std::array<std::string_view, 2>;
  if (fields.has("center") || fields.has("half_extents")) {
    fields.expect(Form{"center", "half_extents"});
    const Point center = fields.point("center");
    box = min_max_of(AabbCenterExtents<double, 3>{center, fields.not_negative_each("half_extents")});
  } else if (fields.has("widths")) {
    fields.expect(Form{"min", "widths"});
    const Point min = fields.point("min");
    box = min_max_of(AabbMinWidths<double, 3>{min, fields.not_negative_each("widths")});
  } else {
    fields.expect(Form{"min", "max"});
    see_fields(box, FieldReader{fields});
    check_bounds(fields, box.min, box.max, 3);
  }
}

/// Converts a volume that was read in 3-D to its own dimension.
template <int Dim>
struct InDimension {
  Fields& fields;

  template <template <class, int> class Kind>
  Volume<double, Dim> operator()(const Kind<double, 3>& volume) const {
    return converted<double, Dim>(volume);
  }
  Volume<double, Dim> operator()(const Kdop<double, 3>& volume) const {
    const auto kdop = converted<double, Dim>(volume);
    if (kdop_vertices(kdop).empty()) fields.fail(fields.field("min") + " and max leave no point that is in all slabs");
    return kdop;
  }
  Volume<double, Dim> operator()(const ConvexHull<double, 3>& volume) const {
    const auto set = PointSet<double, Dim>::make(converted<double, Dim>(volume).vertices);
    if (set) return fit::quickhull(set->span()).volume;
    fields.fail(fields.field("points") + ": " + set.error().what);
    return ConvexHull<double, Dim>{};
  }
};

/// Writes fields as help shows them: what kind of value stands behind each name.
struct FieldForms {
  std::string text;

  void operator()(std::string_view name, const auto& field) {
    text += (text.empty() ? "\"" : ",\"") + std::string(name) + "\":" + form(field);
  }
  static const char* form(double) { return "r"; }
  static const char* form(int) { return "14"; }
  static const char* form(const Point&) { return "[..]"; }
  static const char* form(const Matrix<double, 3>&) { return "[[..],[..],[..]]"; }
  static const char* form(const std::array<Point, 2>&) { return "[[..],[..]]"; }
  static const char* form(const std::array<double, kMostSlabs<3>>&) { return "[..]"; }
  static const char* form(const std::vector<Point>&) { return "[[..],..]"; }
};

/// What the fields do not say by themselves.
std::string_view remark_on(std::string_view kind) {
  if (kind == "aabb")
    return ", {\"aabb\":{\"min\":[..],\"widths\":[..]}} or\n"
           "                   {\"aabb\":{\"center\":[..],\"half_extents\":[..]}}";
  if (kind == "obb") return "; axes are unit rows, right-handed";
  if (kind == "lozenge") return "; the edges are perpendicular";
  return kind == "kdop" ? "; k is 6, 14, 18 or 26, in 2-D 4, 6 or 8" : "";
}

}  // namespace

VolumeWanted volume_wanted(std::string name, int dim, const std::string& scalar, RoughAxes* rough) {
  VolumeWanted wanted{.name = std::move(name), .dim = dim, .rough = rough};
  if (scalar == "float") wanted.largest = PointSet<float, 3>::kLargest, wanted.largest_said = "1.1e18 in float";
  return wanted;
}

tl::expected<AnyVolume, std::string> read_volume(const Json& json, const VolumeWanted& wanted) {
  Fields fields(wanted);
  const std::string kind = fields.enter(json);
  if (!fields.error().empty()) return tl::unexpected(fields.error());
  Volume<double, 3> volume = volume_of_kind(kind);
  std::visit([&](auto& own) { read_into(own, fields); }, volume);
  if (!fields.error().empty()) return tl::unexpected(fields.error());
  AnyVolume result;
  if (fields.dim() == 2) result = std::visit(InDimension<2>{fields}, volume);
  else result = std::visit(InDimension<3>{fields}, volume);
  if (!fields.error().empty()) return tl::unexpected(fields.error());
  return result;
}

bool may_have_either_dim(const Json& json) {
  if (!json.is_object() || !json.contains("kdop")) return false;
  const Json& kdop = json["kdop"];
  return kdop.is_object() && kdop.contains("k") && kdop["k"] == 6;
}

std::string volumes_in_json() {
  std::string text;
  for (const std::string_view kind : kVolumeNames) {
    FieldForms forms;
    auto volume = volume_of_kind(kind);
    std::visit([&](auto& own) { fields_to_read(own, forms); }, volume);
    text += (text.empty() ? "  V                {\"" : "                   {\"") + std::string(kind) + "\":{" +
            forms.text + "}}" + std::string(remark_on(kind)) + "\n";
  }
  return text + "                   In 2-D there are two numbers instead of three. ";
}

}  // namespace snug::desktop
