#include "lesson/subjects/update/update.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/turn.hpp"
#include "lesson/boxes.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/update/entries.hpp"
#include "lesson/subjects/update/samples.hpp"
#include "lesson/subjects/update/update_figures.hpp"
#include "lesson/volume_rows.hpp"

namespace snug::lesson {
namespace {

constexpr double kKnobOfBodyAway =
    0.12;  // from the sphere that the body never leaves to a knob, over the sphere's radius
constexpr std::string_view kTurnOfBody = "turn";
constexpr double kRadiansOfDegree = std::numbers::pi / 180;

std::vector<std::string_view> update_volumes() { return {kUpdateVolume}; }
std::span<const Method> methods_of_update(std::string_view) { return body_update_methods(); }

/// Reads a rotation: in the plane degrees, in space three of them, about x, then y, then z.
Matrix<double, 3> read_turn(TomlTable& table, std::string_view key, int dim) {
  Matrix<double, 3> rotation = Matrix<double, 3>::Identity();
  if (!table.has(key)) return rotation;
  const std::vector<double> degrees = table.numbers(key);
  const bool finite = std::all_of(degrees.begin(), degrees.end(), [](double one) { return std::isfinite(one); });
  if (degrees.size() != (dim == 2 ? 1u : 3u) || !finite)
    return table.wrong(key, dim == 2 ? "must be a number of degrees" : "must be 3 numbers of degrees"), rotation;
  for (std::size_t i = 0; i < degrees.size(); ++i)
    rotation = snug::turn(Point3::Unit(dim == 2 ? 2 : static_cast<int>(i)), degrees[i] * kRadiansOfDegree) * rotation;
  return rotation;
}

Point3 read_position(TomlTable& table, int dim) {
  constexpr double kMost = 1e6;
  Point3 position = Point3::Zero();
  if (!table.has("position")) return position;
  const std::vector<double> numbers = table.numbers("position");
  const bool fine = std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::abs(one) <= kMost; });
  if (static_cast<int>(numbers.size()) != dim || !fine) return table.wrong("position", "must be a place"), position;
  std::copy(numbers.begin(), numbers.end(), position.data());
  return position;
}

void read_update(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  lesson.points = read_points(*table.table("points"), complaints);
  auto set = std::make_shared<BodySet>();
  if (const toml::table* own = table.table("body")) {
    TomlTable body(*own, "[body]", complaints);
    set->now = {read_turn(body, kTurnOfBody, lesson.points.dim), read_position(body, lesson.points.dim)};
    set->was.rotation = read_turn(body, "was", lesson.points.dim);
    body.refuse_others();
  }
  lesson.tables = std::move(set);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_update(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                               Clock) {
  auto points = own_points(lesson, mesh);
  if (!points) return tl::unexpected(std::move(points.error()));
  static const BodySet kUnmoved;
  const auto* set = static_cast<const BodySet*>(lesson.tables.get());
  return std::make_unique<UpdateSubject>(lesson, *std::move(points), std::move(mesh), set != nullptr ? *set : kUnmoved);
}

}  // namespace

const SubjectRow kUpdateRow{.name = "update",
                            .table = "points",
                            .volumes = &update_volumes,
                            .methods = &methods_of_update,
                            .facts = &FactList<BodyStep::Fact>::names,
                            .question_kinds = &FactList<BodyStep::Fact>::question_kinds,
                            .compares = true,
                            .read = &read_update,
                            .read_model = &read_point_model,
                            .open = &open_update,
                            .samples = kUpdateSamples};

UpdateSubject::UpdateSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh,
                             const BodySet& set)
    : PointSubject(lesson, std::move(points), std::move(mesh)), start_(set.now), pose_(set.now), was_(set.was) {
  UpdateSubject::points_changed();
}

void UpdateSubject::points_changed() {
  reach_ = 0;
  for (const Point3& point : all_points(*points())) reach_ = std::max(reach_, point.norm());
  if (!(reach_ > 0)) reach_ = 1;
  grips_.clear();
  for (const Handle& handle : handles_of(held()))
    if (handle.kind != Handle::Kind::kVertex) grips_.push_back(handle);
}

/// The body as a box that stands around the sphere about its pivot, whose handles are the body's.
HeldVolume UpdateSubject::held() const {
  Obb<double, 3> box{pose_.translation, pose_.rotation, Point3::Constant(reach_)};
  if (dim() == 2) box.half_extents[2] = 0;
  return {.volume = box, .dim = dim(), .points = {}, .knob = kKnobOfBodyAway * reach_};
}

Done UpdateSubject::take_held(const HeldVolume& next) {
  const auto& box = *std::get_if<Obb<double, 3>>(&next.volume);
  pose_ = {box.axes, box.center};
  origin_.edited = true;
  return {};
}

Done UpdateSubject::begun(Done done) {
  if (!done) return done;
  const bool flat = dim() == 2 && (start_.rotation.col(2) != Point3::UnitZ() || start_.translation[2] != 0);
  pose_ = flat ? Pose3{} : start_;
  return done;
}

Point3 UpdateSubject::at(Index i) const {
  return i < count() ? placed(pose_, PointSubject::at(i)) : at_handle(held(), grip(i));
}

std::string UpdateSubject::name_of(Index i) const {
  return i < count() ? PointSubject::name_of(i) : "Body" + handle_name(held(), grip(i));
}

/// The points alone.
std::vector<std::vector<Index>> UpdateSubject::things() const {
  std::vector<Index> all(count());
  std::iota(all.begin(), all.end(), Index{0});
  return {all};
}

/// A row for each point in the local frame, then the body's.
Rows UpdateSubject::rows() const {
  Rows rows;
  for (const Point3& point : all_points(*points())) rows.emplace_back(point.data(), point.data() + dim());
  rows.push_back(row_of(held()));
  return rows;
}

Done UpdateSubject::set_rows(const Rows& rows) {
  const auto border = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row.size() > 3; });
  if (rows.end() - border > 1) return tl::unexpected(InputError{.what = "there must be one body"});
  UpdateSubject next = *this;
  if (border != rows.begin() || rows.empty())
    if (Done set = next.PointSubject::set_rows(Rows(rows.begin(), border)); !set) return set;
  if (border != rows.end()) {
    const auto held = with_row(next.held(), *border);
    if (!held) return tl::unexpected(held.error());
    next.take_held(*held);
  }
  *this = std::move(next);
  origin_.edited = true;
  return {};
}

/// A point is moved in the world; the body keeps it in its local frame.
Done UpdateSubject::move(Index i, const Point3& to) {
  if (i < count()) return PointSubject::move(i, turned_back<double, 3>(pose_.rotation, to - pose_.translation));
  const auto next = moved(held(), grip(i), to);
  return next ? take_held(*next) : tl::unexpected(next.error());
}

Done UpdateSubject::add(const Point3& at) {
  return PointSubject::add(turned_back<double, 3>(pose_.rotation, at - pose_.translation));
}

Done UpdateSubject::remove(Index i) {
  if (i < count()) return PointSubject::remove(i);
  return tl::unexpected(InputError{.what = name_of(i) + " cannot be deleted"});
}

Done UpdateSubject::load(const io::PointFile& file, std::string_view name) {
  return begun(PointSubject::load(file, name));
}

Done UpdateSubject::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) {
  return begun(PointSubject::set_generator(kind, count, dim, seed, own));
}

void UpdateSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  PointSubject::begin_task(lesson, task, own);
  start_ = body_of(own).start_, was_ = body_of(own).was_;
  pose_ = start_;
}

double UpdateSubject::degrees() const {
  return angle_of({.center = Point3::Zero(), .axes = pose_.rotation, .half_extents = Point3::Ones()}) /
         kRadiansOfDegree;
}

std::vector<double> UpdateSubject::slack_over_turn(const Method& method, int steps) const {
  const auto update = fit::start_unwatched_updates(strategy_of(method), *points());
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    const double radians = (2.0 * i / steps - 1) * std::numbers::pi;
    Pose3 pose{snug::turn(Point3::UnitZ(), radians), pose_.translation};
    if (dim() == 3) pose.rotation = orthonormal<double, 3>(pose.rotation * pose_.rotation);
    const fit::UpdatedFrame frame = update(pose);
    all.push_back(fit::slack(frame.measure, frame.tightest));
  }
  return all;
}

std::vector<Drive> UpdateSubject::drives() const {
  std::vector<Drive> all = PointSubject::drives();
  Drive& turn = all.emplace_back(Drive{.name = std::string(kTurnOfBody), .unit = "degrees"});
  if (dim() == 2) turn.now = degrees();
  return all;
}

Done UpdateSubject::drive(std::string_view name, double from, double to) {
  if (name != kTurnOfBody) return PointSubject::drive(name, from, to);
  if (dim() == 2) pose_.rotation = snug::turn(Point3::UnitZ(), to * kRadiansOfDegree);
  else
    pose_.rotation =
        orthonormal<double, 3>(snug::turn(Point3::UnitZ(), (to - from) * kRadiansOfDegree) * pose_.rotation);
  origin_.edited = true;
  return {};
}

std::unique_ptr<Run> UpdateSubject::run(const Method& method, std::unique_ptr<Run>) const {
  const fit::UpdateStrategy& strategy = strategy_of(method);
  return std::make_unique<UpdateRun>(strategy, *points(), pose_, record_update(strategy, *points(), was_, pose_),
                                     names());
}

std::string UpdateSubject::opening(const Method& method) const {
  return std::string(method.title) + ", a body of " + std::to_string(count()) + (count() == 1 ? " point" : " points") +
         ": it has just rotated. Take the first step.";
}

std::vector<Figure> UpdateSubject::figures(const View& view) const {
  return update_figures(update_run(view.run()), view.step, degrees());
}

std::vector<Proof> UpdateSubject::proofs(const View& view) const {
  if (!view.at_end()) return {};
  const fit::UpdatedFrame& frame = update_run(view.run()).recording().frame;
  const std::string all = count() == 1 ? "contains the body’s point, exactly"
                                       : "contains all " + std::to_string(count()) + " points of the body, exactly";
  return {{all, frame.contains, true}};
}

fit::UpdatedFrame UpdateSubject::updated(const Method& method) const {
  return record_update(strategy_of(method), *points(), was_, pose_).frame;
}

Aabb<double, 3> UpdateSubject::box_of(const Method& method) const {
  const UpdateRecording recording = record_update(strategy_of(method), *points(), was_, pose_);
  return std::get<Aabb<double, 3>>(recording.steps.back().step.volume);
}

std::vector<Rival> UpdateSubject::rivals(const Lesson& lesson, const View&) const {
  std::vector<Rival> rivals;
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (!suits(method)) continue;
    const fit::UpdatedFrame frame = updated(method);
    rivals.push_back({&method, frame.measure, excess_of(frame.measure, frame.tightest)});
  }
  return rivals;
}

std::optional<double> UpdateSubject::result_size(const Method& method, bool, const View&) const {
  return updated(method).measure;
}

std::int64_t UpdateSubject::operations(const Method& method) const {
  const OperationCounts counts = updated(method).counts;
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

}  // namespace snug::lesson
