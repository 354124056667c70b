// A lesson in which students choose the kinds of both volumes, what is asked about GJK in it, and entries of R.
#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_lesson.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/axis_rows.hpp"
#include "lesson/subjects/pair/difference.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr std::string_view kHead = R"(version = 2
title = "Any"
summary = "Any two."
minutes = 1
covers = ["L: s"]
)";

constexpr std::string_view kAny = R"(volume = "volume_pair"
algorithms = ["gjk", "spheres", "sphere_box", "swept_spheres", "slabs", "slabs_then_gjk", "separating_axes"]
[volumes]
any = true
dim = 2
a = { hull = { points = [[-2.1, -0.5], [-1.0, -1.1], [-0.3, -0.2], [-0.9, 0.9]] } }
b = { hull = { points = [[0.4, 0.9], [1.0, -0.6], [2.0, -0.1], [1.5, 1.2]] } }
[[section]]
title = "One"
text = "A text."
[[question]]
id = "next"
algorithm = "gjk"
before = "support_found"
asks = "next_vertex"
prompt = "Which?"
because = "Because."
[[question]]
id = "origin"
algorithm = "gjk"
before = "nearest_found"
nth = 2
asks = "contains_origin"
prompt = "Now?"
because = "Because."
)";

constexpr std::string_view kCheaper = R"([[question]]
id = "cheaper"
algorithm = "gjk"
before = "overlap_decided"
after = "distance_found"
asks = "cheaper"
prompt = "Which is cheaper?"
because = "Because."
)";

Session open(std::string text) {
  auto lesson = check::checked_lesson(text, "any.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}
Session any() { return open(std::string(kHead) + std::string(kAny)); }

/// The same in space, where no vertex of A - B is asked about.
Session any_in_space() {
  std::string text = std::string(kHead) + std::string(kAny.substr(0, kAny.find("[[question]]")));
  const auto first = text.find("dim = 2"), last = text.find("[[section]]");
  text.replace(first, last - first,
               "dim = 3\n"
               "a = { hull = { points = [[-2.1, -0.5, 0], [-1, -1.1, 0.2], [-0.3, -0.2, -0.6], [-0.9, 0.9, 0.4]] } }\n"
               "b = { hull = { points = [[0.4, 0.9, 0], [1, -0.6, 0.4], [2, -0.1, -0.5], [1.5, 1.2, 0.6]] } }\n");
  return open(text);
}
Session any(int dim) { return dim == 2 ? any() : any_in_space(); }

const VolumePair& pair_on_stage(const Session& session) {
  return as<VolumesSubject>(session.stage().subject())->pair();
}

void choose(Session& session, const Kinds& kinds) {
  auto next = session.stage().subject().clone();
  static_cast<VolumesSubject&>(*next).choose_kinds(kinds);
  REQUIRE(session.stage().become(std::move(next)).has_value());
}

/// The right choices of a question of this run; none if it is not asked here.
std::vector<std::string> right(const Session& session, std::string_view id) {
  std::vector<std::string> choices;
  for (const Asked& asked : session.conversation().questions())
    if (asked.question->id == id)
      for (const int choice : asked.kind->truth(asked, session.player().run(0)).choices)
        choices.push_back(asked.choices[choice]);
  return choices;
}

}  // namespace

TEST_CASE("each of the 28 pairs can be chosen, has its own test, and comes back from its rows") {
  for (const int dim : {2, 3}) {
    CAPTURE(dim);
    Session session = any(dim);
    for (std::size_t a = 0; a < kVolumeNames.size(); ++a)
      for (std::size_t b = a; b < kVolumeNames.size(); ++b) {
        CAPTURE(kVolumeNames[a]);
        CAPTURE(kVolumeNames[b]);
        choose(session, {a, b});
        CHECK(kinds_of(pair_on_stage(session)) == Kinds{a, b});
        const auto test = query::kPairTestNames[static_cast<std::size_t>(test_of(pair_on_stage(session)))];
        CHECK(session.player().choose(0, test).has_value());
        for (const std::string& name : session.lesson().algorithms)
          CHECK(session.stage().subject().suits(*find_method(volume_tests(), name)) ==
                (name == test || name == "gjk" || (name == "slabs_then_gjk" && query::is_conservative(a, b))));
        session.last();
        CHECK(session.telling().caption().back() == '.');

        const Rows rows = session.stage().subject().rows();
        Session other = any(dim);
        REQUIRE(other.stage().set_rows(rows).has_value());
        CHECK(other.stage().subject().rows() == rows);
        CHECK(kinds_of(pair_on_stage(other)) == Kinds{a, b});
        session.stage().scatter(17);
        CHECK(kinds_of(pair_on_stage(session)) == Kinds{a, b});
        CHECK(session.stage().subject().rows() != rows);
        session.stage().undo();
        CHECK(session.stage().subject().rows() == rows);
      }
  }
}

TEST_CASE("rows that are no two volumes of any kind are refused, and change nothing") {
  Session session = any();
  const Rows own = session.stage().subject().rows();
  // A hull of more points and a k-DOP of fewer slabs than the usual ones.
  const Rows others{{5, -2, -2, -1, 1}, {6, 1, 0, 3, 0, 3, 1, 2, 2, 1, 1, 0.5, 0.5, 2, 1}};
  REQUIRE(session.stage().set_rows(others).has_value());
  CHECK(session.stage().subject().rows() == others);
  for (Index i = 0; i < session.stage().subject().size(); ++i) CHECK(session.stage().subject().at(i)[2] == 0);
  session.stage().reset();
  CHECK(session.stage().subject().rows() == own);
  for (const Rows& wrong : {Rows{{7, 0, 0, 1}, {6, 0, 0, 1, 0, 0, 1}}, Rows{{0.5, 0, 0, 1}, own[1]}, Rows{own[0]},
                            Rows{{6, 0, 0, 1, 0, 0, 1}, {0, 3, 0, 1}}, Rows{{}, own[1]}, Rows{{0, 0, 0, -1}, own[1]}}) {
    CHECK_FALSE(session.stage().set_rows(wrong).has_value());
    CHECK(session.stage().subject().rows() == own);
  }
}

TEST_CASE("which vertex of A - B comes next is what the run finds, however the volumes lie") {
  Session session = any();
  int asked = 0, outside = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    session.stage().scatter(seed);
    const PairSteps steps = pair_run(session.player().run(0)).trace();
    for (const auto& entry : steps) {
      const auto* found = std::get_if<query::SupportFound>(&entry.step.fact);
      if (found == nullptr) continue;
      const auto answers = right(session, "next");
      REQUIRE_FALSE(answers.empty());
      const PairRun::Where where{pair_run(session.player().run(0)), 0, nullptr};
      const std::string name = where.vertex(0, found->a).name + "\u00a0−\u00a0" + where.vertex(1, found->b).name;
      CHECK(std::find(answers.begin(), answers.end(), name) != answers.end());
      ++asked;
      break;
    }
    const auto origin = right(session, "origin");
    outside += !origin.empty() && origin.front() == "no" ? 1 : 0;
  }
  CHECK(asked > 40);
  CHECK(outside > 10);
}

TEST_CASE("the outline of A - B contains every difference of two vertices, and has no vertex twice") {
  Session session = any();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    session.stage().scatter(seed);
    const auto outline = difference_outline(pair_on_stage(session));
    REQUIRE(outline.size() >= 3);
    CHECK(outline.size() <= 8);
    for (const Point3& p : core_of(pair_on_stage(session).held[0]))
      for (const Point3& q : core_of(pair_on_stage(session).held[1]))
        for (std::size_t i = 0; i < outline.size(); ++i) {
          const Point3 from = outline[i].at, edge = outline[(i + 1) % outline.size()].at - from, to = p - q - from;
          CHECK(edge[0] * to[1] - edge[1] * to[0] > -1e-12);
        }
  }
}

TEST_CASE("which test is cheaper is counted, and only asked of a pair that has a test of its own") {
  std::string text = std::string(kHead) + std::string(kAny) + std::string(kCheaper);
  CHECK_FALSE(check::checked_lesson(text, "any.toml").has_value());  // two hulls have none
  const auto first = text.find("a = {"), last = text.find("[[section]]");
  text.replace(first, last - first,
               "a = { obb = { center = [-1, 0], half_extents = [0.9, 0.4], turn = 20 } }\n"
               "b = { obb = { center = [1, 0.2], half_extents = [0.7, 0.5], turn = -20 } }\n");
  Session session = open(text);
  const std::int64_t own = operations_in(record("separating_axes", pair_on_stage(session)));
  const std::int64_t gjk = operations_in(record("gjk", pair_on_stage(session)));
  CHECK(own > 0);
  CHECK(gjk > 0);
  REQUIRE(right(session, "cheaper").size() == 1);
  CHECK(right(session, "cheaper").front() == (own < gjk ? "Separating axes" : "GJK"));
  choose(session, {6, 6});
  REQUIRE(session.player().choose(0, "gjk").has_value());
  CHECK(right(session, "cheaper").empty());
}

TEST_CASE("the entries of R that a radius takes are those of its formula") {
  for (const int dim : {2, 3})
    for (int row = 0; row < static_cast<int>(axis_names(dim).size()); ++row) {
      const RowEntries entries = row_entries(dim, row);
      const RowFormulas formulas = row_formulas(dim, row);
      for (const auto& [bits, formula] :
           {std::pair{entries.rotation_a, formulas.radius_a}, std::pair{entries.rotation_b, formulas.radius_b}})
        for (int i = 0; i < dim; ++i)
          for (int j = 0; j < dim; ++j) {
            const std::string entry = "R_{" + std::to_string(i + 1) + std::to_string(j + 1) + "}";
            CHECK(((bits >> (3 * i + j) & 1) != 0) == (formula.find(entry) != std::string::npos));
          }
    }
}

TEST_CASE("the figures of random pairs are the counts, by the seed on the stage") {
  Session session = open(std::string(kHead) +
                         "volume = \"box_pair\"\nalgorithms = [\"sat\"]\n[boxes]\ndim = 3\nrandom_pairs = 300\n"
                         "center = [[-1, 0, 0], [1, 0.3, 0]]\nhalf_extents = [[0.9, 0.4, 0.3], [0.8, 0.5, 0.4]]\n"
                         "turn = [[20, 0, 0], [0, -35, 10]]\n[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n");
  for (const std::uint64_t seed : {1, 5}) {
    session.stage().scatter(seed);
    const cost::AxisCounts counts = cost::count_axes<3>(300, seed);
    const auto value = [&](std::string_view key) {
      for (const Figure& figure : session.telling().figures())
        if (figure.key == key) return figure.value;
      return -1.0;
    };
    CHECK(value("random_overlap") == counts.overlap);
    CHECK(value("random_edges") == counts.edges_alone<3>());
    CHECK(value("random_tests") == doctest::Approx(static_cast<double>(counts.tests) / 300));
  }
}
