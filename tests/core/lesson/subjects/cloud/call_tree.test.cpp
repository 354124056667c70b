// The calls of Welzl's recursion as lectures print it, as they are read off a trace.
#include "lesson/subjects/cloud/call_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <variant>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "fit/sphere/welzl_recursive.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

template <int Dim>
fit::Recording recursion_over(const char* kind, int n, std::uint64_t seed) {
  return fit::find_algorithm("sphere", "welzl_recursive")
      ->record(test::set_of<double, Dim>(test::generated<double, Dim>(kind, n, seed)), {.seed = seed});
}

template <int Dim>
void check_tree(const fit::Recording& run, int n) {
  for (int step = 1; step <= static_cast<int>(run.steps.size()); ++step) {
    const fit::Step3& now = run.steps[step - 1].step;
    const CallTree tree = call_tree(run.steps, step);
    CAPTURE(step);
    for (std::size_t i = 0; i < tree.open.size(); ++i) {
      const TreeCall& call = tree.calls[tree.open[i]];
      CHECK(call.open);
      CHECK(call.depth == static_cast<int>(i) + 1);
      CHECK(call.left == n - static_cast<int>(i));  // each call removes one point
      CHECK(call.parent == (i == 0 ? -1 : tree.open[i - 1]));
    }
    CHECK(std::count_if(tree.calls.begin(), tree.calls.end(), [](const TreeCall& call) { return call.open; }) ==
          static_cast<std::ptrdiff_t>(tree.open.size()));
    for (const TreeCall& call : tree.calls) {
      CHECK(call.boundary.size() <= Dim + 1);
      if (call.parent < 0) continue;
      const TreeCall& caller = tree.calls[call.parent];
      CHECK(call.boundary.size() == caller.boundary.size() + (call.again ? 1 : 0));
      if (call.again) CHECK(call.boundary[call.boundary.size() - 1] == caller.point);
    }
    if (const auto* decided = std::get_if<fit::CallDecided>(&now.fact); decided != nullptr && decided->outside) {
      CHECK(static_cast<int>(tree.open.size()) == decided->depth);
      CHECK(tree.calls[tree.open.back()].point == decided->point);
    }
    CHECK(tree.deepest <= n + 1);
  }
}

}  // namespace

TEST_CASE("the open calls are a chain, each with one point fewer, and all return") {
  for (const char* kind : {"gaussian", "sphere", "line"})
    for (const std::uint64_t seed : {1, 2, 3}) {
      const fit::Recording plane = recursion_over<2>(kind, 7, seed), space = recursion_over<3>(kind, 6, seed);
      check_tree<2>(plane, 7);
      check_tree<3>(space, 6);
      const CallTree end = call_tree(plane.steps, static_cast<int>(plane.steps.size()));
      CHECK(end.open.empty());
      CHECK(end.deepest == 8);
      CHECK(end.bytes == 0);
    }
}

TEST_CASE("the recursion is as deep as there are points, and is stopped at its limit") {
  const auto limit = fit::kWelzlDepthLimit;
  for (const int n : {10, 100, 1000, limit - 1, limit, limit + 100}) {
    const fit::Recording run = recursion_over<3>("gaussian", n, 4);
    const CallTree tree = call_tree(run.steps, static_cast<int>(run.steps.size()));
    CAPTURE(n);
    CHECK(tree.deepest == std::min(n + 1, limit));
    CHECK(tree.stopped_at == (n + 1 > limit ? limit : 0));
    CHECK(run.certificate.contains);
    CHECK(run.certificate.optimal == true);
    if (tree.stopped_at == 0) continue;
    const auto is_stop = [](const auto& entry) {
      return std::holds_alternative<fit::RecursionStopped>(entry.step.fact);
    };
    const auto stop = std::find_if(run.steps.begin(), run.steps.end(), is_stop);
    const CallTree full = call_tree(run.steps, static_cast<int>(stop - run.steps.begin()) + 1);
    CHECK(static_cast<int>(full.open.size()) == limit);  // the call that found no room is open, and was made
    CHECK(static_cast<int>(full.calls.size()) == limit);
    CHECK(full.bytes == std::get<fit::RecursionStopped>(stop->step.fact).bytes);
  }
}

TEST_CASE("no other algorithm has a tree of calls") {
  const auto points = test::set_of<double, 2>(test::generated<double, 2>("cube", 9, 1));
  const fit::Recording run = fit::find_algorithm("sphere", "welzl")->record(points, {});
  CHECK_FALSE(has_calls(run.steps));
  CHECK(call_tree(run.steps, 5).calls.empty());
}
