// The app's side of a subject: what is drawn at a step, how its handles stand and move, what its panels say. Each has
// its folder in app/subjects; this is all that the stage, the inspector and the timeline know of any of them.
#pragma once

#include <string>
#include <string_view>

#include "app/look.hpp"
#include "app/shown.hpp"

namespace snug::app {

struct Brush;
class PointNames;

/// What the timeline's marks are called in its legend.
struct MarkWords {
  std::string grew = "first volume", replaced = "new support", best = "best so far";
};

/// One is made for each lesson that is opened. Where nothing else is said, a subject shows points, the volume that is
/// fitted to them, and the handles that the step names.
class SubjectView {
 public:
  SubjectView() = default;
  virtual ~SubjectView() = default;
  SubjectView(const SubjectView&) = delete;
  SubjectView& operator=(const SubjectView&) = delete;

  // ---- the picture --------------------------------------------------------------------------------------------
  /// Works out what the session's step shows. want_optimum: as of shown_at.
  virtual void refresh(const lesson::Session& session, bool want_optimum) = 0;
  /// What the last refresh found.
  [[nodiscard]] virtual const Shown& shown() const = 0;
  /// The geometry that the step speaks of. brush.volume is shown().volume, on its way there.
  virtual void draw(Brush& brush) const;
  /// The marks on the handles, over the geometry.
  virtual void draw_marks(Brush& brush) const;
  /// The names of those marks: they have their places before all other names.
  virtual void name_marks(PointNames& names) const;
  /// A second picture in the corner of the stage below a height. Returns the room that it takes; empty for none.
  [[nodiscard]] virtual Rect draw_inset(Brush& brush, float top) const;
  /// What the view has to have room for.
  [[nodiscard]] virtual fit::Sphere3 extent(const lesson::Session& session);
  /// Whether the volume passes from one step's place to the next one's; it jumps where what it encloses moves.
  [[nodiscard]] virtual bool glides() const { return true; }
  /// Whether the smallest volume can be shown before the end.
  [[nodiscard]] virtual bool offers_optimum() const { return false; }
  /// The world axis that the step works along, 0 to 2; -1 for none.
  [[nodiscard]] virtual int axis_in_use(const lesson::Session& session) const;

  // ---- the handles --------------------------------------------------------------------------------------------
  /// Where a handle stands at the step.
  [[nodiscard]] virtual Point3 place_of(const lesson::Session& session, Index i) const;
  /// Whether handles can be moved at the step.
  [[nodiscard]] virtual bool can_move(const lesson::Session& session) const;
  /// Whether each is drawn as a point.
  [[nodiscard]] virtual bool shows_points(const lesson::Session& session) const;
  /// Whether a handle bears its name where there is room for all names.
  [[nodiscard]] virtual bool bears_name(const lesson::Session& session, Index i) const;
  /// Whether, while a question is answered on the stage, what can be the answer bears its name, and nothing else.
  [[nodiscard]] virtual bool names_answers_alone() const { return false; }

  // ---- the inspector and the timeline -------------------------------------------------------------------------
  /// Draws the subject's own panels at a place of the current pane and returns how high they are.
  virtual float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const;
  /// Whether a panel says the figure already.
  [[nodiscard]] virtual bool in_panels(const lesson::Figure& figure) const;
  [[nodiscard]] virtual MarkWords mark_words(const lesson::Session& session) const;
  /// The word on the button that goes on by one.
  [[nodiscard]] virtual std::string_view step_button() const { return "Step"; }
  /// Seconds that a step takes while it plays at speed 1. watched: where the way to an outcome is watched, what each
  /// step of it takes at least; else 0.
  [[nodiscard]] virtual double seconds_of_step(const lesson::Session& session, double watched) const;
};

}  // namespace snug::app
