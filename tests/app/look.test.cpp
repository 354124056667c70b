#include "app/look.hpp"

#include "bench.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {

TEST_CASE("a letter and up to three after an underscore are a name with a subscript, and no other underscore is") {
  CHECK(with_subscripts("r_A = 0.97") == std::vector<Letters>{{"r"}, {"A", true}, {" = 0.97"}});
  CHECK(with_subscripts("> r_A + r_B") == std::vector<Letters>{{"> r"}, {"A", true}, {" + r"}, {"B", true}});
  CHECK(with_subscripts("\u00a0r_B") == std::vector<Letters>{{"\u00a0r"}, {"B", true}});
  CHECK(with_subscripts("a_max < b_min") == std::vector<Letters>{{"a"}, {"max", true}, {" < b"}, {"min", true}});
  CHECK(with_subscripts("min_i = min_p n_i · p") ==
        std::vector<Letters>{{"min"}, {"i", true}, {" = min"}, {"p", true}, {" n"}, {"i", true}, {" · p"}});
  CHECK(with_subscripts("(p_k,i − μ_i)") == std::vector<Letters>{{"(p"}, {"k,i", true}, {" − μ"}, {"i", true}, {")"}});
  CHECK(with_subscripts("max(r_A, r_B)") == std::vector<Letters>{{"max(r"}, {"A", true}, {", r"}, {"B", true}, {")"}});
  CHECK(with_subscripts("r = ∑_i e_i") == std::vector<Letters>{{"r = ∑"}, {"i", true}, {" e"}, {"i", true}});
  for (const char* plain : {"distance", "min_max", "FILE_A", "x_axis", "_A", "r_", "a_b_c"})
    CHECK(with_subscripts(plain) == std::vector<Letters>{{plain}});
  CHECK(with_subscripts("").empty());
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

}  // namespace snug::app
