// Exercises: their instances, what a sitting takes and marks, and the attempt that is written and replayed.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "core/lesson/lesson_files.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/exercise/sets.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/names.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/update/update.hpp"
#include "number/fnv.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

using Shared = std::shared_ptr<const Exercise>;

Shared exercise_from(const std::string& text, const std::string& id = "test") {
  ExerciseDraft draft = read_exercise(text, id + ".toml");
  for (const FileError& mistake : draft.mistakes) FAIL(mistake.message());
  return std::make_shared<const Exercise>(std::move(draft.exercise));
}

Shared exercise_of(const std::string& id) { return exercise_from(test::lessons_file("exercises/" + id + ".toml"), id); }

std::vector<ExerciseSet> sets() {
  const std::string text = test::lessons_file("exercises/sets.toml");
  std::set<std::string> ids;  // whatever the file names: whether it exists is seen where it is read
  for (std::size_t at = 0; (at = text.find('"', at)) != std::string::npos;) {
    const std::size_t end = text.find('"', at + 1);
    ids.insert(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  const std::vector<std::string> known(ids.begin(), ids.end());
  const auto read = read_sets(text, "sets.toml", known);
  REQUIRE_MESSAGE(read, (read ? "" : read.error().message()));
  return *read;
}

std::vector<std::string> exercise_ids() {
  std::vector<std::string> ids;
  for (const auto& file : std::filesystem::directory_iterator(test::lessons_folder() + "exercises"))
    if (file.path().stem() != "sets") ids.push_back(file.path().stem().string());
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Each exercise at each of its levels.
struct AtLevel {
  std::string id;
  int level = 0;
};
std::vector<AtLevel> levels() {
  std::vector<AtLevel> all;
  for (const std::string& id : exercise_ids())
    for (int level = 0; level <= static_cast<int>(exercise_of(id)->harder.size()); ++level) all.push_back({id, level});
  return all;
}

/// A sitting at an instance.
struct Sat {
  explicit Sat(Shared exercise, std::uint64_t seed = 1, bool practises = false)
      : session(*open_instance(*exercise, *make_instance(*exercise, seed), nullptr, practises)),
        sitting(exercise, seed, session, practises) {}
  Session session;
  Sitting sitting;
  [[nodiscard]] const Asked& asked() const { return *session.conversation().asked(); }
  [[nodiscard]] Answer right() const { return model_answer(asked(), session.player().run(0)); }
  void decide() { REQUIRE(session.conversation().give(right(), false)); }
  void decide_all() {
    while (!sitting.finished(session)) decide();
  }
};

std::string ritter_with(const std::string& from, const std::string& to) {
  std::string text = test::lessons_file("exercises/be-ritter.toml");
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a set has ten exercises, of several kinds") {
  const std::vector<std::string> ids = exercise_ids();
  constexpr std::string_view kWritten = "write:";
  for (const ExerciseSet& set : sets()) {
    CHECK(set.exercises.size() == 10);
    std::set<std::string_view> kinds;
    for (const std::string& id : set.exercises) {
      CAPTURE(id);
      if (id.starts_with(kWritten)) {
        CHECK_FALSE(test::lessons_file("write/" + id.substr(kWritten.size()) + ".toml").empty());
        continue;
      }
      CHECK(is_among(ids, id));
      kinds.insert(exercise_of(id)->kind());
    }
    CHECK(kinds.size() > 1);
  }
}

TEST_CASE("every exercise keeps its promise at each level, and right decisions earn every mark") {
  for (const AtLevel& at : levels()) {
    CAPTURE(at.id);
    CAPTURE(at.level);
    const Shared exercise = std::make_shared<const Exercise>(at_level(*exercise_of(at.id), at.level));
    if (exercise->build) continue;
    CHECK_NOTHROW(static_cast<void>(test::lesson_of(exercise->lesson)));
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(seed);
      Sat sat(exercise, seed);
      const auto decisions = static_cast<int>(sat.session.conversation().questions().size());
      CHECK(decisions >= exercise->least);
      CHECK(decisions <= exercise->most);
      for (const Asked& asked : sat.session.conversation().questions())
        CHECK((asked.kind->margin(asked, sat.session.player().run(0)) >= exercise->apart ||
               (exercise->ties && has_tie(asked, sat.session.player().run(0)))));
      sat.decide_all();
      CHECK(sat.sitting.mark(sat.session) == decisions);
      const auto graded = grade(exercise, sat.sitting.attempt(sat.session));
      REQUIRE(graded);
      CHECK(graded->mark == decisions);
    }
  }
}

TEST_CASE("a wrong rule is wrong somewhere, and named where it was followed") {
  for (const AtLevel& at : levels()) {
    CAPTURE(at.id);
    CAPTURE(at.level);
    const Shared exercise = std::make_shared<const Exercise>(at_level(*exercise_of(at.id), at.level));
    for (std::size_t kind = 0; kind < exercise->decisions.size(); ++kind)
      for (const RuleWords& words : exercise->decisions[kind].rules) {
        CAPTURE(words.name);
        Sat sat(exercise, 7, !exercise->told_at_once);  // who practises is told each at once
        bool named = false;
        while (!sat.sitting.finished(sat.session) && !named) {
          const Asked& asked = sat.asked();
          const WrongRule* rule =
              decision_of(*exercise, *asked.question) == kind ? find_rule(asked, words.name) : nullptr;
          const auto answer = rule != nullptr ? rule->decides(asked, sat.session.player().run(0)) : std::nullopt;
          if (!answer || judge(asked, *answer, sat.session.player().run(0)).right) {
            sat.decide();
            continue;
          }
          REQUIRE(sat.session.conversation().give(*answer, false));
          named = !sat.sitting.rule_says(sat.session).empty();
          CHECK(named);
        }
        CHECK(named);
      }
  }
}

TEST_CASE("the instance of a seed is the same everywhere, and no other exercise's") {
  const auto instance = make_instance(*exercise_of("be-ritter"), 17);
  REQUIRE(instance);
  CHECK(make_instance(*exercise_of("be-ritter"), 17)->own == instance->own);
  CHECK(make_instance(*exercise_of("be-ritter"), 18)->own != instance->own);
  CHECK(make_instance(*exercise_of("be-aabb-centre"), 17)->own != instance->own);
  CHECK(seed_of("Ada Lovelace") == seed_of("ada lovelace"));
  CHECK(seed_of("Ada") != seed_of("Ade"));
}

TEST_CASE("a second try earns a half, each hint a quarter less, and one that tells it nothing") {
  Sat sat(exercise_of("fit-a-kdop"));
  const Answer wrong = SeveralHandles{{0}};
  REQUIRE(sat.session.conversation().give(wrong, false));
  CHECK(sat.sitting.mark(sat.session) == 0);
  CHECK(sat.session.conversation().tried() != nullptr);
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 0.5);
  CHECK(sat.sitting.next_price(sat.session) == 0.25);
  REQUIRE(sat.sitting.take_hint(sat.session));
  CHECK(sat.sitting.hints(sat.session).size() == 1);
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 1.25);
  for (int hint = 0; hint < kMostHints; ++hint) REQUIRE(sat.sitting.take_hint(sat.session));
  CHECK_FALSE(sat.sitting.take_hint(sat.session));
  CHECK(sat.sitting.hints(sat.session).back() ==
        "The answer: " + sat.asked().kind->truth(sat.asked(), sat.session.player().run(0)).happened + ".");
  sat.decide();
  CHECK(sat.sitting.mark(sat.session) == 1.25);
  CHECK(sat.sitting.attempt(sat.session).made[2].hints == kMostHints);
}

TEST_CASE("after two wrong answers the right step is shown, and the run goes on from it") {
  Sat sat(exercise_of("be-quickhull"));
  const Index right = std::get<OneHandle>(sat.right()).handle;
  for (const Index i : sat.session.conversation().targets())
    if (i != right && sat.session.conversation().outcome() == nullptr)
      REQUIRE(sat.session.conversation().give(OneHandle{i}, false));
  REQUIRE(sat.session.conversation().outcome() != nullptr);
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.conversation().outcome()->right);
  CHECK(sat.session.player().step() == sat.session.conversation().outcome()->step);
  REQUIRE(sat.session.conversation().acknowledge());
  CHECK(sat.sitting.at(sat.session) == 1);
  sat.decide_all();
  CHECK(sat.sitting.mark(sat.session) == sat.sitting.of() - 1);
}

TEST_CASE("a tap decides, a key only chooses, nothing can be skipped, and the stage stays as it is") {
  Sat sat(exercise_of("be-quickhull"));
  const Answer right = sat.right();
  const Rows rows = sat.session.stage().subject().rows();
  REQUIRE(sat.session.conversation().pick(right, false));
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.conversation().give({}, false));
  CHECK(sat.session.conversation().pass_by());
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.stage().move(0, Point3(1, 1, 0)));
  CHECK_FALSE(sat.session.stage().may_move(0));
  CHECK_FALSE(sat.session.stage().scatter(99));
  CHECK_FALSE(sat.session.stage().reset());
  sat.session.stage().begin_drag();
  CHECK_FALSE(sat.session.stage().set_sliders(sat.session.stage().slider_values()));
  CHECK(sat.session.stage().end_drag());
  CHECK_FALSE(sat.session.stage().can_undo());
  CHECK(sat.session.stage().subject().rows() == rows);
  REQUIRE(sat.session.conversation().pick(right));
  CHECK(sat.sitting.at(sat.session) == 1);
}

TEST_CASE("before the first decision is made, nobody is asked to take a step") {
  Sat sat(exercise_of("be-ritter"));
  REQUIRE(sat.session.conversation().asked() != nullptr);
  REQUIRE(sat.session.player().step() == 0);
  CHECK(sat.session.telling().caption().ends_with(": nothing is known yet."));
}

TEST_CASE("where all is told at the end, a decision can be taken back, and nothing is told before") {
  Sat sat(
      exercise_from(ritter_with("lesson = \"sphere-ritter\"", "lesson = \"sphere-ritter\"\ntold = \"at the end\"")));
  const Answer none = SeveralHandles{{0}};
  REQUIRE(sat.session.conversation().give(none, false));
  CHECK(sat.session.conversation().tried() == nullptr);
  CHECK(sat.session.conversation().outcome() == nullptr);
  CHECK(sat.sitting.at(sat.session) == 1);
  CHECK(sat.sitting.rule_says(sat.session).empty());
  CHECK(sat.sitting.marked(sat.session)[0].standing == AnswerState::kOpen);
  REQUIRE(sat.session.conversation().take_back());
  CHECK(sat.sitting.at(sat.session) == 0);
  CHECK_FALSE(sat.session.conversation().take_back());
  sat.decide_all();
  CHECK(sat.sitting.mark(sat.session) == sat.sitting.of());
  CHECK(sat.sitting.marked(sat.session)[0].standing == AnswerState::kRight);
}

TEST_CASE("an attempt is written, read and replayed to the same mark") {
  const Shared exercise = exercise_of("p-and-n-vertex");
  Sat sat(exercise, 5);
  sat.sitting.take_hint(sat.session);
  sat.decide();
  const bool first = sat.right() == Answer(OneChoice{0});
  REQUIRE(sat.session.conversation().give(OneChoice{first ? 1 : 0}, false));
  sat.decide();
  Attempt attempt = sat.sitting.attempt(sat.session);
  CHECK(attempt.made.size() == 2);
  for (Made& made : attempt.made) {
    const auto again = made_of(text_of(made));
    REQUIRE(again);
    CHECK(again->hints == made.hints);
    CHECK(again->tries == made.tries);
    made = *again;
  }
  const auto graded = grade(exercise, attempt);
  REQUIRE(graded);
  CHECK(graded->mark == sat.sitting.mark(sat.session));
  CHECK(graded->decided == 2);
  Sat later(exercise, 5);
  REQUIRE(later.sitting.take_up(later.session, attempt));
  CHECK(later.sitting.at(later.session) == 2);
  attempt.made.push_back({0, {OneHandle{4000}}, {}, 1});
  CHECK_FALSE(grade(exercise, attempt));
}

// Native and WebAssembly print the same (tests/trace_hash.sh): what is decided, and what mark the replay gives it.
TEST_CASE("the marks of every exercise, right and wrong" * doctest::skip()) {
  for (const AtLevel& at : levels()) {
    CAPTURE(at.id);
    CAPTURE(at.level);
    const Exercise exercise = at_level(*exercise_of(at.id), at.level);
    const Shared own = exercise_of(at.id);
    for (const int wrong : {0, 1}) {
      const auto attempt = model_attempt(exercise, 3, wrong, "");
      REQUIRE(attempt);
      Fnv1a hash;
      for (const Made& made : attempt->made)
        for (const char c : text_of(made)) hash.add_bits(static_cast<unsigned char>(c));
      const auto graded = grade(own, *attempt);
      REQUIRE(graded);
      if (!exercise.build) CHECK(graded->mark == graded->of - wrong);
      std::printf("marks %s %d %d %g of %d %016llx\n", at.id.c_str(), at.level, wrong, graded->mark, graded->of,
                  static_cast<unsigned long long>(hash.value()));
    }
  }
}

TEST_CASE("when it is over, the student's run is gone through with what was right, and the right one step by step") {
  using Looked = Sitting::Looked;
  Sat sat(exercise_of("be-quickhull"));
  Session& session = sat.session;
  const std::string right = session.stage().subject().name_of(std::get<OneHandle>(sat.right()).handle);
  sat.decide();
  CHECK_FALSE(sat.sitting.change_run(session));
  const Asked& second = sat.asked();
  std::string last;
  for (const Index i : session.conversation().targets())
    if (session.conversation().outcome() == nullptr && !judge(second, OneHandle{i}, session.player().run(0)).right) {
      REQUIRE(session.conversation().give(OneHandle{i}, false));
      last = session.stage().subject().name_of(i);
    }
  REQUIRE(session.conversation().acknowledge());
  CHECK(sat.sitting.first_difference(session).empty());
  sat.decide_all();
  CHECK(sat.sitting.looks_at(session) == Looked::kNeither);
  const std::string both = "yours: " + last + "; right: " + session.conversation().outcome_of(second)->happened;
  CHECK(sat.sitting.first_difference(session) == "Your run first differs from the right one at decision 2 (" + both +
                                                     "). After a mistake, it goes on from the right step.");
  const double mark = sat.sitting.mark(session);

  REQUIRE(sat.sitting.change_run(session));  // to where they differ, as it was decided
  CHECK(sat.sitting.looks_at(session) == Looked::kOwn);
  CHECK(sat.sitting.finished(session));
  CHECK(session.player().step() == second.step);
  CHECK(session.conversation().answer_shown());
  CHECK(sat.sitting.at(session) == 1);
  REQUIRE(sat.sitting.step_own(session, -1));
  CHECK(session.conversation().outcome()->right);
  CHECK_FALSE(sat.sitting.step_own(session, -1));

  REQUIRE(sat.sitting.change_run(session));
  CHECK(sat.sitting.looks_at(session) == Looked::kRight);
  CHECK(session.player().step() == session.conversation().questions().front().step);
  CHECK(sat.sitting.compared(session) == "Decision 1 (yours: " + right + ", which is right).");
  while (session.player().step() < second.step) session.forward();
  CHECK(sat.sitting.compared(session) == "Decision 2 (" + both + ").");
  session.forward();
  REQUIRE(sat.sitting.change_run(session));  // to the next decision
  CHECK(sat.sitting.at(session) == 2);
  while (sat.sitting.step_own(session, 1)) {
  }
  CHECK(sat.sitting.at(session) + 1 == session.conversation().questions().size());
  session.conversation().acknowledge();
  CHECK(session.player().step() == session.player().steps());
  CHECK(sat.sitting.looks_at(session) == Looked::kNeither);
  CHECK(sat.sitting.mark(session) == mark);
}

TEST_CASE("a decision's text is refused if it is damaged") {
  for (const char* text : {"", "p", "px", "p-1@3", "p3", "p3@", "p3@x", "p3@-1", "p3@inf", "????p3@1", "p1>p2>p3@1",
                           "q7@1", "l1..2@1", "n@1", "nnan@1", "@1"})
    CHECK_MESSAGE(!made_of(text), text);
  CHECK(text_of(*made_of("??p3>c1@12.25")) == "??p3>c1@12.2");
  CHECK(text_of(*made_of("l3.7@0.0")) == "l3.7@0.0");
  CHECK(text_of(*made_of("o2.0.1@1.5")) == "o2.0.1@1.5");
  CHECK(made_of("n0.1@1")->tries[0] == Answer(TypedNumber{0.1}));
}

TEST_CASE("mistakes in an exercise's file are told with their places") {
  const auto says = [](const std::string& text) {
    const ExerciseDraft draft = read_exercise(text, "x.toml");
    return draft.mistakes.empty() ? std::string() : draft.mistakes.front().message();
  };
  CHECK(says(ritter_with("apart = 0.01", "apart = 0.9")).find("x.toml:9:") == 0);
  CHECK(says(ritter_with("apart = 0.01", "apart = 0.9")).find("above 0 and at most 0.2") != std::string::npos);
  std::string wide;
  for (const char letter : test::lessons_file("exercises/be-ritter.toml")) wide += letter, wide += '\0';
  for (const std::string& text : {wide, "\xff\xfe" + wide})
    CHECK(says(text) == "x.toml:1:1: the text is UTF-16: save it as UTF-8");
  CHECK(says(ritter_with("farthest = \"You took the point farthest", "farhtest = \"You took the point farthest"))
            .find("did you mean farthest?") != std::string::npos);
  CHECK(says(ritter_with("asks = \"next_outside\"", "asks = \"grows\""))
            .find("an exercise cannot ask grows of ball_grown") != std::string::npos);
  CHECK(says(ritter_with("hint = \"Compare", "hnit = \"Compare")).find("lacks the key \"hint\"") != std::string::npos);
  std::string without = test::lessons_file("exercises/be-ritter.toml");
  without.erase(without.find("[exercise]"), without.find("[points]") - without.find("[exercise]"));
  CHECK(says(without).find("lacks [exercise]") != std::string::npos);
  CHECK(says(ritter_with("decisions = [4, 9]", "decisions = [9, 4]")).find("two numbers") != std::string::npos);
}

TEST_CASE("an exercise whose promise cannot be kept says what is lacking") {
  const auto made = make_instance(*exercise_from(ritter_with("decisions = [4, 9]", "decisions = [80, 90]")), 1);
  REQUIRE_FALSE(made);
  CHECK(made.error().what == "none of 1000 instances of test keeps the promise; most have too few decisions");
}

TEST_CASE("what is built earns a mark for each level, and the best stage counts") {
  const Shared exercise = exercise_of("build-worst-ritter");
  CHECK(exercise->kind() == "build");
  Sat sat(exercise, 3);
  CHECK(sat.sitting.of() == 4);
  CHECK(sat.sitting.mark(sat.session) == 0);
  CHECK_FALSE(sat.sitting.finish());
  CHECK(level_texts(*exercise, sat.session).front() == "at least 5 %");
  const auto model = find_model(*exercise, sat.session);
  REQUIRE(model);

  SUBCASE("all of it ends the exercise") {
    REQUIRE(sat.session.stage().set_rows(*model));
    sat.sitting.see(sat.session);
    CHECK(sat.sitting.mark(sat.session) == 4);
    CHECK(sat.sitting.finished(sat.session));
  }
  SUBCASE("a hint costs a mark of four, a step back costs nothing") {
    const std::uint64_t before = sat.sitting.changes();
    REQUIRE(sat.sitting.take_hint(sat.session));
    CHECK(sat.sitting.changes() != before);  // or a window that is closed now would give it back
    CHECK(sat.sitting.hint_words(sat.session).empty());
    REQUIRE(sat.session.stage().set_rows(*model));
    sat.sitting.see(sat.session);
    sat.session.stage().reset();
    sat.sitting.see(sat.session);
    CHECK(level_of(*exercise, sat.session) == 0);
    CHECK(sat.sitting.mark(sat.session) == 3);
    REQUIRE(sat.sitting.back_to_best(sat.session));
    CHECK(level_of(*exercise, sat.session) == 4);
  }
  SUBCASE("while the hand drags nothing counts") {
    sat.session.stage().begin_drag();
    for (Index i = 0; i < 3; ++i) REQUIRE(sat.session.stage().move(i, {(*model)[i][0], (*model)[i][1], 0}));
    sat.sitting.see(sat.session);
    CHECK(sat.sitting.mark(sat.session) == 0);
    sat.session.stage().end_drag();
    sat.sitting.see(sat.session);
    CHECK(sat.sitting.mark(sat.session) == 4);
  }
  SUBCASE("only what the task leaves to be moved") {
    CHECK_FALSE(sat.session.stage().move(5, {4, 4, 0}));
    CHECK_FALSE(sat.session.stage().add({1, 1, 0}));
    CHECK_FALSE(sat.session.stage().remove(0));
    REQUIRE(sat.session.stage().move(0, {0.1, 0.1, 0}));
    sat.session.stage().undo();
    REQUIRE(sat.session.stage().set_rows(*model));  // it is still the task's stage
    CHECK(level_of(*exercise, sat.session) == 4);
    Rows foreign = *model;
    foreign[5][0] += 1;
    Attempt attempt{exercise->id, exercise->hash, 3, 0, {{0, {}, foreign, 1}}};
    CHECK_FALSE(grade(exercise, attempt));
  }
  SUBCASE("nothing else replaces the stage") {
    const Rows before = sat.session.stage().subject().rows();
    sat.session.stage().scatter(99);
    CHECK_FALSE(sat.session.stage().set_generator("cube", 8, 2, 1));
    CHECK(sat.session.stage().subject().rows() == before);
    CHECK_FALSE(sat.session.stage().can_undo());
  }
}

TEST_CASE("what was built is written, read and replayed to the same mark and stage") {
  for (const char* id : {"build-worst-ritter", "break-pca-box"}) {
    CAPTURE(id);
    const Shared exercise = exercise_of(id);
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const auto attempt = model_attempt(*exercise, seed, 0, "");
      REQUIRE(attempt);
      const auto read = made_of(text_of(attempt->made.front()));
      REQUIRE(read);
      CHECK(read->built == attempt->made.front().built);
      const auto graded = grade(exercise, *attempt);
      REQUIRE(graded);
      CHECK(graded->mark == exercise->build->levels);
    }
  }
  for (const char* damaged : {"b@1", "b1,x@1", "b1,2;@", "b1,inf@2", "b1,2>p3@4"}) CHECK_FALSE(made_of(damaged));
}

TEST_CASE("a claim is refuted with any number of points, and fewer earn more") {
  const Shared exercise = exercise_of("break-pca-box");
  CHECK(exercise->kind() == "break_it");
  Sat sat(exercise, 2);
  Rows rows{{-1.06, -0.48}, {0.23, 0.73}, {0.19, -0.52}, {-1.03, 0.78}};
  const auto mark_with = [&](int more) {
    Rows all = rows;
    for (int i = 0; i < more; ++i) all.push_back({-0.4, 0.1});
    REQUIRE(sat.session.stage().set_rows(all));
    return level_of(*exercise, sat.session);
  };
  CHECK(now_says(sat.session).find("Points: 12 points; there must be at most 4 points.") != std::string::npos);
  for (const Rows& flat : {Rows{{0, 0}, {1, 0.3}}, Rows{{0, 0}, {1, 1}, {2, 2}, {3, 3}}}) {
    REQUIRE(sat.session.stage().set_rows(flat));
    CHECK(level_of(*exercise, sat.session) == 0);
    CHECK(now_says(sat.session).find("line") != std::string::npos);
  }
  CHECK_FALSE(sat.session.stage().set_rows({{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {1, 1, 0}}));  // not in space
  CHECK_FALSE(sat.session.stage().set_float(true));
  const Done loaded = sat.session.stage().load(io::PointFile{2, {{0, 0, 0}}, {}}, "pasted");
  REQUIRE_FALSE(loaded);
  CHECK(loaded.error().message() == "in an exercise, points cannot be pasted or opened");
  CHECK(mark_with(0) == 4);
  CHECK(mark_with(2) == 3);
  CHECK(mark_with(5) == 1);
  CHECK(mark_with(9) == 0);
}

TEST_CASE("practice tells at once, takes nothing for a hint, and four fifths of the marks lead to a harder level") {
  const Shared exercise = exercise_of("be-ritter");
  const auto instance = make_instance(*exercise, 5);
  REQUIRE(instance);
  auto session = open_instance(*exercise, *instance, nullptr, true);
  REQUIRE(session);
  Sitting sitting(exercise, 5, *session, true);
  CHECK(sitting.tells_at_once());
  CHECK(sitting.hint_words(*session) == "Hint");
  CHECK(sitting.next_price(*session) == 0);
  REQUIRE(sitting.take_hint(*session));
  CHECK_FALSE(sitting.leads_on(*session));
  while (!sitting.finished(*session))
    REQUIRE(
        session->conversation().give(model_answer(*session->conversation().asked(), session->player().run(0)), false));
  CHECK(sitting.leads_on(*session));
  CHECK(sitting.mark(*session) == sitting.of());
  const Exercise hardest = at_level(*exercise, 99);
  CHECK(hardest.level == 3);
  CHECK(hardest.stage.points.count > exercise->stage.points.count);
  CHECK(hardest.apart < exercise->apart);
  CHECK_FALSE(make_instance(hardest, 5)->own == instance->own);
}

TEST_CASE("lines are shuffled anew for each instance, and a typed number follows a wrong rule within its tolerance") {
  std::set<std::string> firsts;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    firsts.insert(Sat(exercise_of("order-of-a-sat-test"), seed).asked().choices.front());
  CHECK(firsts.size() > 1);

  Sat sat(exercise_of("radii-of-boxes"), 4);
  const WrongRule* sum = find_rule(sat.asked(), "sum");
  REQUIRE(sum != nullptr);
  const auto decided = sum->decides(sat.asked(), sat.session.player().run(0));
  REQUIRE(decided);
  TypedNumber typed = std::get<TypedNumber>(*decided);
  typed.number += 0.004;  // as it would be typed
  REQUIRE(sat.session.conversation().give(typed, false));
  CHECK(sat.sitting.rule_says(sat.session).find("half extents") != std::string::npos);
  typed.number = std::get<TypedNumber>(sat.right()).number + 0.015;  // near the first try, and right
  CHECK(sat.session.conversation().give(typed, false));
  CHECK(sat.sitting.mark(sat.session) == 0.5);
}

TEST_CASE("mistakes in what is built are told with their places") {
  const auto mistakes_of = [](const std::string& from, const std::string& to) {
    std::string text = test::lessons_file("exercises/build-worst-ritter.toml");
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    std::string all;
    for (const FileError& mistake : read_exercise(text.replace(at, from.size(), to), "test.toml").mistakes)
      all += mistake.message() + '\n';
    return all;
  };
  CHECK(mistakes_of("steps = [5, 10, 15]", "steps = [5, 10, 25]").find("lead to the bound") != std::string::npos);
  CHECK(mistakes_of("steps = [5, 10, 15]", "steps = []").find("lead to the bound") != std::string::npos);
  CHECK(mistakes_of("[exercise]", "[exercise]\ndecisions = [1, 2]").find("decisions") != std::string::npos);
  CHECK(mistakes_of("[[task]]", "[[task]]\nbogus = 1").find("bogus") != std::string::npos);
}

TEST_CASE("what the run chooses is what is right: the pair along the main axis, the vertex that is climbed to") {
  for (const char* id : {"be-wu", "climb-a-hull"})
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      CAPTURE(id);
      CAPTURE(seed);
      Sat sat(exercise_of(id), seed);
      int checked = 0;
      for (const Asked& asked : sat.session.conversation().questions()) {
        if (asked.kind->name != "extremes" && asked.kind->name != "climb_to") continue;
        std::vector<Index> right = asked.kind->truth(asked, sat.session.player().run(0)).points,
                           chosen = sat.session.player().run(0).handles(asked.fact);
        std::sort(right.begin(), right.end()), std::sort(chosen.begin(), chosen.end());
        CHECK(right == chosen);
        ++checked;
      }
      CHECK(checked >= 1);
      if (std::string_view(id) == "be-wu") CHECK(checked == 1);  // the pair is asked for once
    }
}

TEST_CASE("what a rectangle touches, and the edge of the smallest, is what the calipers found") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    Sat sat(exercise_of("turn-the-calipers"), seed);
    const FitRun& run = fit_run(sat.session.player().run(0));
    std::array<Index, 2> best{};
    int edges = 0;
    for (const Asked& asked : sat.session.conversation().questions()) {
      const Truth truth = asked.kind->truth(asked, run);
      if (asked.kind->name == "smallest_edge") {
        const auto& ends = asked.choice_handles[static_cast<std::size_t>(truth.choices.front())];
        CHECK(std::equal(ends.begin(), ends.end(), best.begin(), best.end()));
        continue;
      }
      const auto& tried = *std::get_if<fit::BoxTried<double, 3>>(&run.trace()[asked.fact].step.fact);
      if (tried.better) best = {tried.on[0], tried.on[1]};
      std::vector<Index> right = truth.points, touched(tried.on.begin() + 2, tried.on.end());
      std::sort(right.begin(), right.end()), std::sort(touched.begin(), touched.end());
      CHECK(right == touched);
      ++edges;
    }
    CHECK(edges >= 3);
  }
}

TEST_CASE("a decision is asked no more often than its exercise says") {
  Sat sat(exercise_of("be-iterative-ritter"), 5);
  const auto sides =
      std::count_if(sat.session.conversation().questions().begin(), sat.session.conversation().questions().end(),
                    [](const Asked& asked) { return asked.kind->name == "side"; });
  CHECK(sides == 8);
  CHECK(sat.session.player().run(0).steps() > 40);  // it goes on for more passes
}

namespace {

/// What the student may answer where several things are tied: each of them; of several sides, one of each tied.
std::vector<Answer> tied_answers(const Asked& asked, const Truth& truth) {
  std::vector<Answer> all;
  if (!asked.many) {
    for (const int choice : truth.choices) all.push_back(OneChoice{choice});
    for (const Index i : truth.points) all.push_back(OneHandle{i});
    return all;
  }
  const std::vector<int> every(truth.points.begin(), truth.points.end());
  all.push_back(SeveralHandles{every});
  const auto needed = [&](Index left_out) {
    return std::any_of(truth.tied.begin(), truth.tied.end(),
                       [&](const std::vector<Index>& tied) { return tied.size() == 1 && tied.front() == left_out; });
  };
  for (const std::vector<Index>& tied : truth.tied) {
    if (tied.size() == 1 || needed(tied.front())) continue;
    std::vector<int> fewer = every;
    std::erase(fewer, static_cast<int>(tied.front()));
    all.push_back(SeveralHandles{fewer});
  }
  return all;
}

}  // namespace

TEST_CASE("of what is exactly tied, each is right, and nothing else is") {
  for (const AtLevel& at : levels()) {
    const Shared exercise = std::make_shared<const Exercise>(at_level(*exercise_of(at.id), at.level));
    if (!exercise->ties) continue;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      CAPTURE(at.id);
      CAPTURE(seed);
      const Sat sat(exercise, seed);
      const Run& run = sat.session.player().run(0);
      int ties = 0;
      for (const Asked& asked : sat.session.conversation().questions()) {
        const Truth truth = asked.kind->truth(asked, run);
        ties += has_tie(asked, run);
        for (const Answer& answer : tied_answers(asked, truth)) CHECK(judge(asked, answer, run).right);
        for (const std::vector<Index>& tied : truth.tied) {
          std::vector<int> none_of_them(truth.points.begin(), truth.points.end());
          for (const Index i : tied) std::erase(none_of_them, static_cast<int>(i));
          CHECK(!judge(asked, SeveralHandles{none_of_them}, run).right);
        }
        for (int i = 0; !asked.many && i < std::ssize(asked.choices); ++i)
          CHECK(judge(asked, OneChoice{i}, run).right ==
                (std::find(truth.choices.begin(), truth.choices.end(), i) != truth.choices.end()));
        for (Index i = 0; !asked.many && asked.choices.empty() && i < asked.subject->size(); ++i)
          CHECK(judge(asked, OneHandle{i}, run).right ==
                (std::find(truth.points.begin(), truth.points.end(), i) != truth.points.end()));
      }
      CHECK(ties >= 1);
    }
  }
}

TEST_CASE("points tied for the farthest from an edge are so in whole numbers") {
  const Shared exercise = std::make_shared<const Exercise>(at_level(*exercise_of("be-quickhull"), 3));
  REQUIRE(exercise->ties);
  int ties = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Sat sat(exercise, seed);
    for (const Asked& asked : sat.session.conversation().questions()) {
      // "from P3 to P8": the corners; the points are multiples of 1/16
      const std::size_t to = asked.of.find(" to ");
      const auto whole = [&](Index i) {
        const Point3 p = asked.subject->at(i) * 16;
        return std::array{std::llround(p[0]), std::llround(p[1])};
      };
      const auto a = whole(*handle_named(*asked.subject, asked.of.substr(5, to - 5))),
                 b = whole(*handle_named(*asked.subject, asked.of.substr(to + 4)));
      const auto from_edge = [&](Index i) {
        const auto p = whole(i);
        return std::llabs((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
      };
      long long most = 0;
      for (const Index i : asked.stage_points) most = std::max(most, from_edge(i));
      std::vector<Index> farthest;
      for (const Index i : asked.stage_points)
        if (from_edge(i) == most) farthest.push_back(i);
      std::vector<Index> right = asked.kind->truth(asked, sat.session.player().run(0)).points;
      std::sort(right.begin(), right.end()), std::sort(farthest.begin(), farthest.end());
      CHECK(right == farthest);
      ties += right.size() > 1;
    }
  }
  CHECK(ties >= 20);
}

TEST_CASE("after a wrong answer to a tie, one of those that are left is wrong too") {
  const Shared exercise = std::make_shared<const Exercise>(at_level(*exercise_of("be-quickhull"), 3));
  int second_tries = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto instance = make_instance(*exercise, seed);
    REQUIRE(instance);
    const auto session = open_instance(*exercise, *instance);
    for (const Asked& asked : session->conversation().questions()) {
      if (!has_tie(asked, session->player().run(0))) continue;
      CAPTURE(seed);
      const std::size_t wrong =
          asked.stage_points.size() - asked.kind->truth(asked, session->player().run(0)).points.size();
      CHECK(wrong != 1);
      ++second_tries;
    }
  }
  CHECK(second_tries >= 300);
}

TEST_CASE("of four updates two give the same AABB, and the loose one is square") {
  const Shared exercise = exercise_of("four-updates");
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const Sat sat(exercise, seed);
    for (const Asked& asked : sat.session.conversation().questions()) {
      const auto& body = static_cast<const UpdateSubject&>(*asked.subject);
      const auto widths = [&](const char* name) {
        const auto box = body.box_of(*find_method(*asked.lesson, name));
        return Point3(box.max - box.min);
      };
      CHECK((widths("rebuild") - widths("hill_climb")).norm() < 1e-12);  // a climb allows for rounding
      CHECK(widths("loose")[0] == doctest::Approx(widths("loose")[1]));
      if (!asked.ordered) CHECK(asked.choices.size() == 3);
      const Truth truth = asked.kind->truth(asked, sat.session.player().run(0));
      if (asked.ordered) CHECK(asked.choices[static_cast<std::size_t>(truth.choices.front())].starts_with("Loose"));
    }
  }
}
