#include "lesson/subjects/cloud/read_hand.hpp"

#include <numbers>

#include "geometry/turn.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/subjects/cloud/hand.hpp"
#include "lesson/volume_rows.hpp"

namespace snug::lesson {
namespace {

/// Reads what a hand sets of each kind of volume; what is not there stays.
struct HandReader {
  TomlTable& table;
  int dim;

  void operator()(auto&) const {}
  void operator()(Obb<double, 3>& box) const {
    if (!table.has("turn")) return;
    const std::vector<double> degrees = table.numbers("turn");
    if (degrees.size() != (dim == 2 ? 1u : 3u))
      return table.wrong("turn", dim == 2 ? "must be a number of degrees" : "must be 3 numbers of degrees");
    for (std::size_t i = 0; i < degrees.size(); ++i) {
      const Point3 about = Point3::Unit(dim == 2 ? 2 : static_cast<int>(i));
      box.axes = snug::turn(about, degrees[i] * std::numbers::pi / 180) * box.axes;
    }
  }
  void operator()(Capsule<double, 3>& capsule) const {
    if (const auto ends = list("segment", 2, "must be two points")) capsule.a = (*ends)[0], capsule.b = (*ends)[1];
  }
  void operator()(Lozenge<double, 3>& lozenge) const {
    const auto rectangle = list("rectangle", 3, "must be a vertex and two edges");
    if (rectangle) lozenge.origin = (*rectangle)[0], lozenge.edges = {(*rectangle)[1], (*rectangle)[2]};
  }
  [[nodiscard]] std::optional<std::vector<Point3>> list(std::string_view key, std::size_t due,
                                                        const char* words) const {
    if (!table.has(key)) return std::nullopt;
    std::vector<Point3> points = table.points(key, dim);
    if (points.size() == due) return points;
    table.wrong(key, words);
    return std::nullopt;
  }
};

/// Reads the directions of a k-DOP; what is not there stays.
std::vector<double> read_axes(TomlTable& table, AxesByHand axes, int dim) {
  if (!table.has("axes")) return axes.row();
  std::vector<double> row;
  for (const Point3& axis : table.points("axes", dim)) row.insert(row.end(), axis.data(), axis.data() + dim);
  if (const Done set = axes.set_row(row); !set) table.wrong("axes", "cannot be drawn: " + set.error().what);
  return axes.row();
}

/// The points that the task's model stands on; none if they could not be read.
std::optional<AnyPointSet> model_points(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  auto set = task.has("hand") && !task.has("model")
                 ? own_points(lesson, {})
                 : to_set(task.points("model", lesson.points.dim), lesson.points.dim);
  if (set) return *std::move(set);
  if (task.has("hand")) complaints.add(task.place(), "a model by hand needs points: " + set.error().what);
  return std::nullopt;
}

}  // namespace

std::vector<std::string_view> volumes_by_hand(const Lesson& lesson) {
  std::vector<std::string_view> volumes;
  for (const std::string& name : lesson.algorithms) {
    const Method* method = lesson.subject != nullptr ? find_method(lesson, name) : nullptr;
    if (method != nullptr && method->by_hand && !is_among(volumes, method->volume)) volumes.push_back(method->volume);
  }
  return volumes;
}

Rows read_cloud_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  if (!task.has("hand")) return read_point_model(task, lesson, complaints);
  const toml::table* toml = task.table("hand");
  const auto points = model_points(task, lesson, complaints);
  if (toml == nullptr || !points) return {};
  Rows rows;
  for (const Point3& point : all_points(*points)) rows.emplace_back(point.data(), point.data() + lesson.points.dim);
  TomlTable table(*toml, "[task.hand]", complaints);
  const std::vector<std::string_view> volumes = volumes_by_hand(lesson);
  const Hand hand(volumes, *points);
  for (const std::string_view volume : volumes) {
    if (hand.held(volume) == nullptr) continue;
    HeldVolume held = *hand.held(volume);
    std::visit(HandReader{table, lesson.points.dim}, held.volume);
    rows.push_back(row_of(held));
  }
  if (hand.axes() != nullptr) rows.push_back(read_axes(table, *hand.axes(), lesson.points.dim));
  table.refuse_others();
  return rows;
}

}  // namespace snug::lesson
