#include "check/own_words.hpp"

#include <doctest/doctest.h>

#include <filesystem>

#include "core/lesson/lesson_files.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects.hpp"

using namespace snug;
using namespace snug::lesson;
using namespace snug::check;

TEST_CASE("words of one run are those that point at it, or count its things") {
  CHECK(words_of_one_run("These boxes overlap. Which row tells?") == "These boxes overlap");
  CHECK(words_of_one_run("In space, this sphere is near the edge.") == "this sphere is");
  CHECK(words_of_one_run("Do these small slender bodies touch?") == "these small slender bodies touch");
  CHECK(words_of_one_run("And on these eight points?") == "these eight");
  CHECK(words_of_one_run("There are 780 pairs of bodies.") == "780 pairs");
  CHECK(words_of_one_run("Of 1,000 points, one is left.") == "1,000 points");
  CHECK(words_of_one_run("It needed hundreds of swaps.") == "hundreds of");
}

TEST_CASE("words that are true of every run are not taken for such") {
  for (const char* fine :
       {"This is the first axis.", "Which row of this test is the first?", "None of these is tighter.",
        "This, too, is a sphere.", "These two meet in an edge.", "Of n points there are n (n − 1) / 2 pairs.",
        "Frame 60 begins. Which effects run?", "This test adds the radius.", "Three points support it."})
    CHECK_MESSAGE(words_of_one_run(fine).empty(), std::string(fine));
}

TEST_CASE("a question's words of one run are warned of, unless it is asked of the lesson's own run alone") {
  const auto warnings = [](const std::string& keys) {
    const std::string text =
        test::small_lesson_with("[[task]]", "[[question]]\nid = \"own\"\nalgorithm = \"welzl\"\nbefore = \"finished\"\n"
                                            "asks = \"choice\"\nchoices = [\"So\", \"Otherwise\"]\nanswer = \"So\"\n" +
                                                keys + "\n[[task]]");
    return test::warnings_of(text);
  };
  const std::string prompt = "prompt = \"These points lie on a line. Why?\"\n", because = "because = \"So.\"\n";
  CHECK(warnings(prompt + because + "holds = \"always\"") ==
        "small.toml:68:11: \"prompt\" says \"These points lie\", which a drag or other points may make false: "
        "\"prompt_here\" is for the lesson's own run\n");
  CHECK(warnings(prompt + because + "holds = \"here\"").empty());
  CHECK(
      warnings("prompt = \"Why?\"\nprompt_here = \"These points lie on a line. Why?\"\nholds = \"always\"\n" + because)
          .empty());
  CHECK(warnings("prompt = \"Why?\"\nholds = \"always\"\nbecause = \"So.\"\nwrong = { Otherwise = \"Of 99 points?\" }")
            .find("\"Otherwise\" says \"99 points\"") != std::string::npos);
}

TEST_CASE("no lesson says after a drag or a scatter what is true of its own run alone") {
  int seen = 0;
  std::string at;
  const auto check = [&](const std::string& text) {
    CHECK_MESSAGE(words_of_one_run(text).empty(), at, ": ", words_of_one_run(text));
    ++seen;
  };
  for (const auto& file : std::filesystem::directory_iterator(test::lessons_folder())) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".toml" || name == "course.toml") continue;
    const auto lesson = read_lesson(test::lessons_file(name), name);
    REQUIRE(lesson.has_value());
    if (lesson->subject->experiment != nullptr) continue;  // a chart's questions are asked of its own run alone
    for (const Question& question : lesson->questions) {
      if (question.holds == Holds::kHere) continue;
      at = lesson->id + ", " + question.id;
      check(question.prompt);
      check(question.because);
      for (const Meaning& meaning : question.meanings) check(meaning.says);
    }
  }
  CHECK(seen > 300);
}
