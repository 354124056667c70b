#include "lesson/point_subject.hpp"

#include <algorithm>

#include "geometry/generate.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

std::vector<Point3> all_points(const AnyPointSet& points) {
  std::vector<Point3> all;
  all.reserve(fit::count_of(points));
  for (Index i = 0; i < fit::count_of(points); ++i) all.push_back(fit::point_of(points, i));
  return all;
}

Index count_of(const Subject& subject) {
  return subject.points() != nullptr ? fit::count_of(*subject.points()) : subject.size();
}

namespace {

bool is_generator(std::string_view kind) {
  const auto kinds = generator_kinds();
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

}  // namespace

const std::vector<std::string>& mesh_names() {
  static const std::vector<std::string> names{"bunny", "teapot", "dragon"};
  return names;
}

std::string point_name(Index i, const NamesOfPoints& names) {
  const bool own = names != nullptr && static_cast<std::size_t>(i) < names->size();
  return own ? (*names)[i] : "P" + std::to_string(i);
}

std::string point_names(std::span<const Index> points, const NamesOfPoints& names) {
  if (points.empty()) return "no point";
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i + 1 == points.size() ? " and " : ", ";
    text += point_name(points[i], names);
  }
  return text;
}

tl::expected<AnyPointSet, InputError> to_set(const std::vector<Point3>& points, int dim, bool in_float) {
  return io::to_point_set({dim, points, {}}, {}, 0, in_float);
}

bool read_scalar(TomlTable& table) {
  const std::string name = table.text_or("scalar", "double");
  if (name != "float" && name != "double") table.wrong("scalar", "must be \"float\" or \"double\"");
  return name == "float";
}

Points read_points(const toml::table& toml, Complaints& complaints, bool may_be_float) {
  TomlTable table(toml, "[points]", complaints);
  Points points;
  points.dim = static_cast<int>(table.integer_or("dim", 2, 3, 2));
  const int ways = int{table.has("generate")} + int{table.has("mesh")} + int{table.has("list")};
  if (ways != 1) complaints.add(table.place(), "[points] needs exactly one of \"generate\", \"mesh\" and \"list\"");
  if (table.has("generate")) {
    points.generate = table.text("generate");
    check_name(table, "generate", points.generate, generator_kinds());
    points.count = static_cast<int>(table.integer("count", 1, kMostGenerated));
  }
  if (table.has("mesh")) {
    points.mesh = table.text("mesh");
    check_name(table, "mesh", points.mesh, mesh_names());
    if (table.has("dim") && points.dim != 3) table.wrong("dim", "of a mesh is 3");
    points.dim = 3;
  }
  if (table.has("list")) points.list = table.points("list", points.dim);
  if (may_be_float) points.in_float = read_scalar(table);
  table.refuse_others();
  return points;
}

tl::expected<AnyPointSet, InputError> own_points(const Lesson& lesson, const std::optional<io::PointFile>& mesh) {
  const Points& points = lesson.points;
  if (!points.mesh.empty()) {
    if (!mesh) return tl::unexpected(InputError{.what = "the mesh " + points.mesh + " is not loaded"});
    return to_set(mesh->points, mesh->dim);
  }
  if (points.generate.empty()) return to_set(points.list, points.dim);
  const auto made = generate(points.generate, points.count, points.dim, lesson.seed);
  if (!made) return tl::unexpected(InputError{.what = "there is no generator " + points.generate});
  return to_set(*made, points.dim);
}

Rows read_point_model(TomlTable& task, const Lesson& lesson, Complaints&) {
  Rows rows;
  for (const Point3& point : task.points("model", lesson.points.dim))
    rows.emplace_back(point.data(), point.data() + lesson.points.dim);
  return rows;
}

PointSubject::PointSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh)
    : unrounded_(std::move(points)) {
  const Points& own = lesson.points;
  Recipe recipe{own.generate, own.count, own.dim, own.generate.empty(), own.mesh, lesson.seed};
  origin_.seed = lesson.seed;
  if (!own.generate.empty()) origin_.source = own.generate, origin_.generated = own.count;
  if (recipe.own_list) {
    recipe.kind = lesson.generators.empty() ? "gaussian" : lesson.generators.front();
    recipe.count = std::min(size(), Index{kMostGenerated}), recipe.dim = dim();
  }
  if (mesh && !own.mesh.empty()) {
    origin_.source = own.mesh;
    triangles_ = std::make_shared<const Triangles>(std::move(mesh->triangles));
  }
  recipe_ = std::make_shared<const Recipe>(std::move(recipe));
  if (!lesson.view.names.empty()) names_ = std::make_shared<const std::vector<std::string>>(lesson.view.names);
}

std::span<const std::array<Index, 3>> PointSubject::triangles() const {
  return triangles_ ? std::span<const std::array<Index, 3>>(*triangles_) : std::span<const std::array<Index, 3>>();
}

/// Where float cannot hold a coordinate, the runs are in double from then on.
void PointSubject::become(AnyPointSet points, std::shared_ptr<const Triangles> triangles) {
  unrounded_ = std::move(points);
  triangles_ = std::move(triangles);
  rounded_.reset();
  if (origin_.in_float)
    if (auto rounded = to_set(all_points(unrounded_), dim(), true)) rounded_ = *std::move(rounded);
  origin_.in_float = rounded_.has_value();
  points_changed();
}

Done PointSubject::take(const std::vector<Point3>& points, int dim, std::shared_ptr<const Triangles> triangles) {
  auto set = to_set(points, dim);
  if (!set) return tl::unexpected(std::move(set.error()));
  if (in_float())
    if (auto rounded = to_set(points, dim, true); !rounded) return tl::unexpected(std::move(rounded.error()));
  origin_.edited = true;
  become(*std::move(set), std::move(triangles));
  return {};
}

Done PointSubject::round_to_float(bool in_float) {
  std::optional<AnyPointSet> rounded;
  if (in_float) {
    auto set = to_set(all_points(unrounded_), dim(), true);
    if (!set) return tl::unexpected(std::move(set.error()));
    rounded = *std::move(set);
  }
  rounded_ = std::move(rounded);
  origin_.in_float = in_float;
  points_changed();
  return {};
}

Done PointSubject::move(Index i, const Point3& to) {
  const auto place = [&]<class Scalar, int Dim>(PointSet<Scalar, Dim>& set) {
    return set.move(i, to.template head<Dim>().template cast<Scalar>());
  };
  // Float takes less than double: what it takes, double does not refuse.
  if (rounded_)
    if (Done moved = std::visit(place, *rounded_); !moved) return moved;
  if (Done moved = std::visit(place, unrounded_); !moved) return moved;
  origin_.edited = true;
  points_changed();
  return {};
}

Done PointSubject::add(const Point3& at) {
  std::vector<Point3> all = all_points(unrounded_);
  all.push_back(at);
  return take(all, dim(), nullptr);
}

Done PointSubject::remove(Index i) {
  if (i < 0 || i >= count()) return tl::unexpected(InputError{.what = "there is no point " + std::to_string(i)});
  if (count() == 1) return tl::unexpected(InputError{.what = "the last point cannot be deleted"});
  std::vector<Point3> all = all_points(unrounded_);
  all.erase(all.begin() + i);
  if (names_ != nullptr && static_cast<std::size_t>(i) < names_->size()) {  // the others keep their names
    std::vector<std::string> left = *names_;
    left.erase(left.begin() + i);
    names_ = std::make_shared<const std::vector<std::string>>(std::move(left));
  }
  return take(all, dim(), nullptr);
}

Rows PointSubject::rows() const {
  Rows rows;
  for (const Point3& point : all_points(unrounded_)) rows.emplace_back(point.data(), point.data() + dim());
  return rows;
}

Done PointSubject::set_rows(const Rows& rows) {
  const int dim = rows.empty() ? 0 : static_cast<int>(rows.front().size());
  std::vector<Point3> all;
  for (const std::vector<double>& row : rows) {
    if (row.size() != static_cast<std::size_t>(dim) || dim < 2 || dim > 3)
      return tl::unexpected(InputError{.what = "points must have two or three numbers each, and all the same number"});
    all.emplace_back(row[0], row[1], dim == 3 ? row[2] : 0);
  }
  return take(all, dim, all.size() == static_cast<std::size_t>(count()) ? triangles_ : nullptr);
}

Done PointSubject::load(const io::PointFile& file, std::string_view name) {
  auto set = io::to_point_set(file, name, 0, false);
  if (!set) return tl::unexpected(std::move(set.error()));
  origin_ = {std::string(name), 0, origin_.seed, name != recipe_->mesh, origin_.situation, in_float()};
  become(*std::move(set), std::make_shared<const Triangles>(file.triangles));
  return {};
}

/// kind: an existing one; count and dim: in range.
void PointSubject::generate_points(std::string_view kind, int count, int dim, std::uint64_t seed, bool edited) {
  origin_ = {std::string(kind), count, seed, edited, origin_.situation, in_float()};
  become(*to_set(*generate(kind, count, dim, seed), dim), nullptr);
}

bool PointSubject::is_as_own(std::string_view kind, int count, int dim) const {
  return kind == recipe_->kind && count == recipe_->count && dim == recipe_->dim;
}

Done PointSubject::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject&) {
  if (!is_generator(kind)) return tl::unexpected(InputError{.what = "there is no generator " + std::string(kind)});
  if (count < 1 || count > kMostGenerated)
    return tl::unexpected(InputError{.what = "a set must have 1 to " + std::to_string(kMostGenerated) + " points"});
  if (dim != 2 && dim != 3) return tl::unexpected(InputError{.what = "the dimension must be 2 or 3"});
  // At the lesson's seed an address means the lesson's own points, which generated ones are not if it has a list.
  const bool own = is_as_own(kind, count, dim) && (seed != recipe_->seed || !recipe_->own_list);
  generate_points(kind, count, dim, seed, !own);
  return {};
}

void PointSubject::scatter(std::uint64_t seed, const Subject& own) {
  const Origin now = origin_;
  if (now.generated > 0 && !is_as_own(now.source, now.generated, dim()))
    return generate_points(now.source, now.generated, dim(), seed, true);
  if (seed != recipe_->seed) return generate_points(recipe_->kind, recipe_->count, recipe_->dim, seed, false);
  const auto& first = static_cast<const PointSubject&>(own);
  origin_ = first.origin_;
  origin_.in_float = now.in_float;
  become(first.unrounded_, first.triangles_);
}

void PointSubject::begin_task(const Lesson&, const Task& task, const Subject& own) {
  origin_ = {"task", 0, own.origin().seed, true, own.origin().situation, in_float()};
  std::vector<Point3> points = all_points(*own.points());
  if (task.points > 0) points.resize(std::min(points.size(), static_cast<std::size_t>(task.points)));
  become(*to_set(points, own.dim()), nullptr);  // these points were accepted before
}

}  // namespace snug::lesson
