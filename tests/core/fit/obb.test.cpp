// What every box fitter promises, on every cloud, and what each is known to be worth.
#include <doctest/doctest.h>

#include "core/exact.hpp"
#include "core/point_clouds.hpp"
#include "fit/certify_obb.hpp"
#include "fit/obb_aabb.hpp"
#include "fit/obb_dito.hpp"
#include "fit/obb_exact.hpp"
#include "fit/obb_face_aligned.hpp"
#include "fit/obb_pca.hpp"
#include "fit/obb_pca_hull.hpp"
#include "fit/obb_pca_hull_area.hpp"
#include "fit/obb_pca_rectangle.hpp"
#include "fit/obb_sphere_axis.hpp"
#include "geometry/turn.hpp"
#include "query/contains.hpp"

using namespace snug;

namespace {

/// Calls see(name, fitter, lines of its pseudocode, whether it claims the smallest box) for each fitter.
void for_each_fitter(auto&& see) {
  see("aabb", [](auto p, auto& o) { return fit::obb_aabb(p, o); }, fit::kObbAabbPseudocode.size(), false);
  see("sphere_axis", [](auto p, auto& o) { return fit::obb_sphere_axis(p, o); }, fit::kObbSphereAxisPseudocode.size(), false);
  see("pca", [](auto p, auto& o) { return fit::obb_pca(p, o); }, fit::kObbPcaPseudocode.size(), false);
  see("pca_hull", [](auto p, auto& o) { return fit::obb_pca_hull(p, o); }, fit::kObbPcaHullPseudocode.size(), false);
  see("pca_hull_area", [](auto p, auto& o) { return fit::obb_pca_hull_area(p, o); }, fit::kObbPcaHullAreaPseudocode.size(), false);
  see("pca_rectangle", [](auto p, auto& o) { return fit::obb_pca_rectangle(p, o); }, fit::kObbPcaRectanglePseudocode.size(), false);
  see("face_aligned", [](auto p, auto& o) { return fit::obb_face_aligned(p, o); }, fit::kObbFaceAlignedPseudocode.size(), false);
  see("exact", [](auto p, auto& o) { return fit::obb_exact(p, o); }, fit::kObbExactPseudocode.size(), true);
  see("dito", [](auto p, auto& o) { return fit::obb_dito(p, o); }, fit::kObbDitoPseudocode.size(), false);
}

template <class Scalar, int Dim>
bool same(const Obb<Scalar, Dim>& a, const Obb<Scalar, Dim>& b) {
  return a.center == b.center && a.axes == b.axes && a.half_extents == b.half_extents;
}

template <class Scalar, int Dim>
void check_promises(const std::string& cloud_name, const test::Cloud<Scalar, Dim>& cloud) {
  const auto set = test::set_of<Scalar, Dim>(cloud);
  for_each_fitter([&](const char* name, auto fitter, std::size_t lines, bool exact) {
    INFO(cloud_name << ", " << name << ", " << cloud.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
    Recorder<fit::ObbStep<Scalar, Dim>> recorder;
    const fit::Fit<Obb<Scalar, Dim>> found = fitter(set.span(), recorder);
    const fit::Certificate certificate = fit::certify(found, set.span(), exact);
    CHECK(certificate.contains);
    CHECK(certificate.max_outside == 0);
    CHECK(certificate.on_boundary);
    CHECK(certificate.optimal == (exact ? std::optional(true) : std::nullopt));
    CHECK(found.volume.half_extents.allFinite());

    Ignore ignore;
    CHECK(same(fitter(set.span(), ignore).volume, found.volume));
    REQUIRE(!recorder.entries.empty());
    const auto& last = recorder.entries.back().step;
    REQUIRE(std::holds_alternative<fit::Finished>(last.fact));
    CHECK(std::get<fit::Finished>(last.fact).support == found.support);
    CHECK(same(last.volume, found.volume));
    for (const auto& entry : recorder.entries) REQUIRE(static_cast<std::size_t>(entry.step.line) < lines);
  });
}

Vector<double, 3> direction(Random& random) {
  return {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
}

/// The corners of a box, and points inside it.
test::Cloud<double, 3> in_box(const Matrix<double, 3>& turned, const Vector<double, 3>& half, int inside, Random& random) {
  test::Cloud<double, 3> cloud;
  for (int corner = 0; corner < 8; ++corner)
    cloud.push_back(turned * Vector<double, 3>((corner & 1 ? 1 : -1) * half[0], (corner & 2 ? 1 : -1) * half[1],
                                               (corner & 4 ? 1 : -1) * half[2]));
  for (int i = 0; i < inside; ++i) cloud.push_back(turned * direction(random).cwiseProduct(half));
  return cloud;
}

test::Cloud<double, 3> scaled(test::Cloud<double, 3> cloud, double scale, double offset = 0) {
  for (auto& p : cloud) p = p * scale + Vector<double, 3>::Constant(offset);
  return cloud;
}

}  // namespace

TEST_CASE_TEMPLATE("box fitters keep their promises on degenerate clouds", Scalar, float, double) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    for (const int n : {3, 12}) {
      for (const auto& [name, cloud] : test::degenerate_clouds<Scalar, 2>(seed, n)) check_promises<Scalar, 2>(name, cloud);
      for (const auto& [name, cloud] : test::degenerate_clouds<Scalar, 3>(seed, n)) check_promises<Scalar, 3>(name, cloud);
    }
}

TEST_CASE_TEMPLATE("box fitters keep their promises on larger clouds", Scalar, float, double) {
  for (const auto kind : generator_kinds()) {
    const std::string name(kind);
    check_promises<Scalar, 2>(name, test::generated<Scalar, 2>(name.c_str(), 1000, 11));
    check_promises<Scalar, 3>(name, test::generated<Scalar, 3>(name.c_str(), 150, 12));
  }
}

TEST_CASE("box fitters keep their promises on far, tiny and huge clouds") {
  for (const double offset : {0.0, 1e3, 1e8, -1e8})
    for (const double scale : {1e-300, 1e-160, 1e-150, 1e-3, 1.0, 1e75, 1e150}) {
      if (offset != 0 && scale != 1) continue;
      for (const char* kind : {"cube", "sphere", "lattice", "line"}) {
        check_promises<double, 2>(kind, test::generated<double, 2>(kind, 30, 3, scale, offset));
        check_promises<double, 3>(kind, test::generated<double, 3>(kind, 30, 4, scale, offset));
      }
    }
}

TEST_CASE("a turned box of 1 x 2 x 3 has volume 6, wherever it stands and whatever its size") {
  Random random(1);
  for (int turned = 0; turned < 20; ++turned) {
    const auto cloud = in_box(turn(direction(random), random.between(-3, 3)), {0.5, 1, 1.5}, turned % 3 * 10, random);
    for_each_fitter([&](const std::string name, auto fitter, std::size_t, bool) {
      if (name == "aabb" || name == "sphere_axis" || name == "pca" || name == "dito") return;
      if (name == "pca_hull" && turned % 3 == 1) return;
      CAPTURE(name);
      Ignore ignore;
      const auto volume = [&](double scale, double offset) {
        const auto set = test::set_of<double, 3>(scaled(cloud, scale, offset));
        return (2 / scale * fitter(set.span(), ignore).volume.half_extents).prod();
      };
      CHECK(volume(1, 0) == doctest::Approx(6).epsilon(1e-14));
      CHECK(volume(1, 1e3) == doctest::Approx(6).epsilon(1e-11));
      CHECK(volume(1e-160, 0) == doctest::Approx(6).epsilon(1e-14));
      CHECK(volume(0x1p500, 0) == doctest::Approx(6).epsilon(1e-14));
    });
  }
}

TEST_CASE("on a regular tetrahedron the best box with a face on a face is twice the smallest, which is a cube") {
  Random random(2);
  for (int turned = 0; turned < 20; ++turned) {
    const Matrix<double, 3> pose = turned == 0 ? Matrix<double, 3>(Matrix<double, 3>::Identity())
                                               : turn(direction(random), random.between(-3, 3));
    test::Cloud<double, 3> cloud;
    for (const Vector<double, 3>& p : test::Cloud<double, 3>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
      cloud.push_back(pose * p);
    const auto set = test::set_of<double, 3>(cloud);
    CHECK(measure(fit::obb_face_aligned(set.span()).volume) == doctest::Approx(16).epsilon(1e-14));
    const fit::Fit<Obb<double, 3>> smallest = fit::obb_exact(set.span());
    CHECK(measure(smallest.volume) == doctest::Approx(8).epsilon(1e-14));
    CHECK(smallest.volume.half_extents.minCoeff() == doctest::Approx(1).epsilon(1e-14));
    CHECK(fit::certify(smallest, set.span(), true).optimal == true);
    CHECK(fit::on_edges<3>(fit::contacts(smallest.volume, set.span())));
  }
}

TEST_CASE("PCA of a solid cube's points can be more than four times too large, and that of its surface is not") {
  // All covariances of a cube are the same in all directions, so that a few points inside choose the axes: here those whose
  // every coordinate is 1/3 or 2/3, along each of which the cube's length is 5/3.
  Matrix<double, 3> worst;
  worst << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  worst /= 3;
  test::Cloud<double, 3> cloud = test::generated<double, 3>("lattice", 125, 1);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.2 * (axis + 1), 0.2 * (axis + 1)}) cloud.push_back(side * worst.col(axis));
  const auto set = test::set_of<double, 3>(cloud);
  const double best = measure(fit::obb_exact(set.span()).volume);
  CHECK(best == doctest::Approx(8).epsilon(1e-14));
  CHECK(measure(fit::obb_pca(set.span()).volume) / best == doctest::Approx(125.0 / 27).epsilon(1e-9));
  CHECK(measure(fit::obb_pca_rectangle(set.span()).volume) == doctest::Approx(8).epsilon(1e-9));
}

TEST_CASE("PCA of the hull's surface is not skewed by how it was sampled") {
  // An ellipse along x with many points in one part of its rim.
  test::Cloud<double, 2> even, skewed;
  for (int i = 0; i < 2000; ++i) {
    const SineCosine at = sine_cosine(i * 2 * 3.141592653589793 / 2000);
    const Vector<double, 2> p(3 * at.cosine, 2 * at.sine);
    if (i % 10 == 0 || (i > 100 && i < 300)) skewed.push_back(p);
  }
  const auto tilt = [](const Obb<double, 2>& box) { return box.axes.cwiseAbs().minCoeff(); };
  const auto set = test::set_of<double, 2>(skewed);
  CHECK(tilt(fit::obb_pca(set.span()).volume) > 0.2);
  CHECK(tilt(fit::obb_pca_hull(set.span()).volume) > 0.2);
  CHECK(tilt(fit::obb_pca_hull_area(set.span()).volume) < 0.01);

  // A box whose faces carry points by the hundred in one corner: no vertices, but points.
  Random random(5);
  const Matrix<double, 3> pose = turn({1, 2, 3}, 0.5);
  test::Cloud<double, 3> box = in_box(Matrix<double, 3>::Identity(), {1, 2, 4}, 0, random);
  for (int i = 0; i < 500; ++i) box.push_back({1, random.between(1, 2), random.between(2, 4)});
  for (auto& p : box) p = pose * p;
  const auto boxes = test::set_of<double, 3>(box);
  CHECK(measure(fit::obb_pca_hull_area(boxes.span()).volume) == doctest::Approx(64).epsilon(1e-12));
  CHECK(measure(fit::obb_pca(boxes.span()).volume) > 1.2 * 64);
}

TEST_CASE("rectangles shrink a box until none of them does") {
  int rounds = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto set = test::set_of<double, 3>(test::generated<double, 3>("cube", 40, seed));
    Recorder<fit::ObbStep<double, 3>> recorder;
    const auto found = fit::obb_pca_rectangle(set.span(), recorder);
    double measure_so_far = std::numeric_limits<double>::infinity();
    int kept = 0;
    for (const auto& entry : recorder.entries)
      if (const auto* rectangle = std::get_if<fit::RectangleFound<double, 3>>(&entry.step.fact)) {
        if (!rectangle->better) continue;
        CHECK(rectangle->measure < measure_so_far);
        measure_so_far = rectangle->measure;
        ++kept;
      }
    rounds += kept > 1;
    CHECK(measure(found.volume) == doctest::Approx(measure_so_far).epsilon(1e-12));
    CHECK(measure(found.volume) <= measure(fit::obb_pca_hull(set.span()).volume) * (1 + 1e-12));
    // Anew across the axes of the result, nothing is gained.
    Ignore ignore;
    for (int axis = 0; axis < 3; ++axis) {
      fit::ObbTrials<double, 3, Ignore> trials(set.span(), ignore);
      trials.attempt(found.volume.axes, std::array<Index, 0>{}, 0);
      const double before = trials.least();
      trials.attempt(fit::rectangle_along(found.volume.axes.col(axis), trials.local().at).axes, std::array<Index, 0>{}, 0);
      CHECK(trials.least() >= before * (1 - 1e-12));
    }
  }
  CHECK(rounds > 5);
}

TEST_CASE("DiTO's box is never larger than the AABB, and near the smallest on turned boxes") {
  Random random(9);
  for (int turned = 0; turned < 50; ++turned) {
    const auto cloud = in_box(turn(direction(random), random.between(-3, 3)), {0.3, 1, 2}, 200, random);
    const auto set = test::set_of<double, 3>(cloud);
    const double dito = measure(fit::obb_dito(set.span()).volume);
    CHECK(dito <= measure(fit::obb_aabb(set.span()).volume) * (1 + 1e-14));
    CHECK(dito < 8 * 0.6 * 1.3);
  }
}
