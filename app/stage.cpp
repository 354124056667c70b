#include "app/stage.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/beside.hpp"
#include "app/close_up.hpp"
#include "app/mesh_normals.hpp"
#include "app/numbers.hpp"
#include "app/widgets.hpp"
#include "geometry/sort.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {
namespace {

constexpr float kToolsHeight = 60, kToolsWidth = 64;  // on a narrow stage, with the room around them
constexpr float kWideStage = 560;
constexpr float kLowStage = 300, kLowMargin = 20;  // the tools of a low one stand beside the picture
constexpr double kFootSeconds = 0.06;  // the time in which the remaining way falls to 1/e, as for the camera
constexpr float kFootMargin = 16;
// Fractions of the free room at which an automatic view is framed again: too tight, or too roomy.
constexpr double kTight = 1.06, kRoomy = 0.7, kRoomyOutlined = 0.85;

float radius_for(Index points, bool has_surface) {
  if (has_surface) return 1.7f;
  return points <= 60 ? 5.0f : points <= 250 ? 4.0f : points <= 1000 ? 2.8f : 1.9f;
}

Camera camera_of(const lesson::Session& session) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto& angles = session.lesson().view.camera;
  return angles ? Camera(session.stage().subject().dim(), (*angles)[0] * kDegree, (*angles)[1] * kDegree)
                : Camera(session.stage().subject().dim());
}

std::array<float, 16> matrix_of(const Camera& camera, const Frame& frame) {
  const Rect& stage = camera.stage();
  const double width = std::max(1.0f, stage.width), height = std::max(1.0f, stage.height);
  const double x = 2 * (camera.center_x() - stage.x) / width - 1, y = 1 - 2 * (camera.center_y() - stage.y) / height;
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  if (camera.dim() == 2) {
    const double scale = camera.scale_at(Point3::Zero());
    const Point3 offset = (frame.origin - camera.view().target) * scale;
    m(0, 0) = 2 * frame.unit * scale / width, m(0, 3) = x + 2 * offset[0] / width;
    m(1, 1) = 2 * frame.unit * scale / height, m(1, 3) = y + 2 * offset[1] / height;
    m(3, 3) = 1;
  } else {
    // In stage units: only what is from a fiftieth of the view's height to a hundred heights away is drawn.
    const double view = camera.view().height / frame.unit, near = view / 50, far = view * 100;
    const Point3 eye = (camera.eye() - frame.origin) / frame.unit;
    const auto row = [&](const Point3& axis) { return Eigen::RowVector4d(axis[0], axis[1], axis[2], -axis.dot(eye)); };
    const Eigen::RowVector4d depth = row(camera.forward());
    m.row(0) = row(camera.right()) * (2 * camera.focal() / width) + depth * x;
    m.row(1) = row(camera.up()) * (2 * camera.focal() / height) + depth * y;
    m.row(2) = depth * ((far + near) / (far - near)) + Eigen::RowVector4d(0, 0, 0, -2 * far * near / (far - near));
    m.row(3) = depth;
  }
  std::array<float, 16> out{};
  for (int i = 0; i < 16; ++i) out[i] = static_cast<float>(m(i % 4, i / 4));
  return out;
}

}  // namespace

void Stage::open(const lesson::Session& session, SubjectView& view) {
  const std::uint64_t version = scene_.points_version;
  *this = Stage();
  scene_.points_version = version;  // the graphics persist, and have uploaded the last lesson's points as this version
  view_ = &view;
  has_close_up_ = session.lesson().view.inset.has_value();
  camera_ = camera_of(session);
  framed_ball_ = aimed_at(session);
  situation_ = session.stage().situation();
  seen_ = session.revision() - 1;
}

void Stage::open_anew(const lesson::Session& session, SubjectView& view) {
  const Camera camera = camera_;
  const Hands hands = hands_;
  const std::string situation = situation_;
  open(session, view);
  situation_ = situation;  // the session may stand in another one, in which that handle is not selected
  camera_kept_ = !camera.framed() && camera.dim() == session.stage().subject().dim();
  if (camera_kept_) camera_ = camera.with_home_of(camera_);
  if (hands.selected < session.stage().subject().size()) hands_.selected = hands.selected, hands_.arrows = hands.arrows;
}

void Stage::reset_view(const lesson::Session& session) {
  if (session.lesson().view.camera) {  // as it will be seen from there
    const Camera now = camera_;
    camera_.turn_home();
    camera_.frame(framed_ball_, true);
    framed_ball_ = aimed_at(session);
    camera_ = now;
    camera_.turn_home();
  } else {
    framed_ball_ = aimed_at(session);
  }
  camera_.frame(framed_ball_, false);
}

bool Stage::look_from(const lesson::Session& session, const std::vector<double>& view) {
  Camera camera = camera_.dim() == session.stage().subject().dim() ? camera_ : camera_of(session);
  if (!camera.look_from(view)) return false;
  camera_ = camera;
  camera_kept_ = scene_.points.empty();
  return true;
}

/// What the view is framed by: everything, unless the lesson's file says otherwise.
fit::Sphere3 Stage::aimed_at(const lesson::Session& session) const {
  const lesson::StageView& wish = session.lesson().view;
  fit::Sphere3 ball = ball_with_beside(session, view_->extent(session));
  if (const auto outline = outline_of(session)) ball = camera_.framing(*outline);
  ball.radius /= wish.zoom;
  if (const auto ends = wish.look_at ? ends_of(*wish.look_at, *view_, session) : std::nullopt)
    ball.center = ((*ends)[0] + (*ends)[1]) / 2;
  return ball;
}

/// The outline of the view alone would leave out what stands beside.
std::optional<Outline> Stage::outline_of(const lesson::Session& session) const {
  if (has_beside(session)) return std::nullopt;
  return view_->outline(session, camera_);
}

bool Stage::orbit_by(double yaw, double pitch) {
  if (camera_.dim() == 2) return false;
  camera_.orbit_eased(yaw, pitch);
  return true;
}

bool Stage::is_low(const Rect& rect) {
  return rect.width < kWideStage && rect.width > rect.height && rect.height <= kLowStage;
}

bool Stage::is_wide(const Rect& rect) { return rect.width >= kWideStage; }

void Stage::set_room(const Rect& rect, const Settings& settings) {
  const bool wide = is_wide(rect), low = is_low(rect);
  const float words = settings.text_scale * palette_of(settings.theme).text;
  // The sentence is at the foot, in two lines with a rim; on a page's narrow stage it stands below.
  const float sentence = wide || settings.prose_in_canvas ? 48 + 44 * words : low ? kLowMargin : 28;
  const float below = foot_ > 0 ? std::max(low ? 0 : sentence, foot_ + kFootMargin) : sentence;
  // Buttons are at the top; on a narrow stage they take most of its width, on a low one both sides.
  const float narrow = has_close_up_ ? room_above(words) : kToolsHeight;
  if (low)
    return camera_.set_stage(rect, (taken_.wide_tools ? kToolsHeight : kLowMargin) + taken_.above, kToolsWidth, below,
                             std::max(0.0f, taken_.inset_right - kToolsWidth));
  camera_.set_stage(rect, (wide ? 20 + 32 * words : narrow) + taken_.above, wide ? 56.0f : 28, below);
}

/// Moves the picture out of the way when a card comes or goes.
void Stage::ease_foot(const Look& look, double dt) {
  foot_goal_ = look.foot;
  if (foot_ == foot_goal_) return;
  const float left = (foot_goal_ - foot_) * static_cast<float>(std::exp(-dt / kFootSeconds));
  foot_ = look.still || scene_.points.empty() || std::abs(left) < 0.5f ? foot_goal_ : foot_goal_ - left;
}

/// Updates what changed in the session since the last frame.
void Stage::sync(const lesson::Session& session, const Settings& settings) {
  if (camera_.dim() != session.stage().subject().dim()) {
    const Rect stage = camera_.stage();
    camera_ = camera_of(session);
    set_room(stage, settings);
    scene_.points.clear();
    hands_.selected = kNoIndex;
  }
  const bool first = scene_.points.empty();
  points_moved_ = false;
  const LocalFrame* const frame = view_->local_frame(session);
  const bool in_frame = frame != nullptr && frame->is_shown();
  if (!first && seen_ == session.revision() && seen_optimum_ == settings.show_optimum && seen_in_frame_ == in_frame)
    return;
  seen_ = session.revision();
  seen_in_frame_ = in_frame;
  seen_optimum_ = settings.show_optimum;
  view_->refresh(session, settings.show_optimum && !session.telling().predicting());
  if (!view_->can_move(session)) hands_.arrows = false;
  if (first) {
    framed_ball_ = aimed_at(session);
    if (!std::exchange(camera_kept_, false)) {
      camera_.frame(framed_ball_, true);
      framed_ball_ = aimed_at(session);  // as it is seen from there
      camera_.frame(framed_ball_, true);
    }
  }
  const bool elsewhere = std::exchange(situation_, session.stage().situation()) != session.stage().situation();
  keep_framed(session, elsewhere);
  const bool gone = hands_.selected >= session.stage().subject().size() ||
                    (hands_.selected != kNoIndex && !view_->draws(session, hands_.selected));
  if (elsewhere || gone) select(kNoIndex);  // another handle would have its number
  upload_points(session);
}

void Stage::upload_points(const lesson::Session& session) {
  std::vector<Point3f> points;
  points.reserve(session.stage().subject().size());
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (view_->is_point(session, i)) points.push_back(frame_.to_stage(view_->place_of(session, i)));
  const lesson::HasPoints* const own = session.stage().subject().with_points();
  const auto triangles = own != nullptr ? own->triangles() : std::span<const std::array<Index, 3>>();
  points_moved_ = points != scene_.points || triangles.size() != scene_.triangles.size();
  if (!points_moved_) return;
  scene_.points = std::move(points);
  scene_.triangles.assign(triangles.begin(), triangles.end());
  scene_.normals = scene_.triangles.empty() ? std::vector<Point3f>{} : mesh_normals(scene_.points, scene_.triangles);
  ++scene_.points_version;
}

/// An automatic view follows the points when they outgrow it or shrink, but never during a drag. anew: others stand
/// there now, whose size has nothing to do with that of those before.
void Stage::keep_framed(const lesson::Session& session, bool anew) {
  if (hands_.dragging) return;
  const fit::Sphere3 all = view_->extent(session);
  if (camera_.framed()) {
    const fit::Sphere3 aim = aimed_at(session);
    const double share = camera_.share_of_room(aim);
    const bool elsewhere = (aim.center - framed_ball_.center).norm() > 0.25 * framed_ball_.radius;
    const bool misfits = share > kTight || share < (is_outlined() ? kRoomyOutlined : kRoomy);
    if (anew || misfits || (elsewhere && !camera_.moving())) {
      framed_ball_ = aim;
      camera_.frame(aim, false);
    }
  }
  const double unit = all.radius > 0 ? all.radius : 1;
  const bool off = (all.center - frame_.origin).norm() > 4 * frame_.unit;
  if (scene_.points.empty() || off || unit > 4 * frame_.unit || unit < frame_.unit / 4) {
    frame_ = {all.center, unit};  // so that floats are precise enough around it
    scene_.points.clear();
  }
}

/// An outline that fills the free room is framed again whenever the room has changed, as by a card that comes or goes;
/// and so is what has lost its outline, because the room has become too narrow for it.
void Stage::keep_outline_framed(const lesson::Session& session) {
  const std::array<double, 2> room = camera_.room();
  if (room == framed_room_ || hands_.dragging || !camera_.framed()) return;
  const bool outlined = outline_of(session).has_value(), was_outlined = is_outlined();
  if (!outlined && !was_outlined) return;
  framed_room_ = outlined ? room : std::array<double, 2>{};
  framed_ball_ = aimed_at(session);
  camera_.frame(framed_ball_, !camera_.moving());
}

void Stage::project_points(const lesson::Session& session) {
  screen_.resize(session.stage().subject().size());
  const bool surface = !scene_.normals.empty();
  const Point3f eye = surface ? frame_.to_stage(camera_.eye()) : Point3f::Zero();
  for (Index i = 0; i < session.stage().subject().size(); ++i) {
    const std::size_t k = i;
    screen_[k] = camera_.project(view_->place_of(session, i));
    // A vertex on the far side of a closed surface can be neither seen nor picked.
    if (surface && k < scene_.normals.size() && scene_.normals[k].dot(eye - scene_.points[k]) < 0)
      screen_[k].visible = false;
    if (!view_->shows(session, i)) screen_[k].visible = false;
  }
}

void Stage::fill_scene(const Look& look, const Rect& rect, float point_radius, bool points) {
  const Palette& p = *look.palette;
  scene_.stage = rect;
  scene_.ground = p.ground, scene_.grid = p.grid, scene_.surface = p.surface;
  scene_.three_d = camera_.dim() == 3;
  scene_.point = scene_.normals.empty() ? with_alpha(p.point, 0.92f) : with_alpha(p.point, 0.55f);
  if (!points) scene_.point = 0;
  scene_.point_radius = point_radius * std::sqrt(p.mark);
  scene_.view_projection = matrix_of(camera_, frame_);
  scene_.volumes.clear();
  scene_.marks.reset();
  if (!scene_.three_d) {
    const double scale = camera_.scale_at(Point3::Zero());
    const double step = nice_at_least(32 / scale);  // cells of 32 to 80 pixels
    const Point3 target = camera_.view().target;
    const auto rest = [&](double at) { return static_cast<float>(std::fmod(-at, step) * scale); };
    scene_.grid_step = static_cast<float>(step * scale);
    scene_.grid_x = camera_.center_x() - rect.x + rest(target[0]);
    scene_.grid_y = rect.y + rect.height - camera_.center_y() + rest(target[1]);
    return;
  }
  scene_.grid = with_alpha(p.line, 0.7f);
  scene_.eye = frame_.to_stage(camera_.eye());
  scene_.eye_to_target = static_cast<float>((camera_.eye() - camera_.view().target).norm() / frame_.unit);
  scene_.focal = static_cast<float>(camera_.focal());
  scene_.light = (-0.5 * camera_.right() + 0.75 * camera_.up() - 0.55 * camera_.forward()).normalized().cast<float>();
  scene_.plane_height = -1.25f;
  scene_.plane_step = 0.25f;
  scene_.plane_reach = 5;
}

/// The volume, possibly moving towards the step's volume.
std::optional<fit::Volume3> Stage::volume_drawn(const Look& look, const lesson::Session& session, double now) {
  const bool stepped =
      session.player().step() != seen_step_ && seen_run_ == session.player().method(0) && !points_moved_;
  const bool jump =
      session.stage().subject().frames() != nullptr || look.still || hands_.dragging || (!stepped && !motion_.moving());
  seen_step_ = session.player().step();
  seen_run_ = session.player().method(0);
  return motion_.at(view_->shown().volume, jump, now);
}

/// What else than the picture takes room. wide_tools: buttons with words, which reach far into a low stage.
Stage::Taken Stage::taken_now(const Look& look, const lesson::Session& session, const Rect& rect) const {
  Taken taken{.inset_right = is_low(rect) ? inset_.x + inset_.width - rect.x : 0};
  if (inset_.width <= 0) taken.inset_right = 0;
  if (camera_.dim() == session.stage().subject().dim()) taken.above = view_->room_of_inset(look, session, rect);
  taken.wide_tools = look.tools_right > 0 || view_->local_frame(session) != nullptr ||
                     (!view_->optimum_button().empty() && !session.telling().predicting());
  return taken;
}

void Stage::draw(const Look& look, Settings& settings, lesson::Session& session, const Rect& rect, double now) {
  const double dt = std::clamp(now - last_now_, 0.0, 0.05);
  const float foot = foot_;
  const Taken taken = taken_;
  if (!hands_.dragging) {  // what is dragged stays under the pointer
    ease_foot(look, dt);
    taken_ = taken_now(look, session, rect);
  }
  set_room(rect, settings);
  if ((foot_ != foot || taken_ != taken) && camera_.framed() && framed_ball_.radius > 0)
    camera_.frame(framed_ball_, !camera_.moving());
  if (view_->take_room(rect, camera_.shape_of_room())) --seen_;  // it is framed anew
  if (camera_.dim() == session.stage().subject().dim()) {
    project_points(session);
    take(session, look, rect);
  }
  sync(session, settings);
  keep_outline_framed(session);
  camera_.ease(dt, look.still);
  last_now_ = now;
  auto volume = volume_drawn(look, session, now);

  project_points(session);
  const float radius = radius_for(lesson::count_of(session.stage().subject()), !scene_.triangles.empty()) *
                       static_cast<float>(session.lesson().view.point_size);
  fill_scene(look, rect, radius, view_->shows_points(session));
  if (!settings.ground) scene_.ground = scene_.grid = 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, true);
  Obstacles obstacles;
  Brush brush{.list = list,
              .look = look,
              .p = *look.palette,
              .session = session,
              .view = *view_,
              .rect = rect,
              .canvas = {list, look, camera_, frame_, scene_, obstacles},
              .hands = hands_,
              .handles = screen_,
              .point_radius = radius,
              .volume = std::move(volume),
              .labels = {}};
  draw_picture(brush);
  draw_handles(brush);
  draw_notes(brush, settings);
  if (settings.labels) draw_labels(brush);
  list->PopClipRect();
}

/// Draws the lines that join the points in their order.
void Stage::draw_outline(Brush& brush) {
  if (!brush.session.lesson().view.outline || brush.session.stage().subject().points() == nullptr) return;
  std::vector<ImVec2> corners;
  for (Index i = 0; i < lesson::count_of(brush.session.stage().subject()); ++i)
    corners.push_back(brush.at(brush.point(i)));
  path(brush.list, corners, true, Stroke::kSolid, with_alpha(brush.p.point, 0.8f), brush.stroke(0.6f));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ImVec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
}

void Stage::draw_picture(Brush& brush) const {
  draw_outline(brush);
  view_->draw(brush);
  draw_beside(brush);
  // The farthest first, so that nearer volumes are blended over farther ones.
  auto& volumes = brush.canvas.gl.volumes;
  sort_stably(volumes, [&](const GlVolume& a, const GlVolume& b) {
    return (a.center - scene_.eye).squaredNorm() > (b.center - scene_.eye).squaredNorm();
  });
}

std::optional<Handle> Stage::place_named(const lesson::Session& session, std::string_view name) const {
  for (std::size_t i = 0; i < screen_.size(); ++i)
    if (screen_[i].visible && session.stage().subject().name_of(static_cast<Index>(i)) == name)
      return Handle{std::string(name), screen_[i].x, screen_[i].y};
  return std::nullopt;
}

std::vector<Handle> Stage::handles(const lesson::Session& session) const {
  std::vector<Handle> handles;
  if (!view_->can_move(session)) return handles;
  for (std::size_t i = 0; i < screen_.size(); ++i)
    if (screen_[i].visible && (session.stage().conduct().decides || session.stage().may_move(static_cast<Index>(i))))
      handles.push_back({session.stage().subject().name_of(static_cast<Index>(i)), screen_[i].x, screen_[i].y});
  return handles;
}

}  // namespace snug::app
