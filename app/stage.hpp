// The stage: draws the subject's picture, and handles the pointer.
#pragma once

#include <vector>

#include "app/brush.hpp"
#include "app/motion.hpp"

namespace snug::app {

class Stage {
 public:
  /// Frames a session that was just opened, and forgets the selection. view: that of the session; it must live as long.
  void open(const lesson::Session& session, SubjectView& view);
  /// The same where the lesson was read anew: a view that a hand has taken stays, and so does the selection.
  void open_anew(const lesson::Session& session, SubjectView& view);
  void draw(const Look& look, Settings& settings, lesson::Session& session, const Rect& rect, double now);
  /// Whether something on it moves without any input.
  [[nodiscard]] bool moving() const {
    return motion_.moving() || camera_.moving() || foot_ != foot_goal_ || (view_ != nullptr && view_->working());
  }
  [[nodiscard]] const GlScene& scene() const { return scene_; }

  /// Moves the selected point by the arrow keys' step; directions on the screen. away: into the screen, in 3-D.
  bool nudge(lesson::Session& session, int right, int up, int away, bool fine);
  bool add_point(lesson::Session& session);
  bool delete_point(lesson::Session& session);
  void reset_view(const lesson::Session& session);
  /// As App::look_from.
  bool look_from(const lesson::Session& session, const std::vector<double>& view);
  void zoom_by(double factor) { camera_.zoom_eased(factor); }
  bool orbit_by(double yaw, double pitch);
  void pinch(float factor, float x, float y, float dx, float dy);

  [[nodiscard]] Index selected() const { return hands_.selected; }
  /// Whether a handle is on the stage.
  [[nodiscard]] bool shows(const lesson::Session& session, Index i) const { return view_->shows(session, i); }
  [[nodiscard]] Index hovered() const { return hands_.hovered; }
  /// Lights a mark of the prose (lesson/speaking.hpp) until another is lit; "" lights none.
  void light(std::string_view mark);
  [[nodiscard]] const std::string& lit() const { return lit_; }
  /// Selects a point deliberately: the arrow keys move it from now on.
  void select(Index point) {
    hands_.selected = point;
    hands_.arrows = point != kNoIndex;
  }
  /// Whether the arrow keys move the selected point. A drag or an answer leaves them to the player.
  [[nodiscard]] bool arrows_move() const { return hands_.arrows && hands_.selected != kNoIndex; }
  [[nodiscard]] std::vector<Handle> handles(const lesson::Session& session) const;
  [[nodiscard]] std::optional<Handle> place_named(const lesson::Session& session, std::string_view name) const;
  /// The camera of the last frame.
  [[nodiscard]] const Camera& camera() const { return camera_; }
  /// The lesson's close-up in the last frame.
  [[nodiscard]] const std::optional<CloseUp>& close_up() const { return close_up_; }
  [[nodiscard]] bool dragging() const { return hands_.dragging; }

 private:
  /// Where a place of the world is shown now, and back.
  [[nodiscard]] Point3 shown_at(const lesson::Session& session, const Point3& at) const;
  [[nodiscard]] Point3 meant_by(const lesson::Session& session, const Point3& shown) const;
  // stage.cpp
  void sync(const lesson::Session& session, const Settings& settings);
  void keep_framed(const lesson::Session& session, bool anew);
  void keep_outline_framed(const lesson::Session& session);
  [[nodiscard]] fit::Sphere3 aimed_at(const lesson::Session& session) const;
  [[nodiscard]] std::optional<Outline> outline_of(const lesson::Session& session) const;
  struct Taken {
    float above = 0;        // as of SubjectView::room_of_inset
    float inset_right = 0;  // how far the second picture reaches into a low stage
    bool wide_tools = false;
    bool operator==(const Taken&) const = default;
  };
  [[nodiscard]] Taken taken_now(const Look& look, const lesson::Session& session, const Rect& rect) const;
  /// Whether the stage is so low that no row of it is given to buttons: that of a phone on its side.
  [[nodiscard]] static bool is_low(const Rect& rect);
  /// Whether the sentence is on it, on a page too.
  [[nodiscard]] static bool is_wide(const Rect& rect);
  void set_room(const Rect& rect, const Settings& settings);
  void ease_foot(const Look& look, double dt);
  void upload_points(const lesson::Session& session);
  void project_points(const lesson::Session& session);
  [[nodiscard]] std::optional<fit::Volume3> volume_drawn(const Look& look, const lesson::Session& session, double now);
  void fill_scene(const Look& look, const Rect& rect, float point_radius, bool points);
  void draw_picture(Brush& brush) const;
  static void draw_outline(Brush& brush);
  // stage_hands.cpp
  void take(lesson::Session& session, const Look& look, const Rect& rect);
  void press(lesson::Session& session, const Look& look);
  void drag(lesson::Session& session);
  void release(lesson::Session& session);
  void let_go();
  void tap(lesson::Session& session);
  [[nodiscard]] Index meant_at(const lesson::Session& session, float x, float y, float reach) const;
  [[nodiscard]] Index grabbed(const lesson::Session& session, const Look& look, float x, float y) const;
  void steer_camera();
  /// Whether the view was framed by an outline.
  [[nodiscard]] bool is_outlined() const { return framed_room_[0] > 0; }
  // stage_handles.cpp
  void draw_handles(Brush& brush) const;
  void draw_invitation(Brush& brush) const;
  void draw_hovered(Brush& brush) const;
  void draw_lit(Brush& brush) const;
  void draw_selected(Brush& brush) const;
  void draw_verdict(Brush& brush) const;
  void name_handles(Brush& brush) const;
  // stage_labels.cpp
  static void draw_labels(Brush& brush);
  // stage_close_up.cpp
  void draw_close_up(const Brush& brush, float top);
  void draw_in_close_up(Brush& close) const;
  // stage_notes.cpp
  void draw_notes(Brush& brush, Settings& settings);
  void draw_tools(Brush& brush, Settings& settings, float y, float height);
  void draw_toggle(Brush& brush, Settings& settings, float right, float y, float height);
  /// inset: the second picture, which it keeps clear of.
  void draw_axis_cross(Brush& brush, const Rect& inset, const Rect& sentence) const;

  SubjectView* view_ = nullptr;
  Camera camera_;
  bool camera_kept_ = false;  // whether it stays at the first refresh
  Frame frame_;
  fit::Sphere3 framed_ball_;
  std::array<double, 2> framed_room_{};  // the free room that an outline was framed for
  GlScene scene_;
  Motion motion_;
  std::vector<ScreenPoint> screen_;
  bool has_close_up_ = false;  // whether the lesson asks for one
  std::optional<CloseUp> close_up_;

  std::uint64_t seen_ = 0;  // the session's revision at the last refresh
  bool seen_optimum_ = false;
  bool seen_in_frame_ = false;
  bool points_moved_ = false;
  int seen_step_ = -1;
  const void* seen_run_ = nullptr;
  double last_now_ = 0;
  Taken taken_;
  Rect inset_;                      // the second picture in the last frame
  float foot_ = 0, foot_goal_ = 0;  // as in Layout: the current value, and the one that it moves to

  Hands hands_;
  std::string situation_;  // the one that the selected handle is of
  std::string lit_;
  Index pressed_ = kNoIndex;  // the handle that a drag from the press moves
  Index tapped_ = kNoIndex;   // the handle that the press means if it is no drag
  bool pressing_ = false;     // whether a button that was pressed on the stage is down
  bool panning_ = false;
  float press_x_ = 0, press_y_ = 0, grab_x_ = 0, grab_y_ = 0;
  bool travelled_ = false;  // whether the pointer has moved since the press
};

}  // namespace snug::app
