#include "lesson/subjects/cloud/cloud.hpp"

#include <algorithm>

#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/entries.hpp"

namespace snug::lesson {
namespace {

std::vector<std::string_view> fitted_volumes() {
  std::vector<std::string_view> names;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (std::find(names.begin(), names.end(), algorithm.volume) == names.end()) names.push_back(algorithm.volume);
  return names;
}

Method method_of(const fit::Algorithm& algorithm) {
  return {algorithm.volume,           algorithm.name,  algorithm.title,     algorithm.source, algorithm.pseudocode,
          algorithm.plane_pseudocode, algorithm.exact, algorithm.max_points};
}

/// Sorted by volume, as in the catalogue.
const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> methods;
    for (const fit::Algorithm& algorithm : fit::algorithms()) methods.push_back(method_of(algorithm));
    return methods;
  }();
  return all;
}

void read_cloud(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  lesson.points = read_points(*table.table("points"), complaints);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_cloud(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                              Clock) {
  auto points = own_points(lesson, mesh);
  if (!points) return tl::unexpected(std::move(points.error()));
  return std::make_unique<CloudSubject>(lesson, *std::move(points), std::move(mesh));
}

}  // namespace

std::span<const Method> fit_methods(std::string_view volume) {
  const std::vector<Method>& all = all_methods();
  const auto is = [&](const Method& method) { return method.volume == volume; };
  const auto from = std::find_if(all.begin(), all.end(), is);
  const auto count = std::find_if_not(from, all.end(), is) - from;
  return std::span(all).subspan(static_cast<std::size_t>(from - all.begin()), static_cast<std::size_t>(count));
}

const SubjectRow kCloudRow{.name = "cloud",
                           .table = "points",
                           .volumes = &fitted_volumes,
                           .methods = &fit_methods,
                           .facts = &FactList<fit::Fact3>::names,
                           .askings = &FactList<fit::Fact3>::askings,
                           .read = &read_cloud,
                           .read_task = &read_cloud_task,
                           .check = &check_cloud_task,
                           .open = &open_cloud};

CloudSubject::CloudSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh)
    : PointSubject(lesson, std::move(points), std::move(mesh)), volume_(lesson.volume),
      tells_optimum_(lesson.subject == &kCloudRow) {}

std::unique_ptr<Run> CloudSubject::run(const Method& method, std::unique_ptr<Run> earlier) const {
  fit::Recording room;
  if (earlier != nullptr) room = static_cast<FitRun&>(*earlier).give_up();
  return std::make_unique<FitRun>(*points(), method.exact,
                                  algorithm_of(method).record(*points(), {.seed = origin_.seed}, std::move(room)));
}

std::string CloudSubject::opening(const Method& method) const {
  return std::string(method.title) + ", " + counted(size(), "point") + ": nothing is known yet. Take the first step.";
}

std::vector<Figure> CloudSubject::figures(const View& view) const {
  return fit_figures(view, fit_run(view.run()), smallest_size(view));
}

std::vector<Proof> CloudSubject::proofs(const View& view) const { return fit_proofs(view, fit_run(view.run())); }

Grade CloudSubject::grade(const Lesson& lesson, const View&, std::vector<bool>&) const {
  return grade_points(lesson, *points(), origin_.seed);
}

/// The exact algorithm; null if there is none, if it cannot take so many points, or if its result is hidden.
const fit::Algorithm* CloudSubject::exact() const {
  // k-DOPs with different directions are different kinds of volume, so none of them is the smallest of all.
  const bool one_kind = volume_ != "kdop";
  const fit::Algorithm* exact = tells_optimum_ && one_kind ? fit::exact_algorithm(volume_) : nullptr;
  return exact != nullptr && size() <= exact->max_points ? exact : nullptr;
}

const fit::Recording* CloudSubject::optimum(const View& view) const {
  const fit::Algorithm* own = exact();
  if (own == nullptr) return nullptr;
  for (const Slot& slot : view.slots)
    if (slot.method != nullptr && &algorithm_of(*slot.method) == own) return &fit_run(*slot.run).recording();
  if (!worked_.optimum)
    worked_.optimum = std::make_shared<const fit::Recording>(own->record(*points(), {.seed = origin_.seed}));
  return worked_.optimum.get();
}

std::optional<double> CloudSubject::smallest_size(const View& view) const {
  const fit::Algorithm* own = exact();
  if (own == nullptr) return std::nullopt;
  if (!worked_.smallest_size) worked_.smallest_size = size_of(*own, view);
  return worked_.smallest_size;
}

/// The size of an algorithm's volume. A run that a slot shows is not repeated.
double CloudSubject::size_of(const fit::Algorithm& algorithm, const View& view) const {
  for (const Slot& slot : view.slots)
    if (slot.method != nullptr && &algorithm_of(*slot.method) == &algorithm)
      return fit::size_of(fit_run(*slot.run).recording().result.volume, dim());
  if (&algorithm == exact() && worked_.smallest_size) return *worked_.smallest_size;
  return fit::size_of(algorithm.fit(*points(), {.seed = origin_.seed}).volume, dim());
}

std::vector<Rival> CloudSubject::rivals(const Lesson& lesson, const View& view) const {
  std::vector<Rival> rivals;
  const std::optional<double> smallest = smallest_size(view);
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (!suits(method)) continue;
    const double own = size_of(algorithm_of(method), view);
    rivals.push_back({&method, own, excess_of(own, smallest)});
  }
  return rivals;
}

const fit::Recording* recording_of(const Session& session, int slot) {
  const bool fits = as<CloudSubject>(session.subject().shape()) != nullptr && session.method(slot) != nullptr;
  return fits ? &fit_run(session.run(slot)).recording() : nullptr;
}

const fit::Recording* optimum_of(const Session& session) {
  const auto* cloud = as<CloudSubject>(session.subject());
  return cloud != nullptr ? cloud->optimum(session.view()) : nullptr;
}

}  // namespace snug::lesson
