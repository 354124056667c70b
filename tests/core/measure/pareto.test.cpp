// The front, held to its definition.
#include "measure/pareto.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <set>

#include "geometry/random.hpp"

using namespace snug;

namespace {

bool undercuts(const cost::Offer& a, const cost::Offer& b) {
  return a.time <= b.time && a.size <= b.size && (a.time < b.time || a.size < b.size);
}

}  // namespace

TEST_CASE("the front is those that none undercuts") {
  Random random(7);
  for (int round = 0; round < 500; ++round) {
    std::vector<cost::Offer> offers;
    const int n = static_cast<int>(random.below(12));
    for (int i = 0; i < n; ++i) offers.push_back({double(random.below(6)), double(random.below(6))});  // many are equal
    std::set<std::size_t> expected;
    for (std::size_t i = 0; i < offers.size(); ++i) {
      bool free = true;
      for (const cost::Offer& other : offers) free = free && !undercuts(other, offers[i]);
      if (free) expected.insert(i);
    }
    const auto front = cost::pareto_front(offers);
    CHECK(std::set<std::size_t>(front.begin(), front.end()) == expected);
    CHECK(front.size() == expected.size());
    for (std::size_t i = 1; i < front.size(); ++i) CHECK(offers[front[i - 1]].time <= offers[front[i]].time);
  }
}

TEST_CASE("sizes that differ by rounding alone are equal: the faster undercuts") {
  const double more = 1 + 1e-12;
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, more, 1e-9}, {2, 1, 1e-9}}) == std::vector<std::size_t>{0});
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, more}, {2, 1}}) == std::vector<std::size_t>{0, 1});
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, 1.1, 1e-9}, {2, 1, 1e-9}}) == std::vector<std::size_t>{0, 1});
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, more, 1e-9}, {1, 1, 1e-9}}).size() == 2);
}

TEST_CASE("times that cannot be told apart are equal: the smaller undercuts, and equal sizes are tied") {
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, 2, 0, 0.1}, {1.05, 1, 0, 0.1}}) == std::vector<std::size_t>{1});
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, 1, 0, 0.1}, {1.05, 1, 0, 0.1}}).size() == 2);
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{1, 1, 0, 0.1}, {1.2, 1, 0, 0.1}}) == std::vector<std::size_t>{0});
}

TEST_CASE("offers that are no numbers are on no front") {
  constexpr double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();
  CHECK(cost::pareto_front(std::vector<cost::Offer>{{kInf, 1}, {1, kNan}, {2, 2}}) == std::vector<std::size_t>{2});
  CHECK(cost::pareto_front(std::vector<cost::Offer>{}).empty());
}
