// What an exercise asks of a climb over a hull.
#include "lesson/decide.hpp"
#include "lesson/subjects/update/entries.hpp"

namespace snug::lesson {
namespace {

const fit::NeighborsCompared& compared_of(const Asked& asked, const Run& run) {
  return *std::get_if<fit::NeighborsCompared>(&update_run(run).trace()[asked.fact].step.fact);
}

/// How far the vertex and its neighbours reach towards the side that is climbed.
Scores reaches(const Asked& asked, const Run& run) {
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  const Point3 towards = update_run(run).axis(fact.axis) * (fact.greatest ? 1 : -1);
  Scores scores;
  const auto add = [&](Index i) { scores.add(static_cast<int>(i), update_run(run).placed(i).dot(towards)); };
  add(fact.vertex);
  for (const Index i : fact.neighbors) add(i);
  return scores;
}

}  // namespace

const char* offer_climb(Asked& asked, const Run& run) {
  const UpdateWhere where{update_run(run), asked.fact, nullptr};
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  asked.of = where.side(fact.axis, fact.greatest) + ", now at " + where.name(fact.vertex);
  asked.on_stage = true;
  asked.stage_points = fact.neighbors;
  asked.stage_points.push_back(fact.vertex);
  return nullptr;
}

Truth climb_truth(const Asked& asked, const Run& run) {
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  Truth truth{{}, {fact.best}, asked.subject->name_of(fact.best), {}};
  truth.sentence = extreme_truth(asked, run).sentence;
  return truth;
}

double climb_margin(const Asked& asked, const Run& run) {
  return reaches(asked, run).lead() / extent_of(*asked.subject);
}

/// The first neighbour that reaches farther, where the best of all is climbed to.
std::optional<Answer> first_higher(const Asked& asked, const Run& run) {
  const Scores scores = reaches(asked, run);
  for (std::size_t i = 1; i < scores.of.size(); ++i)
    if (scores.values[i] > scores.values[0]) return by_handle(scores.of[i]);
  return std::nullopt;
}

/// One step too many: from the extreme to its best neighbour.
std::optional<Answer> always_on(const Asked& asked, const Run& run) {
  Scores scores = reaches(asked, run);
  scores.of.erase(scores.of.begin()), scores.values.erase(scores.values.begin());
  return by_handle(scores.greatest());
}

}  // namespace snug::lesson
