#include "app/subjects/frustum/view.hpp"

#include "app/polytope.hpp"
#include "app/subjects/frustum/draw.hpp"
#include "app/subjects/frustum/planes_panel.hpp"
#include "app/subjects/frustum/survey_panel.hpp"

namespace snug::app {
namespace {

class FrustumView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = frustum_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_frustum(brush, shown_); }
  void draw_marks(Brush& brush) const override {
    SubjectView::draw_marks(brush);
    mark_frustum(brush, shown_);
  }
  void name_marks(PointNames& names) const override { name_frustum(names, shown_); }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override { return draw_from_camera(brush, shown_, at); }

  /// While a vertex of the box is to be tapped, the box and the plane's normal; else all.
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const lesson::BoxPair& pair = lesson::boxes_of(session.stage().subject());
    const auto ball = [&](int box) { return ball_around(pair.boxes[box], session.stage().subject().dim()); };
    const lesson::Asked* asked = session.conversation().asked();
    if (asked != nullptr && asked->on_stage && session.stage().subject().dim() == 3 && shown_.plane_at >= 0) {
      const auto [foot, normal] = normal_arrow(pair, shown_);
      return ball_around(ball_around(ball(0), {foot, 0}), {foot + normal, 0});
    }
    return ball_around(ball_around({lesson::camera_of(pair).position, 0}, ball(1)), ball(0));
  }
  /// A centre has its box's name and a knob its arc; the frustum's vertices need no names.
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override {
    const lesson::BoxHandle place = lesson::place_of(lesson::boxes_of(session.stage().subject()), i);
    return place.kind == lesson::BoxHandle::Kind::kCorner && place.box == 0;
  }
  [[nodiscard]] bool writes_name(const lesson::Session& session, Index i) const override {
    return lesson::place_of(lesson::boxes_of(session.stage().subject()), i).kind == lesson::BoxHandle::Kind::kCenter;
  }
  [[nodiscard]] bool names_answers_alone() const override { return true; }
  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    work(session);
    const float planes = draw_planes_panel(look, session, shown_, at, width);
    return planes + draw_survey_panel(look, session, {at.x, at.y + planes}, width);
  }
  void work(lesson::Session& session) const override { surveying_ = work_on_survey(session); }
  [[nodiscard]] std::vector<PanelWords> panel_words(const lesson::Session& session) const override {
    std::vector<PanelWords> panels;
    for (auto& panel : {planes_in_words(session), survey_in_words(session)})
      if (panel) panels.push_back(*panel);
    return panels;
  }
  bool command(lesson::Session& session, std::string_view name) const override {
    return name == kSurveyCommand && start_survey(session);
  }
  [[nodiscard]] bool working() const override { return surveying_; }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "verdict", .best = "entirely outside", .wrong = "wrong"};
  }

 private:
  FrustumShown shown_;
  mutable bool surveying_ = false;
};

}  // namespace

std::unique_ptr<SubjectView> frustum_view() { return std::make_unique<FrustumView>(); }

}  // namespace snug::app
