// Where one looks from: pan and zoom in 2-D, orbit in 3-D, and how it eases from one place to the next.
#pragma once

#include <optional>

#include "app/app.hpp"
#include "geometry/sphere.hpp"

namespace snug::app {

/// On the canvas, in page pixels, y down.
struct ScreenPoint {
  float x = 0, y = 0;
  float depth = 0;      // along the view, scene units over the view's height; smaller is nearer
  bool visible = true;  // in front of the camera
};

/// All that an eased camera has to pass through. Scene units; angles in radians.
struct View {
  Vector<double, 3> target = Vector<double, 3>::Zero();
  double height = 2;  // what the stage's free height shows at the target
  double yaw = 0, pitch = 0;
};

class Camera {
 public:
  explicit Camera(int dim = 2) : dim_(dim) { turn(); }

  /// The room that things should be framed in: the stage less the margins for what stands over it.
  void set_stage(const Rect& stage, float margin_top, float margin_side, float margin_bottom);
  [[nodiscard]] const Rect& stage() const { return stage_; }
  [[nodiscard]] int dim() const { return dim_; }

  /// Goes to where the ball fills the free room. At once, or easing there.
  void frame(const Sphere<double, 3>& ball, bool at_once);
  /// How much of the free room the ball takes, by its larger side; > 1 where it reaches beyond.
  [[nodiscard]] double share_of_room(const Sphere<double, 3>& ball) const;

  [[nodiscard]] ScreenPoint project(const Vector<double, 3>& p) const;
  /// The scene's place under a pixel: in 2-D exactly, in 3-D on the plane parallel to the screen through `through`.
  [[nodiscard]] Vector<double, 3> unproject(float x, float y, const Vector<double, 3>& through) const;
  /// Page pixels for one scene unit at a place.
  [[nodiscard]] double scale_at(const Vector<double, 3>& p) const;

  // What a hand does: at once, for it follows the hand.
  void pan(float dx, float dy);
  void zoom(double factor, float x, float y);  // factor > 1 comes nearer; the place under (x, y) stays
  void orbit(float dx, float dy);              // pixels
  // What a key does: eased.
  void zoom_eased(double factor);
  void orbit_eased(double yaw, double pitch);
  /// Moves on by dt seconds. Returns whether it is still under way. at_once: for those who want no motion.
  bool ease(double dt, bool at_once);
  [[nodiscard]] bool moving() const;
  /// Whether a hand has taken it away from where frame() put it.
  [[nodiscard]] bool framed() const { return framed_; }

  [[nodiscard]] const Vector<double, 3>& right() const { return right_; }
  [[nodiscard]] const Vector<double, 3>& up() const { return up_; }
  [[nodiscard]] const Vector<double, 3>& forward() const { return forward_; }
  [[nodiscard]] const Vector<double, 3>& eye() const { return eye_; }  // 3-D only
  [[nodiscard]] const View& view() const { return now_; }
  [[nodiscard]] double focal() const;  // page pixels; 3-D only
  [[nodiscard]] float center_x() const;
  [[nodiscard]] float center_y() const;
  /// Where the room for what stands over the stage's foot begins.
  [[nodiscard]] float free_bottom() const { return stage_.y + stage_.height - bottom_; }

 private:
  [[nodiscard]] double free_height() const;
  [[nodiscard]] double free_width() const;
  [[nodiscard]] double distance() const;  // from eye to target, scene units

  int dim_;
  Rect stage_;
  float top_ = 0, side_ = 0, bottom_ = 0;
  void turn();  // to now_, after every change of it

  View now_, goal_;
  Vector<double, 3> right_, up_, forward_, eye_;  // as now_ has them: a frame projects tens of thousands of places
  bool framed_ = true;
};

}  // namespace snug::app
