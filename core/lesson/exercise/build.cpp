#include "lesson/exercise/build.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/random.hpp"
#include "lesson/decide.hpp"
#include "lesson/grade.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostMoves = 1500, kMovesBeforeNewStart = 500;
constexpr double kRoom = 0.75;    // how far around the middle things are put, a share of the extent
constexpr double kGrid = 1000;    // coordinates are rounded to so many parts of a unit: a model is read by people
constexpr double kFlat = 1e-3;    // as thin as this share of the length, points count as on a line
constexpr int kSmallestStep = 6;  // a step is the extent halved at most so often

bool rises(const Requirement& due) { return std::isfinite(due.at_least); }

/// How many levels a requirement reaches.
int level_of(const Build& build, std::size_t which, const Requirement& due, const Judged& judged) {
  const std::vector<double>& steps = build.steps[which];
  if (judged.met) return build.levels;
  const auto reached = [&](double step) { return rises(due) ? judged.value >= step : judged.value <= step; };
  return static_cast<int>(std::count_if(steps.begin(), steps.end(), reached));
}

/// How far what is asked is missed: 0 where nothing is.
double missing(const Requirement& due, const Judged& judged) {
  if (judged.met) return 0;
  if (!due.goal.empty() || std::isnan(judged.value)) return 1;
  const double bound = rises(due) && judged.value < due.at_least ? due.at_least : due.at_most;
  return std::abs(judged.value - bound) / std::max(std::abs(bound), 1.0);
}

/// Whether all points lie on a line, or in space in a plane, but for rounding: volumes of nothing, whose ratio says
/// nothing.
bool is_flat(const Subject& subject) {
  if (subject.points() == nullptr) return false;
  const std::vector<Point3> all = all_points(*subject.points());
  Point3 along = Point3::Zero();
  for (const Point3& p : all)
    if ((p - all.front()).norm() > along.norm()) along = p - all.front();
  const auto cross = [&](const Point3& p) { return Point3(along.cross(p - all.front())); };
  Point3 across = Point3::Zero();
  for (const Point3& p : all)
    if (cross(p).norm() > across.norm()) across = cross(p);
  const double reach = along.norm();
  if (across.norm() <= kFlat * reach * reach) return true;
  if (subject.dim() == 2) return false;
  const Point3 normal = across.normalized();
  return std::all_of(all.begin(), all.end(),
                     [&](const Point3& p) { return std::abs(normal.dot(p - all.front())) <= kFlat * reach; });
}

/// A stage whose handles are moved at random, and kept where that brings it nearer.
class Search {
 public:
  Search(const Lesson& lesson, const Subject& subject, std::uint64_t seed)
      : lesson_(lesson), task_(lesson.tasks.front()), begins_(subject), random_(seed), extent_(extent_of(subject)) {
    const Index n = subject.size();
    for (Index i = 0; i < n; ++i) {
      middle_ += subject.at(i) / static_cast<double>(n);
      if (task_.only.empty() || is_among(task_.only, subject.name_of(i))) movable_.push_back(i);
    }
  }

  std::optional<Rows> find() {
    if (movable_.empty()) return std::nullopt;
    std::unique_ptr<Subject> best;
    double least = 0;
    for (int moves = 0; moves < kMostMoves; ++moves) {
      if (moves % kMovesBeforeNewStart == 0) best = begins_.clone(), least = missed(*best);
      if (least == 0) return best->rows();
      auto next = best->clone();
      const Index i = movable_[random_.below(static_cast<std::uint32_t>(movable_.size()))];
      if (!next->move(i, place_near(next->at(i), next->dim()))) continue;
      const double now = missed(*next);
      if (now <= least) best = std::move(next), least = now;
    }
    return least == 0 ? std::optional(best->rows()) : std::nullopt;
  }

 private:
  [[nodiscard]] double missed(const Subject& subject) const {
    const Method& method = *find_method(lesson_, task_.algorithm);
    if (!subject.suits(method)) return std::numeric_limits<double>::infinity();
    const auto run = subject.run(method, nullptr);
    const View view{{Slot{&method, run.get()}, Slot{}}, 0, run->steps()};
    double sum = 0;
    for (const Requirement& due : task_.conditions)
      sum += missing(due, judge_requirement(due, lesson_, task_.algorithm, subject, view));
    return sum;
  }

  /// Anywhere, or a step away.
  [[nodiscard]] Point3 place_near(const Point3& from, int dim) {
    const bool anywhere = random_.below(3) == 0;
    const double reach =
        anywhere ? kRoom * extent_ : std::ldexp(extent_, -static_cast<int>(random_.below(kSmallestStep)) - 1);
    Point3 to = anywhere ? middle_ : from;
    for (int axis = 0; axis < dim; ++axis)
      to[axis] = std::round((to[axis] + reach * (2 * random_.unit() - 1)) * kGrid) / kGrid;
    return to;
  }

  const Lesson& lesson_;
  const Task& task_;
  const Subject& begins_;
  Random random_;
  double extent_;
  Point3 middle_ = Point3::Zero();
  std::vector<Index> movable_;
};

}  // namespace

int level_of(const Exercise& exercise, const Session& session) {
  const Task& task = session.lesson().tasks.front();
  if ((!task.only.empty() && !session.stage().at_task()) || is_flat(session.stage().subject())) return 0;
  if (const AnyPointSet* points = session.stage().subject().points();
      points != nullptr && task.points > 0 && static_cast<int>(fit::count_of(*points)) != task.points)
    return 0;
  int least = exercise.build->levels;
  for (std::size_t i = 0; i < task.conditions.size(); ++i) {
    const Requirement& due = task.conditions[i];
    const Judged judged =
        judge_requirement(due, session.lesson(), task.algorithm, session.stage().subject(), session.player().view());
    least = std::min(least, level_of(*exercise.build, i, due, judged));
  }
  return least;
}

std::string now_says(const Session& session) {
  if (is_flat(session.stage().subject()))
    return session.stage().subject().dim() == 2
               ? "All points lie on a line, or nearly so: there is no area to compare."
               : "All points lie in a plane, or nearly so: there is no volume to compare.";
  return session.grade(0).says;
}

std::vector<std::string> level_texts(const Exercise& exercise, const Session& session) {
  const Task& task = session.lesson().tasks.front();
  std::vector<std::string> texts(static_cast<std::size_t>(exercise.build->levels));
  for (std::size_t i = 0; i < task.conditions.size(); ++i) {
    const Requirement& due = task.conditions[i];
    const std::vector<double>& steps = exercise.build->steps[i];
    if (steps.empty()) continue;
    const std::string unit =
        judge_requirement(due, session.lesson(), task.algorithm, session.stage().subject(), session.player().view())
            .unit;
    for (std::size_t level = 0; level < texts.size(); ++level) {
      const double bound = level < steps.size() ? steps[level] : rises(due) ? due.at_least : due.at_most;
      texts[level] += (texts[level].empty() ? "" : ", ") + std::string(rises(due) ? "at least " : "at most ") +
                      bound_text(bound, unit);
    }
  }
  return texts;
}

std::optional<Rows> find_model(const Exercise& exercise, const Session& instance) {
  const Task& task = exercise.stage.tasks.front();
  if (!task.searched) return task.model;
  const Subject& begins = instance.stage().subject();
  return Search(instance.lesson(), begins, begins.origin().seed).find();
}

}  // namespace snug::lesson
