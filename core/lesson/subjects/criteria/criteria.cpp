#include "lesson/subjects/criteria/criteria.hpp"

#include <algorithm>
#include <limits>

#include "fit/catalogue.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/check_solution.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/criteria/criteria_words.hpp"
#include "lesson/subjects/criteria/samples.hpp"

namespace snug::lesson {
namespace {

/// Times that differ by less are not told apart.
constexpr double kTimeDoubt = 0.05;

void read_criteria(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  read_on_cloud(table, lesson, complaints);
  lesson.tables = read_load(table, complaints);
}

/// Reads "model", a list of points, or in its place "load", the numbers that sliders set.
Rows read_criteria_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  const toml::table* own = task.table("load");
  if (own == nullptr) return read_point_model(task, lesson, complaints);
  TomlTable table(*own, "[task.load]", complaints);
  Load load = load_of(lesson);
  load.frames = table.any_number("frames", load.frames);
  load.pairs = table.any_number("pairs", load.pairs);
  load.hit_rate = table.any_number("hit_rate", 100 * load.hit_rate) / 100;
  table.refuse_others();
  return {row_of(load)};
}

tl::expected<std::unique_ptr<Subject>, InputError> open_criteria(const Lesson& lesson,
                                                                 std::optional<io::PointFile> mesh, Clock clock) {
  auto cloud = open_cloud_of(lesson, std::move(mesh), clock);
  if (!cloud) return tl::unexpected(std::move(cloud.error()));
  return std::make_unique<CriteriaSubject>(*std::move(cloud), methods_of(lesson), load_of(lesson));
}

/// Checks as any task is checked, with operations in place of times.
void check_criteria_task(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints) {
  const auto begun = own.clone(), solved = own.clone();
  begun->begin_task(lesson, task, own);
  if (const Done made = solved->set_rows(task.model); !made) return complaints.add(task.model_place, made.error().what);
  auto& counting = static_cast<CriteriaSubject&>(*begun);  // its clones know what it knows
  counting.count(*begun->points());
  counting.count(*solved->points());
  check_solution(lesson, task, *begun, complaints);
}

/// Without a clock, answers and grades are based on counted operations, and say so.
void count_criteria(Session& session) {
  session.inform<CriteriaSubject>([](CriteriaSubject& subject) { subject.count(*subject.points()); });
}

tl::expected<Grade, InputError> play_criteria_task(Session& session, const Task& task) {
  if (const Done made = session.stage().set_rows(task.model); !made) return tl::unexpected(made.error());
  count_criteria(session);
  return *session.grade();
}

/// The share of others that a value is above by more than the doubt.
std::vector<int> ranks_among(const std::vector<double>& values, double doubt) {
  std::vector<int> ranks;
  for (const double value : values)
    ranks.push_back(static_cast<int>(
        std::count_if(values.begin(), values.end(), [&](double other) { return other * (1 + doubt) < value; })));
  return ranks;
}

constexpr Experiment kCriteriaExperiment{.chart = "criteria", .decided_by = "operations", .perform = &count_criteria};

}  // namespace

constinit const SubjectRow kCriteriaRow = row_on_cloud({.name = "criteria",
                                                        .experiment = &kCriteriaExperiment,
                                                        .question_kinds = &criteria_question_kinds,
                                                        .compares = true,
                                                        .read = &read_criteria,
                                                        .read_model = &read_criteria_model,
                                                        .check_task = &check_criteria_task,
                                                        .open = &open_criteria,
                                                        .play_task = &play_criteria_task,
                                                        .samples = kCriteriaSamples});

ShapeCosts& CriteriaSubject::known() const {
  if (known_ != nullptr) return *known_;
  const auto shape = store_->shape(*points(), methods_, origin_.seed);
  if (!shape->rows.empty()) known_ = shape;
  return *shape;  // the store keeps it, for it is the latest
}

void CriteriaSubject::measured(const AnyPointSet& points, std::vector<cost::CriteriaRow> rows) {
  const auto shape = store_->shape(points, methods_, origin_.seed);
  if (rows.size() == shape->volumes.size()) shape->rows = std::move(rows);
}

void CriteriaSubject::count(const AnyPointSet& points) {
  const auto shape = store_->shape(points, methods_, origin_.seed);
  measured(points, cost::counted_criteria(points, algorithms_of(*shape), own_load_.still(), {.seed = origin_.seed}));
}

std::optional<TotalCost> CriteriaSubject::total(std::size_t volume, const Load& load) const {
  return cost::total_of(known().rows, volume, load);
}

std::optional<double> CriteriaSubject::value(std::size_t volume, Criterion criterion, const Load& load) const {
  const ShapeCosts& shape = known();
  if (criterion == Criterion::kLooseness) return shape.volumes[volume].over_hull;
  if (shape.rows.empty()) return std::nullopt;
  const cost::CriteriaRow& row = shape.rows[volume];
  switch (criterion) {
    case Criterion::kTest: return row.costs.overlap.median;
    case Criterion::kBuild: return row.costs.whole_ns.value_or(row.costs.time.median);
    case Criterion::kUpdate: return row.update.median;
    case Criterion::kBytes: return static_cast<double>(row.costs.bytes);
    default: break;
  }
  const auto all = total(volume, load);
  return all ? std::optional(all->sum()) : std::nullopt;
}

std::vector<int> CriteriaSubject::ranks(Criterion criterion, const Load& load) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < known().volumes.size(); ++i) {
    const auto own = value(i, criterion, load);
    if (!own) return {};
    values.push_back(*own);
  }
  const bool exact = criterion == Criterion::kLooseness || criterion == Criterion::kBytes || is_counted();
  return ranks_among(values, exact ? tolerance::kBoxProof : kTimeDoubt);
}

std::vector<Drive> CriteriaSubject::drives() const {
  std::vector<Drive> all = OnCloud::drives();
  all.push_back({.name = "frames", .unit = "", .now = load_.frames, .whole = true});
  all.push_back({.name = "pairs", .unit = "", .now = load_.pairs, .whole = true});
  all.push_back({.name = "hit rate", .unit = "%", .now = 100 * load_.hit_rate});
  return all;
}

Done CriteriaSubject::drive(std::string_view name, double from, double to) {
  std::vector<double> row = row_of(load_);
  if (name == "frames") row[0] = to;
  else if (name == "pairs") row[1] = to;
  else if (name == "hit rate") row[2] = to / 100;
  else return OnCloud::drive(name, from, to);
  auto next = with_row(load_, row);
  if (!next) return tl::unexpected(std::move(next.error()));
  load_ = *next;
  return {};
}

Rows CriteriaSubject::rows() const {
  Rows all = OnCloud::rows();
  all.push_back(row_of(load_));
  return all;
}

Done CriteriaSubject::set_rows(const Rows& rows) {
  const bool has_load = !rows.empty() && rows.back().size() == kLoadRow;
  Load next = load_;
  if (has_load) {
    auto read = with_row(load_, rows.back());
    if (!read) return tl::unexpected(std::move(read.error()));
    next = *read;
  }
  const Rows points(rows.begin(), rows.end() - (has_load ? 1 : 0));
  if (!points.empty() || !has_load)
    if (Done set = OnCloud::set_rows(points); !set) return set;
  load_ = next;
  return {};
}

void CriteriaSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  cloud().begin_task(lesson, task, own.shape());
  load_ = own_load_;
  static_cast<void>(edited({}));
}

std::vector<Figure> CriteriaSubject::results(const Method& method, const View& view) const {
  std::vector<Figure> figures = Subject::results(method, view);
  Figure lead{.name = "Total cost below that of the next", .key = "lead", .text = "–", .unit = "%", .known = false};
  std::optional<double> own;
  double others = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < known().volumes.size(); ++i) {
    const auto sum = value(i, Criterion::kTotal, load_);
    if (known().volumes[i].method == &method) own = sum;
    else if (sum) others = std::min(others, *sum);
  }
  if (own && others > 0) {
    lead.value = 100 * (1 - *own / others);
    lead.text = number_text(lead.value) + " %", lead.known = true;
  }
  figures.push_back(std::move(lead));
  return figures;
}

Grade CriteriaSubject::grade(const Lesson& lesson, const Task& task, const View& view) const {
  const bool of_load = std::any_of(task.conditions.begin(), task.conditions.end(),
                                   [](const Requirement& due) { return due.figure == "lead"; });
  if (!of_load || is_measured()) return grade_by_requirements(lesson, task, *this, view);
  Grade grade;
  grade.points = static_cast<int>(size());
  grade.says = "Measure this shape.";
  return grade;
}

const CriteriaSubject* criteria_of(const Session& session) { return as<CriteriaSubject>(session.stage().subject()); }

}  // namespace snug::lesson
