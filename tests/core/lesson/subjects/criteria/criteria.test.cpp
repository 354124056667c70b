// Which volume when: the model, what is known of shapes, predictions and tasks.
#include "lesson/subjects/criteria/criteria.hpp"

#include "check/check_lesson.hpp"
#include "check/play.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects/criteria/criteria_words.hpp"
#include "measure/report.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kCriteria = R"(version = 2
title = "Criteria"
summary = "For tests."
minutes = 1
chart = "criteria"
algorithms = ["sphere/welzl", "aabb/min_max", "kdop/k14", "hull/quickhull"]
reference = "hull/quickhull"
generators = ["stick"]

[points]
dim = 3
generate = "gaussian"
count = 20

[load]
bodies = 10
frames = 100
updates = 0
pairs = 50
hit_rate = 20

[[situation]]
name = "cloth"
title = "Cloth"
[situation.points]
dim = 3
generate = "stick"
count = 12
[situation.load]
deforms = true

[[slider]]
title = "Frames"
drives = "frames"
from = 1
to = 10000
logarithmic = true

[[slider]]
title = "Hit rate"
drives = "hit rate"
from = 0
to = 100

[[section]]
title = "One"
text = "Prose."

[[question]]
id = "total"
asks = "least"
figure = "total"
prompt = "Which?"
because = "So."

[[question]]
id = "tight"
asks = "order"
figure = "looseness"
prompt = "Which order?"
because = "So."

[[question]]
id = "cloth"
situation = "cloth"
asks = "least"
figure = "build"
prompt = "Which?"
because = "So."

[[task]]
prompt = "Few frames."
algorithm = "aabb/min_max"
hint = "Build."
load = { frames = 1 }

[[task.require]]
figure = "lead"
at_least = 25
)";

Session opened_criteria() {
  auto lesson = check::checked_lesson(kCriteria, "criteria.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  return *Session::open(*std::move(lesson));
}

void count_now(Session& session) {
  session.inform<CriteriaSubject>([](CriteriaSubject& subject) { subject.count(*subject.points()); });
}

}  // namespace

TEST_CASE("the total cost is what each part costs, as often as the load has it") {
  std::vector<cost::CriteriaRow> rows(2);
  rows[0].costs.time.median = 100, rows[0].update.median = 7, rows[0].costs.overlap.median = 3;
  rows[0].passes = {.pairs = 9, .apart = 8, .passed = 2};
  rows[1].costs.volume = "hull", rows[1].costs.overlap.median = 40;
  const Load load{.bodies = 2, .frames = 10, .updates = 5, .pairs = 8, .hit_rate = 0.5, .deforms = false};
  const TotalCost total = *cost::total_of(rows, 0, load);
  CHECK(total.build == 200);
  CHECK(total.updates == 350);
  CHECK(total.tests == 240);
  CHECK(total.false_positives == 400);
  CHECK(total.sum() == 1190);
  Load cloth = load;
  cloth.deforms = true;
  CHECK(cost::total_of(rows, 0, cloth)->updates == 5000);
  CHECK_FALSE(cost::total_of(rows, 2, load));
  rows[1].costs.volume = "obb";  // nobody knows what the exact test costs
  CHECK_FALSE(cost::total_of(rows, 0, load));
}

TEST_CASE("the table of a load has its figures, and reads back to them") {
  std::vector<cost::CriteriaRow> rows(1);
  rows[0].costs.volume = "hull", rows[0].costs.time.median = 100, rows[0].costs.overlap.median = 40;
  rows[0].costs.time.repeats = rows[0].costs.overlap.repeats = rows[0].update.repeats = 9;
  rows[0].passes = {.pairs = 9, .apart = 8, .passed = 2};
  const auto table = cost::which_rows(rows, {.bodies = 2, .frames = 10, .updates = 5, .pairs = 8, .hit_rate = 0.5});
  REQUIRE(table.size() == 1);
  CHECK(table[0].total == 200 + 80 * 40 + 80 * 0.5 * 0.25 * 40);
  const auto back = cost::read_csv<cost::WhichRow>(cost::csv_of({}, std::span<const cost::WhichRow>(table)), "which");
  REQUIRE(back.has_value());
  CHECK(back->rows[0].total == table[0].total);
  CHECK(back->rows[0].passed == 2);
  CHECK(back->rows[0].hit_rate == 0.5);
}

TEST_CASE("a slider, undo and a look at another situation lose no measurement") {
  Session session = opened_criteria();
  CHECK_FALSE(criteria_of(session)->is_measured());
  session.stage().begin_drag();
  count_now(session);  // it ends while the slider is in hand
  const double before = *criteria_of(session)->value(0, Criterion::kTotal, criteria_of(session)->load_now());
  REQUIRE(session.stage().slide(0, 1000));
  session.stage().end_drag();
  CHECK(criteria_of(session)->is_measured());
  CHECK(*criteria_of(session)->value(0, Criterion::kTotal, criteria_of(session)->load_now()) > before);
  CHECK(*criteria_of(session)->value(0, Criterion::kTotal, criteria_of(session)->own_load()) == before);
  CHECK(session.stage().is_own());
  session.stage().undo();
  CHECK(criteria_of(session)->is_measured());
  CHECK(criteria_of(session)->load_now() == criteria_of(session)->own_load());
  REQUIRE(session.stage().show_situation("cloth"));
  CHECK_FALSE(criteria_of(session)->is_measured());
  REQUIRE(session.stage().show_situation("own"));
  CHECK(criteria_of(session)->is_measured());
}

TEST_CASE("points that have changed are not measured; brought back by undo, they are") {
  Session session = opened_criteria();
  count_now(session);
  REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Point3(0.5, 0, 0)));
  CHECK_FALSE(criteria_of(session)->is_measured());
  CHECK_FALSE(criteria_of(session)->total(0, criteria_of(session)->load_now()).has_value());
  session.stage().undo();
  CHECK(criteria_of(session)->is_measured());
}

TEST_CASE("the looseness of the pictures is that of the measurement, digit for digit") {
  Session session = opened_criteria();
  count_now(session);
  const ShapeCosts& shape = criteria_of(session)->around();
  REQUIRE(shape.rows.size() == shape.volumes.size());
  for (std::size_t i = 0; i < shape.rows.size(); ++i) {
    CHECK(shape.volumes[i].over_hull == shape.rows[i].costs.over_hull);
    CHECK(shape.volumes[i].over_hull >= 1);
    CHECK(shape.volumes[i].method->volume == shape.rows[i].costs.volume);
  }
}

TEST_CASE("predictions wait for the measurement, and are judged by the situation's own load") {
  Session session = opened_criteria();
  CHECK(session.conversation().asked() == nullptr);  // seen first, then asked
  session.conversation().ask_predictions();
  REQUIRE(session.conversation().asked() != nullptr);
  CHECK(session.conversation().asked()->choices == std::vector<std::string>{"Sphere", "AABB", "14-DOP", "Hull"});
  const int wrong = 3;  // the hull's test is the exact test itself, and costs most
  REQUIRE(session.conversation().give(OneChoice{wrong}));
  CHECK(session.log().outcomes().front().pending);
  REQUIRE(session.conversation().give(ChoicesInOrder{{3, 2, 1, 0}}));
  REQUIRE(session.stage().slide(0, 10000));
  count_now(session);
  CHECK_FALSE(session.log().outcomes().front().pending);
  CHECK_FALSE(session.log().outcomes().front().right);
  const CriteriaSubject& subject = *criteria_of(session);
  const std::vector<int> ranks = subject.ranks(Criterion::kLooseness, subject.own_load());
  CHECK(ranks[3] == 0);
  CHECK(session.log().outcomes()[1].right == (ranks[2] <= ranks[1] && ranks[1] <= ranks[0]));
}

TEST_CASE("it is played, and its task is done by the model alone") {
  Session session = opened_criteria();
  const auto played = check::play(session);
  REQUIRE(played.has_value());
  CHECK(played->sound());
  session = opened_criteria();
  session.stage().start_task(0);
  CHECK(session.grade()->says == "Measure this shape.");
  count_now(session);
  CHECK_FALSE(session.grade()->done);
  REQUIRE(session.stage().slide(0, 1));
  CHECK(session.grade()->done);
}

TEST_CASE("its rows hold points and load, and bad ones are refused") {
  Session session = opened_criteria();
  REQUIRE(session.stage().slide(0, 500));
  const Rows rows = session.stage().subject().rows();
  Session other = opened_criteria();
  REQUIRE(other.stage().set_rows(rows));
  CHECK(other.stage().subject().rows() == rows);
  CHECK(criteria_of(other)->load_now().frames == 500);
  for (const std::vector<double>& bad : {std::vector<double>{-1, 1, 0, 0}, {1, 1, 2, 0}, {1, 1, NAN, 0}}) {
    Rows worse = rows;
    worse.back() = bad;
    CHECK_FALSE(other.stage().set_rows(worse).has_value());
  }
  CHECK(other.stage().subject().rows() == rows);
}

TEST_CASE("tables have a cell for each head, and the textbooks' order has no capsule") {
  Session session = opened_criteria();
  for (const auto kind : {CriteriaTableKind::kCriteria, CriteriaTableKind::kTotal, CriteriaTableKind::kRanks}) {
    for (const bool measured : {false, true}) {
      if (measured) count_now(session);
      const CriteriaTable table = criteria_table(*criteria_of(session), kind);
      REQUIRE(table.cells.size() == 4);
      for (const auto& row : table.cells) CHECK(row.size() + 1 == table.head.size());
    }
  }
  const CriteriaTable ranks = criteria_table(*criteria_of(session), CriteriaTableKind::kRanks);
  CHECK(ranks.cells[0][0].text == "1");
  CHECK(ranks.cells[3][0].text == "5");
  CHECK(cost_text(35.14, false) == "35.1 ns");
  CHECK(cost_text(1204, false) == "1.20 µs");
  CHECK(cost_text(3.4e6, false) == "3.40 ms");
  CHECK(cost_text(123e9, false) == "123 s");
  CHECK(cost_text(0, false) == "0");
  CHECK(cost_text(1204, true) == "1,204");
}
