// The stage: the points, the volumes of the step, and the hands on them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/camera.hpp"
#include "app/look.hpp"
#include "app/shown.hpp"
#include "app/stage_gl.hpp"
#include "app/volumes.hpp"

namespace snug::app {

/// A label that is still to be placed.
struct Label {
  LabelRequest request;
  std::string words;
  Face face = Face::kSemiBold;
  float size = 14;
  Color color = 0;
};

/// The volume on its short way from one step's place to the next one's.
class Motion {
 public:
  /// The volume to draw. jump: go there at once.
  [[nodiscard]] std::optional<fit::Volume3> at(const std::optional<fit::Volume3>& target, bool jump, double now);
  [[nodiscard]] bool moving() const { return moving_; }

 private:
  std::optional<fit::Volume3> from_, to_, drawn_;
  double since_ = 0;
  bool moving_ = false;
};

/// Where a point is in the frame of the scene that stands: with the body that it is of, or that stands at it. Without a
/// scene session.point.
[[nodiscard]] Point3 place_of(const lesson::Session& session, Index i);
/// Whether points are drawn as such: not where a body stands at each.
[[nodiscard]] bool shows_points(const lesson::Session& session);
/// Whether points can be moved on the stage. What a scene moves is placed where it begins.
[[nodiscard]] bool can_move(const lesson::Session& session);
/// What a scene takes up in all of its frames.
[[nodiscard]] fit::Sphere3 extent_of_scene(const lesson::Session& session);

class Stage {
 public:
  /// Frames a session that was just opened, and forgets the selection.
  void open(const lesson::Session& session);
  void draw(const Look& look, Settings& settings, lesson::Session& session, const Rect& rect, double now);
  /// Whether something on it is under way without any input.
  [[nodiscard]] bool moving() const { return motion_.moving() || camera_.moving(); }
  [[nodiscard]] const GlScene& scene() const { return scene_; }

  /// Moves the selected point by the arrow keys' step; directions on the screen. away: into it, in 3-D.
  bool nudge(lesson::Session& session, int right, int up, int away, bool fine);
  bool add_point(lesson::Session& session);
  bool delete_point(lesson::Session& session);
  void reset_view(const lesson::Session& session);
  void zoom_by(double factor) { camera_.zoom_eased(factor); }
  bool orbit_by(double yaw, double pitch);
  void pinch(float factor, float x, float y, float dx, float dy);

  [[nodiscard]] Index selected() const { return selected_; }
  /// Deliberately: the arrow keys move it from now on.
  void select(Index point) {
    selected_ = point;
    arrows_ = point != kNoIndex;
  }
  /// Whether the arrow keys move the selected point. A drag or an answer leaves them to the player.
  [[nodiscard]] bool arrows_move() const { return arrows_ && selected_ != kNoIndex; }
  [[nodiscard]] std::vector<Handle> handles(const lesson::Session& session) const;
  /// A point's place on the screen as last drawn.
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] bool dragging() const { return dragging_; }

 private:
  struct Brush;  // what drawing needs, for the length of a frame
  struct Ruler;  // an axis of two boxes on the screen

  // stage.cpp
  void sync(const lesson::Session& session, const Settings& settings);
  void keep_framed(const lesson::Session& session);
  void set_room(const Rect& rect, const Settings& settings);
  void project_points(const lesson::Session& session);
  void fill_scene(const Look& look, const Rect& rect);
  // stage_hands.cpp
  void hands(lesson::Session& session, const Look& look, const Rect& rect);
  void press(lesson::Session& session, const Look& look);
  void drag(lesson::Session& session);
  void release(lesson::Session& session);
  void tap(lesson::Session& session);
  [[nodiscard]] static bool is_asked(const lesson::Session& session);  // whether a question is answered on the stage
  [[nodiscard]] Index meant_at(const lesson::Session& session, float x, float y, float reach) const;
  void steer_camera();
  // stage_volumes.cpp
  void draw_volumes(Brush& brush) const;
  void draw_current(Brush& brush) const;
  void draw_radius(Brush& brush, const fit::Sphere3& ball) const;
  [[nodiscard]] Point3 top_of(const fit::Volume3& volume, double right) const;
  void draw_rivals(Brush& brush) const;
  void draw_candidate(Brush& brush) const;
  void draw_extremes(Brush& brush) const;
  void draw_spread(Brush& brush) const;
  void draw_axis_ends(Brush& brush) const;
  void draw_hull(Brush& brush) const;
  // stage_boxes.cpp
  void draw_boxes(Brush& brush) const;
  void draw_wrong_test(Brush& brush, const lesson::BoxPair& pair) const;
  void draw_knobs(Brush& brush, const lesson::BoxPair& pair, int box) const;
  void draw_projections(Brush& brush, const lesson::BoxPair& pair) const;
  static void draw_gap(const Ruler& ruler, const query::AxisTested<double, 3>& axis);
  void draw_asked_axis(Brush& brush, const lesson::BoxPair& pair) const;
  // stage_frustum.cpp
  void draw_frustum(Brush& brush, const lesson::BoxPair& pair) const;
  void draw_camera(Brush& brush, const lesson::BoxPair& pair) const;
  void draw_plane(Brush& brush, const lesson::BoxPair& pair, int plane) const;
  void draw_box_axes(Brush& brush, const lesson::BoxPair& pair) const;
  void draw_distances(Brush& brush, const lesson::BoxPair& pair) const;
  void draw_corners(Brush& brush) const;
  // stage_scene.cpp
  void draw_scene(Brush& brush) const;
  void draw_traces(Brush& brush, const lesson::SceneFrame& frame) const;
  void draw_loose(Brush& brush, const lesson::SceneFrame& frame) const;
  void draw_bodies(Brush& brush, const lesson::SceneFrame& frame) const;
  void draw_body(Brush& brush, const scene::Shape& shape, const scene::Motion& body, bool touching) const;
  void draw_faces(Brush& brush, const scene::Shape& shape, const scene::Motion& body, Color fill, Color edge,
                  float width) const;  // width 0: no edges
  void draw_pairs(Brush& brush, const lesson::SceneFrame& frame) const;
  // stage_inset.cpp
  [[nodiscard]] Rect draw_inset(Brush& brush, float top) const;
  // stage_points.cpp
  void draw_points(Brush& brush) const;
  void draw_invitation(Brush& brush) const;
  void draw_selected(Brush& brush) const;
  void draw_verdict(Brush& brush) const;
  void name_points(Brush& brush) const;
  void draw_labels(Brush& brush) const;
  // stage_notes.cpp
  void draw_notes(Brush& brush, Settings& settings);
  void draw_toggle(Brush& brush, Settings& settings, float right, float y, float height);
  void draw_axis_cross(Brush& brush) const;

  /// What the view has to have room for.
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session);
  struct SceneExtent {
    std::uint64_t trace;
    const fit::Algorithm* beside;
    fit::Sphere3 ball;
  };

  Camera camera_;
  Frame frame_;
  fit::Sphere3 framed_ball_;
  std::optional<SceneExtent> scene_extent_;  // worked out once a run: of thousands of bodies in all frames
  GlScene scene_;
  Shown shown_;
  Motion motion_;
  std::optional<fit::Volume3> volume_;  // as drawn, on its way
  std::vector<ScreenPoint> screen_;
  std::vector<bool> special_;  // points that have a mark of their own
  float point_radius_ = 5;
  bool points_shown_ = true;

  std::uint64_t seen_ = 0;  // the session's revision that shown_ is of
  bool seen_optimum_ = false;
  bool points_moved_ = false;
  int seen_step_ = -1;
  const void* seen_run_ = nullptr;
  double last_now_ = 0;

  Index selected_ = kNoIndex;
  Index hovered_ = kNoIndex;
  bool arrows_ = false;       // whether arrow keys move the selected point
  Index pressed_ = kNoIndex;  // what a drag from the press moves
  Index tapped_ = kNoIndex;   // what the press means if it does not travel
  bool pressing_ = false;     // a button is down that went down on the stage
  bool panning_ = false;
  bool grabs_ = false;  // a press where the pointer is would grab a point
  bool dragging_ = false;
  float press_x_ = 0, press_y_ = 0, grab_x_ = 0, grab_y_ = 0;
  bool travelled_ = false;  // since the press
};

}  // namespace snug::app
