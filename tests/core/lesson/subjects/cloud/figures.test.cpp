#include <algorithm>

#include "core/lesson/lesson_files.hpp"
#include "core/lesson/small_lesson.hpp"
#include "trace/observer.hpp"

using namespace snug;
using namespace snug::lesson;
using test::open_small;

namespace {

const Figure* find(const std::vector<Figure>& figures, std::string_view key) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& f) { return f.key == key; });
  return found == figures.end() ? nullptr : &*found;
}

Figure figure(const Session& session, std::string_view key) {
  const auto figures = session.telling().figures();
  const Figure* found = find(figures, key);
  REQUIRE_MESSAGE(found != nullptr, key);
  return *found;
}

}  // namespace

TEST_CASE("numbers have four digits that count") {
  CHECK(number_text(0) == "0.000");
  CHECK(number_text(2.1184) == "2.118");
  CHECK(number_text(21.184) == "21.18");
  CHECK(number_text(1839) == "1,839");
  CHECK(number_text(660000) == "660,000");
  CHECK(number_text(-481287, 3) == "−481,287");
  CHECK(coordinate_text(-1839) == "−1839");
  CHECK(decimal_text(2815, 0) == "2,815");
  CHECK(decimal_text(-12345.6, 1) == "−12,345.6");
  CHECK(decimal_text(999.9, 1) == "999.9");
  CHECK(number_text(-2.5) == "−2.500");
  CHECK(number_text(0.0123456) == "0.012");
  CHECK(number_text(-0.0042345) == "−0.0042");
  CHECK(number_text(-0.0042345, 3) == "−0.0042");
  CHECK(number_text(0.0423, 3) == "0.042");
  CHECK(number_text(1.5e-9) == "1.500 × 10⁻⁹");
  CHECK(number_text(1e150) == "1.000 × 10¹⁵⁰");
  CHECK(with_unit(1, "points") == "1 point");
  CHECK(with_unit(1, "vertices") == "1 vertex");
  CHECK(with_unit(1, "boxes") == "1 box");
  CHECK(with_unit(1, "units²") == "1 unit²");
  CHECK(with_unit(3, "axes") == "3 axes");
  CHECK(with_unit(1, "%") == "1 %");
  CHECK(with_unit(0.5, "") == "0.5");
  CHECK(percent_text(0.091) == "+9.1 %");
  CHECK(percent_text(-0.2) == "−20.0 %");
  CHECK(percent_text(1e-9) == "0.0 %");
  CHECK(looseness_text(0.35) == "+35.0 %");
  CHECK(looseness_text(3.8467) == "+385 %");
  CHECK(looseness_text(18.85) == "+1,885 %");
  CHECK(count_text(0) == "0");
  CHECK(count_text(999) == "999");
  CHECK(count_text(1839) == "1,839");
  CHECK(count_text(475004613501) == "475,004,613,501");
}

TEST_CASE("two numbers have the digits that tell them apart") {
  using Texts = std::pair<std::string, std::string>;
  CHECK(number_texts_apart(2.25, 2.5) == Texts{"2.250", "2.500"});
  CHECK(number_texts_apart(0.99214, 0.99208) == Texts{"0.99214", "0.99208"});
  CHECK(number_texts_apart(1234.4, 1234.3) == Texts{"1,234.4", "1,234.3"});
  CHECK(number_texts_apart(2.25, std::nextafter(2.25, 3.0)) == Texts{"2.250", "2.250"});
}

TEST_CASE("the figures of a place in the run") {
  Session session = open_small();
  CHECK(find(session.telling().figures(), "radius") == nullptr);
  CHECK(figure(session, "distance_tests").value == 0);

  session.jump(7);  // P4 was examined and lies outside
  CHECK(figure(session, "radius").text == "2.000 units");
  CHECK(figure(session, "radius").name == "Radius so far");
  CHECK(figure(session, "excess").text == "—");  // it is smaller than the optimum, but does not hold all points
  CHECK_FALSE(figure(session, "excess").known);
  CHECK(figure(session, "outside").text == "1 of 6");
  CHECK(figure(session, "seen").text == "5 of 6");
  CHECK(figure(session, "outside_by").value == doctest::Approx(0.5));
  CHECK(figure(session, "support").text == "2 points");
  CHECK(figure(session, "support").name == "Found on the boundary");  // others may lie there too

  session.jump(8);  // the circle grew to it
  CHECK(figure(session, "radius").value == 2.25);
  CHECK(figure(session, "outside").value == 0);
  CHECK(find(session.telling().figures(), "outside_by") == nullptr);
  session.jump(session.player().steps());
  CHECK(figure(session, "radius").name == "Radius");
  CHECK(figure(session, "excess").text == "+9.8 %");
  CHECK(figure(session, "excess").known);
  CHECK(figure(session, "excess").value == doctest::Approx(100 * (2.25 / 2.05 - 1)));
  REQUIRE(session.player().choose(0, "welzl").has_value());
  CHECK(figure(session, "support").name == "Support set");
}

TEST_CASE("operations: those that the algorithm spends, the same rows at every step, never falling") {
  Session session = open_small();
  for (const char* algorithm : {"ritter", "pca", "welzl", "brute_force"}) {
    REQUIRE(session.player().choose(0, algorithm).has_value());
    std::vector<std::string> keys;
    double before = 0;
    for (int step = 0; step <= session.player().steps(); ++step) {
      session.jump(step);
      std::vector<std::string> now;
      for (const Figure& f : session.telling().figures())
        if (std::find(kOperationNames.begin(), kOperationNames.end(), f.key) != kOperationNames.end())
          now.push_back(f.key);
      if (step == 0) keys = now;
      CHECK(now == keys);
      CHECK(figure(session, "distance_tests").value >= before);
      before = figure(session, "distance_tests").value;
    }
    CHECK(keys.size() >= 2);
    CHECK(before > 0);
  }
  CHECK(find(session.telling().figures(), "dot_products") == nullptr);
}

TEST_CASE("the points that a sum of products has touched are counted as it grows") {
  for (const char* const way : {"pca_sums", "pca_one_pass"}) {
    CAPTURE(way);
    Session session = test::session_of("covariance");
    REQUIRE(session.player().choose(0, way).has_value());
    session.jump(2);
    for (int step = 3; step < 8; ++step) {
      const double before = figure(session, "points_touched").value;
      session.jump(step);
      CHECK(figure(session, "points_touched").value == before + 1);
    }
  }
}

TEST_CASE("the statistics have their figures where they are found") {
  Session session = test::open(test::small_lesson_with("\"welzl\", ", "\"welzl\", \"pca\", "));
  REQUIRE(session.player().choose(0, "pca").has_value());
  session.jump(1);
  CHECK(figure(session, "mean_x").value == doctest::Approx(0.5 / 6));
  CHECK(figure(session, "mean_y").value == doctest::Approx(2.7 / 6));
  CHECK(find(session.telling().figures(), "mean_z") == nullptr);
  session.jump(3);
  const double first = figure(session, "variance_1").value;
  const double second = figure(session, "variance_2").value;
  CHECK(first >= second);
  CHECK(second > 0);
  CHECK(figure(session, "deviation_1").value == doctest::Approx(std::sqrt(first)));
  CHECK(find(session.telling().figures(), "variance_3") == nullptr);
}

TEST_CASE("the proof: what is claimed, and whether it holds") {
  Session session = open_small();
  CHECK(session.player().proofs().empty());
  session.jump(2);
  auto proofs = session.player().proofs();
  REQUIRE(proofs.size() == 2);
  CHECK(proofs[0].text == "contains 5 of 6 points");
  CHECK_FALSE(proofs[0].holds);
  CHECK(proofs[1].holds);
  session.jump(session.player().steps());
  proofs = session.player().proofs();
  REQUIRE(proofs.size() == 3);
  CHECK(proofs[0].text == "contains all 6 points, exactly");
  CHECK(proofs[0].holds);
  CHECK_FALSE(proofs[2].claimed);

  REQUIRE(session.player().choose(0, "welzl").has_value());
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    for (const Proof& proof : session.player().proofs())
      if (proof.claimed) CHECK_MESSAGE(proof.holds, proof.text, " at ", step);
  }
  proofs = session.player().proofs();
  REQUIRE(proofs.size() == 3);
  CHECK(proofs[2].claimed);
  CHECK(proofs[2].holds);
}

TEST_CASE("the last line of the proof says what makes a volume of its kind the smallest") {
  const auto says = [](std::string_view volume, std::string_view algorithm) {
    constexpr std::string_view kHead = R"(version = 2
title = "Small"
summary = "A lesson for tests."
minutes = 1
)";
    constexpr std::string_view kPoints = R"(
[points]
list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]
[[section]]
title = "First"
text = "A **term**."
)";
    std::string text(kHead);
    text.append("volume = \"").append(volume).append("\"\nalgorithms = [\"").append(algorithm).append("\"]\n");
    Session session = test::open(text.append(kPoints));
    session.jump(session.player().steps());
    const Proof last = session.player().proofs().back();
    CHECK(last.claimed);
    CHECK(last.holds);
    const auto figures = session.telling().figures();
    const Figure* over = find(figures, "excess");
    CHECK((over == nullptr || over->text == "0.0 %"));
    return last.text;
  };
  CHECK(says("aabb", "min_max") == "no smaller AABB: a point lies on each side");
  CHECK(says("obb", "exact") == "no smaller box: no orientation does better");
  CHECK(says("kdop", "k8") == "no smaller k-DOP with these directions");
  CHECK(says("kdop", "k6") == "no smaller k-DOP with these directions");

  CHECK(says("hull", "quickhull") == "no smaller convex set contains the points");
}

TEST_CASE("a k-DOP is supported by the points of all slabs so far, and its sentence names the direction") {
  Session session = test::open(R"(version = 2
title = "Small"
summary = "A lesson for tests."
minutes = 1
volume = "kdop"
algorithms = ["k8"]
[points]
list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0.5, 2.5], [0.5, 0.2]]
[[section]]
title = "First"
text = "A **term**."
)");
  const auto supported = [&](int step) {
    session.jump(step);
    CHECK(session.telling().caption().find(": nothing") == std::string::npos);
    const auto figures = session.telling().figures();
    const Figure* support = find(figures, "support");
    return support != nullptr ? support->text : "none";
  };
  CHECK(supported(1) == "none");  // there is no volume yet
  CHECK(supported(2) == "4 points");
  CHECK(supported(3) == "4 points");
  CHECK(session.telling().caption() == "Slab 3 lies between P0 and P4, the extremes along x+y.");
  CHECK(session.player().support(0) == std::vector<Index>{0, 1, 3, 4});
  CHECK(supported(4) == "4 points");
  CHECK(session.telling().caption().find("along x−y.") != std::string::npos);
}

TEST_CASE("how many facets an eye sees is known where its horizon is found, and never none") {
  Session session = test::open(R"(version = 2
title = "Hull"
summary = "A hull."
minutes = 1
volume = "hull"
algorithms = ["quickhull"]
[points]
dim = 3
generate = "cube"
count = 14
[[section]]
title = "One"
text = "Words."
)");
  int found = 0;
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    const bool known = session.player().run(0).fact(step - 1) == "horizon_found";
    found += known ? 1 : 0;
    const auto figures = session.telling().figures();
    const Figure* seen = find(figures, "seen_facets");
    if (seen != nullptr) CHECK_MESSAGE(seen->known == known, step);
    if (known) CHECK(seen->value > 0);
  }
  CHECK(found > 0);
}

TEST_CASE("a support set of no points is not counted") {
  Session session = open_small();
  session.jump(1);
  for (int step = 1; step <= session.player().steps(); ++step) {
    session.jump(step);
    for (const Figure& f : session.telling().figures())
      if (f.key == "support") CHECK_MESSAGE(f.known == (f.value > 0), step);
  }
}

TEST_CASE("figures and proofs are there at every step of every algorithm, also of a thousand points and of one") {
  Session session = open_small();
  for (const int count : {1, 2, 300}) {
    REQUIRE(session.stage().set_generator("gaussian", count, 3, 11).has_value());
    for (const char* algorithm : {"aabb_center", "ritter", "ritter_iterative", "pca", "welzl"}) {
      REQUIRE(session.player().choose(0, algorithm).has_value());
      const int stride = 1 + session.player().steps() / 60;
      for (int step = 0; step <= session.player().steps(); step += stride) {
        session.jump(step);
        for (const Figure& f : session.telling().figures()) {
          CHECK(std::isfinite(f.value));
          CHECK_FALSE(f.text.empty());
        }
        static_cast<void>(session.player().proofs());
      }
      session.jump(session.player().steps());
      CHECK(figure(session, "outside").value == 0);
      CHECK(session.player().proofs().front().holds);
    }
  }
}
