// The votes of a class: how counts are typed, that none shows before it is revealed, and the second vote beside the
// first.
#include "lesson/vote.hpp"

#include <algorithm>

#include <doctest/doctest.h>

using snug::lesson::Vote;

namespace {

void type_keys(Vote& vote, std::string_view keys) {
  for (const char key : keys) vote.take_key(key == '\n' ? std::string_view("Enter") : std::string_view(&key, 1));
}

bool shows_digit(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

TEST_CASE("hands are counted in order, and no number shows before the vote is revealed") {
  Vote vote({"They overlap", "They are apart"}, {});
  CHECK(vote.hidden_text().empty());
  CHECK_FALSE(vote.take_key("b"));  // black, as long as nothing is typed
  type_keys(vote, "12\n31\n");
  CHECK(vote.told_text() == "First vote: A 12, B 31");
  CHECK(vote.hidden_text() == "First vote: A, B counted");
  CHECK(vote.row_text(vote.rows()[0]) == "A 12 (28 %)");
  CHECK(vote.row_text(vote.rows()[1]) == "B 31 (72 %)");
  for (const char* key : {"PageDown", ".", "Tab", "F5"}) CHECK_FALSE(vote.take_key(key));  // a clicker's are no vote's
}

TEST_CASE("a second vote is kept beside the first") {
  Vote vote({"Yes", "No", "Sometimes"}, {});
  type_keys(vote, "v20\n10\n0\n\nv4\nc 26\n");
  CHECK(vote.round() == 1);
  CHECK(vote.told_text() == "First vote: A 20, B 10, C 0. Second vote: A 4, C 26");
  CHECK(vote.row_text(vote.rows()[2]) == "C 0 (0 %), then 26 (87 %)");
  CHECK(vote.row_text(vote.rows()[1]) == "B 10 (33 %), then 0 (0 %)");
  CHECK_FALSE(shows_digit(vote.hidden_text()));
  CHECK(vote.take_key("Backspace"));  // the last count, and no earlier vote's
  CHECK(vote.told_text() == "First vote: A 20, B 10, C 0. Second vote: A 4");
  CHECK(vote.take_key("Backspace"));
  vote.take_key("Backspace");
  CHECK(vote.counted(0));
  CHECK_FALSE(vote.counted(1));
}

TEST_CASE("V begins the second vote while counts are typed, unless a place may be called so") {
  Vote vote({"Yes", "No"}, {});
  type_keys(vote, "v4\nv");  // of the first vote there is a count
  CHECK(vote.round() == 1);
  type_keys(vote, "6\n");
  CHECK(vote.told_text() == "First vote: A 4. Second vote: A 6");
  Vote places({}, {"V1", "V2"});
  type_keys(places, "v1 4\nv2 5\n");
  CHECK(places.round() == 0);
  CHECK(places.told_text() == "First vote: V1 4, V2 5");
}

TEST_CASE("places are counted by their names, or by their numbers where these are clear") {
  Vote vote({}, {"P3", "P9", "A1", "B1"});
  type_keys(vote, "9 12\np3 5\n1 4\n");
  CHECK(vote.told_text() == "First vote: P3 5, P9 12. There is no \"1\" to vote for");
  CHECK(vote.percent(vote.rows()[1], 0) == 71);
  type_keys(vote, "b1 4\n");
  CHECK(vote.told_text() == "First vote: P3 5, P9 12, B1 4");
  type_keys(vote, "7\n");
  CHECK(vote.told_text().ends_with("For which? Type its name, a space, and its hands"));
  vote.take_key("Escape");
  CHECK(vote.told_text() == "First vote: P3 5, P9 12, B1 4");
}

TEST_CASE("what has no choices is counted as it is typed; what is no count changes nothing") {
  Vote vote({}, {});
  type_keys(vote, "2.5 8\n99999\n3 x\n");
  CHECK(vote.rows().size() == 1);
  CHECK(vote.rows()[0].name == "2.5");
  CHECK(vote.told_text() == "First vote: 2.5 8. \"3 X\" has no number of hands");
}
