// A length along an axis has the same digits in the table, on the stage and in the sentence, and they show the gap.
#include <set>
#include <string>

#include "../../bench.hpp"
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

}  // namespace snug::app
