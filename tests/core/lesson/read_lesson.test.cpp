#include <algorithm>

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/course.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects/cloud/cloud.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::kSmallLesson;
using snug::test::small_lesson_with;

namespace {

int line_of(std::string_view text, std::string_view marker) {
  const auto at = text.find(marker);
  REQUIRE(at != std::string_view::npos);
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// A stretch of the small lesson, what it becomes, where the error is to point, and words that it must have.
struct BrokenLesson {
  std::string_view from, to, marker, says;
};

constexpr BrokenLesson kBrokenLessons[] = {
    {"minutes = 3", "minutes = = 3", "minutes = =", ""},
    {"version = 2\n", "", "title", "lacks the key \"version\""},
    {"version = 2", "version = 3", "version", "reads 2"},
    {"version = 2", "version = \"1\"", "version", "whole number"},
    {"minutes = 3", "minutes = 3\ncolour = \"red\"", "colour", "no key \"colour\""},
    {"title = \"Small\"", "title = 7", "title = 7", "text in quotes"},
    {"title = \"Small\"", "title = \"  \"", "title = ", "is empty"},
    {"title = \"Small\"", "title = \"Small\"\ntitle = \"Smaller\"", "title = \"Smaller\"", ""},
    {"minutes = 3", "minutes = 0", "minutes = 0", "from 1 to 240"},
    {"minutes = 3\n", "", "version", "lacks the key \"minutes\""},
    {"seed = 5", "seed = -5", "seed = -5", "from 0"},
    {"covers = [\"A lecture: a slide\"]", "covers = [3]", "covers", "list of texts"},
    {"[\"ritter\", \"welzl\", \"brute_force\"]", "[]", "algorithms", "at least 1"},
    {"[\"ritter\", \"welzl\", \"brute_force\"]", "[\"ritter\", \"wezl\"]", "algorithms", "wezl"},
    {"[\"ritter\", \"welzl\", \"brute_force\"]", "[\"ritter\", \"welzl\", \"ritter\"]", "algorithms",
     "names ritter twice"},
    {"\"cube\", \"gaussian\"", "\"cube\", \"cube\"", "generators", "names cube twice"},
    {"meshes = [\"bunny\"]", "meshes = [\"cow\"]", "meshes", "bunny, teapot or dragon"},
    {"\"cube\", \"gaussian\"", "\"blob\"", "generators", "blob"},
    {"seed = 5", "seed = 5\nstart = \"middle\"", "start = \"middle\"", "begin or end"},
    {"seed = 5", "seed = 5\ncompare = \"pca\"", "compare", "does not offer"},
    {"seed = 5", "seed = 5\ncompare = \"ritter\"", "compare", "is the first algorithm itself"},
    {"after = \"pair_chosen\"", "after = \"radius_checked\"", "after = \"radius_checked\"",
     "does not come before this one"},
    {"after = \"pair_chosen\"", "after = \"point_examined\"\nafter_nth = 6", "after = \"point_examined\"",
     "does not come before this one"},
    {"over two lines", "over [two](mesh:cow) lines", "over [two]", "links to a mesh that is none of bunny"},
    {"figure = \"excess\"\nat_least = 5", "goal = \"wrong_in_float_alone\"\nat_least = 5", "goal", "stands alone"},
    {"Another paragraph.", "| a | b |\n| 1 | 2 |", "| 1 | 2 |", "second line is not of dashes"},
    {"Another paragraph.", "- one\n* two", "* two", "beside a space"},
    {"[points]", "[[beside]]\nis = \"wrong\"\nvolume = { sphere = { center = [0, 0], radius = 0 } }\n[points]",
     "is = ", "right, yours or given"},
    {"[points]", "[[beside]]\nis = \"right\"\n[points]", "[[beside]]", "lacks its \"volume\""},
    {"[points]", "[[beside]]\nis = \"right\"\nvolume = { sphere = { center = [0], radius = 0 } }\n[points]",
     "volume = ", "must be 2 numbers"},
    {"[points]", "[pionts]", "[pionts]", "no key \"pionts\": did you mean \"points\"?"},
    {"dim = 2", "dim = 4", "dim = 4", "from 2 to 3"},
    {"dim = 2", "dim = 2\ngenerate = \"cube\"\ncount = 4", "[points]", "exactly one"},
    {"list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]", "generate = \"cow\"\ncount = 6",
     "generate = \"cow\"", "cow"},
    {"[0, 2.5], [0.5", "[0, 2.5, 1], [0.5", "list = ", "2 finite numbers"},
    {"[0, 2.5], [0.5", "[0, nan], [0.5", "list = ", "2 finite numbers"},
    {"[0, 2.5], [0.5", "[0, 1e200], [0.5", "[points]", "too far out"},
    {"[0, 2.5], [0.5", "[0, 9007199254740993], [0.5", "list = ", "2 finite numbers"},  // no double is that number
    {"A **term** stands", "A **term stands", "A **term stands", "without a partner"},
    {"title = \"First\"\n", "", "[[section]]", "lacks the key \"title\""},
    {"id = \"growth\"", "id = \"pair\"", "id = \"pair\"\nalgorithm = \"ritter\"\nbefore = \"ball", "another question"},
    {"before = \"ball_grown\"", "before = \"ball_grew\"", "ball_grew", "ball_grew"},
    {"after = \"pair_chosen\"", "after = \"pair_picked\"", "pair_picked", "pair_picked"},
    {"after = \"pair_chosen\"", "nth = 2", "id = \"growth\"", "ball_grown 2 times"},
    {"after = \"pair_chosen\"", "nth = 0", "nth = 0", "from 1"},
    {"asks = \"axis\"", "asks = \"leaves\"", "id = \"pair\"", "support_replaced"},
    {"asks = \"axis\"", "asks = \"what\"", "asks = \"what\"", "none of point"},
    {"asks = \"grows\"", "asks = \"number\"\nfigure = \"points_touched\"\nwrong = { \"six\" = \"No.\" }", "wrong",
     "cannot be given: six"},
    {"asks = \"grows\"", "asks = \"better\"", "id = \"again\"", "pass_judged"},
    {"asks = \"grows\"", "asks = \"holds\"", "id = \"again\"", "finished"},
    {"answer = \"three\"", "answer = \"two\"", "answer = \"two\"", "none of one or three: two"},
    {"choices = [\"one\", \"three\"]", "choices = [\"three\"]", "choices", "at least 2"},
    {"choices = [\"one\", \"three\"]", "choices = [\"one\", \"three\", \"one\"]", "choices", "has one twice"},
    {"seed = 5", "seed = 5\nreference = \"sphere/wezl\"", "reference", "wezl; did you mean welzl?"},
    {"seed = 5", "seed = 5\nreference = \"spher/welzl\"", "reference", "spher; did you mean sphere?"},
    {"holds = \"here\"", "holds = \"there\"", "holds", "none of always or here: there; did you mean here?"},
    {"holds = \"here\"\n", "", "id = \"number\"", "a choice needs \"holds\""},
    {"holds = \"here\"\nwrong = { one = \"That one finds the extremes.\" }\nbecause = \"Extremes, growth, check.\"",
     "because = \"So.\"\n[[question.require]]\nfigure = \"excess\"\nat_most = 3", "figure = \"excess\"\nat_most",
     "9.8 %; it must be at most 3 %"},
    {"figure = \"excess\"\nat_least = 5", "figure = \"gap\"\nat_least = 5", "figure = \"gap\"",
     "is none of radius, excess"},
    {"wrong = { one = \"That one finds the extremes.\" }", "wrong = { \"two\" = \"No.\" }", "wrong",
     "cannot be given: two"},
    {"holds = \"here\"", "holds = \"here\"\nbecause_here = 3", "because_here", "a text in quotes"},
    {"holds = \"here\"", "holds = \"here\"\nprompt_here = \"\"", "prompt_here", "is empty"},
    {"because = \"All are inside.\"\n", "", "id = \"again\"", "lacks the key \"because\""},
    {"at_least = 5\n", "", "[[task.require]]", "needs \"at_least\", \"at_most\" or \"equals\""},
    {"at_least = 5", "at_least = 50", "model", "does not solve"},
    {"at_least = 5", "at_least = 5\nat_most = 4", "at_most", "leaves no number"},
    {"at_least = 5", "at_least = 5\nover = \"aabb/min_max\"", "[[task]]", "before the student begins"},
    {"figure = \"excess\"", "figure = \"exces\"", "figure = \"exces\"", "exces; did you mean excess?"},
    {"figure = \"excess\"\nat_least = 5", "goal = \"fail\"", "goal", "none of wrong_in_float_alone"},
    {"hint = \"Think.\"", "hint = \"Think.\"\nonly = [\"P9\"]", "only = ", "not there: P9; the last one is P5"},
    {"points = 4", "points = 6", "[[task]]", "before the student begins"},
    {"points = 4", "points = 7", "[[task]]", "more points than"},
    {"[[-2, 0], [2, 0], [0, -1], [0, 2.5]]", "[[-2, 0], [2, 0]]", "model", "There are 2 points"},
    {"[[task]]", "[pseudocode.ritter]\nlines = [\"one\"]\n[[task]]", "lines = [", "must be 6"},
    {"[[task]]", "[pseudocode.ritta]\nlines = [\"one\"]\n[[task]]", "[pseudocode.ritta]", "ritta"},
};

}  // namespace

TEST_CASE("a lesson file is read whole") {
  const auto lesson = check::checked_lesson(kSmallLesson, "folder/small.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  CHECK(lesson->id == "small");
  CHECK(lesson->minutes == 3);
  CHECK(lesson->seed == 5);
  CHECK(lesson->start == Lesson::Start::kBegin);
  CHECK(lesson->algorithms == std::vector<std::string>{"ritter", "welzl", "brute_force"});
  CHECK(lesson->generators == std::vector<std::string>{"cube", "gaussian"});
  REQUIRE(lesson->points.list.size() == 6);
  CHECK(lesson->points.list[4] == Vector<double, 3>(0, 2.5, 0));
  REQUIRE(lesson->questions.size() == 4);
  CHECK(lesson->questions[1].gate.after == "pair_chosen");
  CHECK(lesson->questions[3].answer == 1);
  REQUIRE(lesson->tasks.size() == 1);
  REQUIRE(lesson->tasks[0].conditions.size() == 1);
  CHECK(lesson->tasks[0].conditions[0].figure == "excess");
  CHECK(lesson->tasks[0].conditions[0].at_least == 5);
}

TEST_CASE("prose: paragraphs, joined lines and strong words") {
  const auto lesson = check::checked_lesson(kSmallLesson, "small.toml");
  REQUIRE(lesson.has_value());
  const auto paragraphs = paragraphs_of(lesson->sections.at(0));
  REQUIRE(paragraphs.size() == 2);
  const Paragraph& first = *paragraphs[0];
  REQUIRE(first.size() == 3);
  CHECK(first[0].text == "A ");
  CHECK(first[1].text == "term");
  CHECK(first[1].strong);
  CHECK(first[2].text == " stands here over two lines.");
  CHECK_FALSE(first[2].strong);
}

TEST_CASE("each mistake in a lesson file is told with its line") {
  for (const BrokenLesson& broken : kBrokenLessons) {
    CAPTURE(broken.to);
    const std::string text = small_lesson_with(broken.from, broken.to);
    const auto lesson = check::checked_lesson(text, "small.toml");
    REQUIRE_FALSE(lesson.has_value());
    CHECK(lesson.error().file == "small.toml");
    CHECK(lesson.error().unit == InputError::Unit::kLine);
    CHECK_MESSAGE(lesson.error().what.find(broken.says) != std::string::npos, lesson.error().what);
    const int line = line_of(text, broken.marker);
    const bool in_table =
        broken.marker.substr(0, 4) == "id =";  // a question is named by its [[question]], the line above
    CHECK_MESSAGE(lesson.error().position == line - (in_table ? 1 : 0), lesson.error().message());
    const std::vector<FileError> all = check::checked_draft(text, "small.toml").mistakes;
    CHECK_MESSAGE(all.size() == 1, all.back().message());  // what follows from a mistake is not told as another
  }
}

TEST_CASE("a case without a section is refused, and not read beyond that") {
  const std::string text = small_lesson_with("minutes = 3", "minutes = 3\nsource = \"A page. https://example.org\"");
  REQUIRE(check::checked_lesson(text, "small.toml").has_value());
  std::string bare = text;
  for (auto at = bare.find("[[section]]"); at != std::string::npos; at = bare.find("[[section]]"))
    bare.replace(at, 11, "[[sektion]]");
  const auto refused = check::checked_lesson(bare, "small.toml");
  REQUIRE_FALSE(refused.has_value());
  CHECK_MESSAGE(refused.error().what.find("section") != std::string::npos, refused.error().what);
}

TEST_CASE("all mistakes of a lesson file are told, in its order, each with line and column") {
  std::string text(kSmallLesson);
  const auto put = [&](std::string_view from, std::string_view to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  };
  put("title = \"Small\"", "titel = \"Small\"");
  put("minutes = 3", "minutes = 300");
  put("meshes = [\"bunny\"]", "meshes = [\"buny\"]");
  put("A **term** stands", "A **term stands");
  put("over two lines.", "over [two](algorithm:wezl) lines.");
  put("before = \"pair_chosen\"", "before = \"pair_chosn\"");
  put("id = \"growth\"", "id = \"growth\"\nnth = 2");
  put("asks = \"grows\"", "asks = \"grow\"");
  put("id = \"number\"", "id = \"growth\"");
  put("answer = \"three\"", "answer = \"two\"");
  put("at_least = 5", "at_least = 50");
  put("hint = \"Think.\"", "hint = \"Think.\"\nhints = 2");
  const Draft draft = check::checked_draft(text, "small.toml");
  std::vector<std::string> said;
  for (const FileError& mistake : draft.mistakes) said.push_back(mistake.message());
  const std::vector<std::string> due{
      "small.toml:2:1: the lesson has no key \"titel\": did you mean \"title\"?",
      "small.toml:4:11: \"minutes\" must be from 1 to 240",
      "small.toml:8:10: \"meshes\" is none of bunny, teapot or dragon: buny; did you mean bunny?",
      "small.toml:18:3: \"text\" has a ** without a partner",
      "small.toml:19:6: \"text\" links to an algorithm that is none of ritter, welzl or brute_force: wezl; did you "
      "mean "
      "welzl?",
      "small.toml:27:10: \"before\" of ritter is none of extremes_found, pair_chosen, point_examined, ball_grown, "
      "radius_checked or finished: pair_chosn; did you mean pair_chosen?",
      "small.toml:32:1: ritter does not take step ball_grown 2 times on these points",
      "small.toml:46:8: \"asks\" is none of point, points, choice, sequence, figure, number, tightest, tightest_order, "
      "cheapest, cheapest_order, next_outside or grows: grow; did you mean grows?",
      "small.toml:50:1: there is another question with the id growth, in line 32",
      "small.toml:57:10: \"answer\" is none of one or three: two",
      "small.toml:67:1: [[task]] has no key \"hints\": did you mean \"hint\"?",
      "small.toml:68:9: the model does not solve the task: Excess over the optimum: 9.8 %; it must be at least 50 %.",
  };
  INFO(said.back());
  REQUIRE(said.size() == due.size());
  for (std::size_t i = 0; i < due.size(); ++i) CHECK(said[i] == due[i]);
  REQUIRE(draft.lesson.has_value());  // what is sound of it can be looked at
  CHECK(draft.lesson->questions.empty());
}

TEST_CASE(
    "mistakes in the view, a slider or a situation hide no others, and one in a question hides none of its others") {
  std::string text(kSmallLesson);
  const auto put = [&](std::string_view from, std::string_view to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    text.replace(at, from.size(), to);
  };
  put("A **term** stands", "A [pair](mark:pair_chosn) stands");
  put("over two lines.", "with radius {radus ritter}.");
  put("before = \"pair_chosen\"", "before = \"pair_chosn\"");
  put("because = \"It is farther apart.\"", "reason = \"It is farther apart.\"");
  put("because = \"It lies outside.\"", "because = \"It lies outside.\"\nwrong = { P44 = \"No.\" }");
  put("asks = \"grows\"", "asks = \"number\"\ntolerance = 0.1\nfigure = \"radus\"");
  put("answer = \"three\"", "answer = \"tree\"");
  put("hint = \"Think.\"", "tip = \"Think.\"");
  put("at_least = 5", "at_least = 50");
  text += "[view]\nlook_at = \"P77\"\n[[slider]]\ntitle = \"Size\"\ndrives = \"scael\"\nfrom = 1\nto = 2\n"
          "[[situation]]\nname = \"more\"\ntitle = \"More\"\n[situation.points]\nlist = [[0, 0], [1, 1, 1]]\n";
  const std::pair<std::string_view, std::string_view> due[] = {
      {"A [pair]", "there is no mark pair_chosn: a mark is support, a step's name or a handle's name; did you mean "
                   "pair_chosen?"},
      {"with radius", "\"text\" shows a figure of ritter at its end that is none of radius"},
      {"before = \"pair_chosn", "\"before\" of ritter is none of"},
      {"reason = ", "[[question]] has no key \"reason\"; it lacks the key \"because\""},
      {"wrong = { P44", "cannot be given: P44; did you mean P4?"},
      {"figure = \"radus\"", "\"figure\" after radius_checked is none of radius"},
      {"answer = \"tree\"", "\"answer\" is none of one or three: tree; did you mean three?"},
      {"tip = ", "[[task]] has no key \"tip\"; it lacks the key \"hint\""},
      {"model = ", "the model does not solve the task"},
      {"look_at", "\"look_at\" names no handle: P77"},
      {"drives = ", "scael; did you mean scale?"},
      {"list = [[0, 0], [1", "must be a point of 2 finite numbers"}};
  const Draft draft = check::checked_draft(text, "small.toml");
  REQUIRE(draft.mistakes.size() == std::size(due));
  for (std::size_t i = 0; i < std::size(due); ++i) {
    CHECK(draft.mistakes[i].place.line == line_of(text, due[i].first));
    CHECK_MESSAGE(draft.mistakes[i].what.find(due[i].second) != std::string::npos, draft.mistakes[i].what);
  }
}

TEST_CASE("a misspelt algorithm is one mistake, and the lesson is checked with the one that is meant") {
  std::string text = small_lesson_with("[\"ritter\", \"welzl\", \"brute_force\"]", "[\"riter\"]");
  text.replace(text.find("asks = \"grows\""), 14, "asks = \"grow\"");
  const auto mistakes = check::checked_draft(text, "small.toml").mistakes;
  REQUIRE(mistakes.size() == 2);
  CHECK(mistakes[0].what.find("riter; did you mean ritter?") != std::string::npos);
  CHECK(mistakes[1].what.find("did you mean grows?") != std::string::npos);
}

TEST_CASE("unknown keys and missing ones are told in pairs, each in a line where there are more of one kind") {
  const auto said = [](std::string_view to) {
    std::string all;
    for (const FileError& mistake :
         check::checked_draft(small_lesson_with("prompt = \"Which pair?\"\nbecause = \"It is farther apart.\"", to),
                              "small.toml")
             .mistakes)
      all += mistake.message() + "\n";
    return all;
  };
  CHECK(said("text = \"Which?\"\nreason = \"So.\"") ==
        "small.toml:29:1: [[question]] has no key \"text\"; it lacks the key \"prompt\"\n"
        "small.toml:30:1: [[question]] has no key \"reason\"; it lacks the key \"because\"\n");
  CHECK(said("prompt = \"Which?\"\nbecause = \"So.\"\ncolour = \"red\"") ==
        "small.toml:31:1: [[question]] has no key \"colour\"\n");
  CHECK(said("") == "small.toml:24:1: [[question]] lacks the key \"prompt\"\n"
                    "small.toml:24:1: [[question]] lacks the key \"because\"\n");
}

TEST_CASE("what is allowed and probably not meant is warned of") {
  std::string words;
  for (int i = 0; i < 61; ++i) words += " word";
  const std::string text = small_lesson_with("Another paragraph.", "P99 is far, P4 is not." + words);
  const auto both = test::warned(text);
  REQUIRE(both.size() == 2);
  CHECK(both[0].message() == "small.toml:21:1: \"text\" speaks of P99, which is not there: the last one is P5");
  CHECK(both[1].message() == "small.toml:21:1: a paragraph has 67 words: beside a stage at most 60 are read");
  CHECK(test::warned(kSmallLesson).empty());
  const auto more = test::warned(small_lesson_with("prompt = \"Make it fail.\"", "prompt = \"Move P6 alone.\""));
  REQUIRE(more.size() == 1);
  CHECK(more[0].what == "\"prompt\" speaks of P6, which is not there: the last one is P5");
  const auto wrong = test::warned(
      small_lesson_with("because = \"It lies outside.\"", "because = \"So.\"\nwrong = { P2 = \"P8 is meant.\" }"));
  REQUIRE(wrong.size() == 1);
  CHECK(wrong[0].what == "\"wrong\" speaks of P8, which is not there: the last one is P5");
}

TEST_CASE("a wrong answer that nothing is said to is warned of") {
  const auto told = [](const std::string& text) {
    const Draft draft = check::checked_draft(text, "small.toml");
    REQUIRE_MESSAGE(draft.mistakes.empty(), draft.mistakes.front().message());
    std::string all;
    for (const FileError& warning : draft.warnings) all += warning.message() + '\n';
    return all;
  };
  const auto with_wrong = [](const std::string& wrong) {
    return small_lesson_with("because = \"It lies outside.\"", "because = \"So.\"\nwrong = { " + wrong + " }");
  };
  const auto asked = [&](const std::string& asks) {
    const std::string head = "[[question]]\nid = \"own\"\nalgorithm = \"welzl\"\nbefore = \"finished\"\nasks = ";
    return told(small_lesson_with("[[task]]", head + asks + "\nprompt = \"Which?\"\nbecause = \"So.\"\n[[task]]"));
  };
  const std::string handles = "small.toml:32:1: \"wrong\" has no reason for \"P0\", \"P1\", \"P2\", \"P3\", \"P5\"\n";
  const std::string own = "small.toml:61:1: \"wrong\" has no reason for ";
  SUBCASE("a choice of the file") {
    CHECK(told(small_lesson_with("wrong = { one = \"That one finds the extremes.\" }\n", "")) ==
          handles + "small.toml:49:1: \"wrong\" has no reason for \"one\"\n");
  }
  SUBCASE("handles: all that are wrong, and not the right ones") {
    CHECK(told(std::string(kSmallLesson)) == handles);
    CHECK(told(with_wrong("P0 = \"So.\", P1 = \"So.\", P2 = \"So.\", P5 = \"So.\"")) ==
          "small.toml:32:1: \"wrong\" has no reason for \"P3\"\n");
    CHECK(asked("\"points\"") == handles + own + "\"P2\", \"P3\", \"P5\"\n");
  }
  SUBCASE("choices that the run decides about") {
    CHECK(asked("\"holds\"\nwrong = { \"2\" = \"Too few.\" }") == handles + own + "\"1\"\n");
  }
  SUBCASE("none where the program has words, or where there is no second try") {
    CHECK(asked("\"figure\"\nfigure = \"radius\"\nbounds = [1, 9]") == handles);
    CHECK(asked("\"number\"\nfigure = \"radius\"\ntolerance = 0.1") == handles);
    CHECK(asked("\"tightest_order\"") == handles);
    CHECK(asked("\"grows\"") == handles);
  }
  SUBCASE("two of more than eight") {
    const auto of_many = [&](const std::string& wrong) {
      std::string text = with_wrong(wrong);
      const std::string_view last = "[0.5, 0.2]";
      text.insert(text.find(last) + last.size(), ", [0, 0], [0.1, 0], [0, 0.1], [0.1, 0.1]");
      return told(text);
    };
    CHECK(of_many("P0 = \"So.\", P3 = \"So.\"").empty());
    CHECK(of_many("P0 = \"So.\"").starts_with("small.toml:32:1: \"wrong\" has no reason for one more of \"P1\", "));
  }
}

TEST_CASE("a fixed answer that the run contradicts, or that a drag makes false, is warned of") {
  const auto warnings = [](const std::string& keys) {
    const std::string text = test::small_lesson_with(
        "[[task]]", "[[question]]\nid = \"own\"\nalgorithm = \"welzl\"\nbefore = \"finished\"\nasks = "
                    "\"choice\"\nbecause = \"So.\"\n" +
                        keys + "\n[[task]]");
    return test::warnings_of(text);
  };
  SUBCASE("handles") {
    const std::string about = "prompt = \"Which point supports it?\"\nchoices = [\"P4\", \"P2\"]\n";
    CHECK(warnings(about + "answer = \"P2\"\nholds = \"here\"") ==
          "small.toml:61:1: the run contradicts the answer \"P2\": it is P0, P1 and P4; asks = \"points\" works it out "
          "from the run\n");
    CHECK(
        warnings(about + "answer = \"P4\"\nholds = \"always\"") ==
        "small.toml:61:1: the answer \"P4\" is true only of the lesson's own stage, and needs holds = \"here\"; asks = "
        "\"points\" works it out from the run\n");
    CHECK(warnings(about + "answer = \"P4\"\nholds = \"here\"").empty());
  }
  SUBCASE("algorithms") {
    const std::string about = "prompt = \"Which is tightest?\"\nchoices = [\"Ritter\", \"Welzl\"]\n";
    CHECK(warnings(about + "answer = \"Ritter\"\nholds = \"here\"").find("contradicts the answer \"Ritter\"") !=
          std::string::npos);
    CHECK(warnings(about + "answer = \"Welzl\"\nholds = \"here\"").empty());
  }
  SUBCASE("algorithms by their names, and other words for the tightest") {
    const std::string about = "prompt = \"Which circle wins?\"\nchoices = [\"ritter\", \"the welzl\"]\n";
    CHECK(warnings(about + "answer = \"ritter\"\nholds = \"here\"").find("contradicts the answer \"ritter\"") !=
          std::string::npos);
    CHECK(warnings(about + "answer = \"the welzl\"\nholds = \"here\"").empty());
  }
  SUBCASE("what the step can be asked") {
    const std::string about = "prompt = \"Does the circle grow?\"\nchoices = [\"no\", \"yes\"]\n";
    CHECK(warnings(about + "answer = \"yes\"\nholds = \"here\"").find("it is no; asks = \"grows\"") !=
          std::string::npos);
    CHECK(warnings(about + "answer = \"no\"\nholds = \"here\"").empty());
    CHECK(warnings("prompt = \"Does any circle grow?\"\nchoices = [\"no\", \"yes\"]\nanswer = \"yes\"\nholds = "
                   "\"here\"")
              .empty());
  }
  SUBCASE("ranges of a figure") {
    const std::string about = "prompt = \"How large is the radius?\"\nchoices = [\"less than 2 units\", \"2 to 3 "
                              "units\", \"over 3 units\"]\n";
    CHECK(warnings(about + "answer = \"over 3 units\"\nholds = \"here\"").find("it is 2.05") != std::string::npos);
    CHECK(warnings(about + "answer = \"2 to 3 units\"\nholds = \"here\"").empty());
  }
  SUBCASE("a figure") {
    const std::string about = "prompt = \"What is the radius?\"\nchoices = [\"2.25 units\", \"2.05 units\"]\n";
    CHECK(warnings(about + "answer = \"2.25 units\"\nholds = \"here\"").find("it is 2.05") != std::string::npos);
    CHECK(warnings(about + "answer = \"2.05 units\"\nholds = \"here\"").empty());
  }
  SUBCASE("what the run knows nothing of") {
    CHECK(
        warnings("prompt = \"How?\"\nchoices = [\"So\", \"Otherwise\"]\nanswer = \"So\"\nholds = \"always\"").empty());
  }
}

TEST_CASE("a figure of the run in the prose is warned of, and one that is asked of the run is not") {
  const auto draft = test::warned(test::small_lesson_with("Another paragraph.", "Ritter's circle has radius 2.25."));
  REQUIRE(draft.size() == 1);
  CHECK(draft[0].message() == "small.toml:21:28: \"text\" has 2.25, a figure of the run: {radius ritter} stays "
                              "true when the student drags");
  for (const char* fine :
       {"It has radius {radius ritter}.", "It takes 6 points.", "$r = 2.25$ and `2.25`.", "It is 2.26."})
    CHECK(test::warned(test::small_lesson_with("Another paragraph.", fine)).empty());
}

TEST_CASE("a figure of the run in a question is warned of, unless its words are for the lesson's own run") {
  const auto warnings = [](std::string_view to) {
    return test::warned(small_lesson_with("because = \"It lies outside.\"", to));
  };
  const auto told = warnings("because = \"The radius is 2.25 in the end.\"");
  REQUIRE(told.size() == 1);
  CHECK(told[0].what == "\"because\" has 2.25, a figure of the run: {radius ritter} stays true when the student drags");
  CHECK(warnings("because = \"So.\"\nbecause_here = \"The radius is 2.25 in the end.\"").empty());
}

TEST_CASE("a fixed answer that the run contradicts makes a played lesson unsound") {
  const std::string text = small_lesson_with(
      "[[task]]", "[[question]]\nid = \"own\"\nalgorithm = \"welzl\"\nbefore = \"finished\"\nasks = \"choice\"\n"
                  "prompt = \"Which point supports it?\"\nchoices = [\"P4\", \"P2\"]\nanswer = \"P2\"\nholds = "
                  "\"here\"\nbecause = \"So.\"\n[[task]]");
  Session session = test::open(text);
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  REQUIRE(played->false_keys.size() == 1);
  CHECK(played->false_keys[0].question == "own");
  CHECK(played->false_keys[0].answer == "P2");
  CHECK(played->false_keys[0].is == "P0, P1 and P4");
  CHECK_FALSE(played->sound());
}

TEST_CASE("no bytes make the reader fail otherwise than by an error") {
  for (const std::string_view text : {std::string_view(""), std::string_view("\0\0", 2), std::string_view("\xff\xfe"),
                                      std::string_view("[["), std::string_view("[[["), std::string_view("[[a]]\n[[="),
                                      std::string_view("a = 1"), std::string_view("version = 2")}) {
    const auto lesson = check::checked_lesson(text, "x.toml");
    REQUIRE_FALSE(lesson.has_value());
    CHECK(lesson.error().position >= 1);
  }
  std::string tables = "a";
  for (int level = 0; level < 1000000; ++level) tables += ".a";
  const auto deep = check::checked_lesson(tables + " = 1\n", "x.toml");
  REQUIRE_FALSE(deep.has_value());
  CHECK(deep.error().what.find("a lesson has at most 262144 bytes") != std::string::npos);
  // Cut short before its prose is whole, a file is no lesson, wherever it is cut.
  const std::size_t prose_ends = kSmallLesson.find("Another paragraph");
  for (std::size_t length = 0; length < prose_ends; ++length) {
    const auto lesson = check::checked_lesson(kSmallLesson.substr(0, length), "x.toml");
    REQUIRE_FALSE(lesson.has_value());
    CHECK(lesson.error().unit == InputError::Unit::kLine);
  }
}

TEST_CASE("a key of more dots than a file needs is refused before it is read") {
  std::string dots;
  for (int i = 0; i < 100'000; ++i) dots += ".a";
  for (const std::string& deep : {"a" + dots + " = 1\n", "[a" + dots + "]\n", "x = {a" + dots + " = 1}\n"}) {
    const Draft draft = read_draft("# A comment.\nversion = 2\n" + deep, "a.toml");
    REQUIRE(!draft.mistakes.empty());
    CHECK(draft.mistakes.front().place.line == 3);
    CHECK(draft.mistakes.front().what == "a key has more than 64 dots");
    const auto course = read_course(deep, "course.toml", std::vector<std::string>{"a"});
    REQUIRE(!course);
    CHECK(course.error().what == "a key has more than 64 dots");
    CHECK(kept_answers_of(deep).outcomes.empty());
  }
  // Dots in texts and comments are none of a key's.
  std::string dotted(kSmallLesson);
  const std::string many(200, '.');
  dotted = "# " + many + "\n" + dotted;
  for (const std::string& text :
       {"\"" + many + "\\\"" + many + "\"", "'" + many + "'", "\"\"\"\n" + many + "\"" + many + "\n\"\"\""}) {
    std::string lesson = dotted;
    const std::string_view summary = "summary = ";
    const std::size_t at = lesson.find(summary) + summary.size();
    lesson.replace(at, lesson.find('\n', at) - at, text);
    CHECK(read_draft(lesson, "a.toml").mistakes.empty());
  }
}

TEST_CASE("a lesson's own pseudocode stands in for the catalogue's, line for line") {
  auto session = test::open(small_lesson_with(
      "[[task]]", "[pseudocode.ritter]\nlines = [\"a\", \"b\", \"c\", \"d\", \"e\", \"f\"]\n[[task]]"));
  REQUIRE(session.player().pseudocode(0).size() == 6);
  CHECK(session.player().pseudocode(0)[2] == "c");
  REQUIRE(session.player().choose(0, "welzl").has_value());
  CHECK(session.player().pseudocode(0).size() == session.player().method(0)->pseudocode.size());
  CHECK(session.player().pseudocode(0)[0] == session.player().method(0)->pseudocode[0]);
}
