#include "lesson/subjects/cost/cost.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cost/asks.hpp"

namespace snug::lesson {
namespace {

const char* offer_written(Asked& asked, const Run&) {
  for (const std::string& choice : asked.question->choices) asked.add_choice(choice);
  return nullptr;
}

constexpr std::array kCostQuestionKinds{QuestionKind{"choice", &offer_written, &measured_choice_truth},
                                        QuestionKind{"on_front", &offer_front, &front_truth},
                                        QuestionKind{"slowest", &offer_methods, &slowest_truth},
                                        QuestionKind{"times_slower", &offer_times, &times_truth}};

constexpr std::array<std::string_view, 1> kTaskFigures{kTighterFigure};

/// Checks that on the model's points some algorithm is smaller by as much as the task asks. Which of them is fastest
/// depends on the student's machine.
void check_cost_task(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints) {
  if (task.conditions.size() != 1 || task.conditions.front().figure != kTighterFigure)
    return complaints.add(task.place, "a task with the chart has one [[task.require]], of the figure tighter");
  auto model = own.clone();
  if (const Done made = model->set_rows(task.model); !made) return complaints.add(task.model_place, made.error().what);
  if (cheapest_of(task, counted_costs(lesson, *model->points())).empty())
    complaints.add(task.model_place, "on the model, no algorithm's result is smaller by as much as the task asks");
}

tl::expected<std::unique_ptr<Subject>, InputError> open_chart(const Lesson& lesson, std::optional<io::PointFile> mesh,
                                                              Clock clock) {
  auto cloud = open_cloud_of(lesson, std::move(mesh), clock);
  if (!cloud) return tl::unexpected(std::move(cloud.error()));
  return std::make_unique<CostSubject>(*std::move(cloud), methods_of(lesson));
}

/// Without a clock, answers and grades are based on counted operations, and say so.
void count_costs(Session& session) {
  auto rows = counted_costs(session.lesson(), *session.stage().subject().points());
  session.inform<CostSubject>([&](CostSubject& subject) { subject.measured(std::move(rows)); });
}

tl::expected<Grade, InputError> play_cost_task(Session& session, const Task& task) {
  if (const Done made = session.stage().set_rows(task.model); !made) return tl::unexpected(made.error());
  count_costs(session);
  static_cast<void>(session.player().choose(0, cheapest_of(task, *costs_of(session))));
  return *session.grade();
}

constexpr Experiment kCostExperiment{.chart = "cost", .decided_by = "operations", .perform = &count_costs};

}  // namespace

constinit const SubjectRow kCostRow = row_on_cloud({.name = "cost",
                                                    .experiment = &kCostExperiment,
                                                    .question_kinds = &of_no_fact<kCostQuestionKinds>,
                                                    .task_figures = kTaskFigures,
                                                    .check_task = &check_cost_task,
                                                    .open = &open_chart,
                                                    .play_task = &play_cost_task});

void CostSubject::begin_task(const Lesson& lesson, const Task& task, const Subject& own) {
  const std::string_view kind = lesson.generators.empty() ? "gaussian" : std::string_view(lesson.generators.front());
  static_cast<void>(set_generator(kind, std::max(task.points, 1), dim(), lesson.seed, own));
  origin_.edited = true;
}

Grade CostSubject::grade(const Lesson& lesson, const Task& task, const View& view) const {
  Grade grade;
  grade.points = static_cast<int>(size());
  const bool is_own = !origin_.edited && origin_.seed == lesson.seed && origin_.source != "task";
  if (is_own) grade.says = "This is the lesson's own shape: scatter another, or open a file of your own.";
  else if (costs() == nullptr) grade.says = "Measure this shape.";
  else return grade_costs(task, *costs(), name_in(lesson, *view.slots[0].method));
  return grade;
}

const std::vector<cost::CostRow>* costs_of(const Session& session) {
  const auto* chart = as<CostSubject>(session.stage().subject());
  return chart != nullptr ? chart->costs() : nullptr;
}

}  // namespace snug::lesson
