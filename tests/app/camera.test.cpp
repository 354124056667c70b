#include "app/camera.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "app/picking.hpp"

namespace snug::app {
namespace {

using V3 = Vector<double, 3>;

Camera framed(int dim, const Sphere<double, 3>& ball) {
  Camera camera(dim);
  camera.set_stage({100, 50, 640, 480}, 40, 40, 80);
  camera.frame(ball, true);
  return camera;
}

}  // namespace

TEST_CASE("a framed ball stands within the free room and fills it") {
  for (const int dim : {2, 3})
    for (const double scale : {1e-100, 1.0, 1e100}) {
      const Sphere<double, 3> ball{V3(3, -2, dim == 3 ? 5 : 0) * scale, 2 * scale};
      const Camera camera = framed(dim, ball);
      CHECK(camera.share_of_room(ball) == doctest::Approx(1).epsilon(0.05));
      const ScreenPoint center = camera.project(ball.center);
      CHECK(center.x == doctest::Approx(camera.center_x()));
      CHECK(center.y == doctest::Approx(camera.center_y()));
    }
}

TEST_CASE("a view that a hand has made is looked from again; one of another dimension is none") {
  for (const int dim : {2, 3}) {
    Camera camera = framed(dim, {V3::Zero(), 2});
    CHECK(camera.hand_view().empty());
    camera.zoom(1.7, 300, 200);
    camera.pan(31, -12);
    if (dim == 3) camera.orbit(90, -20);
    const auto view = camera.hand_view();
    REQUIRE(view.size() == (dim == 3 ? 6 : 3));
    Camera other = framed(dim, {V3(5, 5, 0), 9});
    REQUIRE(other.look_from(view));
    CHECK_FALSE(other.framed());
    for (const V3& p : {V3(1, 0, 0), V3(0, 1, 0), V3(-1, 1, dim == 3 ? 1 : 0)}) {
      CHECK(std::abs(other.project(p).x - camera.project(p).x) < 1);
      CHECK(std::abs(other.project(p).y - camera.project(p).y) < 1);
    }
    CHECK(other.hand_view() == view);
    for (const double value : view) CHECK(value == std::round(value * 1e6) / 1e6);  // a short decimal, for an address
    CHECK_FALSE(framed(5 - dim, {V3::Zero(), 2}).look_from(view));
    CHECK_FALSE(other.look_from({0, 0, 0}));
  }
}

TEST_CASE("an outline fills the free room by its width or by its height, clear of what is beside it") {
  for (const auto& [half_width, half_height] : {std::pair{4.0, 1.0}, {1.0, 4.0}}) {
    Camera camera = framed(2, {V3::Zero(), 1});
    const Outline outline{
        .center = {2, 1, 0}, .half_width = half_width, .half_height = half_height, .left = 60, .below = 20};
    camera.frame(camera.framing(outline), true);
    const ScreenPoint low = camera.project(outline.center - V3(half_width, half_height, 0)),
                      high = camera.project(outline.center + V3(half_width, half_height, 0));
    // The free room: 140 to 700 across, 90 to 450 down.
    if (half_width > half_height) {
      CHECK(low.x == doctest::Approx(200));
      CHECK(high.x == doctest::Approx(700));
    } else {
      CHECK(high.y == doctest::Approx(90));
      CHECK(low.y == doctest::Approx(430));
    }
    CHECK((low.x + high.x) / 2 == doctest::Approx(450));
    CHECK((low.y + high.y) / 2 == doctest::Approx(260));
    CHECK(camera.share_of_room(camera.framing(outline)) < 1.06);
  }
}

TEST_CASE("an outline that wants more room beside it than there is stays in the free room") {
  Camera camera = framed(2, {V3::Zero(), 1});
  const Outline outline{.center = {2, 1, 0}, .half_width = 4, .half_height = 1, .left = 400, .below = 300};
  camera.frame(camera.framing(outline), true);
  const ScreenPoint low = camera.project(outline.center - V3(4, 1, 0)),
                    high = camera.project(outline.center + V3(4, 1, 0));
  CHECK(low.x == doctest::Approx(420));  // half of the room
  CHECK(high.x == doctest::Approx(700));
  CHECK(high.y > 90);
  CHECK(low.y < 270);
}

TEST_CASE("far from the origin a pixel is still a pixel") {
  const Camera camera = framed(2, {V3(1e8, -1e8, 0), 1});
  const V3 right(1e8 + 0.5, -1e8, 0);
  const double pixels = camera.project(right).x - camera.center_x();
  CHECK(pixels == doctest::Approx(0.5 * camera.scale_at(right)).epsilon(1e-3));
}

TEST_CASE("what is under a pixel is drawn there") {
  for (const int dim : {2, 3}) {
    const Camera camera = framed(dim, {V3(0, 0, 0), 2});
    const V3 through = camera.forward() * (dim == 3 ? 0.7 : 0);
    const V3 p = camera.unproject(250, 310, through);
    const ScreenPoint back = camera.project(p);
    CHECK(back.x == doctest::Approx(250));
    CHECK(back.y == doctest::Approx(310));
    // A drag in 3-D stays in the plane parallel to the screen.
    CHECK((p - through).dot(camera.forward()) == doctest::Approx(0).epsilon(1e-9));
  }
}

TEST_CASE("zooming keeps what is under the pointer there") {
  for (const int dim : {2, 3}) {
    Camera camera = framed(dim, {V3(1, 2, 0), 2});
    const V3 under = camera.unproject(420, 200, camera.view().target);
    const double before = camera.view().height;
    camera.zoom(1.5, 420, 200);
    CHECK(camera.view().height == doctest::Approx(before / 1.5));
    CHECK(camera.project(under).x == doctest::Approx(420));
    CHECK(camera.project(under).y == doctest::Approx(200));
    CHECK_FALSE(camera.framed());
  }
}

TEST_CASE("panning moves the scene with the hand") {
  for (const int dim : {2, 3}) {
    Camera camera = framed(dim, {V3(1, 2, 0), 2});
    const V3 target = camera.view().target;
    camera.pan(30, -12);
    CHECK(camera.project(target).x == doctest::Approx(camera.center_x() + 30));
    CHECK(camera.project(target).y == doctest::Approx(camera.center_y() - 12));
  }
}

TEST_CASE("orbiting keeps the distance, and never goes over the top") {
  Camera camera = framed(3, {V3(1, 2, 3), 2});
  const double distance = (camera.eye() - camera.view().target).norm();
  camera.orbit(400, 4000);
  CHECK((camera.eye() - camera.view().target).norm() == doctest::Approx(distance));
  CHECK(camera.up()[1] > 0);
  CHECK(camera.right().dot(camera.forward()) == doctest::Approx(0));
  CHECK(camera.project(camera.view().target - camera.forward() * 2 * distance).visible == false);
}

TEST_CASE("the camera eases, arrives, and then is still") {
  Camera camera = framed(3, {V3(0, 0, 0), 1});
  camera.zoom_eased(2);
  const double before = camera.view().height;
  CHECK(camera.moving());
  double last = before;
  int frames = 0;
  while (camera.ease(1.0 / 60, false)) {
    REQUIRE(camera.view().height < last);
    last = camera.view().height;
    REQUIRE(++frames < 60);
  }
  CHECK(frames > 5);
  CHECK(camera.view().height == doctest::Approx(before / 2));
  camera.orbit_eased(1, 0);
  CHECK_FALSE(camera.ease(0, true));  // for those who want no motion: at once
  CHECK(camera.view().yaw != 0);
}

TEST_CASE("one point, and points all on one spot, can be framed") {
  for (const int dim : {2, 3}) {
    const Camera camera = framed(dim, {V3::Zero(), 0});
    CHECK(std::isfinite(camera.project(V3(1, 1, 0)).x));
    CHECK(camera.view().height > 0);
  }
}

TEST_CASE("picking: the nearest within reach, of equals the one in front, never one that is hidden") {
  const std::vector<ScreenPoint> points{
      {100, 100, 2, true}, {100, 100, 1, true}, {108, 100, 0, true}, {50, 50, 0, false}};
  CHECK(pick(points, 101, 100, kMouseReach) == 1);
  CHECK(pick(points, 107, 101, kMouseReach) == 2);
  CHECK(pick(points, 50, 50, kMouseReach) == kNoIndex);
  CHECK(pick(points, 128, 100, kMouseReach) == kNoIndex);
  CHECK(pick(points, 128, 100, kFingerReach) == 2);
  CHECK(pick({}, 0, 0, kMouseReach) == kNoIndex);
  static_assert(2 * kFingerReach >= 44);
}

}  // namespace snug::app
