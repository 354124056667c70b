#include "lesson/kept_answers.hpp"

#include <doctest/doctest.h>

#include "lesson/packed_rows.hpp"

using namespace snug::lesson;

namespace {

std::vector<Outcome> some() {
  Outcome right{.question = "pair"};
  right.given = OneHandle{7};
  right.from_step = 3, right.step = 9, right.right = true, right.tries = 2;
  right.predicted = "P7", right.happened = "P7", right.says = "P7 \"left\" \\ the\nset.", right.because = "Σ ≤ ε";
  Outcome skipped{.question = "grows"};
  skipped.skipped = skipped.passed = true;
  return {right, skipped};
}

}  // namespace

TEST_CASE("answers are kept as they were given") {
  Outcome pending{.question = "front"};
  pending.pending = true;
  auto given = some();
  given.push_back(pending);
  const std::vector<DoneTask> done{{.task = 0}, {.task = 2, .by = packed_rows({{0.1, -2}, {1e-300, 3}})}};
  const KeptAnswers kept = kept_answers_of(kept_text({given, done}));
  const std::vector<Outcome>& back = kept.outcomes;
  CHECK(kept.tasks == done);
  CHECK(kept_answers_of("tasks = [1]").tasks == std::vector<DoneTask>{{.task = 1}});  // an earlier version's
  REQUIRE(back.size() == 3);
  CHECK(back[2].question == "front");
  CHECK(back[2].pending);
  CHECK_FALSE(back[1].pending);
  CHECK(back[0].question == "pair");
  CHECK(back[0].given == given[0].given);
  CHECK(back[0].from_step == 3);
  CHECK(back[0].step == 9);
  CHECK(back[0].right);
  CHECK(back[0].tries == 2);
  CHECK_FALSE(back[0].skipped);
  CHECK(back[0].says == given[0].says);
  CHECK(back[0].because == given[0].because);
  CHECK(is_skipped(back[1].given));
  CHECK(back[1].skipped);
  CHECK(back[1].passed);
  CHECK(kept_text({}).empty());
  CHECK(kept_answers_of("").outcomes.empty());
}

TEST_CASE("of damaged answers none are taken up") {
  const std::string whole = kept_text({some(), {{.task = 1}}});
  for (std::size_t length = 1; length < whole.size(); ++length)
    CHECK(kept_answers_of(std::string_view(whole).substr(0, length)).outcomes.size() <= 2);
  CHECK(kept_answers_of("[[answer]]\nquestion = 7\n").outcomes.empty());
  CHECK(kept_answers_of("answer = 3").outcomes.empty());
  CHECK(kept_answers_of("{\"version\": 2}").outcomes.empty());
  CHECK(kept_answers_of(std::string(1000, '[')).outcomes.empty());
  CHECK(kept_answers_of(std::string(1 << 20, 'a')).outcomes.empty());
}
