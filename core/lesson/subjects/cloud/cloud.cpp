#include "lesson/subjects/cloud/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/break_it.hpp"
#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/subjects/cloud/certificate_figures.hpp"
#include "lesson/subjects/cloud/entries.hpp"
#include "lesson/subjects/cloud/left_outside.hpp"
#include "lesson/subjects/cloud/read_hand.hpp"
#include "lesson/subjects/cloud/samples.hpp"
#include "lesson/subjects/cloud/stored.hpp"
#include "lesson/words.hpp"
#include "measure/volume_cost.hpp"

namespace snug::lesson {
namespace {

std::vector<std::string_view> fitted_volumes() {
  std::vector<std::string_view> names;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (std::find(names.begin(), names.end(), algorithm.volume) == names.end()) names.push_back(algorithm.volume);
  return names;
}

Method method_of(const fit::Algorithm& algorithm) {
  return {algorithm.volume, algorithm.name,       algorithm.title,
          algorithm.source, algorithm.pseudocode, algorithm.plane_pseudocode,
          algorithm.exact,  algorithm.max_points, algorithm.plane,
          algorithm.space,  algorithm.naive};
}

/// Sorted by volume, as in the catalogue.
const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> methods;
    for (const std::string_view volume : fitted_volumes()) {
      for (const fit::Algorithm& algorithm : fit::algorithms_of(volume)) methods.push_back(method_of(algorithm));
      for (const Method& method : hand_methods())
        if (method.volume == volume) methods.push_back(method);
    }
    return methods;
  }();
  return all;
}

/// A method of the catalogue.
const fit::Algorithm& algorithm_of(const Method& method) { return *fit::find_algorithm(method.volume, method.name); }

void read_cloud(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  lesson.points = read_points(*table.table("points"), complaints, true);
  if (!table.has("stored") && !table.has("tested")) return table.allow("stored"), table.allow("tested");
  auto tables = std::make_shared<CloudTables>();
  tables->stored = table.flag_or("stored", false);
  tables->tested = table.flag_or("tested", false);
  lesson.tables = std::move(tables);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_cloud(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                              Clock) {
  auto points = own_points(lesson, mesh);
  if (!points) return tl::unexpected(std::move(points.error()));
  auto cloud = std::make_unique<CloudSubject>(lesson, *std::move(points), std::move(mesh));
  if (Done set = cloud->set_float(lesson.points.in_float); !set) return tl::unexpected(std::move(set.error()));
  return cloud;
}

}  // namespace

std::span<const Method> fit_methods(std::string_view volume) {
  const std::vector<Method>& all = all_methods();
  const auto is = [&](const Method& method) { return method.volume == volume; };
  const auto from = std::find_if(all.begin(), all.end(), is);
  const auto count = std::find_if_not(from, all.end(), is) - from;
  return std::span(all).subspan(from - all.begin(), count);
}

const SubjectRow kCloudRow{.name = "cloud",
                           .table = "points",
                           .volumes = &fitted_volumes,
                           .methods = &fit_methods,
                           .facts = &FactList<fit::Fact3>::names,
                           .question_kinds = &FactList<fit::Fact3>::question_kinds,
                           .compares = true,
                           .read = &read_cloud,
                           .read_model = &read_cloud_model,
                           .goals = kCloudGoals,
                           .open = &open_cloud,
                           .samples = kCloudSamples};

/// The method that sizes are compared with. If the lesson names none, the exact one of its volume; null if there are
/// several volumes, and for k-DOPs, because k-DOPs with different directions are different kinds of volume. Null for a
/// cost chart as well, which is to reveal it.
const Method* reference_of(const Lesson& lesson) {
  if (!lesson.subject->compares) return nullptr;
  if (!lesson.reference.empty()) return find_method(lesson, lesson.reference);
  if (is_mixed(lesson) || lesson.volume == "kdop") return nullptr;
  const fit::Algorithm* exact = fit::exact_algorithm(lesson.volume);
  return exact != nullptr ? find_method(fit_methods(lesson.volume), exact->name) : nullptr;
}

CloudSubject::CloudSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh)
    : PointSubject(lesson, std::move(points), std::move(mesh)), reference_(reference_of(lesson)),
      by_measure_(is_mixed(lesson) || (reference_ != nullptr && reference_->volume != lesson.volume)),
      has_naive_(std::any_of(lesson.algorithms.begin(), lesson.algorithms.end(),
                             [&](const std::string& name) { return find_method(lesson, name)->naive; })),
      is_tested_(lesson.subject == &kCloudRow && lesson.tables != nullptr &&
                 static_cast<const CloudTables&>(*lesson.tables).tested),
      hand_(volumes_by_hand(lesson), *this->points()) {}

Point3 CloudSubject::at(Index i) const { return i < count() ? PointSubject::at(i) : hand_.at(i - count()); }
std::string CloudSubject::name_of(Index i) const {
  return i < count() ? PointSubject::name_of(i) : hand_.name_of(i - count());
}

/// The points alone.
std::vector<std::vector<Index>> CloudSubject::things() const {
  std::vector<Index> all(count());
  std::iota(all.begin(), all.end(), Index{0});
  return {all};
}

Rows CloudSubject::rows() const {
  Rows rows = PointSubject::rows();
  for (std::vector<double>& row : hand_.rows()) rows.push_back(std::move(row));
  return rows;
}

Done CloudSubject::set_rows(const Rows& rows) {
  const auto border = std::find_if(rows.begin(), rows.end(), &Hand::is_row);
  CloudSubject next = *this;
  if (border != rows.begin() || rows.empty())
    if (Done set = next.PointSubject::set_rows(Rows(rows.begin(), border)); !set) return set;
  const auto of_hand = std::span(rows).subspan(border - rows.begin());
  if (Done set = next.hand_.set_rows(of_hand, *next.points()); !set) return set;
  *this = std::move(next);
  origin_.edited = true;
  return {};
}

Done CloudSubject::move(Index i, const Point3& to) {
  if (i < count()) return PointSubject::move(i, to);
  if (Done moved = hand_.move(i - count(), to, *points()); !moved) return moved;
  worked_ = {};
  origin_.edited = true;
  return {};
}

Done CloudSubject::remove(Index i) {
  if (i < count() || i >= size()) return PointSubject::remove(i);
  if (Done removed = hand_.remove(i - count()); !removed) return removed;
  worked_ = {};
  origin_.edited = true;
  return {};
}

std::vector<Drive> CloudSubject::drives() const {
  std::vector<Drive> all = PointSubject::drives();
  if (hand_.axes() != nullptr)
    all.push_back({.name = "axes",
                   .unit = "slabs",
                   .now = static_cast<double>(hand_.axes()->size()),
                   .whole = true,
                   .by_hand = true});
  return all;
}

Done CloudSubject::drive(std::string_view name, double from, double to) {
  if (name != "axes" || hand_.axes() == nullptr) return PointSubject::drive(name, from, to);
  if (Done resized = hand_.resize_axes(static_cast<int>(std::lround(to))); !resized) return resized;
  worked_ = {};
  origin_.edited = true;
  return {};
}

/// Other points start with the hand at its first place.
Done CloudSubject::begun(Done done) {
  if (done) hand_.begin(*points());
  return done;
}

Done CloudSubject::load(const io::PointFile& file, std::string_view name) {
  return begun(PointSubject::load(file, name));
}

Done CloudSubject::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) {
  return begun(PointSubject::set_generator(kind, count, dim, seed, own));
}

void CloudSubject::scatter(std::uint64_t seed, const Subject& own) {
  PointSubject::scatter(seed, own);
  hand_.begin(*points());
}

void CloudSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  PointSubject::begin_task(lesson, task, own);
  hand_.begin(*points());
}

fit::Recording CloudSubject::record(const Method& method, fit::Recording room) const {
  if (method.by_hand) return hand_.record(method, *points(), std::move(room));
  return algorithm_of(method).record(*points(), {.seed = origin_.seed}, std::move(room));
}

fit::Volume3 CloudSubject::fitted(const Method& method) const {
  if (method.by_hand) return hand_.fitted(method, *points());
  return algorithm_of(method).fit(*points(), {.seed = origin_.seed}).volume;
}

std::unique_ptr<Run> CloudSubject::run(const Method& method, std::unique_ptr<Run> earlier) const {
  fit::Recording room;
  if (earlier != nullptr) room = static_cast<FitRun&>(*earlier).give_up();
  const bool slabs = method.by_hand && hand_.axes() != nullptr && hand_.held(method.volume) == nullptr;
  const bool loses_points = !method.by_hand && algorithm_of(method).loses_points;
  return std::make_unique<FitRun>(*points(), method.exact, record(method, std::move(room)), names(), hand_.size() > 0,
                                  slabs ? hand_.axes()->axes() : std::vector<Point3>(), loses_points);
}

std::string CloudSubject::opening(const Method& method) const {
  return std::string(method.title) + ", " + counted(count(), "point") + ": nothing is known yet. Take the first step.";
}

std::vector<Figure> CloudSubject::figures(const View& view) const {
  std::vector<Figure> figures = fit_figures(view, fit_run(view.run()), reference(view));
  add_wrong_tests(figures, view);
  if (is_tested_ && view.at_end()) {
    const fit::Recording& recording = fit_run(view.run()).recording();
    const double operations = cost::operations_of_test(recording.result.volume, dim(), origin_.seed);
    figures.push_back({"Operations of a test", "test_operations", number_text(operations), operations, "operations"});
  }
  if (!has_naive_ || !view.at_end()) return figures;
  add_left_outside(figures, fit_run(view.run()));
  add_certificate(figures, fit_run(view.run()), view.method().naive, names());
  return figures;
}

void CloudSubject::add_wrong_tests(std::vector<Figure>& figures, const View& view) {
  const std::vector<WrongTest>* wrong = fit_run(view.run()).wrong();
  if (wrong == nullptr || view.step == 0) return;
  const auto shown = [&](const WrongTest& test) { return test.step < view.step; };
  const auto count = std::count_if(wrong->begin(), wrong->end(), shown);
  figures.push_back({view.at_end() ? "Wrong tests" : "Wrong tests so far", "wrong_tests", count_text(count),
                     static_cast<double>(count), "tests"});
  const bool known = count > 0;
  const int first = known ? wrong->front().step + 1 : 0;
  figures.push_back({"First of them, in step", "first_wrong", known ? count_text(first) : "—",
                     static_cast<double>(first), "", known});
}

std::vector<Proof> CloudSubject::proofs(const View& view) const { return fit_proofs(view, fit_run(view.run())); }

std::optional<double> CloudSubject::result_size(const Method& method, bool by_measure, const View& view) const {
  if (by_measure == by_measure_) return size_of(method, view);
  const fit::Volume3 volume = fitted(method);
  return by_measure ? fit::measure_of(volume, dim()) : fit::size_of(volume, dim());
}

bool CloudSubject::reaches(std::string_view goal) const {
  return breaks(compare_scalars(goal, *points(), origin_.seed));
}

std::string CloudSubject::goal_says(std::string_view goal) const {
  return says_of(compare_scalars(goal, *points(), origin_.seed), [&](Index i) { return name_of(i); });
}

std::int64_t CloudSubject::operations(const Method& method) const {
  const OperationCounts counts = method.by_hand
                                     ? record(method, {}).counts
                                     : algorithm_of(method).watch(*points(), {.seed = origin_.seed}, {}).counts;
  return std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
}

/// Null if there is none, or if it cannot take these points.
const Method* CloudSubject::compared_with() const {
  return reference_ != nullptr && suits(*reference_) ? reference_ : nullptr;
}

const fit::Recording* CloudSubject::optimum(const View& view) const {
  const Method* own = compared_with();
  if (own == nullptr) return nullptr;
  for (const Slot& slot : view.slots)
    if (slot.method == own) return &fit_run(*slot.run).recording();
  if (!worked_.optimum) worked_.optimum = std::make_shared<const fit::Recording>(record(*own, {}));
  return worked_.optimum.get();
}

Reference CloudSubject::reference(const View& view) const {
  Reference reference{.size = {}, .name = "the optimum", .word = {}, .by_measure = by_measure_};
  const Method* own = compared_with();
  if (own == nullptr) return reference;
  reference.word = "smallest " + std::string(volume_word(own->volume, dim()));
  if (!worked_.size) worked_.size = size_of(*own, view);
  reference.size = worked_.size;
  if (own->volume == "hull") reference.name = "the convex hull", reference.word = "convex hull";
  else if (by_measure_ || !own->exact) reference.name = reference.word = own->title;
  return reference;
}

double CloudSubject::size_of(const fit::Volume3& volume) const {
  return by_measure_ ? fit::measure_of(volume, dim()) : fit::size_of(volume, dim());
}

/// The size of a method's volume. A run that a slot shows is not repeated.
double CloudSubject::size_of(const Method& method, const View& view) const {
  for (const Slot& slot : view.slots)
    if (slot.method == &method) return size_of(fit_run(*slot.run).recording().result.volume);
  if (&method == compared_with() && worked_.size) return *worked_.size;
  return size_of(fitted(method));
}

std::vector<Rival> CloudSubject::rivals(const Lesson& lesson, const View& view) const {
  std::vector<Rival> rivals;
  const Reference than = reference(view);
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (!suits(method)) continue;
    const double own = size_of(method, view);
    rivals.push_back({&method, own, excess_of(own, than.size)});
  }
  return rivals;
}

const fit::Recording* recording_of(const Session& session, int slot) {
  const bool fits =
      as<CloudSubject>(session.stage().subject().shape()) != nullptr && session.player().method(slot) != nullptr;
  return fits ? &fit_run(session.player().run(slot)).recording() : nullptr;
}

}  // namespace snug::lesson
