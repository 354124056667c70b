// The app's side of a subject: what is drawn at a step, where its handles are and move, what its panels show. Each has
// its folder in app/subjects; the stage, the inspector and the timeline know only this interface.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/camera.hpp"
#include "app/look.hpp"
#include "app/panel_words.hpp"
#include "app/shown.hpp"

namespace snug::app {

struct Brush;
class PointNames;

/// The names of the timeline's marks in its legend.
struct MarkWords {
  std::string grew = "first volume", replaced = "new support", best = "best so far", wrong = "first wrong test";
};

/// What a second picture so many pixels high takes from the first (SubjectView::room_of_inset): nothing, and they
/// overlap, if that left the first less than so much height.
[[nodiscard]] float room_over_picture(const Look& look, const Rect& stage, float height, float least);

/// Another coordinate system in which the stage can be shown.
class LocalFrame {
 public:
  [[nodiscard]] virtual std::string_view button() const = 0;
  [[nodiscard]] virtual bool is_shown() const = 0;
  virtual void show(bool on) = 0;
  /// Where a place of the world is shown now, and back.
  [[nodiscard]] virtual Point3 place_shown(const lesson::Session& session, const Point3& at) const = 0;
  [[nodiscard]] virtual Point3 place_meant(const lesson::Session& session, const Point3& shown) const = 0;

 protected:
  ~LocalFrame() = default;
};

/// The view of a subject; one is made for each opened lesson. By default it shows points, the volume fitted to them,
/// and the handles that the step names.
class SubjectView {
 public:
  SubjectView() = default;
  virtual ~SubjectView() = default;
  SubjectView(const SubjectView&) = delete;
  SubjectView& operator=(const SubjectView&) = delete;

  // ---- the picture --------------------------------------------------------------------------------------------
  /// Computes what the session's step shows. want_optimum: as for shown_at.
  virtual void refresh(const lesson::Session& session, bool want_optimum) = 0;
  /// The result of the last refresh.
  [[nodiscard]] virtual const Shown& shown() const = 0;
  /// Draws the geometry that the step is about. brush.volume is shown().volume, possibly still moving.
  virtual void draw(Brush& brush) const;
  /// Draws the marks on the handles, over the geometry.
  virtual void draw_marks(Brush& brush) const;
  /// Names those marks; their names are placed before all others.
  virtual void name_marks(PointNames& names) const;
  /// Draws a second picture in the corner of the stage, from its own upper left corner on. Returns the room that it
  /// takes; empty for none.
  [[nodiscard]] virtual Rect draw_inset(Brush& brush, ImVec2 at) const;
  /// How high the part of the stage is that its second picture takes from the first, pixels; 0 if they may overlap.
  [[nodiscard]] virtual float room_of_inset(const Look&, const lesson::Session&, const Rect&) const { return 0; }
  /// Arranges the picture for a stage on which it has room for that shape, width over height. Returns whether anything
  /// has changed.
  virtual bool take_room(const Rect&, double) { return false; }
  /// The ball that the view has to show.
  [[nodiscard]] virtual fit::Sphere3 extent(const lesson::Session& session);
  /// The same as it is seen, which frames it more tightly; none if only the ball is known.
  [[nodiscard]] virtual std::optional<Outline> outline(const lesson::Session&, const Camera&) const { return {}; }
  /// The button that shows the smallest volume, or what the lesson compares with, before the end; empty for none.
  [[nodiscard]] virtual std::string_view optimum_button() const { return {}; }
  /// The coordinate axis that the step works along, 0 to 2; -1 for none.
  [[nodiscard]] virtual int axis_in_use(const lesson::Session& session) const;

  /// Goes on for a part of a frame with what the panels measure: drawing them does it, and so does a door that cannot
  /// draw.
  virtual void work(lesson::Session&) const {}
  /// Whether its panels work on something, so that the next frame is wanted.
  [[nodiscard]] virtual bool working() const { return false; }
  /// The frame in which the stage can be shown besides the world's; null for none.
  [[nodiscard]] virtual LocalFrame* local_frame(const lesson::Session&) { return nullptr; }

  /// Lights a mark of the prose that is no handle, until another is lit; "" for none.
  virtual void light(std::string_view) {}

  // ---- the handles --------------------------------------------------------------------------------------------
  /// Where a handle is at the step.
  [[nodiscard]] virtual Point3 place_of(const lesson::Session& session, Index i) const;
  /// Whether handles can be moved at the step.
  [[nodiscard]] virtual bool can_move(const lesson::Session& session) const;
  /// Whether a handle is on the stage at all: it may belong to a method that is not shown.
  [[nodiscard]] virtual bool shows(const lesson::Session& session, Index i) const;
  /// Whether a handle is a point, or else something that the view draws itself.
  [[nodiscard]] virtual bool is_point(const lesson::Session& session, Index i) const;
  /// Whether anything is at a handle: a point stands there even while no hand can take it, as A's in A's frame.
  [[nodiscard]] bool draws(const lesson::Session& session, Index i) const {
    return shows(session, i) || is_point(session, i);
  }
  /// Whether the points are drawn.
  [[nodiscard]] virtual bool shows_points(const lesson::Session& session) const;
  /// How far what is at a handle reaches on the screen, pixels, beside which its name is placed; 0 for a point.
  [[nodiscard]] virtual float reach_of(const Brush& brush, Index i) const;
  /// Whether a handle is named if there is room for all names.
  [[nodiscard]] virtual bool bears_name(const lesson::Session& session, Index i) const;
  /// Whether a handle is named in any crowd, because its name stands elsewhere in the picture as well.
  [[nodiscard]] virtual bool needs_name(const lesson::Session&, Index) const { return false; }
  /// Whether names may stand over opaque bodies, on which a halo is too little.
  [[nodiscard]] virtual bool names_over_bodies(const lesson::Session&) const { return false; }
  /// Whether the view itself writes a handle's name beside what it draws.
  [[nodiscard]] virtual bool writes_name(const lesson::Session&, Index) const { return false; }
  /// Whether only possible answers are named while a question is answered on the stage.
  [[nodiscard]] virtual bool names_answers_alone() const { return false; }

  // ---- the inspector and the timeline -------------------------------------------------------------------------
  /// What the figures at the step are: "Final result".
  [[nodiscard]] virtual std::string_view figures_are(const lesson::Session& session) const;
  /// Draws the subject's own panels at a place of the current pane and returns how high they are.
  virtual float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const;
  /// What the panels tell beyond the figures, in words.
  [[nodiscard]] virtual std::vector<PanelWords> panel_words(const lesson::Session&) const { return {}; }
  /// Runs the command of a panel's button. Returns false if it is unknown or impossible now.
  virtual bool command(lesson::Session&, std::string_view) const { return false; }
  /// Whether the panels have so many rows that they may need the inspector's whole column.
  [[nodiscard]] virtual bool fills_column(const lesson::Session& session) const;
  /// Whether a panel shows the figure already.
  [[nodiscard]] virtual bool in_panels(const lesson::Figure& figure) const;
  [[nodiscard]] virtual MarkWords mark_words(const lesson::Session& session) const;
};

}  // namespace snug::app
