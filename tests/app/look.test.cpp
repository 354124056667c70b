#include "app/look.hpp"

#include "bench.hpp"
#include "course_lessons.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {

TEST_CASE("a letter and up to three after an underscore are a name with a subscript, a capital after a caret is "
          "raised, and no other sign is") {
  constexpr Script kLow = Script::kLowered, kHigh = Script::kRaised;
  CHECK(with_scripts("r_A = 0.97") == std::vector<Letters>{{"r"}, {"A", kLow}, {" = 0.97"}});
  CHECK(with_scripts("> r_A + r_B") == std::vector<Letters>{{"> r"}, {"A", kLow}, {" + r"}, {"B", kLow}});
  CHECK(with_scripts("\u00a0r_B") == std::vector<Letters>{{"\u00a0r"}, {"B", kLow}});
  CHECK(with_scripts("a_max < b_min") == std::vector<Letters>{{"a"}, {"max", kLow}, {" < b"}, {"min", kLow}});
  CHECK(with_scripts("min_i = min_p n_i · p") ==
        std::vector<Letters>{{"min"}, {"i", kLow}, {" = min"}, {"p", kLow}, {" n"}, {"i", kLow}, {" · p"}});
  CHECK(with_scripts("(p_k,i − μ_i)") == std::vector<Letters>{{"(p"}, {"k,i", kLow}, {" − μ"}, {"i", kLow}, {")"}});
  CHECK(with_scripts("max(r_A, r_B)") == std::vector<Letters>{{"max(r"}, {"A", kLow}, {", r"}, {"B", kLow}, {")"}});
  CHECK(with_scripts("r = ∑_i e_i") == std::vector<Letters>{{"r = ∑"}, {"i", kLow}, {" e"}, {"i", kLow}});
  CHECK(with_scripts("u_i^A · u_j^B") ==
        std::vector<Letters>{{"u"}, {"i", kLow}, {"A", kHigh}, {" · u"}, {"j", kLow}, {"B", kHigh}});
  CHECK(with_scripts("add (p − m)(p − m)^T to") == std::vector<Letters>{{"add (p − m)(p − m)"}, {"T", kHigh}, {" to"}});
  for (const char* plain : {"distance", "min_max", "FILE_A", "x_axis", "_A", "r_", "a_b_c", "2^n", "^T", "p^", "x^AB"})
    CHECK(with_scripts(plain) == std::vector<Letters>{{plain}});
  CHECK(with_scripts("").empty());
}

TEST_CASE("on the stage, a name with a subscript is as wide as its letters, without the underscore") {
  Bench bench(test::boxes_apart("0.5"));
  std::vector<DrawnWords> drawn;
  bench.app.note_words(&drawn);
  bench.session().jump(2);
  bench.frames(2);
  bench.app.note_words(nullptr);
  const auto label = [&](std::string_view begins) {
    for (const DrawnWords& words : drawn)
      if (words.words.starts_with(begins)) return words;
    FAIL("no label ", begins);
    return DrawnWords{};
  };
  const DrawnWords radius = label("r_A = "), distance = label("distance ");
  const auto per_letter = [](const DrawnWords& words, std::size_t letters) {
    return (words.high.x - words.low.x) / static_cast<float>(letters);
  };
  CHECK(per_letter(radius, radius.words.size()) < 0.9f * per_letter(distance, distance.words.size()));
}

TEST_CASE("the sign on a question's flag stays within it, however large the words of a lecture are") {
  Bench bench(course_lesson("sphere-ritter"));
  bench.app.settings().least_words = 40;
  std::vector<DrawnWords> drawn;
  bench.app.note_words(&drawn);
  bench.frames(2);
  bench.app.note_words(nullptr);
  CHECK_FALSE(drawn.empty());
  for (const DrawnWords& words : drawn)
    if (words.words == "?") CHECK(words.high.y - words.low.y <= 17);
}

}  // namespace snug::app
