// Welzl's list and his calls, as they are read off a trace.
#include "lesson/subjects/cloud/waiting_calls.hpp"

#include <algorithm>
#include <numeric>

#include "core/lesson/small_lesson.hpp"
#include "geometry/generate.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

fit::Recording welzl_run_of(const char* algorithm, int n, int dim, std::uint64_t seed) {
  const auto points = *generate("gaussian", n, dim, seed);
  const auto record = [&](const AnyPointSet& set) {
    return fit::find_algorithm("sphere", algorithm)->record(set, {.seed = seed});
  };
  if (dim == 3) return record(*PointSet<double, 3>::make(points));
  std::vector<Vector<double, 2>> flat;
  for (const auto& p : points) flat.push_back(p.head<2>());
  return record(*PointSet<double, 2>::make(std::move(flat)));
}

/// What the facts say of a step holds of the state behind it.
void check_welzl_state(const WelzlState& state, const fit::Step3& step) {
  if (const auto* examined = std::get_if<fit::PointExamined>(&step.fact)) {
    const WaitingCall& call = state.calls.back();
    CHECK(static_cast<int>(state.calls.size()) == examined->depth + 1);
    CHECK(call.at == examined->point);
    CHECK(state.list[call.done - (examined->outside ? 0 : 1)] == examined->point);
  }
  if (const auto* forced = std::get_if<fit::BoundaryForced>(&step.fact)) {
    CHECK(static_cast<int>(state.calls.size()) == forced->depth + 1);
    CHECK(state.calls.back().boundary.list() == forced->boundary.list());
    const WaitingCall& caller = state.calls[state.calls.size() - 2];
    CHECK(caller.at == forced->boundary[forced->depth - 1]);
    CHECK(state.list[state.calls.back().length] == caller.at);
  }
  if (const auto* moved = std::get_if<fit::MovedToFront>(&step.fact)) {
    CHECK(state.list.front() == moved->point);
    CHECK(state.moved == moved->point);
    CHECK(static_cast<int>(state.calls.size()) == moved->depth + 1);
  }
}

}  // namespace

TEST_CASE("the list always has every point once, and the calls are nested in it, never more than Dim + 2") {
  for (const int dim : {2, 3})
    for (const std::uint64_t seed : {1, 2, 590}) {
      const fit::Recording run = welzl_run_of("welzl", 14, dim, seed);
      std::size_t deepest = 0;
      for (int step = 0; step <= static_cast<int>(run.steps.size()); ++step) {
        const WelzlState state = welzl_state(run.steps, step);
        std::vector<Index> sorted = state.list, all(14);
        std::sort(sorted.begin(), sorted.end());
        std::iota(all.begin(), all.end(), 0);
        REQUIRE(sorted == all);
        deepest = std::max(deepest, state.calls.size());
        for (std::size_t i = 1; i < state.calls.size(); ++i) {
          CHECK(state.calls[i].length == state.calls[i - 1].done);
          CHECK(state.calls[i].boundary.size() == static_cast<int>(i));
        }
        if (step > 0) check_welzl_state(state, run.steps[step - 1].step);
      }
      CHECK(deepest >= 3);
      CHECK(deepest <= static_cast<std::size_t>(dim) + 2);
    }
}

TEST_CASE("the points that the outermost call has been through lie in the circle when it goes on") {
  const fit::Recording run = welzl_run_of("welzl", 40, 2, 7);
  const auto points = *generate("gaussian", 40, 2, 7);
  for (int step = 1; step <= static_cast<int>(run.steps.size()); ++step) {
    const fit::Step3& now = run.steps[step - 1].step;
    const auto* moved = std::get_if<fit::MovedToFront>(&now.fact);
    if (moved == nullptr || moved->depth > 0) continue;
    const WelzlState state = welzl_state(run.steps, step);
    for (int i = 0; i < state.calls.back().done; ++i)
      CHECK((points[state.list[i]] - ball_of(now)->center).norm() <= ball_of(now)->radius * (1 + 1e-12));
  }
}

TEST_CASE("the list begins in an order of the seed's, and no other method has one") {
  CHECK(welzl_state(welzl_run_of("welzl", 14, 2, 1).steps, 0).list !=
        welzl_state(welzl_run_of("welzl", 14, 2, 2).steps, 0).list);
  for (const char* algorithm : {"ritter", "pivot", "brute_force", "aabb_center"})
    CHECK(welzl_state(welzl_run_of(algorithm, 9, 2, 1).steps, 3).list.empty());
}
