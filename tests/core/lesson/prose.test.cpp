// The markup of the lessons' texts, its mistakes, and the figures of the run in them.
#include "lesson/prose.hpp"

#include <algorithm>

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/search.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open;
using snug::test::small_lesson_with;

namespace {

/// The stretches of a text without mistakes, a mark before each that has one.
std::string marked(std::string_view text) {
  std::vector<ProseFault> faults;
  std::string all;
  for (const Stretch& one : paragraph_of(text, faults)) {
    all += one.strong ? "S" : "";
    all += one.emphasis ? "E" : "";
    all += one.code ? "C" : "";
    all += one.script == Stretch::Script::kLow ? "_" : one.script == Stretch::Script::kHigh ? "^" : "";
    all += one.figure ? "{" + name_of(*one.figure) + "}" : "<" + one.text + ">";
  }
  for (const ProseFault& fault : faults) all += " fault: " + fault.what;
  return all;
}

/// The blocks of a text: a letter for the kind, and its cells.
std::string blocks(std::string_view text) {
  std::vector<ProseFault> faults;
  std::string all;
  for (const Block& block : blocks_of(text, faults)) {
    all += "PBNT"[static_cast<std::size_t>(block.kind)];
    for (const auto& row : block.rows) {
      all += "(";
      for (std::size_t i = 0; i < row.size(); ++i) all += (i > 0 ? "|" : "") + plain_text(row[i]);
      all += ")";
    }
    for (const bool right : block.right) all += right ? ">" : "<";
  }
  for (const ProseFault& fault : faults) all += " fault: " + fault.what;
  return all;
}

std::string now(const Session& session, std::string_view figure) {
  const auto named = figure_named(figure);
  REQUIRE(named);
  ProseFigures figures(session.conversation());
  const FigureNow& found = figures.of(*named);
  return found.text + (found.says.empty() ? "" : " " + std::string(found.says));
}

const std::string* figure_text(const std::vector<Figure>& figures, std::string_view key) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.key == key; });
  return found != figures.end() ? &found->text : nullptr;
}

/// As the inspector shows it, on one line.
std::string shown(const Session& session, std::string_view key) {
  const std::vector<Figure> figures = session.telling().figures();
  const std::string* text = figure_text(figures, key);
  REQUIRE(text != nullptr);
  std::string line = *text;
  for (auto at = line.find(' '); at != std::string::npos; at = line.find(' ')) line.replace(at, 1, "\u00a0");
  return line;
}

}  // namespace

TEST_CASE("words are emphasised, strong, code, low and high") {
  CHECK(marked("a *b* c") == "<a >E<b>< c>");
  CHECK(marked("a **b** and ***c***, *d **e***") == "<a >S<b>< and >SE<c><, >E<d >SE<e>");
  CHECK(marked("use `a * b_{c}` there") == "<use >C<a * b_{c}>< there>");
  CHECK(marked("x_{min}, n^{5}, 10^{-3}") == "<x>_<min><, n>^<5><, 10>^<−3>");
  CHECK(marked("*p*_{i}") == "E<p>_<i>");
  CHECK(marked("r_A ^ b_c, $x_{1}$") == "<r_A ^ b_c, ><x₁>");
  CHECK(marked("over\n  two   lines ") == "<over two lines>");
  CHECK(marked("2 \\* 3 \\{a\\} \\_\\{b\\} \\`c\\` \\$5 \\\\") == "<2 * 3 {a} _{b} `c` $5 \\>");
  CHECK(marked("") == "");
}

TEST_CASE("figures of the run have a key, an algorithm, or only their number") {
  CHECK(marked("now {radius}, {excess kdop/k8}, {count after_broad}") ==
        "<now >{radius}<, >{excess kdop/k8}<, >{count after_broad}");
  CHECK(marked("**{count\n radius  welzl}**") == "S{count radius welzl}");
  CHECK_FALSE(figure_named(""));
  CHECK_FALSE(figure_named("count "));
  CHECK_FALSE(figure_named("a b c"));
  CHECK_FALSE(figure_named("A"));
}

TEST_CASE("a text has paragraphs, lists and tables") {
  CHECK(blocks("One\nline.\n\nAnother.\n") == "P(One line.)P(Another.)");
  CHECK(blocks("Two:\n- one\n  goes on\n- *two*\n\nAfter.") == "P(Two:)B(one goes on)(two)P(After.)");
  CHECK(blocks("1. one\n2. two\n\n3. three") == "N(one)(two)(three)");
  CHECK(blocks("- a\n\n- b\n\n1. c\n\n1. d") == "B(a)(b)N(c)N(d)");
  CHECK(blocks("| a | b |\n|---|--:|\n| `|` | $|x|$ |\n| c \\| d | |") == "T(a|b)(|||x|)(c | d|)<>");
  CHECK(blocks("Words:\n| a | b |\n|---|---:|\n| 1 | 2 |\nMore.") == "P(Words:)T(a|b)(1|2)<>P(More.)");
  // A line within a paragraph or a formula may begin with a number, a sign, or a bar.
  CHECK(blocks("There were\n12. Then\nnone.") == "P(There were 12. Then none.)");
  CHECK(blocks("So $a\n- b\n| c$ is\n-1.") == "P(So a\u00a0−\u00a0b|c is -1.)");
  CHECK(blocks("-1 and 1.5") == "P(-1 and 1.5)");
}

TEST_CASE("each mistake of markup is told") {
  struct Case {
    const char *text, *says;
  };
  for (const Case& one : std::to_array<Case>({
           {"a *b", "has a * without a partner"},
           {"a **b", "has a ** without a partner"},
           {"a * b", "has a * beside a space"},
           {"a *b * c", "has a * beside a space"},
           {"a ** b **", "has a ** beside a space"},
           {"2*3*4", "has a * within a word"},
           {"a `b", "has a ` without a partner"},
           {"a `` b", "has `` without words between"},
           {"x_{i", "has a _{ without a }"},
           {"x^{}", "has an empty ^{}"},
           {"x _{i}", "has a _{ with nothing before it"},
           {"x_{*i*}", "has markup within _{}"},
           {"{radius", "has a { without a }"},
           {"{}", "has no figure of the run between { and }"},
           {"{a b c}", "has no figure of the run between { and }: a b c"},
           {"a } b", "has a } without a {"},
           {"a \\alpha", "has a \\ outside of a formula"},
           {"[a](step:1)", "has a link, which only a section's text can have"},
           {"$$a$$", "has a $$ formula, which can only be a paragraph"},
       })) {
    CAPTURE(one.text);
    const std::string found = marked(one.text);
    CHECK_MESSAGE(found.find(std::string("fault: ") + one.says) != std::string::npos, found);
  }
  for (const Case& one : std::to_array<Case>({
           {"- a\n  - b", "has a list within a list"},
           {"1. a\n3. b", "has a list whose numbers are not in order: here comes 2"},
           {"2. a", "has a list whose numbers are not in order: here comes 1"},
           {"- $$a$$", "has a $$ formula, which can only be a paragraph"},
           {"| a | b |\n|---|---|\n| 1 |", "has a row of 1 cell in a table whose head has 2"},
           {"| a | b |\n|---|\n| 1 | 2 |", "has a row of 1 cell in a table whose head has 2"},
           {"| a | b |\n|---|---|\n| 1 | 2", "has a row of a table that does not end with |"},
           {"| a | b |\n| 1 | 2 |", "has a table whose second line is not of dashes"},
           {"| a | b |\n|---|---|", "has a table without rows"},
           {"|\n|---|", "has a row of a table without cells"},
           {"[*a*](step:1)", "has * within a link: put it around the link"},
           {"[`a`](step:1)", "has markup within a link"},
       })) {
    CAPTURE(one.text);
    const std::string found = blocks(one.text);
    CHECK_MESSAGE(found.find(std::string("fault: ") + one.says) != std::string::npos, found);
  }
}

TEST_CASE("a mistake is told with its line and column, in prompts and hints too") {
  struct Case {
    const char *from, *to, *says;
  };
  for (const Case& one : std::to_array<Case>({
           {"over two lines.", "over *two lines.", "small.toml:19:6: \"text\" has a * without a partner"},
           {"over two lines.", "over two lines:\n- a\n- b `c", "small.toml:21:5: \"text\" has a ` without a partner"},
           {"over two lines.", "over {exces welzl} lines.",
            "small.toml:19:6: \"text\" shows a figure of welzl at its end that is none of "},
           {"over two lines.", "over {radius wezl} lines.",
            "small.toml:19:6: \"text\" shows a figure of an algorithm that is none of ritter, welzl or brute_force: "
            "wezl; "
            "did you mean welzl?"},
           {"over two lines.", "over {radiu} lines.", "small.toml:19:6: \"text\" shows a figure that is none of "},
           {"\"Which pair?\"", "\"Which *pair?\"", "small.toml:29:17: \"prompt\" has a * without a partner"},
           {"\"It lies outside.\"", "\"It lies {outsid} outside.\"",
            "small.toml:39:20: \"because\" shows a figure that is none of "},
           {"because = \"It lies outside.\"", "because = \"It does.\"\nwrong = {P0 = \"It *lies.\"}",
            "small.toml:40:19: \"wrong\" has a * without a partner"},
           {"\"Think.\"", "\"Think `twice.\"", "small.toml:65:15: \"hint\" has a ` without a partner"},
       })) {
    CAPTURE(one.to);
    const Draft draft = check::checked_draft(small_lesson_with(one.from, one.to), "small.toml");
    REQUIRE(draft.mistakes.size() == 1);
    const std::string message = draft.mistakes.front().message();
    CHECK_MESSAGE(message.substr(0, std::string_view(one.says).size()) == one.says, message);
  }
  const Draft near = check::checked_draft(small_lesson_with("over two lines.", "over {exces welzl}."), "small.toml");
  REQUIRE(near.mistakes.size() == 1);
  CHECK(near.mistakes.front().what.ends_with(": exces; did you mean excess?"));
}

TEST_CASE("a figure without an algorithm is that of the inspector; with one, its final result; both follow a drag") {
  Session session =
      open(small_lesson_with(test::kSmallText, "Now {radius}, in the end {radius welzl} and {count radius ritter}."));
  CHECK(session.lesson().figures.size() == 3);
  CHECK(now(session, "radius") == "… not known yet");
  while (session.conversation().asked() != nullptr || session.player().step() < session.player().steps()) {
    if (session.conversation().asked() != nullptr) REQUIRE(session.conversation().give({}, false));
    session.forward();
  }
  CHECK(now(session, "radius") == "2.250\u00a0units");
  CHECK(now(session, "radius") == shown(session, "radius"));
  CHECK(now(session, "radius welzl") == "2.050\u00a0units");
  CHECK(now(session, "count radius ritter") == "2.250");
  session.go(3);
  CHECK(now(session, "radius") == "2.000\u00a0units");
  CHECK(now(session, "radius ritter") == "2.250\u00a0units");
  REQUIRE(session.stage().move(4, {0, 1, 0}));  // now the two at the ends of the diameter are the outermost
  for (const char* name : {"radius", "radius ritter", "radius welzl"}) CHECK(now(session, name) == "2.000\u00a0units");
  session.stage().undo();
  CHECK(now(session, "radius welzl") == "2.050\u00a0units");
  CHECK(now(session, "outside") == shown(session, "outside"));
  CHECK(now(session, "count outside") == "1");
}

TEST_CASE("a sentence is left out while its figure has no value yet; a list and a table stay") {
  Session session =
      open(small_lesson_with(test::kSmallText, "One **term**. Now it is {radius}, no more. In the end {radius welzl}."
                                               "\n\n- {radius} so far\n\n| now |\n|---|\n| {radius} |\n"));
  const auto told = [&](const Block& block) {
    ProseFigures figures(session.conversation());
    const Paragraph& paragraph = block.rows.back().front();
    std::string text;
    for (const Stretch& one : paragraph)
      if (figures.tells(paragraph, one)) text += one.figure ? figures.of(*one.figure).text : one.text;
    return text;
  };
  const std::vector<Block>& blocks = session.lesson().sections.front().blocks;
  REQUIRE(blocks.size() >= 3);
  CHECK(told(blocks[0]) == "One term. In the end 2.050\u00a0units.");
  CHECK(told(blocks[1]) == "… so far");
  CHECK(told(blocks[2]) == "…");
  session.jump(3);
  CHECK(told(blocks[0]).starts_with("One term. Now it is 2.000\u00a0units, no more. In the end "));
}

TEST_CASE("a figure is hidden while a question asks for it, and results while they are to be predicted") {
  const std::string text = small_lesson_with("[[task]]", R"([[question]]
id = "how-large"
algorithm = "ritter"
before = "radius_checked"
after = "ball_grown"
asks = "figure"
figure = "radius"
bounds = [2.1]
prompt = "How large?"
because = "So large."

[[task]])");
  Session session = open(text.substr(0, text.find("[[question]]\nid = \"pair\"")) +
                         text.substr(text.find("[[question]]\nid = \"how-large\"")));
  CHECK(now(session, "radius") == "… hidden until you answer");
  CHECK(now(session, "radius ritter") == "… hidden until you answer");
  session.jump(8);
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(now(session, "radius") == "… hidden until you answer");
  CHECK(now(session, "excess welzl") == "… hidden until you answer");
  CHECK(now(session, "outside") == shown(session, "outside"));
  REQUIRE(session.conversation().give({}, false));
  CHECK(now(session, "radius") == "2.250\u00a0units");
  CHECK(now(session, "excess welzl") == "0.0\u00a0%");
}

TEST_CASE("an algorithm that cannot take the points has no figures") {
  Session session = open(small_lesson_with(test::kSmallText, "{radius brute_force}"));
  CHECK(now(session, "radius brute_force") == "2.050\u00a0units");
  REQUIRE(session.stage().set_generator("cube", 60, 2, 1));
  CHECK(now(session, "radius brute_force") == "… not for these points");
}

TEST_CASE("what a result has none of is not called unknown: it will not be known later either") {
  std::string text =
      small_lesson_with("over two lines.", "over {first_wrong welzl_naive} and {wrong_tests welzl_naive}.");
  text.replace(text.find("brute_force"), 11, "welzl_naive");
  Session session = open(text);
  CHECK(now(session, "wrong_tests welzl_naive") == "0");
  CHECK(now(session, "first_wrong welzl_naive") == "— none");
}

TEST_CASE("prompts are plain words where there is no markup, and a search finds no figures") {
  Session session = open(small_lesson_with("\"Which pair?\"", "\"Which *pair* of {count radius welzl}?\""));
  ProseFigures figures(session.conversation());
  CHECK(plain_now(session.conversation().questions().front().prompt, figures) == "Which pair of 2.050?");
  const Session strong = open(small_lesson_with(test::kSmallText, "**Bounds** and **{radius}**"));
  CHECK(search_text(strong.lesson(), 1, "", {}).find("…") == std::string::npos);
}
