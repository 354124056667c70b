#include "app/subject.hpp"

#include "app/fitted.hpp"
#include "app/point_marks.hpp"
#include "app/polytope.hpp"

namespace snug::app {

void SubjectView::draw(Brush& brush) const {
  draw_compared(brush, shown());
  draw_fitted(brush, shown());
}

void SubjectView::draw_marks(Brush& brush) const {
  draw_support(brush, shown());
  draw_spoken_of(brush, shown());
  draw_examined(brush, shown(), among(shown().support, shown().examined));
}

void SubjectView::name_marks(PointNames& names) const { names.plain(shown().support); }

Rect SubjectView::draw_inset(Brush&, ImVec2) const { return {}; }

fit::Sphere3 SubjectView::extent(const lesson::Session& session) {
  const auto ball = [&](int slot) {
    const lesson::Run& run = session.player().run(slot);
    const fit::Volume3* volume = run.volume(run.steps());
    return volume != nullptr ? ball_around(*volume, session.stage().subject().dim())
                             : fit::Sphere3{session.stage().subject().at(0), 1};
  };
  const fit::Sphere3 result = session.player().method(1) == nullptr ? ball(0) : ball_around(ball(0), ball(1));
  // On the way there it may be larger, or reach out elsewhere.
  return shown().volume ? ball_around(result, ball_around(*shown().volume, session.stage().subject().dim())) : result;
}

float room_over_picture(const Look& look, const Rect& stage, float height, float least) {
  return stage.height - look.foot - height < look.px(least) ? 0 : height;
}

int SubjectView::axis_in_use(const lesson::Session&) const { return -1; }
Point3 SubjectView::place_of(const lesson::Session& session, Index i) const { return session.stage().subject().at(i); }
bool SubjectView::can_move(const lesson::Session& session) const {
  return session.stage().subject().moves_at(session.player().step());
}
bool SubjectView::shows(const lesson::Session&, Index) const { return true; }
bool SubjectView::is_point(const lesson::Session&, Index) const { return true; }
bool SubjectView::shows_points(const lesson::Session&) const { return true; }
float SubjectView::reach_of(const Brush&, Index) const { return 0; }
bool SubjectView::bears_name(const lesson::Session&, Index) const { return true; }
std::string_view SubjectView::figures_are(const lesson::Session& session) const {
  return session.player().step() == session.player().steps() ? "Final result" : "Now";
}
float SubjectView::draw_panels(const Look&, lesson::Session&, ImVec2, float) const { return 0; }
bool SubjectView::fills_column(const lesson::Session&) const { return false; }
bool SubjectView::in_panels(const lesson::Figure&) const { return false; }
MarkWords SubjectView::mark_words(const lesson::Session&) const { return {}; }

}  // namespace snug::app
