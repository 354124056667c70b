// Where the calls of a tree stand in its picture.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/subjects/cloud/call_tree_view.hpp"
#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"

namespace snug::app {

TEST_CASE("calls of one depth stand apart in their order, and each between the first and the last that it made") {
  for (const std::uint64_t seed : {1, 7, 9}) {
    const AnyPointSet points = *PointSet<double, 3>::make(*generate("gaussian", 6, 3, seed));
    const fit::Recording run = fit::find_algorithm("sphere", "welzl_recursive")->record(points, {.seed = seed});
    const lesson::CallTree tree = lesson::call_tree(run.steps, static_cast<int>(run.steps.size()));
    const std::vector<float> columns = columns_of(tree);
    REQUIRE(columns.size() == tree.calls.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      CHECK(columns[i] >= 0);
      CHECK(columns[i] <= 1);
      float least = 2, most = -1;
      for (std::size_t k = i + 1; k < columns.size(); ++k) {
        if (tree.calls[k].depth == tree.calls[i].depth) CHECK(columns[k] > columns[i]);
        if (tree.calls[k].parent != static_cast<int>(i)) continue;
        least = std::min(least, columns[k]), most = std::max(most, columns[k]);
      }
      if (most >= 0) CHECK(columns[i] == doctest::Approx((least + most) / 2));
    }
    CHECK(*std::min_element(columns.begin(), columns.end()) == 0);
    CHECK(*std::max_element(columns.begin(), columns.end()) == 1);
  }
}

TEST_CASE("a tree of one call has a place") {
  lesson::CallTree tree;
  tree.calls.resize(1);
  CHECK(columns_of(tree) == std::vector<float>{0.5f});
}

}  // namespace snug::app
