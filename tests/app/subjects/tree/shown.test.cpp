// What the stage shows of a tree follows from the session's step, and gives no answer away.
#include "app/subjects/tree/shown.hpp"

#include <doctest/doctest.h>

namespace snug::app {
namespace {

lesson::Session tree_session(std::string_view volume, const std::string& method, const char* before, const char* asks,
                             int nth = 1) {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.volume = volume;
  auto tables = std::make_shared<lesson::TreeTables>();
  for (const double x : {-3.0, -2.6, -2.2, 2.0, 2.5}) tables->stage.boxes.push_back({{x, x * x / 4}, {0.15, 0.1}});
  if (lesson::is_query(volume)) tables->stage.query = lesson::QueryPlaces{{lesson::Point2(2, 0), lesson::Point2(3, 3)}};
  lesson.tables = std::move(tables);
  lesson.algorithms = {method};
  if (asks != nullptr) {
    lesson::Question& question = lesson.questions.emplace_back();
    question.id = "asked";
    question.gate = {method, before, nth, ""};
    question.asks = asks;
  }
  lesson::Session session = *lesson::Session::open(std::move(lesson));
  session.go(0);
  return session;
}

}  // namespace

TEST_CASE("a split's prices stay until its node is divided") {
  lesson::Session session = tree_session(lesson::kTreeBuild, "top_down_sah", "", nullptr);
  CHECK(tree_shown_at(session).priced == nullptr);
  CHECK(tree_shown_at(session).branch == kNoIndex);
  session.go(1);
  REQUIRE(tree_shown_at(session).priced != nullptr);
  CHECK(tree_shown_at(session).split == nullptr);
  CHECK(tree_shown_at(session).branch == 0);
  session.go(2);
  REQUIRE(tree_shown_at(session).split != nullptr);
  CHECK(tree_shown_at(session).priced != nullptr);
  CHECK(tree_shown_at(session).spoken_of == std::vector<Index>{0, 1, 2});
  session.go(3);
  CHECK(tree_shown_at(session).split == nullptr);
}

TEST_CASE("a question about a split shows the node, and neither the border nor the boxes") {
  lesson::Session session = tree_session(lesson::kTreeBuild, "top_down_sah", "split_chosen", "points");
  session.go(session.player().steps());
  REQUIRE(session.conversation().asked() != nullptr);
  const TreeShown shown = tree_shown_at(session);
  CHECK(shown.branch == 0);
  CHECK(shown.split == nullptr);
  CHECK(shown.spoken_of.empty());
}

TEST_CASE("a question about an insertion shows the box, and not where it goes") {
  lesson::Session session = tree_session(lesson::kTreeBuild, "insertion", "body_inserted", "beside", 3);
  session.go(session.player().steps());
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(tree_shown_at(session).incoming == 2);
  CHECK(tree_shown_at(session).branch == kNoIndex);
}

TEST_CASE("what a query leaves out is crossed where it was tested, and pale below") {
  lesson::Session session = tree_session(lesson::kTreeQuery, "point_query", "", nullptr);
  session.go(session.player().steps());
  const TreeShown shown = tree_shown_at(session);
  int crossed = 0, pale = 0;
  for (const Index i : shown.forest().there()) {
    const TreeInk ink = ink_of(kLight, shown, i);
    crossed += ink.crossed, pale += ink.pale;
    const Index parent = shown.forest().parent_of(i);
    if (ink.pale) CHECK((ink_of(kLight, shown, parent).crossed || ink_of(kLight, shown, parent).pale));
  }
  CHECK(crossed >= 1);
  CHECK(pale >= 4);
}

TEST_CASE(
    "of two trees, the nodes that are tested are inked on both sides, and a question shows them before the answer") {
  lesson::Session session = tree_session(lesson::kTreeQuery, std::string(lesson::kTwoTrees), "", nullptr);
  CHECK(tree_shown_at(session).partner == kNoIndex);
  session.go(1);
  const TreeShown roots = tree_shown_at(session);
  REQUIRE(roots.pairs() != nullptr);
  CHECK(roots.branch == 0);
  CHECK(roots.partner == 0);
  const bool apart = roots.pairs()->apart;
  for (const TreeSide side : {TreeSide::kOwn, TreeSide::kCopy}) CHECK(ink_of(kLight, roots, 0, side).crossed == apart);
  session.go(session.player().steps());
  const TreeShown end = tree_shown_at(session);
  CHECK(end.branch == kNoIndex);
  CHECK(end.partner == kNoIndex);
  for (const Index i : end.forest().there())
    for (const TreeSide side : {TreeSide::kOwn, TreeSide::kCopy}) CHECK_FALSE(ink_of(kLight, end, i, side).crossed);

  lesson::Session asked = tree_session(lesson::kTreeQuery, std::string(lesson::kTwoTrees), "pair_tested", "apart");
  REQUIRE(asked.conversation().asked() != nullptr);
  const TreeShown before = tree_shown_at(asked);
  CHECK(before.branch == 0);
  CHECK(before.partner == 0);
  for (const TreeSide side : {TreeSide::kOwn, TreeSide::kCopy})
    CHECK(ink_of(kLight, before, 0, side).line == kLight.examined);
}

}  // namespace snug::app
