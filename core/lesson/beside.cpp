#include "lesson/beside.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/volume_fields.hpp"
#include "lesson/boxes.hpp"
#include "lesson/names.hpp"

namespace snug::lesson {
namespace {

constexpr double kLargest = 1e6;

/// Reads a volume's fields by their names.
struct FieldReader {
  TomlTable& table;
  int dim;
  int k = 0;  // for a k-DOP

  /// A sphere of radius 0 is a point, a capsule a segment.
  void operator()(std::string_view name, double& length) const {
    length = table.has(name) ? table.any_number(name, 1) : table.number(name, kLargest);
    if (length >= 0 && length <= kLargest) return;
    table.wrong(name, "must be at least 0 and at most 1000000");
    length = 1;
  }
  void operator()(std::string_view name, Point3& point) const {
    const auto numbers = table.numbers(name);
    if (static_cast<int>(numbers.size()) != dim)
      return table.wrong(name, "must be " + std::to_string(dim) + " numbers");
    for (int i = 0; i < dim; ++i) point[i] = numbers[i];
  }
  void operator()(std::string_view name, std::array<Point3, 2>& edges) const {
    const auto list = table.points(name, dim);
    if (list.size() != 2) return table.wrong(name, "must be two edges");
    std::copy(list.begin(), list.end(), edges.begin());
    if (std::abs(edges[0].dot(edges[1])) > 1e-9 * edges[0].norm() * edges[1].norm())
      table.wrong(name, "must be perpendicular");
  }
  /// Reads degrees: in space about x, then y, then z.
  void operator()(std::string_view, Matrix<double, 3>& axes) const {
    const auto degrees = table.numbers("turn");
    if (degrees.size() != (dim == 2 ? 1u : 3u))
      return table.wrong("turn", dim == 2 ? "must be a number of degrees" : "must be 3 numbers of degrees");
    Obb<double, 3> box;
    for (std::size_t i = 0; i < degrees.size(); ++i)
      box = turned_by(box, dim == 2 ? 2 : static_cast<int>(i), degrees[i] * std::numbers::pi / 180);
    axes = box.axes;
  }
  void operator()(std::string_view name, int& number) {
    number = static_cast<int>(table.integer(name, 4, 26));
    const std::size_t slabs = dim == 2 ? kdop_axes<2>(number).size() : kdop_axes<3>(number).size();
    if (slabs == 0) table.wrong(name, dim == 2 ? "must be 4, 6 or 8" : "must be 6, 14, 18 or 26");
    k = static_cast<int>(2 * slabs);
  }
  void operator()(std::string_view name, std::array<double, kMostSlabs<3>>& bounds) const {
    const auto numbers = table.numbers(name);
    if (static_cast<int>(numbers.size()) != k / 2)
      return table.wrong(name, "must be " + std::to_string(k / 2) + " numbers, one for each slab");
    std::copy(numbers.begin(), numbers.end(), bounds.begin());
  }
  void operator()(std::string_view name, std::vector<Point3>& vertices) const { vertices = table.points(name, dim); }
};

}  // namespace

HeldVolume read_held_volume(const toml::table& toml, std::string name, int dim, Complaints& complaints) {
  const std::size_t before = complaints.count();
  TomlTable table(toml, std::move(name), complaints);
  HeldVolume held{.dim = dim};
  const auto kind = std::find_if(kVolumeNames.begin(), kVolumeNames.end(), [&](auto one) { return table.has(one); });
  if (kind == kVolumeNames.end()) {
    complaints.add(table.place(), "a volume is one of " + one_of(kVolumeNames) + ", with its fields");
    return held;
  }
  held.volume = volume_of_kind(*kind);
  const toml::table* fields = table.table(*kind);
  table.refuse_others();
  if (fields == nullptr) return held;
  TomlTable own(*fields, std::string(*kind), complaints);
  std::visit([&](auto& volume) { fields_to_read(volume, FieldReader{own, dim}); }, held.volume);
  own.refuse_others();
  if (const auto* hull = std::get_if<ConvexHull<double, 3>>(&held.volume)) held.points = hull->vertices;
  if (complaints.count() > before) return held;
  if (const std::string fault = fault_of(held); !fault.empty()) return complaints.add(own.place(), fault), held;
  return placed(held, Matrix<double, 3>::Identity(), Point3::Zero());
}

std::shared_ptr<const std::vector<Beside>> read_beside(TomlTable& lesson, int dim, Complaints& complaints) {
  const std::vector<const toml::table*> tables = lesson.tables("beside");
  if (tables.empty()) return nullptr;
  const std::vector<std::string_view> kinds{"right", "yours", "given"};
  auto all = std::make_shared<std::vector<Beside>>(tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    TomlTable table(*tables[i], "[[beside]]", complaints);
    Beside& own = (*all)[i];
    const std::string is = table.text("is");
    check_name(table, "is", is, kinds);
    own.is = is == kinds[0] ? Beside::Is::kRight : is == kinds[1] ? Beside::Is::kYours : Beside::Is::kGiven;
    own.name = table.text_or("name", "");
    if (const toml::table* volume = table.table("volume"))
      own.volume = read_held_volume(*volume, "volume", dim, complaints);
    else table.lack("volume", "[[beside]] lacks its \"volume\"");
    table.refuse_others();
  }
  return all;
}

}  // namespace snug::lesson
