#include "lesson/play.hpp"

#include "lesson/costs.hpp"
#include "lesson/methods.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

/// Answers what is asked, or takes a step. false: neither could be done.
bool advance(Session& session, std::vector<Outcome>& outcomes) {
  const int step = session.step();
  if (const Asked* asked = session.asked(); asked != nullptr && !session.lesson().measures) {
    if (!session.answer(model_answer(*asked, session.recording(0).steps))) return false;
    if (const Outcome* outcome = session.outcome()) outcomes.push_back(*outcome);
    return true;
  }
  session.forward();
  return session.step() > step;
}

tl::expected<Played::Algorithm, InputError> play_algorithm(Session& session, const std::string& name) {
  if (const auto chosen = session.choose(0, name); !chosen) return tl::unexpected(chosen.error());
  Played::Algorithm played{name, session.steps(), {}};
  session.first();
  // Every turn answers a question or takes a step, so that more turns than both are one too many.
  std::size_t turns = session.questions().size() + static_cast<std::size_t>(session.steps());
  const auto asks = [&] {
    return session.asked() != nullptr && !session.lesson().measures;
  };  // the chart's are asked apart
  while (session.step() < session.steps() || asks())
    if (turns-- == 0 || !advance(session, played.outcomes))
      return tl::unexpected(
          InputError{.what = "the player does not get past step " + std::to_string(session.step()) + " of " + name});
  return played;
}

/// Predicts what comes of the chart, by operations in the place of times, and has it measured so.
void play_chart(Session& session, Played& played) {
  const std::vector<cost::CostRow> rows = counted_costs(session.lesson(), session.points());
  while (const Asked* asked = session.asked())
    if (!session.answer(model_answer(*asked, rows))) return;
  session.measured(rows);
  if (!played.algorithms.empty()) played.algorithms.front().outcomes = session.outcomes();
}

/// The cheapest that the task asks for, on the model's points.
void choose_cheapest(Session& session, const Task& task) {
  session.measured(counted_costs(session.lesson(), session.points()));
  static_cast<void>(session.choose(0, cheapest_of(task, *session.costs())));
}

void find_not_asked(const Lesson& lesson, Played& played) {
  for (const Question& question : lesson.questions) {
    bool asked = false;
    for (const auto& algorithm : played.algorithms)
      for (const Outcome& outcome : algorithm.outcomes) asked = asked || outcome.question == question.id;
    if (!asked) played.not_asked.push_back(question.id);
  }
}

}  // namespace

std::vector<std::string> playable(const Session& session) {
  std::vector<std::string> names;
  for (const std::string& name : session.lesson().algorithms)
    if (const fit::Algorithm* known = find_method(session.lesson().volume, name);
        known && session.size() <= known->max_points)
      names.push_back(name);
  return names;
}

bool Played::sound() const {
  for (const Algorithm& algorithm : algorithms)
    for (const Outcome& outcome : algorithm.outcomes)
      if (!outcome.right) return false;
  return not_asked.empty() && (!grade || grade->done);
}

tl::expected<Played, InputError> play(Session& session) {
  Played played;
  session.forget_answers();
  for (const std::string& name : playable(session)) {
    auto algorithm = play_algorithm(session, name);
    if (!algorithm) return tl::unexpected(std::move(algorithm.error()));
    played.algorithms.push_back(std::move(*algorithm));
  }
  if (session.lesson().measures) play_chart(session, played);
  find_not_asked(session.lesson(), played);
  const auto& task = session.lesson().task;
  if (task && session.boxes() != nullptr) {
    session.start_task();
    for (const BoxPair& model : task->models) {
      if (const auto placed = session.set_boxes(model); !placed) return tl::unexpected(placed.error());
      played.grade = session.grade();
    }
  } else if (task) {
    const auto loaded = session.load({session.lesson().points.dim, task->model, {}}, "the task's model answer");
    if (!loaded) return tl::unexpected(loaded.error());
    if (session.lesson().measures) choose_cheapest(session, *task);
    played.grade = session.grade();
  }
  return played;
}

}  // namespace snug::lesson
