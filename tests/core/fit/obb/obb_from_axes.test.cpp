// The box of given axes, and the axes of a box.
#include "fit/obb/obb_from_axes.hpp"

#include <doctest/doctest.h>

#include "core/at_random.hpp"
#include "core/point_clouds.hpp"
#include "fit/obb/obb_frame.hpp"
#include "fit/obb/obb_trials.hpp"
#include "geometry/sphere.hpp"
#include "geometry/turn.hpp"
#include "number/exact_tally.hpp"
#include "query/contain/contains.hpp"

using namespace snug;

namespace {

template <int Dim>
Matrix<double, Dim> any_axes(Random& random) {
  if constexpr (Dim == 2) return fit::frame(Vector<double, 2>(random.between(-1, 1), random.between(-1, 1)));
  else return fit::frame(test::any_direction(random), test::any_direction(random));
}

template <class Scalar, int Dim>
struct Judged {
  Index outside = 0;
  bool tight = true;  // no half extent could be one step smaller
};

template <class Scalar, int Dim>
Judged<Scalar, Dim> judge(const Obb<Scalar, Dim>& box, PointSpan<Scalar, Dim> points) {
  Judged<Scalar, Dim> judged;
  for (const auto& p : points) judged.outside += query::contains(box, p) ? 0 : 1;
  for (int axis = 0; axis < Dim; ++axis) {
    const Scalar half = box.half_extents[axis];
    bool needed = half == 0;
    for (const auto& p : points)
      needed = needed ||
               query::side_of_slab<Scalar, Dim>(p, box.center, box.axes.col(axis), std::nextafter(half, Scalar(0))) > 0;
    judged.tight = judged.tight && needed;
  }
  return judged;
}

template <class Scalar, int Dim>
void check(const std::string& name, const test::Cloud<Scalar, Dim>& cloud, std::uint64_t seed) {
  INFO(name << ", " << cloud.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  const auto set = test::set_of<Scalar, Dim>(cloud);
  Random random(seed);
  for (int turn = 0; turn < 3; ++turn) {
    Matrix<double, Dim> axes = Matrix<double, Dim>::Identity();
    if (turn > 0) axes = any_axes<Dim>(random);
    const auto found = fit::obb_from_axes<Scalar, Dim>(axes.template cast<Scalar>(), set.span());
    const auto judged = judge(found.box, set.span());
    CHECK(judged.outside == 0);
    CHECK(judged.tight);
    // A point that reaches farthest may be off its face by the rounding of the centre and of the projection.
    double size = 0;
    for (const auto& p : cloud) size = std::max(size, static_cast<double>(scaled_norm<Scalar, Dim>(p)));
    for (int axis = 0; axis < Dim; ++axis)
      for (const Index i : {found.least[axis], found.greatest[axis]}) {
        const Vector<double, Dim> from = cloud[i].template cast<double>() - found.box.center.template cast<double>();
        const double gap = std::abs(from.dot(found.box.axes.col(axis).template cast<double>())) -
                           static_cast<double>(found.box.half_extents[axis]);
        CHECK(std::abs(gap) <= 16 * tolerance::roundoff<Scalar>(size));
      }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("a box on given axes holds every point exactly", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const int n : {1, 4, 30}) {
      for (const auto& [name, cloud] : test::degenerate_clouds<Scalar, 2>(seed, n)) check<Scalar, 2>(name, cloud, seed);
      for (const auto& [name, cloud] : test::degenerate_clouds<Scalar, 3>(seed, n)) check<Scalar, 3>(name, cloud, seed);
    }
  for (const auto kind : generator_kinds()) {
    const std::string name(kind);
    check<Scalar, 2>(name, test::generated<Scalar, 2>(name.c_str(), 3000, 1), 2);
    check<Scalar, 3>(name, test::generated<Scalar, 3>(name.c_str(), 3000, 1), 2);
  }
}

TEST_CASE("a box on given axes holds tiny, huge and far points") {
  for (const double scale : {1e-320, 1e-300, 1e-160, 1e-150, 1e-20, 1e20, 1e150})
    for (const char* kind : {"cube", "sphere", "lattice", "line"}) {
      check<double, 2>(kind, test::generated<double, 2>(kind, 50, 1, scale), 3);
      check<double, 3>(kind, test::generated<double, 3>(kind, 50, 1, scale), 3);
    }
  for (const double offset : {1e3, 1e8, -1e15})
    for (const char* kind : {"cube", "sphere", "lattice", "line"})
      check<double, 3>(kind, test::generated<double, 3>(kind, 50, 1, 1, offset), 4);
  for (const double scale : {1e-42, 1e-30, 1e-15, 1e15, 1e17})
    check<float, 3>("cube", test::generated<float, 3>("cube", 50, 1, scale), 5);
}

TEST_CASE("where very many points lie on a face, a half extent is at most one step wider") {
  test::Cloud<double, 3> cloud;
  const Matrix<double, 3> turned = turn({1, 2, 3}, 0.7);
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 120; ++j)
      for (const int k : {-1, 1}) cloud.push_back(turned * Vector<double, 3>(i * 0.01, j * 0.01, k));
  const auto set = test::set_of<double, 3>(cloud);
  const Obb<double, 3> box = fit::obb_from_axes<double, 3>(turned, set.span()).box;
  CHECK(judge(box, set.span()).outside == 0);
  CHECK(box.half_extents[2] == doctest::Approx(1).epsilon(1e-15));

  const auto lattice = test::set_of<double, 3>(test::generated<double, 3>("lattice", 27000, 1));
  const Obb<double, 3> cube = fit::obb_from_axes<double, 3>(Matrix<double, 3>::Identity(), lattice.span()).box;
  CHECK(judge(cube, lattice.span()).outside == 0);
  CHECK(cube.half_extents.maxCoeff() <= std::nextafter(1.0, 2.0));
}

TEST_CASE_TEMPLATE("along the coordinates, whichever axis runs along which, nothing is decided exactly", Scalar, float,
                   double) {
  const auto set = test::set_of<Scalar, 3>(test::generated<Scalar, 3>("lattice", 1000, 1, 0.1, 3));
  Matrix<Scalar, 3> axes;
  axes << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const std::int64_t before = exact_decisions;
  const auto found = fit::obb_from_axes<Scalar, 3>(axes, set.span());
  CHECK(exact_decisions == before);
  CHECK(fit::along_coordinates<Scalar, 3>(axes));
  const auto judged = judge(found.box, set.span());
  CHECK(judged.outside == 0);
  CHECK(judged.tight);
  for (int axis = 0; axis < 3; ++axis) {
    const auto along = [&](Index i) { return axes.col(axis).dot(set[i]); };
    CHECK(along(found.least[axis]) < along(found.greatest[axis]));
  }
}

TEST_CASE("a half extent is 0 just where the points are flat exactly") {
  test::Cloud<double, 3> cloud{{0, 0, 0.1}, {1, 0, 0.1}, {0, 1, 0.1}, {3, 2, 0.1}};
  const auto half = [&] {
    return fit::obb_from_axes<double, 3>(Matrix<double, 3>::Identity(), test::set_of<double, 3>(cloud).span())
        .box.half_extents[2];
  };
  CHECK(half() == 0);
  cloud[1][2] = std::nextafter(0.1, 1.0);
  CHECK(half() > 0);
}

TEST_CASE("axes from any two directions are unit, perpendicular and right-handed, and the first is along the first") {
  Random random(7);
  int parallel = 0;
  for (int turn = 0; turn < 3000; ++turn) {
    Vector<double, 3> first = test::any_direction(random), second = test::any_direction(random);
    switch (turn % 6) {
      case 0: first *= 1e-300; break;
      case 1: second *= 1e300; break;
      case 2: second = 3 * first; break;
      case 3: second = first + 1e-12 * second; break;
      case 4: second.setZero(); break;
      default: break;
    }
    if (turn % 37 == 0) first.setZero();
    const Matrix<double, 3> axes = fit::frame(first, second);
    CHECK((axes.transpose() * axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff() <=
          8 * tolerance::kRoundoff<double>);
    CHECK(axes.determinant() > 0.999);
    if (first.isZero(0)) continue;
    const Vector<double, 3> unit = fit::unit<3>(first);
    CHECK((axes.col(0) - unit).norm() <= 4 * tolerance::kRoundoff<double>);
    const double sine = unit.cross(fit::unit<3>(second)).norm();
    if (sine > 1e-11) CHECK(axes.col(1).dot(fit::unit<3>(second)) > 0.999 * sine);
    else ++parallel;
  }
  CHECK(parallel > 500);
}

TEST_CASE("among flat boxes the smaller area is better") {
  // A unit square on a tilted plane, whose rounded corners span some thickness along any rounded axis.
  const Matrix<double, 3> tilt = turn({1, 0.3, 0.2}, 1);
  test::Cloud<double, 3> square;
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) square.push_back(tilt * Vector<double, 3>(x, y, 0));
  Random random(3);
  Ignore ignore;
  for (int turn = 0; turn < 200; ++turn) {
    fit::ObbTrials<double, 3, Ignore> trials(square, ignore);
    const Vector<double, 3> askew(random.between(0.1, 1), random.between(0.1, 1), 0);
    trials.attempt(fit::frame(tilt.col(2), tilt * askew), std::array<Index, 0>{}, 0);
    CHECK(trials.attempt(fit::frame(tilt.col(2), tilt.col(0)), std::array<Index, 0>{}, 0));
    CHECK_FALSE(trials.attempt(fit::frame(tilt.col(2), tilt * askew), std::array<Index, 0>{}, 0));
  }
}
