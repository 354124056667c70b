#include "lesson/speaking.hpp"

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/prose.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open;
using snug::test::small_lesson_with;

namespace {

/// The small lesson, whose prose speaks.
std::string speaking_lesson() {
  std::string text = small_lesson_with(
      test::kSmallText,
      "The [pair](mark:pair_chosen) is [the support](mark:support), [P4](mark:P4) is outside; "
      "[Welzl](algorithm:welzl),\n"
      "[the bunny](mesh:bunny), [step 2](step:2), [spheres](lesson:sphere-ritter), $a \\\\le b$ and [brackets].");
  const auto at = text.find("title = \"First\"\n");
  text.insert(at, "facts = [\"pair_chosen\"]\n");
  text.insert(text.find("[[question]]"), R"([[section]]
title = "Growing"
algorithm = "ritter"
facts = ["ball_grown", "point_examined"]
text = "It **grows**."

)");
  return text;
}

void pass_question(Session& session) {
  REQUIRE(session.conversation().give({}, false));
  session.conversation().acknowledge();
}

}  // namespace

TEST_CASE("links and formulas of the prose are stretches of their own") {
  const auto lesson = check::checked_lesson(speaking_lesson(), "small.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  const Paragraph& first = *paragraphs_of(lesson->sections.at(0)).at(0);
  std::vector<std::string> links;
  for (const Stretch& stretch : first)
    if (stretch.link) links.push_back(stretch.text + " > " + stretch.link->target);
  CHECK(links == std::vector<std::string>{"pair > pair_chosen", "the support > support", "P4 > P4", "Welzl > welzl",
                                          "the bunny > bunny", "step 2 > 2", "spheres > sphere-ritter"});
  const auto formula = std::find_if(first.begin(), first.end(), [](const Stretch& one) { return !one.tex.empty(); });
  REQUIRE(formula != first.end());
  CHECK(formula->tex == "a \\le b");
  CHECK(formula->text == "a\u00a0≤\u00a0b");
  CHECK(first.back().text == " and [brackets].");
  CHECK(marks_of(*lesson) == std::vector<std::string_view>{"pair_chosen", "support", "P4"});
}

TEST_CASE("a mistake in the prose is told with its own line") {
  struct Case {
    const char *text, *says;
  };
  for (const Case& one : std::to_array<Case>({
           {"[a](mesh:teapot)", "links to a mesh that is none of bunny: teapot"},
           {"[a](algorithm:aabb_center)", "links to an algorithm that is none of ritter, welzl or brute_force"},
           {"[a](step:12)", "there is no step 12: the run has 11"},
           {"[a](mark:pair_chosen/3)", "the mark pair_chosen/3 lights nothing"},
           {"[a](mark:mean_found)", "the mark mean_found lights nothing"},
           {"[a](mark:pair_chosen/0)", "there is no mark pair_chosen/0"},
           {"[$a$](step:1)", "has a formula within a link"},
           {"Words and $$a$$.", "has a $$ formula among words"},
           {"$$a$", "has a $$ without a partner"},
           {"[a](step:two)", "links to a step that is not a number: two"},
           {"[a](mark:P99)", "there is no mark P99"},
           {"[a](mark:no_fact)", "there is no mark no_fact"},
           {"[a](place:x)", "has a link that leads nowhere, (place:x)"},
           {"[a](mesh:)", "has a link that leads nowhere, (mesh:)"},
           {"[**a**](step:1)", "has ** within a link"},
           {"$a", "has a $ without a partner"},
           {"$\\\\foo$", "has a formula that cannot be set, $\\foo$: \\foo is not known here"},
       })) {
    CAPTURE(one.text);
    const std::string text = small_lesson_with(test::kSmallText, one.text);
    const auto lesson = check::checked_lesson(text, "small.toml");
    REQUIRE_FALSE(lesson.has_value());
    CHECK_MESSAGE(lesson.error().what.find(one.says) != std::string::npos, lesson.error().what);
    const auto before = text.substr(0, text.find(one.text));
    CHECK(lesson.error().position == 1 + std::count(before.begin(), before.end(), '\n'));
  }
}

TEST_CASE("in a long text the line is that of the mistake, whatever the quotes") {
  for (const char* quotes : {"\"\"\"", "'''"}) {
    CAPTURE(quotes);
    std::string text =
        small_lesson_with("text = \"\"\"\nA **term** stands here\nover two lines.\n\nAnother paragraph.\n\"\"\"",
                          std::string("text = ") + quotes + "\n\nOne line.\nAnother [good](step:1).\n\n" +
                              "A third\nwith a [bad](mesh:cow) link.\nThe end.\n" + quotes);
    const auto lesson = check::checked_lesson(text, "small.toml");
    REQUIRE_FALSE(lesson.has_value());
    const auto before = text.substr(0, text.find("with a [bad]"));
    CHECK(lesson.error().position == 1 + std::count(before.begin(), before.end(), '\n'));
  }
}

TEST_CASE("brackets before a link are brackets, and TeX stays as it was written") {
  const auto lesson = check::checked_lesson(
      small_lesson_with(test::kSmallText,
                        "In [0, 1] the [pair](mark:pair_chosen).\n\n$$ r_A + r_B $$\n\nThe $r_A + r_B$."),
      "a.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  const auto paragraphs = paragraphs_of(lesson->sections.at(0));
  CHECK(paragraphs.at(0)->at(0).text == "In [0, 1] the ");
  CHECK(paragraphs.at(0)->at(1).text == "pair");
  REQUIRE(paragraphs.at(1)->size() == 1);
  CHECK(paragraphs.at(1)->at(0).tex == "r_A + r_B");
  CHECK(paragraphs.at(2)->at(1).tex == "r_A + r_B");
  CHECK(paragraphs.at(2)->at(1).text == "r_A\u00a0+\u00a0r_B");
}

TEST_CASE("a mark lights what the run has of it by now") {
  Session session = open(speaking_lesson());
  CHECK(marked_handles(session, "pair_chosen").empty());
  session.jump(1);
  pass_question(session);  // the question about the pair
  session.jump(2);
  pass_question(session);
  session.jump(5);
  CHECK(marked_handles(session, "pair_chosen") == std::vector<Index>{0, 1});
  CHECK(marked_handles(session, "pair_chosen/2") == std::vector<Index>{1});
  CHECK(marked_handles(session, "pair_chosen/3").empty());
  CHECK(marked_handles(session, "support") == session.player().support(0));
  CHECK(marked_handles(session, "P4") == std::vector<Index>{4});
  CHECK(marked_handles(session, "P77").empty());
  CHECK(marked_handles(session, "").empty());
  CHECK(marks_at(session, 4) == std::vector<std::string_view>{"P4"});
  CHECK(marks_at(session, 0) == std::vector<std::string_view>{"pair_chosen", "support"});
}

TEST_CASE("while a question is answered on the stage no mark gives the answer away") {
  Session session = open(speaking_lesson());
  session.jump(1);
  pass_question(session);
  session.jump(2);
  REQUIRE(session.conversation().asked() != nullptr);
  REQUIRE(session.conversation().asked()->on_stage);
  for (const auto mark : {"support", "pair_chosen", "P4"}) CHECK(marked_handles(session, mark).empty());
}

TEST_CASE("the section is the step's, and the question's while one is open") {
  Session session = open(speaking_lesson());
  CHECK_FALSE(section_at(session).has_value());
  session.jump(1);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(section_at(session) == 0);  // asked about the pair, before that step is done
  pass_question(session);
  session.jump(2);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(section_at(session) == 1);  // about the growth
  pass_question(session);
  session.jump(4);
  CHECK(section_at(session) == 1);
  REQUIRE(session.player().choose(0, "welzl"));
  session.jump(3);
  CHECK_FALSE(section_at(session).has_value());  // no section speaks of Welzl's steps
}
