#include "geometry/frustum.hpp"

#include <doctest/doctest.h>

#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "geometry/frustum_corners.hpp"

using namespace snug;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();

template <class Scalar, int Dim>
void check_signed(const Frustum<Scalar, Dim>& frustum, const Vector<Scalar, Dim>& p,
                  std::initializer_list<double> expected) {
  int plane = 0;
  for (const double value : expected) CHECK(signed_distance(frustum[plane++], p) == doctest::Approx(value));
}

FrustumCamera<double, 3> camera() { return {.position = {1, 2, 3}, .half_tangents = {1, 0.5}, .near = 1, .far = 9}; }

/// Its planes, one of them changed.
template <int Dim>
std::string refused(int plane, const Plane<double, Dim>& changed) {
  auto planes = Frustum<double, Dim>().planes();
  planes[plane] = changed;
  const auto made = Frustum<double, Dim>::make(planes);
  return made ? "" : made.error().what;
}

std::array<double, 16> identity() {
  std::array<double, 16> m{};
  for (std::size_t i = 0; i < 4; ++i) m[5 * i] = 1;
  return m;
}

template <class Scalar, int Dim>
void check_corners() {
  Random random(3);
  for (int kind = 0; kind < test::kFrustumKinds; ++kind)
    for (int round = 0; round < 20; ++round) {
      CAPTURE(kind);
      const auto scene = test::any_scene<Scalar, Dim>(kind, random);
      const auto corners = corners_of(scene.frustum);
      REQUIRE(corners.has_value());
      const auto exact = *exact_corners_of(scene.frustum);
      for (std::size_t c = 0; c < corners->size(); ++c) {
        // Each exact corner solves its planes' equations.
        for (int i = 0; i < Dim; ++i) {
          const auto& plane = scene.frustum[2 * i + static_cast<int>(c >> i & 1)];
          Dyadic value = Dyadic(static_cast<double>(plane.d)) * exact[c].weight;
          for (int k = 0; k < Dim; ++k) value += Dyadic(static_cast<double>(plane.normal[k])) * exact[c].coordinates[k];
          CHECK(value.sign() == 0);
        }
        // And the rounded one is near it.
        for (int k = 0; k < Dim; ++k) {
          const double rounded = static_cast<double>((*corners)[c][k]);
          const Dyadic off = Dyadic(rounded) * exact[c].weight - exact[c].coordinates[k];
          const double bound = 8 * static_cast<double>(std::numeric_limits<Scalar>::epsilon()) / 2 * std::abs(rounded);
          CHECK(std::abs(off.approximate()) <= bound * exact[c].weight.approximate());
        }
      }
    }
}

}  // namespace

TEST_CASE("a frustum is a cube until it is made of something") {
  check_signed(Frustum<double, 3>(), Vector<double, 3>(0.5, 0, -0.25), {-1.5, -0.5, -1, -1, -0.75, -1.25});
  check_signed(Frustum<float, 2>(), Vector<float, 2>(0.5f, -0.25f), {-1.5, -0.5, -0.75, -1.25});
  CHECK(corners_of(Frustum<double, 3>()).value()[5] == Vector<double, 3>(1, -1, 1));
}

TEST_CASE("a camera's planes point out and go through what it sees last") {
  const auto frustum = frustum_of_camera(camera());
  REQUIRE(frustum.has_value());
  // Straight ahead 4: 4 right and left, 2 up and down, 3 behind near, 5 before far.
  const double side = 4 / std::sqrt(2.0), up = 2 / std::sqrt(1.25);
  check_signed(frustum->normalized(), Vector<double, 3>(1, 2, -1), {-side, -side, -up, -up, -3, -5});
  const auto corners = corners_of(*frustum);
  REQUIRE(corners.has_value());
  CHECK((*corners)[0] == Vector<double, 3>(0, 1.5, 2));    // left, bottom, near
  CHECK((*corners)[7] == Vector<double, 3>(10, 6.5, -6));  // right, top, far
  CHECK((*corners)[6] == Vector<double, 3>(-8, 6.5, -6));  // left, top, far

  const auto flat = frustum_of_camera(FrustumCamera<float, 2>{.position = {1, 2}, .near = 1, .far = 3});
  REQUIRE(flat.has_value());
  const auto four = corners_of(*flat).value();
  CHECK(four[0] == Vector<float, 2>(0, 1));
  CHECK(four[1] == Vector<float, 2>(2, 1));
  CHECK(four[2] == Vector<float, 2>(-2, -1));
  CHECK(four[3] == Vector<float, 2>(4, -1));
}

TEST_CASE("a camera that cannot see is refused") {
  const auto said = [](FrustumCamera<double, 3> changed) {
    const auto made = frustum_of_camera(changed);
    return made ? "" : made.error().what;
  };
  auto changed = camera();
  changed.position[1] = kNan;
  CHECK(said(changed) == "the camera's position is not finite");
  changed = camera(), changed.axes(2, 2) = kInfinity;
  CHECK(said(changed) == "the camera's axes are not finite");
  changed = camera(), changed.axes.setZero();
  CHECK(said(changed) == "plane 0 (left) has no normal: it is zero");
  for (const double tangent : {0.0, -1.0, kNan, kInfinity}) {
    changed = camera(), changed.half_tangents[1] = tangent;
    CHECK(said(changed) == "the camera's half tangents are not all finite and above 0");
  }
  for (const auto& [near, far] :
       {std::pair{0.0, 1.0}, {2.0, 2.0}, {3.0, 2.0}, {kNan, 2.0}, {1.0, kInfinity}, {-1.0, 1.0}}) {
    changed = camera(), changed.near = near, changed.far = far;
    CHECK(said(changed) == "the camera's near and far are not finite with 0 < near < far");
  }
}

TEST_CASE("planes are refused by their names") {
  CHECK(refused<3>(3, {{0, 0, 0}, 1}) == "plane 3 (top) has no normal: it is zero");
  CHECK(refused<3>(4, {{0, kNan, 0}, 1}) == "plane 4 (near) is not finite");
  CHECK(refused<3>(5, {{0, 1, 0}, kInfinity}) == "plane 5 (far) is not finite");
  CHECK(refused<2>(2, {{0, 0}, 1}) == "plane 2 (near) has no normal: it is zero");
  CHECK(refused<3>(0, {{0x1p509, 0, 0}, 1}) == "plane 0 (left) has a normal longer than this program can take");
  CHECK(refused<3>(1, {{0x1p-509, 0, 0}, 0}) == "plane 1 (right) has a normal shorter than this program can take");
  CHECK(refused<3>(2, {{0, -1, 0}, 0x1p511}) == "plane 2 (bottom) is farther away than this program can take");
  CHECK(refused<3>(2, {{0, -0x1p-508, 0x1p-600}, 3}).empty());
}

TEST_CASE("a matrix leaves what lies in clip space") {
  // The identity's clip space is the cube.
  const auto m = identity();
  const auto cube = frustum_of_matrix<double>(m);
  REQUIRE(cube.has_value());
  for (int plane = 0; plane < 6; ++plane) {
    CHECK((*cube)[plane].normal == Frustum<double, 3>()[plane].normal);
    CHECK((*cube)[plane].d == Frustum<double, 3>()[plane].d);
  }
  // A camera's own matrix, column by column: 90 degrees, near 1, far 3, at the origin.
  const std::array<float, 16> perspective{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -2, -1, 0, 0, -3, 0};
  const auto seen = frustum_of_matrix<float>(perspective);
  REQUIRE(seen.has_value());
  const auto corners = corners_of(*seen).value();
  CHECK(corners[0] == Vector<float, 3>(-1, -1, -1));
  CHECK(corners[7] == Vector<float, 3>(3, 3, -3));
}

TEST_CASE("any point is in a matrix's planes just where its clip coordinates are in the cube") {
  Random random(9);
  int inside = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<double, 16> m;  // small whole numbers: nothing rounds
    for (double& entry : m) entry = static_cast<double>(random.below(9)) - 4;
    const auto frustum = frustum_of_matrix<double>(m);
    if (!frustum) continue;
    for (int i = 0; i < 20; ++i) {
      const double p[4]{static_cast<double>(random.below(9)) - 4, static_cast<double>(random.below(9)) - 4,
                        static_cast<double>(random.below(9)) - 4, 4};
      double clip[4]{};
      for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column) clip[row] += m[4 * column + row] * p[column];
      bool in_cube = true, in_planes = true;
      for (int k = 0; k < 3; ++k) in_cube = in_cube && -clip[3] <= clip[k] && clip[k] <= clip[3];
      for (const auto& plane : frustum->planes())
        in_planes =
            in_planes && plane.normal[0] * p[0] + plane.normal[1] * p[1] + plane.normal[2] * p[2] + 4 * plane.d <= 0;
      CHECK(in_cube == in_planes);
      inside += in_cube;
    }
  }
  CHECK(inside > 500);
}

TEST_CASE("degenerate matrices are refused") {
  const auto said = [](std::span<const double> m) {
    const auto made = frustum_of_matrix<double>(m);
    return made ? "" : made.error().what;
  };
  auto m = identity();
  CHECK(said(std::span(m).first(15)) == "the matrix has 15 numbers where 16 belong");
  m[7] = kNan;
  CHECK(said(m) == "the matrix is not finite");
  // Far at infinity: clip z = -z - 2 near w, clip w = -z.
  const std::array<double, 16> endless{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0};
  CHECK(said(endless) == "the matrix gives plane 5 (far) no normal, as for a plane at infinity");
  const std::array<double, 16> singular{1, 2, 0, 0, 2, 4, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  CHECK(said(singular) == "the matrix is singular");
  auto nearly = singular;
  nearly[5] = std::nextafter(4.0, 5.0);
  CHECK(said(nearly).empty());
}

TEST_CASE("corners solve their planes' equations, and are rounded by no more than they say") {
  check_corners<double, 3>();
  check_corners<double, 2>();
  check_corners<float, 3>();
  check_corners<float, 2>();
}

TEST_CASE("planes that bound no frustum have no corners") {
  const auto said = [](int plane, const Plane<double, 3>& changed) {
    auto planes = Frustum<double, 3>().planes();
    planes[plane] = changed;
    const auto corners = corners_of(*Frustum<double, 3>::make(planes));
    return corners ? "" : corners.error().what;
  };
  CHECK(said(1, {{1, 0, 0}, -1}).empty());
  CHECK(said(1, {{0, 1, 0}, -1}) == "right, bottom and near do not meet in a vertex");                   // parallel
  CHECK(said(1, {{1, 0, 0}, 2}) == "the vertex of left, bottom and near lies outside of right");         // empty
  CHECK(said(1, {{-1, 0, 0}, -1}) == "left and right face the same way, and nothing bounds the other");  // unbounded
  CHECK(said(1, {{-1, 0, 0}, -2}) == "the vertex of right, bottom and near lies outside of left");
  CHECK(said(1, {{1, 1, 0}, 0.5}) == "the vertex of left, top and near lies outside of right");  // fewer corners
  CHECK(said(1, {{1, 1, 0}, -0.5}).empty());
  CHECK(said(5, {{0x1p-400, 0, 1}, -0x1p500}).empty());
  CHECK(said(1, {{0x1p-500, 0x1p-500, 0x1p-500}, -4}).empty());
  auto wedge = Frustum<double, 3>().planes();
  const auto of_wedge = [&](double d) {  // left and right meet at z = -d
    wedge[0] = {{-1, 0, 1}, d}, wedge[1] = {{1, 0, 1}, d};
    const auto corners = corners_of(*Frustum<double, 3>::make(wedge));
    return corners ? "" : corners.error().what;
  };
  CHECK(of_wedge(-1.5).empty());
  CHECK(of_wedge(-1) == "there is another vertex, of left, right and bottom");
  CHECK(of_wedge(-0.5) == "the vertex of left, bottom and far lies outside of right");
}

TEST_CASE("normalizing moves a plane by no more than it says") {
  Random random(4);
  for (int round = 0; round < 500; ++round) {
    const auto scene = test::any_scene<float, 3>(round % test::kFrustumKinds, random);
    const auto unit = scene.frustum.normalized();
    for (int plane = 0; plane < 6; ++plane) {
      const Vector<double, 3> exact = scene.frustum[plane].normal.cast<double>(),
                              own = unit[plane].normal.cast<double>();
      const double length = exact.norm(), u = std::numeric_limits<float>::epsilon() / 2;
      CHECK((own - exact / length).norm() <= 4 * u);
      CHECK(std::abs(static_cast<double>(unit[plane].d) - static_cast<double>(scene.frustum[plane].d) / length) <=
            4 * u * std::abs(static_cast<double>(unit[plane].d)));
    }
  }
}
