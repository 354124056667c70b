// The camera: pan and zoom in 2-D, orbit in 3-D, and easing from one view to the next.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "app/app.hpp"
#include "geometry/sphere.hpp"

namespace snug::app {

/// A point on the canvas, in page pixels, y down.
struct ScreenPoint {
  float x = 0, y = 0;
  float depth = 0;      // along the view, scene units over the view's height; smaller is nearer
  bool visible = true;  // in front of the camera
};

/// What a view has to show, as it is seen from where the camera stands: half of its width, height and depth around a
/// place, scene units, and the pixels that are needed beside it.
struct Outline {
  Vector<double, 3> center = Vector<double, 3>::Zero();
  double half_width = 0, half_height = 0, half_depth = 0;
  float left = 0, right = 0, below = 0, above = 0;
  double nearer = 1.06;  // in space, by how much what is nearer than the middle may look larger
};

/// The state of the camera, which easing interpolates. Scene units; angles in radians.
struct View {
  Vector<double, 3> target = Vector<double, 3>::Zero();
  double height = 2;  // the height visible in the free room, at the target
  double yaw = 0, pitch = 0;
};

class Camera {
 public:
  /// yaw, pitch: where it looks from at first and after turn_home, in 3-D.
  explicit Camera(int dim = 2, double yaw = kYaw, double pitch = kPitch) : dim_(dim), home_{yaw, pitch} { turn(); }

  /// The free room: the stage without the margins for what is drawn over it. more_left: how much wider the left one is.
  void set_stage(const Rect& stage, float margin_top, float margin_side, float margin_bottom, float more_left = 0);
  /// Its width over its height.
  [[nodiscard]] double shape_of_room() const { return free_width() / free_height(); }
  [[nodiscard]] const Rect& stage() const { return stage_; }
  [[nodiscard]] int dim() const { return dim_; }

  /// Turns back to where it looked from at first.
  void turn_home() { goal_.yaw = home_[0], goal_.pitch = home_[1]; }
  /// The same camera, which turns back to where another one does.
  [[nodiscard]] Camera with_home_of(const Camera& other) const {
    Camera camera = *this;
    camera.home_ = other.home_;
    return camera;
  }
  /// Moves to where the ball fills the free room, at once or easing.
  void frame(const Sphere<double, 3>& ball, bool at_once);
  /// The ball that frames an outline: more tightly than the ball around it would, where the free room is wide or high.
  [[nodiscard]] Sphere<double, 3> framing(const Outline& outline) const;
  /// The fraction of the free room that the ball takes, by the larger side; > 1 if it reaches beyond.
  [[nodiscard]] double share_of_room(const Sphere<double, 3>& ball) const;

  [[nodiscard]] ScreenPoint project(const Vector<double, 3>& p) const;
  /// The point of the scene at a pixel: in 3-D, on the plane parallel to the screen through `through`.
  [[nodiscard]] Vector<double, 3> unproject(float x, float y, const Vector<double, 3>& through) const;
  /// How many page pixels a scene unit has at a place.
  [[nodiscard]] double scale_at(const Vector<double, 3>& p) const;

  /// Magnifies the picture: what is at a pixel goes to another one, and what is around it is so many times larger.
  void magnify(double times, const std::array<double, 2>& from, const std::array<double, 2>& to);

  /// Whether it does: then it is a close-up's.
  [[nodiscard]] bool magnifies() const { return lens_.times != 1; }

  // What the pointer does: immediate, because it follows the pointer.
  void pan(float dx, float dy);
  void zoom(double factor, float x, float y);  // factor > 1 comes nearer; the place under (x, y) stays
  void orbit(float dx, float dy);              // pixels
  // What a key does: eased.
  void zoom_eased(double factor);
  void orbit_eased(double yaw, double pitch);
  /// Advances by dt seconds. Returns whether the camera is still moving. at_once: for reduced motion.
  bool ease(double dt, bool at_once);
  [[nodiscard]] bool moving() const;
  /// Whether a hand has taken it away from where frame() put it.
  [[nodiscard]] bool framed() const { return framed_; }
  /// The view that a hand has made, as App::hand_view has it; and takes one at once, as if a hand had. look_from
  /// returns false if it is none of this dimension.
  [[nodiscard]] std::vector<double> hand_view() const;
  bool look_from(const std::vector<double>& view);

  [[nodiscard]] const Vector<double, 3>& right() const { return right_; }
  [[nodiscard]] const Vector<double, 3>& up() const { return up_; }
  [[nodiscard]] const Vector<double, 3>& forward() const { return forward_; }
  [[nodiscard]] const Vector<double, 3>& eye() const { return eye_; }  // 3-D only
  [[nodiscard]] const View& view() const { return now_; }
  [[nodiscard]] double focal() const;  // page pixels; 3-D only
  [[nodiscard]] float center_x() const;
  [[nodiscard]] float center_y() const;
  /// The width and the height of the free room, page pixels.
  [[nodiscard]] std::array<double, 2> room() const { return {free_width(), free_height()}; }
  /// The lower end of the free room.
  [[nodiscard]] float free_bottom() const { return stage_.y + stage_.height - bottom_; }

 private:
  [[nodiscard]] double free_height() const;
  [[nodiscard]] double free_width() const;
  [[nodiscard]] double distance() const;  // from eye to target, scene units

  static constexpr double kYaw = 0.55, kPitch = 0.32;  // radians

  int dim_;
  std::array<double, 2> home_;  // yaw and pitch
  Rect stage_;
  float top_ = 0, side_ = 0, bottom_ = 0, more_left_ = 0;
  void turn();  // updates what depends on now_, after every change of it

  View now_, goal_;
  Vector<double, 3> right_, up_, forward_, eye_;  // cached for now_: a frame projects tens of thousands of places
  bool framed_ = true;
  bool placed_ = false;  // whether it was framed before
  struct Lens {
    double times = 1;
    std::array<double, 2> from{}, to{};
  } lens_;
};

/// The outline of what reaches from the first of range(way) to the second along each direction.
[[nodiscard]] Outline outline_within(const Camera& camera,
                                     const std::function<std::array<double, 2>(const Vector<double, 3>&)>& range);

}  // namespace snug::app
