// Stages of boxes by chance, and lessons on them, for the tests of this folder.
#pragma once

#include <doctest/doctest.h>

#include <set>

#include "geometry/random.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/tree/tree.hpp"

namespace snug::test {

using namespace snug::lesson;

/// Boxes by chance: spread, in one another, in a row, some as flat as a line or in the same place.
inline TreeStage any_tree_stage(std::uint64_t seed) {
  Random random(seed);
  TreeStage stage;
  const int count = kFewestBoxes + static_cast<int>(random.below(kMostBoxes - kFewestBoxes + 1));
  const double wide = random.between(0, 3), high = seed % 5 == 0 ? 0 : 3;
  for (int i = 0; i < count; ++i)
    stage.boxes.push_back({{random.between(-wide, wide), random.between(-high, high)},
                           {random.between(0, 0.7), seed % 7 == 0 ? 0 : random.between(0, 0.7)}});
  if (seed % 6 == 0) stage.boxes[1] = stage.boxes[0];
  const auto place = [&] { return Point2(random.between(-4, 4), random.between(-4, 4)); };
  stage.query = QueryPlaces{{place(), place()}};
  return stage;
}

inline Lesson tree_lesson_on(const TreeStage& stage, std::string_view volume) {
  Lesson lesson;
  lesson.id = "test";
  lesson.volume = volume;
  auto tables = std::make_shared<TreeTables>();
  tables->stage = stage;
  if (volume == kTreeBuild) tables->stage.query.reset();
  lesson.tables = std::move(tables);
  for (const Method& method : volume == kTreeBuild ? build_methods() : query_methods())
    lesson.algorithms.emplace_back(method.name);
  return lesson;
}

inline Session tree_session_on(const TreeStage& stage, std::string_view volume) {
  auto session = Session::open(tree_lesson_on(stage, volume));
  REQUIRE_MESSAGE(session.has_value(), (session ? "" : session.error().message()));
  return *std::move(session);
}

/// The nodes of a forest, by the boxes below each.
inline std::set<std::vector<Index>> tree_nodes_of(const Forest& forest) {
  std::set<std::vector<Index>> all;
  for (const Index i : forest.there()) all.insert(forest.at(i).boxes);
  return all;
}

inline double tree_figure(const Session& session, std::string_view key) {
  for (const Figure& figure : session.telling().figures())
    if (figure.key == key && figure.known) return figure.value;
  return -1;
}

/// The queries with a result of their own: neither by hand nor of two trees.
inline std::vector<Method> plain_queries() {
  std::vector<Method> all(query_methods().begin(), query_methods().end());
  std::erase_if(all, [](const Method& method) { return method.by_hand || method.name == kTwoTrees; });
  return all;
}

}  // namespace snug::test
