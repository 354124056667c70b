#include "check/draft_text.hpp"

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/prose.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::check;
using snug::test::small_lesson_with;

TEST_CASE("what is wrong with a draft stands in the order of its file, each with its place") {
  std::string text = small_lesson_with("title = \"Small\"", "titel = \"Small\"");
  text.replace(text.find("Another paragraph."), 18, "Look at P17.");
  text.replace(text.find("asks = \"grows\""), 14, "asks = \"grow\"");
  const Draft draft = checked_draft(text, "folder/small.toml");
  REQUIRE(draft.lesson);
  const DraftText says = text_of(draft, "small.toml");
  CHECK(says.heading == "small.toml: 2 mistakes and 2 warnings");
  REQUIRE(says.lines.size() == 4);
  CHECK(says.lines[0].text == "2:1: the lesson has no key \"titel\": did you mean \"title\"?");
  CHECK_FALSE(says.lines[0].warning);
  CHECK(says.lines[1].text.starts_with("21:9: warning: \"text\" speaks of P17"));
  CHECK(says.lines[1].warning);
  CHECK(says.lines[2].text.find("\"wrong\" has no reason for") != std::string::npos);
  CHECK(says.lines[2].warning);
  CHECK(says.lines[3].text.starts_with("45:8: "));
}

TEST_CASE("a lesson that could not be run is not drawn, and one is drawn without the links that lead nowhere") {
  const std::string far = small_lesson_with("[0, 2.5], [0.5", "[0, 1e200], [0.5");
  CHECK_FALSE(checked_draft(far, "small.toml").lesson);
  const Draft draft = checked_draft(small_lesson_with("over two lines", "over [two](step:two) lines"), "small.toml");
  CHECK(draft.mistakes.size() == 1);
  REQUIRE(draft.lesson);
  for (const Stretch* stretch : stretches_of(draft.lesson->sections[0])) CHECK_FALSE(stretch->link);
}

TEST_CASE("a file that cannot be drawn says so, and a sound one says nothing") {
  const DraftText says = text_of(checked_draft("version = = 1", "small.toml"), "small.toml");
  CHECK(says.heading == "small.toml: 1 mistake. It cannot be drawn like this.");
  const std::string reasons = "wrong = { P0 = \"No.\", P1 = \"No.\", P2 = \"No.\", P3 = \"No.\", P5 = \"No.\" }\n";
  const std::string sound = small_lesson_with("because = \"It lies outside.\"", reasons + "because = \"Yes.\"");
  CHECK(text_of(checked_draft(sound, "small.toml"), "small.toml").empty());
}
