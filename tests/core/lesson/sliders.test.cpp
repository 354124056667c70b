#include "lesson/sliders.hpp"

#include <cmath>

#include "check/check_lesson.hpp"
#include "core/lesson/lesson_files.hpp"
#include "core/lesson/small_lesson.hpp"
#include "lesson/subjects/pair/pair.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::kSmallLesson;
using snug::test::open;

namespace {

/// The small lesson with a slider. keys: those besides its title.
std::string small_with(const std::string& keys) {
  return std::string(kSmallLesson) + "\n[[slider]]\ntitle = \"Slider\"\n" + keys + "\n";
}

std::string generated_with(const std::string& keys) {
  std::string text = small_with(keys);
  const std::string list = "list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]";
  return text.replace(text.find(list), list.size(), "generate = \"cube\"\ncount = 12");
}

constexpr std::string_view kBoxes = R"(version = 2
title = "Boxes"
summary = "Boxes with sliders."
minutes = 5
algorithms = ["sat_all"]
volume = "box_pair"
[boxes]
center = [[-2, 0], [2, 0]]
half_extents = [[1, 0.5], [1, 0.5]]
turn = [[0], [30]]
[[section]]
title = "x"
text = "x"
[[slider]]
title = "Turn of B"
drives = "B turn"
from = 0
to = 360
steps = 72
)";

std::string only_mistake_of(const std::string& text) {
  const auto mistakes = check::checked_draft(text, "small.toml").mistakes;
  REQUIRE_MESSAGE(mistakes.size() == 1, (mistakes.empty() ? "none" : mistakes.back().message()));
  return mistakes.front().message();
}

double angle_of_b(const Session& session) { return session.stage().subject().numbers()[1].rows[2].values[0]; }

}  // namespace

TEST_CASE("a slider shows a number of what stands on the stage, and drives it") {
  Session session = open(std::string(kBoxes));
  REQUIRE(session.stage().sliders().size() == 1);
  CHECK(session.stage().sliders()[0].text == "30°");
  CHECK(session.stage().sliders()[0].place == 6);
  CHECK(session.stage().sliders()[0].places == 72);
  CHECK(session.stage().is_own());
  const auto before = session.player().trace_hash();
  REQUIRE(session.stage().slide_to_place(0, 20));
  CHECK(session.stage().sliders()[0].text == "100°");
  CHECK(angle_of_b(session) == doctest::Approx(100));
  CHECK(session.player().trace_hash() != before);
  CHECK(!session.stage().is_own());
  CHECK(session.stage().has_slid());
  session.stage().undo();
  CHECK(session.stage().sliders()[0].text == "30°");
  CHECK(session.player().trace_hash() == before);
}

TEST_CASE("what is read without its checks opens, though a slider has nothing to drive: it is not shown") {
  std::string text(kBoxes);
  text.replace(text.find("B turn"), 6, "B trun");
  auto lesson = read_lesson(text, "boxes.toml");
  REQUIRE(lesson);
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session);
  CHECK(session->stage().sliders().empty());
  CHECK(session->stage().slide_to_place(0, 3));
  CHECK(session->stage().is_own());
  CHECK(only_mistake_of(text).find("did you mean B turn?") != std::string::npos);
}

TEST_CASE("from one end of a slider to the other and back, the lesson's own stands again") {
  Session session = open(std::string(kBoxes));
  const auto own = session.player().trace_hash();
  for (const int place : {0, 72, 41, 6}) REQUIRE(session.stage().slide_to_place(0, place));
  CHECK(session.stage().is_own());
  CHECK(session.player().trace_hash() == own);
  CHECK(session.stage().sliders()[0].value == doctest::Approx(30));
}

TEST_CASE("a slider drives what the rows of numbers do not have: how near the near plane of a frustum is") {
  for (const char* id : {"frustum-matrix", "cases/far-plane"}) {
    CAPTURE(id);
    Session session = test::session_of(id);
    const auto own = session.player().trace_hash();
    const double start = session.stage().sliders()[0].value;
    for (const int place : {0, session.stage().sliders()[0].places}) {
      REQUIRE(session.stage().slide_to_place(0, place));
      CHECK(session.stage().sliders()[0].place == place);
      CHECK(session.player().trace_hash() != own);
      CHECK_FALSE(session.stage().is_own());
    }
    REQUIRE(session.stage().slide(0, start));
    CHECK(session.stage().is_own());
    CHECK(session.player().trace_hash() == own);
  }
}

TEST_CASE("a drag of a slider is one entry of undo, and the run follows each of its moves") {
  Session session = open(std::string(kBoxes));
  session.stage().begin_drag();
  for (int place = 7; place < 20; ++place) {
    REQUIRE(session.stage().slide_to_place(0, place));
    CHECK(angle_of_b(session) == doctest::Approx(5 * place));
  }
  session.stage().end_drag();
  session.stage().undo();
  CHECK(session.stage().is_own());
  CHECK(!session.stage().can_undo());
}

TEST_CASE("a slider follows what is edited by other means, beyond its ends as well") {
  Session session = open(std::string(kBoxes));
  const std::array<double, 1> turned{-77.5};
  REQUIRE(session.stage().set_numbers(1, 2, turned));
  CHECK(session.stage().sliders()[0].value == doctest::Approx(282.5));  // of the angles, the one between its ends
  CHECK(session.stage().sliders()[0].text == "282.5°");
  REQUIRE(session.stage().slide_to_place(0, 57));
  CHECK(angle_of_b(session) == doctest::Approx(285 - 360));
  session.stage().reset();
  CHECK(session.stage().sliders()[0].text == "30°");
}

TEST_CASE("a slider's number keeps its decimals wherever it is dragged to") {
  std::string text(kBoxes);
  text += "\n[[slider]]\ntitle = \"A to the right\"\ndrives = \"A x\"\nfrom = -3\nto = 3\nsteps = 48\n";
  Session session = open(text);
  CHECK(session.stage().sliders()[1].text == "−2.000 units");
  const auto moved_to = [&](double x) {
    REQUIRE(session.stage().set_numbers(0, 0, std::array{x, 0.0}));
    return session.stage().sliders()[1].text;
  };
  CHECK(moved_to(0.3) == "0.300 units");
  CHECK(moved_to(-0.55) == "−0.550 units");
  CHECK(moved_to(0.00125) == "0.00125 units");
}

TEST_CASE("the offset of points goes from 1 to 1e8 in equal factors, and back without a lost bit") {
  Session session = open(small_with("drives = \"offset\"\nfrom = 1\nto = 1e8\nlogarithmic = true"));
  CHECK(session.stage().is_own());
  CHECK(session.stage().sliders()[0].text == "1 unit");
  const Rows own = session.stage().subject().rows();
  CHECK(session.stage().subject().at(1)[0] == doctest::Approx(2.8));
  CHECK(session.stage().subject().at(1)[1] == doctest::Approx(0.6));
  REQUIRE(session.stage().slide_to_place(0, 80));
  CHECK(session.stage().sliders()[0].value == 1e8);
  CHECK(session.stage().subject().at(1)[0] == doctest::Approx(2 + 0.8e8));
  REQUIRE(session.stage().slide_to_place(0, 40));
  CHECK(session.stage().sliders()[0].value == 1e4);
  REQUIRE(session.stage().slide_to_place(0, 0));
  CHECK(session.stage().subject().rows() == own);
  CHECK(session.stage().is_own());
}

TEST_CASE("scale and angle are about the centroid, and several sliders hold together") {
  std::string text = small_with("drives = \"scale\"\nfrom = 0.5\nto = 4");
  text += "\n[[slider]]\ntitle = \"Angle\"\ndrives = \"angle\"\nfrom = -180\nto = 180\nsteps = 360\n";
  Session session = open(text);
  const Point3 first = session.stage().subject().at(0), second = session.stage().subject().at(1);
  REQUIRE(session.stage().slide(0, 2));
  REQUIRE(session.stage().slide(1, 90));
  const Point3 way = session.stage().subject().at(1) - session.stage().subject().at(0), before = second - first;
  CHECK(way[0] == doctest::Approx(-2 * before[1]));
  CHECK(way[1] == doctest::Approx(2 * before[0]));
  CHECK(session.stage().sliders()[0].text == "× 2.000");
  CHECK(session.stage().sliders()[1].text == "90°");
  REQUIRE(session.stage().move(0, {5, 5, 0}));  // by hand: the sliders stay, and go on from there
  CHECK(session.stage().sliders()[1].text == "90°");
  REQUIRE(session.stage().slide(1, 0));
  CHECK(session.stage().sliders()[0].text == "× 2.000");
  const Point3 after = session.stage().subject().at(2) - session.stage().subject().at(1);
  CHECK(after[0] == doctest::Approx(2 * (0 - 2)));
  CHECK(after[1] == doctest::Approx(2 * (1 - 0)));
}

TEST_CASE("jitter is the same for the same seed, and no point goes farther than it says") {
  Session session = open(small_with("drives = \"jitter\"\nfrom = 0\nto = 0.5"));
  const Rows own = session.stage().subject().rows();
  REQUIRE(session.stage().slide(0, 0.25));
  const Rows jittered = session.stage().subject().rows();
  CHECK(jittered != own);
  for (std::size_t i = 0; i < own.size(); ++i)
    for (std::size_t axis = 0; axis < 2; ++axis) CHECK(std::abs(jittered[i][axis] - own[i][axis]) <= 0.25);
  REQUIRE(session.stage().slide(0, 0.5));
  REQUIRE(session.stage().slide(0, 0.25));
  CHECK(session.stage().subject().rows() == jittered);
}

TEST_CASE("a count keeps the first points, and takes whole numbers alone") {
  Session session = open(generated_with("drives = \"count\"\nfrom = 3\nto = 20"));
  CHECK(session.stage().sliders()[0].text == "12 points");
  CHECK(session.stage().sliders()[0].places == 17);
  const Rows own = session.stage().subject().rows();
  REQUIRE(session.stage().slide_to_place(0, 1));
  CHECK(session.stage().subject().size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(session.stage().subject().rows()[i] == own[i]);
  REQUIRE(session.stage().slide_to_place(0, 17));
  CHECK(session.stage().subject().size() == 20);
  REQUIRE(session.stage().slide_to_place(0, 9));
  CHECK(session.stage().is_own());
}

TEST_CASE("after a scatter the sliders begin again, and count what is there") {
  Session session = open(generated_with("drives = \"offset\"\nfrom = 0\nto = 10"));
  REQUIRE(session.stage().slide(0, 5));
  session.stage().scatter(77);
  CHECK(session.stage().sliders()[0].value == 0);
  CHECK(!session.stage().edited());
  REQUIRE(session.stage().slide(0, 5));
  session.stage().reset();
  CHECK(session.stage().sliders()[0].value == 0);
  CHECK(session.stage().is_own());
}

TEST_CASE("a slider in hand whose points wait for its rest goes back to where it began") {
  std::string text = generated_with("drives = \"offset\"\nfrom = 0\nto = 10");
  text.replace(text.find("count = 12"), 10, "count = 1200");
  Session session = open(text);
  session.stage().give_way(true);
  session.stage().begin_drag();
  REQUIRE(session.stage().slide(0, 5));
  CHECK(session.stage().sliders()[0].value == 5);
  REQUIRE(session.stage().slide(0, 0));
  CHECK(session.stage().sliders()[0].value == 0);
  REQUIRE(session.stage().end_drag());
  CHECK(session.stage().is_own());
}

TEST_CASE("the values of sliders lead from the lesson's own to the same bits again") {
  Session session = open(small_with("drives = \"angle\"\nfrom = 0\nto = 90"));
  session.stage().begin_drag();
  for (const int place : {3, 50, 97, 31}) REQUIRE(session.stage().slide_to_place(0, place));
  session.stage().end_drag();
  Session other = open(small_with("drives = \"angle\"\nfrom = 0\nto = 90"));
  REQUIRE(other.stage().set_sliders(session.stage().slider_values()));
  CHECK(other.stage().subject().rows() == session.stage().subject().rows());
  CHECK(!other.stage().set_sliders({1, 2}));
  CHECK(!other.stage().set_sliders({std::nan("")}));
}

TEST_CASE("a value that an algorithm cannot take is refused, and nothing moves") {
  Session session = open(generated_with("drives = \"count\"\nfrom = 3\nto = 60"));
  REQUIRE(session.player().choose(0, "brute_force"));
  const Done refused = session.stage().slide(0, 50);
  REQUIRE(!refused);
  CHECK(refused.error().what == "Brute force takes at most 40 points");
  CHECK(session.stage().subject().size() == 12);
  CHECK(session.stage().sliders()[0].value == 12);
}

TEST_CASE("mistakes in sliders are told with their place") {
  CHECK(only_mistake_of(small_with("drives = \"ofset\"\nfrom = 0\nto = 1"))
            .find("\"drives\" is none of offset, jitter, scale, squeeze or angle: ofset; did you mean offset?") !=
        std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"offset\"\nfrom = 2\nto = 1")).find("\"to\" must be above \"from\"") !=
        std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"offset\"\nfrom = 0\nto = 1\nlogarithmic = true"))
            .find("of a logarithmic slider must be above 0") != std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"offset\"\nfrom = 0\nto = 1\nstart = 2")).find("\"start\" must lie") !=
        std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"scale\"\nfrom = 0\nto = 1"))
            .find("at 0 the slider cannot be drawn: a scale must be above 0") != std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"offset\"\nfrom = 0\nto = 1e300")).find("the slider cannot be drawn") !=
        std::string::npos);
  CHECK(only_mistake_of(small_with("drives = \"offset\"\nfrom = 0\nto = 1\nsteps = 0")).find("from 1 to") !=
        std::string::npos);
  std::string narrow(kBoxes);
  narrow += "\n[[slider]]\ntitle = \"Width of A\"\ndrives = \"A half x\"\nfrom = -1\nto = 1\n";
  CHECK(only_mistake_of(narrow).find("at −1 the slider cannot be drawn: a half extent is below 0") !=
        std::string::npos);
}

TEST_CASE("volumes are driven by their centres and their turns") {
  Session session = open(R"(version = 2
title = "Volumes"
summary = "Volumes with sliders."
minutes = 5
algorithms = ["gjk"]
volume = "volume_pair"
[volumes]
dim = 2
a = { obb = { center = [1, 0], half_extents = [1, 0.5], turn = [0] } }
b = { capsule = { a = [-1.9, -0.7], b = [-0.7, 0.9], radius = 0.4 } }
[[section]]
title = "x"
text = "x"
[[slider]]
title = "Turn of B"
drives = "B turn"
from = 0
to = 90
[[slider]]
title = "A to the right"
drives = "A x"
from = -3
to = 3
)");
  REQUIRE(session.stage().sliders().size() == 2);
  CHECK(session.stage().sliders()[1].value == doctest::Approx(1));
  REQUIRE(session.stage().slide(1, 2));
  CHECK(session.stage().subject().at(0)[0] == doctest::Approx(2));
  const auto before = session.player().trace_hash();
  REQUIRE(session.stage().slide(0, 45));
  CHECK(session.player().trace_hash() != before);
  CHECK(session.stage().subject().at(0)[0] == doctest::Approx(2));
}
