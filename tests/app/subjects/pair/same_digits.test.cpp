// A length along an axis has the same digits in the table, on the stage and in the sentence, and they show the gap.
#include <map>
#include <set>
#include <string>

#include "../../bench.hpp"
#include "../../course_lessons.hpp"
#include "../../viewed_lessons.hpp"
#include "app/look.hpp"

namespace snug::app {

TEST_CASE("the table and the stage have the same digits, none of them a minus on zero") {
  for (const char* gap : {"0.5", "0.997", "0.9997", "1", "1.0004"}) {
    CAPTURE(gap);
    Bench bench(test::boxes_apart(gap),
                {.stage = {0, 0, 800, 600}, .timeline = {0, 600, 800, 100}, .inspector = {800, 0, 280, 700}});
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.session().jump(2);  // along A's x
    bench.frames(2);
    std::set<std::string> on_stage, in_table;  // each is drawn more than once: on its halo
    for (const DrawnWords& one : drawn) (one.low.x < 800 ? on_stage : in_table).insert(one.words);
    int lengths = 0;
    for (const std::string& words : on_stage)
      for (const std::string_view kind : {"distance ", "separation ", "penetration "}) {
        if (!words.starts_with(kind)) continue;
        ++lengths;
        const std::string number = words.substr(kind.size());
        CHECK_MESSAGE(in_table.count(number) + in_table.count("−" + number) > 0, words);
      }
    CHECK(lengths == 2);
    for (const std::string& words : in_table)
      CHECK((!words.starts_with("−") || words.find_first_of("123456789") != std::string::npos));
  }
}

TEST_CASE("no figures of the table run into each other, however many digits they need") {
  for (const char* name : {"unit-of-length", "edge-touch", "parallel-noise"}) {
    CAPTURE(name);
    Bench bench(course_lesson(std::string("cases/") + name),
                {.stage = {0, 0, 800, 600}, .timeline = {0, 600, 800, 100}, .inspector = {800, 0, 270, 900}});
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.session().jump(bench.session().player().steps());
    bench.frames(2);
    std::map<float, std::map<float, DrawnWords>> rows;  // from the left
    for (const DrawnWords& one : drawn)
      if (one.low.x >= 800) rows[one.low.y][one.low.x] = one;
    int full = 0;
    for (const auto& [y, row] : rows) {
      full += row.size() >= 5;
      float end = 0;
      for (const auto& [x, one] : row) {
        CHECK_MESSAGE(x >= end, one.words);
        end = one.high.x;
      }
    }
    CHECK(full >= 10);
  }
}

}  // namespace snug::app
