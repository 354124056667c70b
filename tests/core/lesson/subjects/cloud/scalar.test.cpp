// Float or double: a choice like any other edit, which loses none of the points' digits.
#include <cmath>
#include <limits>

#include "check/check_lesson.hpp"
#include "core/lesson/small_lesson.hpp"
#include "fit/catalogue.hpp"
#include "geometry/random.hpp"
#include "lesson/subjects/cloud/break_it.hpp"
#include "lesson/subjects/cloud/volume_check.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::kSmallLesson;
using snug::test::open;

namespace {

std::string with(std::string text, const std::string& old, const std::string& now) {
  return text.replace(text.find(old), old.size(), now);
}

/// The small lesson with a point that float cannot hold, and a slider.
std::string with_fraction() {
  return with(std::string(kSmallLesson), "[0.5, 0.2]]", "[0.5, 0.1]]") +
         "\n[[slider]]\ntitle = \"Offset\"\ndrives = \"offset\"\nfrom = 0\nto = 1000\n";
}

constexpr double kExact = 0.1;
const double kRounded = static_cast<double>(0.1f);

double fraction(const Session& session) { return session.stage().subject().at(5)[1]; }

}  // namespace

TEST_CASE("in float the points are rounded; double shows them as they were, and undo goes back") {
  Session session = open(with_fraction());
  const std::uint64_t in_double = session.player().trace_hash();
  REQUIRE(session.stage().set_float(true));
  CHECK(fraction(session) == kRounded);
  CHECK(session.stage().subject().rows()[5][1] == kExact);
  CHECK(session.player().trace_hash() != in_double);
  CHECK_FALSE(session.stage().edited());
  CHECK_FALSE(session.stage().is_own());
  REQUIRE(session.stage().set_float(false));
  CHECK(fraction(session) == kExact);
  CHECK(session.player().trace_hash() == in_double);
  session.stage().undo();
  CHECK(session.stage().subject().in_float());
  CHECK(fraction(session) == kRounded);
  session.stage().undo();
  CHECK_FALSE(session.stage().subject().in_float());
  CHECK_FALSE(session.stage().can_undo());
}

TEST_CASE("float is kept by drags, sliders and scattering, and given up by a reset") {
  Session session = open(with_fraction());
  REQUIRE(session.stage().slide(0, 10));  // the next slide begins at what stood before, in float from then on
  REQUIRE(session.stage().set_float(true));
  REQUIRE(session.stage().slide(0, 20));
  CHECK(session.stage().subject().in_float());
  REQUIRE(session.stage().slide(0, 0));
  CHECK(session.stage().subject().in_float());
  CHECK(fraction(session) == kRounded);
  REQUIRE(session.stage().move(0, {kExact, kExact, 0}));
  CHECK(session.stage().subject().at(0)[0] == kRounded);
  session.stage().scatter(9);
  CHECK(session.stage().subject().in_float());
  CHECK(session.stage().subject().at(3)[0] ==
        static_cast<double>(static_cast<float>(session.stage().subject().at(3)[0])));
  session.stage().start_task();
  CHECK(session.stage().subject().in_float());
  session.stage().reset();
  CHECK_FALSE(session.stage().subject().in_float());
}

TEST_CASE("a squeeze brings points as near to a line as it says, and back to the last bit") {
  Session session = open(std::string(kSmallLesson) +
                         "\n[[slider]]\ntitle = \"Squeeze\"\ndrives = \"squeeze\"\nfrom = 1e-9\nto = 1\nstart = 1\n");
  const auto across = [&](Index i) {  // from the first point, at a right angle to the line
    const Point3 offset = session.stage().subject().at(i) - session.stage().subject().at(0);
    return offset[0] * -0.6 + offset[1] * 0.8;
  };
  std::vector<double> before;
  for (Index i = 0; i < session.stage().subject().size(); ++i) before.push_back(across(i));
  REQUIRE(session.stage().slide(0, 1e-3));
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    CHECK(across(i) == doctest::Approx(1e-3 * before[i]).epsilon(1e-9));
  CHECK(session.stage().subject().at(1)[0] - session.stage().subject().at(0)[0] ==
        doctest::Approx(4 * 0.8 * 0.8).epsilon(1e-2));
  REQUIRE(session.stage().slide(0, 1));
  CHECK(session.stage().is_own());
}

TEST_CASE("what float cannot hold is refused, and nothing changes") {
  Session session = open(std::string(kSmallLesson));
  REQUIRE(session.stage().move(0, {1e30, 0, 0}));
  CHECK_FALSE(session.stage().set_float(true));
  CHECK(session.stage().subject().at(0)[0] == 1e30);
  session.stage().undo();
  REQUIRE(session.stage().set_float(true));
  CHECK_FALSE(session.stage().move(0, {1e30, 0, 0}));
  CHECK(session.stage().subject().at(0)[0] == -2);
  CHECK_FALSE(session.stage().set_rows({{0, 0}, {1e30, 0}}));
  CHECK(session.stage().subject().size() == 6);
}

TEST_CASE("a lesson's file chooses the scalar of its points, for a cloud alone") {
  const std::string in_float = with(std::string(kSmallLesson), "dim = 2", "dim = 2\nscalar = \"float\"");
  Session session = open(in_float);
  CHECK(session.stage().subject().in_float());
  CHECK(session.stage().is_own());
  REQUIRE(session.stage().set_float(false));
  session.stage().reset();
  CHECK(session.stage().subject().in_float());
  const Draft draft = check::checked_draft(with(in_float, "\"float\"", "\"half\""), "small.toml");
  REQUIRE(draft.mistakes.size() == 1);
  CHECK(draft.mistakes[0].message().find("\"float\" or \"double\"") != std::string::npos);
}

TEST_CASE_TEMPLATE("how far a point is outside is told in ulps of the radius and of the size", Scalar, float, double) {
  const Scalar one_up = std::nextafter(Scalar(1), Scalar(2)), step = one_up - 1;
  const AnyPointSet points = *PointSet<Scalar, 2>::make({{0, 0}, {one_up, 0}, {0, -1}, {0, 1 + 3 * step}, {8, 0}});
  LeftOutside left = left_outside(points, {Point3(0, 0, 0), 1});
  CHECK(left.points == std::vector<Index>{1, 3, 4});
  CHECK(left.worst == 4);
  const AnyPointSet near = *PointSet<Scalar, 2>::make({{0, 0}, {one_up, 0}, {0, -1}, {0, 1 + 3 * step}, {-1, 0}});
  left = left_outside(near, {Point3(0, 0, 0), 1});
  CHECK(left.points == std::vector<Index>{1, 3});
  CHECK(left.worst == 3);
  CHECK(left.ulps() == doctest::Approx(3).epsilon(1e-6));
  CHECK(left.by / left.size_ulp == doctest::Approx(3).epsilon(1e-6));
  CHECK(left_outside(near, {Point3(0, 0, 0), 1 + 3 * static_cast<double>(step)}).points.empty());
}

TEST_CASE_TEMPLATE("a radius of 0 has no ulp, so how far a point is outside it is told in units", Scalar, float,
                   double) {
  const AnyPointSet points = *PointSet<Scalar, 2>::make({{0, 0}, {Scalar(0.25), 0}});
  const LeftOutside left = left_outside(points, {Point3(0, 0, 0), 0});
  CHECK(left.points == std::vector<Index>{1});
  CHECK(std::isinf(left.ulps()));
  CHECK(worst_text(left, " of the radius") == "0.25 units");
  CHECK(worst_text(left_outside(points, {Point3(0, 0, 0), 0.125}), " of the radius").ends_with(" ulps of the radius"));
  const AnyPointSet one_place = *PointSet<Scalar, 2>::make({{1, 1}, {1, 1}});
  CHECK(left_outside(one_place, {Point3(1, 1, 0), 0}).ulps() == 0);
}

TEST_CASE("a point that is seen outside is counted, however much rounding would excuse") {
  const float far = 1e7f;  // an ulp is 1
  const AnyPointSet points = *PointSet<float, 2>::make({{far, 0}, {far + 2, 0}, {far + 1, 2}});
  CHECK(count_outside(points, fit::Sphere3{Point3(1e7 + 1, 0, 0), 1}) == 1);
  const AnyPointSet near = *PointSet<float, 2>::make({{1, 1}, {1, 1}, {1 + 0x1p-21f, 1}});
  CHECK(count_outside(near, fit::Sphere3{Point3(1, 1, 0), 0}) == 1);
  const AnyPointSet unit = *PointSet<float, 2>::make({{-1, 0}, {1, 0}, {0, 1}});
  CHECK(count_outside(unit, fit::Sphere3{Point3(0, 0, 0), 1 - 0x1p-24}) == 0);  // by an ulp
}

TEST_CASE("a ball that a distance's own rounding would call right is told by exact arithmetic") {
  // The point lies outside by a few thousandths of an ulp, which no distance in double shows.
  const double radius = std::sqrt(2.0);
  const AnyPointSet points = *PointSet<double, 2>::make({{1, 1}});
  const bool outside = radius * radius < 2 || std::fma(radius, radius, -2.0) < 0;
  const LeftOutside left = left_outside(points, {Point3(0, 0, 0), radius});
  CHECK(left.points.size() == (outside ? 1 : 0));
  const LeftOutside below = left_outside(points, {Point3(0, 0, 0), std::nextafter(radius, 0)});
  REQUIRE(below.points.size() == 1);
  CHECK(below.ulps() > 0);
  CHECK(below.ulps() < 1);
}

TEST_CASE("a finished run's certificate comes with its numbers, where a naive method is offered") {
  const std::string naive = with(std::string(kSmallLesson), "\"brute_force\"]", "\"welzl_naive\"]");
  Session session = open(naive);
  REQUIRE(session.player().choose(0, "welzl"));
  session.last();
  const auto value = [&](std::string_view key) {
    for (const Figure& figure : session.stage().subject().figures(session.player().view()))
      if (figure.key == key) return figure.value;
    return -1.0;
  };
  // The circle of (-2, 0), (2, 0) and (0, 2.5) is about (0, 0.45): 0.45 / 2.5 = 0.18, and half of the rest each.
  CHECK(value("least_weight") == doctest::Approx(0.18).epsilon(1e-12));
  CHECK(value("weight_1") + value("weight_2") + value("weight_3") == doctest::Approx(1).epsilon(1e-12));
  CHECK(value("lower_bound") == doctest::Approx(2.05).epsilon(1e-12));
  CHECK(value("boundary_ulps") <= 2);
  CHECK(std::max({std::abs(value("off_1")), std::abs(value("off_2")), std::abs(value("off_3"))}) ==
        value("boundary_ulps"));
  CHECK(value("off_1") <= 0);  // none is outside
  CHECK(value("widened_ulps") >= 0);
  CHECK(value("outside_count") == 0);
  CHECK(value("outside") == -1);
  CHECK(value("steps") == session.player().steps());
  session.go(session.player().step() - 1);
  CHECK(value("steps") == -1);
}

TEST_CASE("which point is left outside is asked of the finished run, and none is an answer") {
  const std::string asks =
      with(with(std::string(kSmallLesson), "\"brute_force\"]", "\"welzl_naive\"]"), "dim = 2", "scalar = \"float\"") +
      "\n[[question]]\nid = \"lost\"\nalgorithm = \"welzl_naive\"\nbefore = \"finished\"\nasks = \"outside\"\n"
      "prompt = \"Which?\"\nbecause = \"So.\"\n";
  Session session = open(asks);
  REQUIRE(session.player().choose(0, "welzl_naive"));
  session.last();
  REQUIRE(session.conversation().asked() != nullptr);
  const LeftOutside left =
      left_outside(*session.stage().subject().points(),
                   *std::get_if<fit::Sphere3>(session.player().run(0).volume(session.player().steps())));
  REQUIRE(session.conversation().pick(left.points.empty() ? "none" : session.stage().subject().name_of(left.worst)));
  REQUIRE(session.conversation().commit());
  REQUIRE(session.log().outcomes().size() == 1);
  CHECK(session.log().outcomes()[0].right);
}

TEST_CASE("the goal of breaking it is judged on the same points in both scalars") {
  int reached = 0, wrong_in_both = 0, right_in_both = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<Vector<double, 2>> points(4);
    for (auto& point : points) point = {random.between(-2, 2), random.between(-2, 2)};
    const AnyPointSet set = *PointSet<double, 2>::make(std::move(points));
    const ScalarsCompared compared = compare_scalars(kCloudGoals[0], set, 1);
    REQUIRE(compared.fits);
    const bool in_float = compared.in_float.points.empty(), in_double = compared.in_double.points.empty();
    CHECK(breaks(compared) == (!in_float && in_double));
    reached += breaks(compared) ? 1 : 0, wrong_in_both += !in_float && !in_double ? 1 : 0;
    right_in_both += in_float && in_double ? 1 : 0;
  }
  CHECK(reached > 0);
  CHECK(wrong_in_both > 0);
  CHECK(right_in_both > 0);
  CHECK_FALSE(breaks(compare_scalars(kCloudGoals[0], *PointSet<double, 2>::make({{1e30, 0}, {0, 0}}), 1)));
}

TEST_CASE("what a hull leaves outside, and where it turns inward, is judged exactly on its own vertices") {
  const AnyPointSet points = *PointSet<double, 2>::make({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1.5, 0.5}, {1, 1.5}});
  CHECK(left_outside_hull(points, std::vector<Index>{0, 1, 2, 3}).none());
  const LeftOutside lost = left_outside_hull(points, std::vector<Index>{0, 4, 2, 3});
  CHECK(lost.points == std::vector<Index>{1});
  CHECK(lost.by == doctest::Approx(std::sqrt(0.5)).epsilon(1e-15));
  CHECK(lost.extent == 1);
  CHECK(lost.dents.empty());
  const LeftOutside dented = left_outside_hull(points, std::vector<Index>{0, 1, 2, 5, 3});
  CHECK(dented.points.empty());
  CHECK(dented.dents == std::vector<Index>{5});
  CHECK_FALSE(dented.none());
  // By one bit: the lower left half of a square, and a point beyond its long side.
  const AnyPointSet near =
      *PointSet<double, 2>::make({{0, 0}, {1, 0}, {0, 1}, {0.5, std::nextafter(0.5, 1)}, {0.5, 0.5}});
  const LeftOutside bit = left_outside_hull(near, std::vector<Index>{0, 1, 2});
  CHECK(bit.points == std::vector<Index>{3});
  CHECK(bit.by == doctest::Approx(0x1p-53 * std::sqrt(0.5) * 1).epsilon(1e-6));
}

TEST_CASE("the goal of breaking a hull is judged on the same points in both scalars") {
  int reached = 0, right = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::vector<Vector<double, 2>> points;
    for (int i = 0; i < 4; ++i) {
      const double x = static_cast<double>(random.below(41)) / 10 - 2;
      points.emplace_back(x, (seed % 2 == 0 ? 0.75 : 1.0) * x);
    }
    const ScalarsCompared compared =
        compare_scalars("hull_wrong_in_float_alone", *PointSet<double, 2>::make(points), 1);
    REQUIRE(compared.fits);
    reached += breaks(compared) ? 1 : 0, right += compared.in_float.none() ? 1 : 0;
  }
  CHECK(reached > 5);
  CHECK(right > 5);
  CHECK_FALSE(compare_scalars("hull_wrong_in_float_alone", *PointSet<double, 3>::make({{0, 0, 0}}), 1).fits);
}
