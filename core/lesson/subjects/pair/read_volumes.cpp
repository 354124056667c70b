#include "lesson/subjects/pair/read_volumes.hpp"

#include <algorithm>
#include <numbers>

#include "geometry/volume_fields.hpp"
#include "lesson/boxes.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"

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

/// Reads whether cylinders stand beside the capsules.
bool read_cylinders(TomlTable& table, int dim) {
  if (!table.has("beside")) return table.allow("beside"), false;
  if (table.text("beside") != "cylinders") table.wrong("beside", "must be \"cylinders\"");
  else if (dim != 3) table.wrong("beside", "is for capsules in space");
  return true;
}

/// Reads which of the two volumes are shown as they are stored.
std::array<bool, 2> read_stored(TomlTable& table) {
  constexpr std::array<std::string_view, 2> kSides{"a", "b"};
  const std::vector<std::string> names = read_names(table, "stored", 0, kSides);
  return {is_among(names, kSides[0]), is_among(names, kSides[1])};
}

HeldVolume read_volume(const toml::table& toml, std::string name, int dim, Complaints& complaints) {
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

}  // namespace

void read_volumes(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<VolumeTables>();
  TomlTable own(*table.table("volumes"), "[volumes]", complaints);
  tables->in_float = read_scalar(own);
  tables->line = own.place().line;
  const int dim = tables->pair.dim = lesson.points.dim = static_cast<int>(own.integer_or("dim", 2, 3, 2));
  tables->stored = read_stored(own);
  tables->pair.any = own.flag_or("any", false);
  tables->pair.cylinders = read_cylinders(own, dim);
  const std::size_t before = complaints.count();
  double reach = 0;
  for (const std::size_t side : {0, 1}) {
    const char* key = side == 0 ? "a" : "b";
    HeldVolume& held = tables->pair.held[side];
    held.dim = dim;
    if (const toml::table* volume = own.table(key); volume != nullptr)
      held = read_volume(*volume, std::string("[volumes] ") + key, dim, complaints);
    else own.lack(key, std::string("[volumes] lacks the volume \"") + key + '"');
    if (complaints.count() > before) continue;
    for (const Handle& handle : handles_of(held))
      reach = std::max(reach, (at_handle(held, handle) - at_handle(held, {})).norm());
  }
  for (HeldVolume& held : tables->pair.held) held.knob = 0.3 * reach;
  for (const std::size_t which : {0, 1}) {
    const char* key = which == 0 ? "right" : "yours";
    if (const toml::table* volume = own.table(key))
      tables->answers[which] = read_volume(*volume, std::string("[volumes] ") + key, dim, complaints);
  }
  if (complaints.count() == before && own.has("a") && own.has("b") &&
      tables->pair.held[0].volume.index() > tables->pair.held[1].volume.index())
    own.wrong("a", "must be of the kind that comes first: " + one_of(kVolumeNames));
  const auto is_capsule = [](const HeldVolume& held) {
    return std::holds_alternative<Capsule<double, 3>>(held.volume);
  };
  if (complaints.count() == before && tables->pair.cylinders &&
      !std::all_of(tables->pair.held.begin(), tables->pair.held.end(), is_capsule))
    own.wrong("beside", "is for two capsules");
  own.refuse_others();
  lesson.tables = std::move(tables);
}

Rows read_volume_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  const toml::table* model = task.table("model");
  if (model == nullptr) return task.lack("model", "the task lacks [task.model]"), Rows();
  TomlTable own(*model, "[task.model]", complaints);
  VolumePair pair{.dim = lesson.points.dim, .any = static_cast<const VolumeTables&>(*lesson.tables).pair.any};
  for (const std::size_t side : {0, 1}) {
    const char* key = side == 0 ? "a" : "b";
    pair.held[side].dim = pair.dim;
    if (const toml::table* volume = own.table(key); volume != nullptr)
      pair.held[side] = read_volume(*volume, std::string("[task.model] ") + key, pair.dim, complaints);
    else own.lack(key, std::string("[task.model] lacks the volume \"") + key + '"');
  }
  own.refuse_others();
  return rows_of(pair);
}

void check_volume_tests(const Lesson& lesson, const Subject& own, Complaints& complaints) {
  const VolumePair& pair = as<VolumesSubject>(own)->pair();
  if (pair.any) return;  // other volumes take the others
  const std::vector<std::string_view> tests = tests_of(pair);
  for (const std::string& algorithm : lesson.algorithms)
    if (!is_among(tests, algorithm))
      complaints.add(static_cast<const VolumeTables&>(*lesson.tables).line,
                     "the test of these two volumes is " + one_of(tests) + ", not " + algorithm);
}

}  // namespace snug::lesson
