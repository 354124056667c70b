#include "app/camera.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace snug::app {
namespace {

using V3 = Vector<double, 3>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFieldOfView = 30 * kDegree;  // narrow enough that spheres look round
constexpr double kSteepest = 85 * kDegree;
constexpr double kRadiansPerPixel = 0.008;
constexpr double kEaseSeconds = 0.06;  // the time in which the remaining way falls to 1/e: at rest after about 0.3 s
constexpr double kArrived = 1e-3;      // of the view's height

const double kTanHalf = std::tan(kFieldOfView / 2);

}  // namespace

void Camera::set_stage(const Rect& stage, float margin_top, float margin_side, float margin_bottom, float more_left) {
  stage_ = stage;
  top_ = margin_top, side_ = margin_side, bottom_ = margin_bottom, more_left_ = more_left;
}

double Camera::free_height() const { return std::max(1.0, static_cast<double>(stage_.height - top_ - bottom_)); }
double Camera::free_width() const { return std::max(1.0, static_cast<double>(stage_.width - 2 * side_ - more_left_)); }
float Camera::center_x() const { return stage_.x + (stage_.width + more_left_) / 2; }
float Camera::center_y() const { return stage_.y + top_ + static_cast<float>(free_height()) / 2; }
double Camera::focal() const { return free_height() / (2 * kTanHalf); }
double Camera::distance() const { return now_.height / (2 * kTanHalf); }

void Camera::turn() {
  forward_ = {0, 0, -1}, right_ = {1, 0, 0};
  if (dim_ == 3) {
    const double cos_yaw = std::cos(now_.yaw), sin_yaw = std::sin(now_.yaw), cos_pitch = std::cos(now_.pitch);
    forward_ = {-sin_yaw * cos_pitch, -std::sin(now_.pitch), -cos_yaw * cos_pitch};
    right_ = {cos_yaw, 0, -sin_yaw};
  }
  up_ = right_.cross(forward_);
  eye_ = now_.target - forward_ * distance();
}

void Camera::frame(const Sphere<double, 3>& ball, bool at_once) {
  double radius = ball.radius > 0 ? ball.radius : std::max(ball.center.cwiseAbs().maxCoeff() * 1e-3, 1e-300);
  if (ball.radius <= 0 && ball.center.isZero()) radius = 1;
  goal_.target = ball.center;
  // In the plane through its centre, the silhouette of a ball of radius r has the radius r / sqrt(1 - (r/d)^2).
  const double fit = std::min(1.0, free_width() / free_height());
  goal_.height = 2 * radius / fit * (dim_ == 3 ? 1.0 / std::cos(kFieldOfView / 2 * fit) : 1.0);
  if (dim_ == 3 && !placed_) turn_home();
  framed_ = placed_ = true;
  if (at_once) now_ = goal_, turn();
}

Sphere<double, 3> Camera::framing(const Outline& outline) const {
  // What is needed before and after the outline. In a small room there is less of it than it wants.
  const auto free_of = [](double whole, double before, double after) {
    return std::max(whole - before - after, whole / 2);
  };
  const auto moved = [](double whole, double free, double before, double after) {
    const double wanted = before + after;
    return wanted > 0 ? (after - before) / 2 * (whole - free) / wanted : 0;
  };
  const double width = free_width(), height = free_height();
  const double free_x = free_of(width, outline.left, outline.right),
               free_y = free_of(height, outline.below, outline.above);
  double unit = (dim_ == 3 ? outline.nearer : 1) *
                std::max(2 * outline.half_width / free_x, 2 * outline.half_height / free_y);  // to a pixel
  const double fit = std::min(1.0, width / height);
  // The camera stands farther away where the view is high: what is deep would have its near end look far too large.
  if (dim_ == 3) unit = std::max(unit, 1.6 * outline.half_depth / height);
  return {outline.center + right_ * (moved(width, free_x, outline.left, outline.right) * unit) +
              up_ * (moved(height, free_y, outline.below, outline.above) * unit),
          unit * fit * height / 2};
}

Outline outline_within(const Camera& camera, const std::function<std::array<double, 2>(const V3&)>& range) {
  const auto [left, right] = range(camera.right());
  const auto [low, high] = range(camera.up());
  const auto [near, far] = range(camera.forward());
  return {.center = camera.right() * ((left + right) / 2) + camera.up() * ((low + high) / 2) +
                    camera.forward() * ((near + far) / 2),
          .half_width = (right - left) / 2,
          .half_height = (high - low) / 2,
          .half_depth = (far - near) / 2};
}

double Camera::share_of_room(const Sphere<double, 3>& ball) const {
  const ScreenPoint center = project(ball.center);
  const double reach = ball.radius * scale_at(ball.center);
  const double across = (std::abs(static_cast<double>(center.x - center_x())) + reach) / (free_width() / 2);
  const double along = (std::abs(static_cast<double>(center.y - center_y())) + reach) / (free_height() / 2);
  return std::max(across, along);
}

ScreenPoint Camera::project(const V3& p) const {
  const auto pixel = [&](double value, std::size_t axis) {
    return static_cast<float>((value - lens_.from[axis]) * lens_.times + lens_.to[axis]);
  };
  if (dim_ == 2) {
    const double scale = free_height() / now_.height;
    return {pixel(center_x() + (p[0] - now_.target[0]) * scale, 0),
            pixel(center_y() - (p[1] - now_.target[1]) * scale, 1), 0, true};
  }
  const V3 from_eye = p - eye();
  const double depth = from_eye.dot(forward());
  const bool visible = depth > 0.02 * now_.height;
  const double scale = focal() / std::max(depth, 0.02 * now_.height);
  return {pixel(center_x() + from_eye.dot(right()) * scale, 0), pixel(center_y() - from_eye.dot(up()) * scale, 1),
          static_cast<float>(depth / now_.height), visible};
}

V3 Camera::unproject(float x, float y, const V3& through) const {
  const double scale = scale_at(through) / lens_.times;
  const double dx = ((x - lens_.to[0]) / lens_.times + lens_.from[0] - center_x()) / scale;
  const double dy = (center_y() - (y - lens_.to[1]) / lens_.times - lens_.from[1]) / scale;
  if (dim_ == 2) return {now_.target[0] + dx, now_.target[1] + dy, 0};
  const V3 middle = eye() + forward() * (through - eye()).dot(forward());
  return middle + right() * dx + up() * dy;
}

double Camera::scale_at(const V3& p) const {
  if (dim_ == 2) return lens_.times * free_height() / now_.height;
  return lens_.times * focal() / std::max((p - eye()).dot(forward()), 0.02 * now_.height);
}

void Camera::magnify(double times, const std::array<double, 2>& from, const std::array<double, 2>& to) {
  lens_ = {times, from, to};
}

void Camera::pan(float dx, float dy) {
  const double scale = free_height() / now_.height;
  now_.target += (-dx * right() + dy * up()) / scale;
  goal_ = now_, turn();
  framed_ = false;
}

void Camera::zoom(double factor, float x, float y) {
  const V3 under = unproject(x, y, now_.target);
  now_.height = std::max(now_.height / factor, 1e-300), turn();
  const V3 moved = unproject(x, y, now_.target);
  now_.target += under - moved;
  goal_ = now_, turn();
  framed_ = false;
}

void Camera::orbit(float dx, float dy) {
  now_.yaw -= dx * kRadiansPerPixel;
  now_.pitch = std::clamp(now_.pitch + dy * kRadiansPerPixel, -kSteepest, kSteepest);
  goal_ = now_, turn();
  framed_ = false;
}

void Camera::zoom_eased(double factor) {
  goal_.height = std::max(goal_.height / factor, 1e-300);
  framed_ = false;
}

void Camera::orbit_eased(double yaw, double pitch) {
  goal_.yaw += yaw;
  goal_.pitch = std::clamp(goal_.pitch + pitch, -kSteepest, kSteepest);
  framed_ = false;
}

std::vector<double> Camera::hand_view() const {
  if (framed_) return {};
  const double digits = 3 - std::floor(std::log10(goal_.height)), fine = std::pow(10.0, std::abs(digits));
  const auto rounded = [&](double value) {  // to a short decimal
    return digits > 0 ? std::round(value * fine) / fine : std::round(value / fine) * fine;
  };
  std::vector<double> view;
  if (dim_ == 3)
    for (const double angle : {goal_.yaw, goal_.pitch}) view.push_back(std::round(10 * angle / kDegree) / 10);
  view.push_back(rounded(goal_.height));
  for (int i = 0; i < dim_; ++i) view.push_back(rounded(goal_.target[i]));
  return view;
}

bool Camera::look_from(const std::vector<double>& view) {
  const std::size_t angles = dim_ == 3 ? 2 : 0;
  if (view.size() != angles + 1 + static_cast<std::size_t>(dim_) || !(view[angles] > 0)) return false;
  if (!std::all_of(view.begin(), view.end(), [](double number) { return std::isfinite(number); })) return false;
  if (dim_ == 3) goal_.yaw = kDegree * view[0], goal_.pitch = std::clamp(kDegree * view[1], -kSteepest, kSteepest);
  goal_.height = view[angles];
  for (int i = 0; i < dim_; ++i) goal_.target[i] = view[angles + 1 + static_cast<std::size_t>(i)];
  now_ = goal_, turn();
  framed_ = false, placed_ = true;
  return true;
}

bool Camera::moving() const {
  return (goal_.target - now_.target).norm() > 0 || goal_.height != now_.height || goal_.yaw != now_.yaw ||
         goal_.pitch != now_.pitch;
}

bool Camera::ease(double dt, bool at_once) {
  if (!moving()) return false;
  const double share = 1 - std::exp(-std::max(dt, 0.0) / kEaseSeconds);
  now_.target += (goal_.target - now_.target) * share;
  now_.height *= std::pow(goal_.height / now_.height, share);
  now_.yaw += (goal_.yaw - now_.yaw) * share;
  now_.pitch += (goal_.pitch - now_.pitch) * share;
  const bool arrived = (goal_.target - now_.target).norm() < kArrived * goal_.height &&
                       std::abs(std::log(goal_.height / now_.height)) < kArrived &&
                       std::abs(goal_.yaw - now_.yaw) < kArrived && std::abs(goal_.pitch - now_.pitch) < kArrived;
  if (arrived || at_once) now_ = goal_;
  turn();
  return moving();
}

}  // namespace snug::app
