// Two volumes of any kind: every pair opens, is tested, and follows the hand.
#include "lesson/subjects/pair/volumes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "check/check_lesson.hpp"
#include "core/lesson/lesson_files.hpp"
#include "lesson/session.hpp"
#include "lesson/volume_rows.hpp"
#include "query/overlap/overlaps.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// A volume of each kind, in kVolumeNames' order. x: where about its centre is.
std::string volume_of(std::size_t kind, int dim, const char* x) {
  const std::string z = dim == 3 ? ", 0.2]" : "]", at = std::string("[") + x + ", 0.1" + z;
  const std::string end = std::string("[") + x + ", 1.3" + z;
  switch (kind) {
    case 0: return "{ sphere = { center = " + at + ", radius = 0.8 } }";
    case 1: return "{ aabb = { min = " + at + ", max = [9" + (dim == 3 ? ", 2, 1]" : ", 2]") + " } }";
    case 2:
      return "{ obb = { center = " + at + ", half_extents = [0.9, 0.4" +
             (dim == 3 ? ", 0.3], turn = [10, 20, 30]" : "], turn = 20") + " } }";
    case 3: return "{ capsule = { a = " + at + ", b = " + end + ", radius = 0.3 } }";
    case 4:
      return "{ lozenge = { origin = " + at +
             ", edges = " + (dim == 3 ? "[[1, 0, 0], [0, 0.6, 0.2]]" : "[[1, 0], [0, 0.6]]") + ", radius = 0.25 } }";
    case 5:
      return dim == 3
                 ? std::string("{ kdop = { k = 14, min = [-1, -1, -1, -2, -2, -2, -2], max = [1, 1, 1, 2, 2, 2, 2] } }")
                 : std::string("{ kdop = { k = 8, min = [-1, -1, -1.5, -1.5], max = [1, 1, 1.5, 1.5] } }");
    default:
      return "{ hull = { points = [" + at + ", " + end + ", [9, 0" + (dim == 3 ? ", 0], [8, 1, 1" : "], [8, 1") +
             "]] } }";
  }
}

std::string lesson_text(std::size_t a, std::size_t b, int dim, const std::string& algorithms) {
  return "version = 2\ntitle = \"Two volumes\"\nsummary = \"Two volumes.\"\nminutes = 1\n"
         "covers = [\"L: s\"]\nvolume = \"volume_pair\"\nalgorithms = [" +
         algorithms + "]\n[volumes]\ndim = " + std::to_string(dim) + "\na = " + volume_of(a, dim, "-2") +
         "\nb = " + volume_of(b, dim, "1.7") + "\n[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n";
}

std::string own_test(std::size_t a, std::size_t b) {
  return std::string(query::kPairTestNames[static_cast<std::size_t>(query::kPairTests[a][b])]);
}

Session pair_session(std::size_t a, std::size_t b, int dim) {
  const std::string test = own_test(a, b);
  const std::string both = test == "gjk" ? "\"gjk\"" : "\"" + test + "\", \"gjk\"";
  auto lesson = check::checked_lesson(lesson_text(a, b, dim, both), "two.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

const VolumePair& pair_of(const Session& session) { return as<VolumesSubject>(session.stage().subject())->pair(); }

/// What the test of the volumes themselves says.
bool overlap_of(const VolumePair& pair) {
  const auto own = [&]<int Dim>(std::integral_constant<int, Dim>) {
    return std::visit(
        [](const auto& a, const auto& b) {
          return query::overlaps(converted<double, Dim>(a), converted<double, Dim>(b));
        },
        pair.held[0].volume, pair.held[1].volume);
  };
  return pair.dim == 2 ? own(std::integral_constant<int, 2>()) : own(std::integral_constant<int, 3>());
}

/// How many tests `snug overlap` counts.
int tests_counted(const VolumePair& pair) {
  const auto own = [&]<int Dim>(std::integral_constant<int, Dim>) {
    return std::visit(
        [](const auto& a, const auto& b) {
          return query::test_overlap(converted<double, Dim>(a), converted<double, Dim>(b)).tests;
        },
        pair.held[0].volume, pair.held[1].volume);
  };
  return pair.dim == 2 ? own(std::integral_constant<int, 2>()) : own(std::integral_constant<int, 3>());
}

/// What the run says in the end.
bool overlap_said(const Session& session) {
  const auto& end = pair_run(session.player().run(0)).trace().back().step.fact;
  if (const auto* verdict = std::get_if<query::Verdict<double, 3>>(&end)) return verdict->result.overlap;
  const auto* decided = std::get_if<OverlapDecided>(&end);
  REQUIRE(decided != nullptr);
  return decided->overlap;
}

void check_all_steps(Session& session) {
  for (int step = 0; step <= session.player().steps(); ++step) {
    session.jump(step);
    CHECK(session.player().step() == step);
    CHECK(session.telling().caption().size() > 10);
    CHECK(session.telling().caption().back() == '.');
    for (const Figure& figure : session.telling().figures()) CHECK(std::isfinite(figure.value));
  }
  CHECK(session.player().line() >= 0);
  CHECK(session.player().line() < static_cast<int>(session.player().pseudocode(0).size()));
  for (const Proof& proof : session.player().proofs()) CHECK(proof.holds);
}

/// Opens each pair of kinds of volumes, in the plane and in space.
template <class Test>
void each_pair(Test test) {
  for (const int dim : {2, 3})
    for (std::size_t a = 0; a < kVolumeNames.size(); ++a)
      for (std::size_t b = a; b < kVolumeNames.size(); ++b) {
        CAPTURE(dim);
        CAPTURE(kVolumeNames[a]);
        CAPTURE(kVolumeNames[b]);
        Session session = pair_session(a, b, dim);
        test(session, dim);
      }
}

}  // namespace

TEST_CASE("every pair of volumes opens, is tested step by step, and says what overlaps says, wherever it is dragged") {
  int apart = 0, together = 0;
  each_pair([&](Session& session, int dim) {
    std::set<std::string> names;
    for (Index i = 0; i < session.stage().subject().size(); ++i) {
      CAPTURE(session.stage().subject().name_of(i));
      CHECK(names.insert(session.stage().subject().name_of(i)).second);
      const Vector<double, 3> to =
          session.stage().subject().at(i) + Vector<double, 3>(0.11, -0.07, dim == 3 ? 0.05 : 0);
      if (!session.stage().move(i, to)) continue;  // slabs that would have no point in common
      CHECK(session.stage().subject().origin().edited);
      // The handle went where the hand is, or as near as its kind can be.
      CHECK((session.stage().subject().at(i) - to).norm() < 1.2);
      CHECK(overlap_said(session) == overlap_of(pair_of(session)));
      (overlap_said(session) ? together : apart) += 1;
    }
    check_all_steps(session);
    for (const std::uint64_t seed : {2, 3, 4}) {
      session.stage().scatter(seed);
      CHECK(overlap_said(session) == overlap_of(pair_of(session)));
    }
    session.stage().undo();
    session.stage().scatter(1);
    if (session.lesson().algorithms.size() == 2) {
      REQUIRE(session.player().choose(0, "gjk"));
      CHECK(overlap_said(session) == overlap_of(pair_of(session)));
      check_all_steps(session);
    }
  });
  CHECK(apart > 100);
  CHECK(together > 100);
}

TEST_CASE("a pair's tests are counted as the command line counts them, and the figure says what they are") {
  std::set<std::string> named;
  each_pair([&](Session& session, int) {
    session.jump(session.player().steps());
    for (const Figure& figure : session.telling().figures())
      if (figure.key == "tests") {
        named.insert(figure.name);
        CHECK(figure.value == tests_counted(pair_of(session)));
      }
  });
  CHECK(named == std::set<std::string>{"Axes so far", "Pairs of features so far", "Simplices so far", "Slabs so far"});
}

TEST_CASE("the centre takes its volume along, and what a handle does not hold stays") {
  for (const int dim : {2, 3})
    for (std::size_t kind = 0; kind < kVolumeNames.size(); ++kind) {
      CAPTURE(dim);
      CAPTURE(kVolumeNames[kind]);
      Session session = pair_session(kind, kind, dim);
      std::vector<Vector<double, 3>> before;
      for (Index i = 0; i < session.stage().subject().size(); ++i) before.push_back(session.stage().subject().at(i));
      const Vector<double, 3> by(0.5, 0.25, dim == 3 ? -0.125 : 0);
      REQUIRE(session.stage().subject().name_of(0) == "A");
      REQUIRE(session.stage().move(0, before[0] + by));
      for (Index i = 0; i < session.stage().subject().size(); ++i) {
        CAPTURE(session.stage().subject().name_of(i));
        const Vector<double, 3> due =
            session.stage().subject().name_of(i)[0] == 'A' ? Vector<double, 3>(before[i] + by) : before[i];
        CHECK((session.stage().subject().at(i) - due).norm() < 1e-12);
      }
      session.stage().undo();
      for (Index i = 0; i < session.stage().subject().size(); ++i) CHECK(session.stage().subject().at(i) == before[i]);
    }
}

TEST_CASE("the rows of two volumes that hands have changed bring them back, to the last bit") {
  for (const int dim : {2, 3})
    for (std::size_t kind = 0; kind < kVolumeNames.size(); ++kind) {
      CAPTURE(dim);
      CAPTURE(kVolumeNames[kind]);
      Session session = pair_session(0, kind, dim);
      for (Index i = 0; i < session.stage().subject().size(); ++i)
        static_cast<void>(
            session.stage().move(i, session.stage().subject().at(i) + Point3(0.037, -0.11, dim == 3 ? 0.07 : 0)));
      Session fresh = pair_session(0, kind, dim);
      CHECK_FALSE(fresh.stage().subject().rows() == session.stage().subject().rows());
      REQUIRE(fresh.stage().set_rows(session.stage().subject().rows()).has_value());
      CHECK(fresh.stage().subject().rows() == session.stage().subject().rows());
      CHECK(fresh.player().trace_hash() == session.player().trace_hash());
      CHECK(fresh.stage().edited());
      fresh.stage().undo();
      CHECK_FALSE(fresh.stage().edited());
      // What can be no such volume is refused, and what stands there stays.
      Rows wrong = session.stage().subject().rows();
      wrong[1].pop_back();
      CHECK_FALSE(fresh.stage().set_rows(wrong).has_value());
      wrong[1].push_back(std::nan(""));
      CHECK_FALSE(fresh.stage().set_rows(wrong).has_value());
      wrong = session.stage().subject().rows();
      wrong[0].back() = -1;  // the sphere's radius
      CHECK_FALSE(fresh.stage().set_rows(wrong).has_value());
      CHECK_FALSE(fresh.stage().edited());
    }
}

TEST_CASE("a file on two volumes says what is wrong in it, and where") {
  const auto error_of = [](std::string text) {
    const auto lesson = check::checked_lesson(text, "two.toml");
    return lesson ? std::string() : lesson.error().message();
  };
  const auto has = [](const std::string& error, std::string_view part) {
    CAPTURE(error);
    CHECK(error.find(part) != std::string::npos);
  };
  has(error_of(lesson_text(0, 0, 2, "\"gjk\", \"slabs\"")),
      "the test of these two volumes is spheres or gjk, not slabs");
  has(error_of(lesson_text(3, 0, 2, "\"gjk\"")), "must be of the kind that comes first");
  std::string text = lesson_text(0, 0, 2, "\"gjk\"");
  text.replace(text.find("radius = 0.8"), 12, "radius = -1 ");
  has(error_of(text), "radius");
  text = lesson_text(0, 0, 2, "\"gjk\"");
  text.replace(text.find("sphere"), 6, "ball  ");
  has(error_of(text), "a volume is one of sphere");
  text = lesson_text(5, 5, 2, "\"gjk\"");
  text.replace(text.find("k = 8"), 5, "k = 7");
  has(error_of(text), "must be 4, 6 or 8");
  text = lesson_text(5, 5, 2, "\"gjk\"");
  text.replace(text.find("max = [1, 1, 1.5"), 16, "max = [1, 1, -9 ");
  has(error_of(text), "\"min\" is above \"max\"");
  text = lesson_text(5, 5, 2, "\"gjk\"");
  text.replace(text.find("min = [-1, -1, -1.5, -1.5], max = [1, 1, 1.5, 1.5]"), 50,
               "min = [1, 1, -1.5, -1.5], max = [2, 2, 1.5, 1.5]  ");
  has(error_of(text), "no point in common");
  text = lesson_text(4, 4, 2, "\"gjk\"");
  text.replace(text.find("[0, 0.6]"), 8, "[1, 0.6]");
  has(error_of(text), "perpendicular");
}

namespace {

/// Whether float holds every number of the volume.
bool is_rounded(const HeldVolume& held) {
  const HeldVolume again = rounded_to_float(held);
  return again.points == held.points && row_of(again) == row_of(held);
}

}  // namespace

TEST_CASE("in float both volumes are rounded, whatever their kinds, and in double they are what they were") {
  int traces = 0;
  each_pair([&](Session& session, int) {
    const std::uint64_t trace = session.player().run(0).hash();
    const Rows rows = session.stage().subject().rows();
    REQUIRE(session.stage().set_float(true).has_value());
    CHECK(session.stage().subject().in_float());
    CHECK(session.stage().subject().rows() == rows);
    for (const HeldVolume& held : pair_of(session).held) CHECK(is_rounded(held));
    traces += session.player().run(0).hash() != trace ? 1 : 0;

    // The tests are careful in both: in float they are right about the rounded volumes.
    VolumePair in_double = pair_of(session);
    in_double.in_float = false;
    CHECK(overlap_said(session) == overlap_of(in_double));

    REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Point3(0.123456789, 0, 0)).has_value());
    CHECK(is_rounded(pair_of(session).held[0]));
    session.stage().scatter(7);
    CHECK(session.stage().subject().in_float());
    CHECK(is_rounded(pair_of(session).held[1]));
    session.stage().undo();
    session.stage().undo();
    REQUIRE(session.stage().set_float(false).has_value());
    CHECK(session.stage().subject().rows() == rows);
    CHECK(session.player().run(0).hash() == trace);
  });
  CHECK(traces > 40);
}

TEST_CASE("a lesson's file has its volumes in float, and what float cannot hold is refused in float alone") {
  std::string text = lesson_text(0, 0, 2, "\"spheres\"");
  text.replace(text.find("[volumes]\n"), 10, "[volumes]\nscalar = \"float\"\n");
  auto lesson = check::checked_lesson(text, "two.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  Session session = *Session::open(*std::move(lesson));
  CHECK(session.stage().subject().in_float());
  CHECK(session.stage().is_own());
  CHECK(is_rounded(pair_of(session).held[0]));
  CHECK_FALSE(session.stage().move(0, Point3(1e30, 0, 0)));
  REQUIRE(session.stage().set_float(false));
  REQUIRE(session.stage().move(0, Point3(1e30, 0, 0)));
  CHECK_FALSE(session.stage().set_float(true));
  CHECK_FALSE(session.stage().subject().in_float());
}

TEST_CASE("a simplex that contains the origin is at distance 0, also where rounding leaves a little") {
  Session session = snug::test::session_of("overlap-any");
  REQUIRE(session.stage().show_situation("overlapping").has_value());
  session.jump(session.player().steps());
  const auto figures = session.telling().figures();
  const auto upper = std::find_if(figures.begin(), figures.end(), [](const Figure& one) { return one.key == "upper"; });
  REQUIRE(upper != figures.end());
  CHECK(upper->value == 0);
  CHECK(upper->text == "0.000 units");
}

TEST_CASE("a line separates two volumes of the plane, and a plane those of space") {
  Session session = snug::test::session_of("overlap-any");
  session.jump(session.player().steps());
  REQUIRE(session.player().proofs().size() == 1);
  CHECK(session.player().proofs()[0].text.starts_with("a line that passes between"));
  REQUIRE(session.stage().show_situation("space").has_value());
  session.jump(session.player().steps());
  REQUIRE(session.player().proofs().size() == 1);
  CHECK(session.player().proofs()[0].text.starts_with("a plane that passes between"));
}

TEST_CASE("the name of a difference is not broken over two lines") {
  Session session = snug::test::session_of("overlap-any");
  session.jump(1);
  CHECK(session.telling().caption() == "A0\u00a0−\u00a0B0 is 2.865 from the origin.");
}
