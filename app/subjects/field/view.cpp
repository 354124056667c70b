#include "app/subjects/field/view.hpp"

#include "app/point_marks.hpp"
#include "app/polytope.hpp"
#include "app/subjects/field/draw.hpp"

namespace snug::app {
namespace {

class FieldView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override {
    shown_ = shown_at(session);
    shown_.spoken_of.clear();
  }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override {
    marks_.show(brush);
    draw_field(brush);
  }
  void name_marks(PointNames& names) const override {
    for (Index i = 0; i < names.brush.session.stage().subject().size(); ++i) names.on_plate(i);
  }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override { return draw_camera_image(brush, at); }

  /// The field, and the camera if it is outside.
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const auto& stage = lesson::as<lesson::FieldSubject>(session.stage().subject())->stage();
    const fit::Sphere3 field{{0, stage.recipe.height / 2, 0}, 1.08 * stage.recipe.reach};
    return ball_around(field, fit::Sphere3{stage.now.position, 0});
  }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    work(session);
    return draw_field_panel(look, session, costs_, at, width);
  }
  [[nodiscard]] bool fills_column(const lesson::Session&) const override { return true; }
  void work(lesson::Session& session) const override { costs_.measure(session); }
  [[nodiscard]] std::vector<PanelWords> panel_words(const lesson::Session& session) const override {
    return {field_in_words(session, costs_)};
  }
  [[nodiscard]] bool working() const override { return costs_.working(); }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "the end", .best = "objects decided"};
  }

 private:
  Shown shown_;
  mutable FieldMarks marks_;
  mutable FieldCosts costs_;
};

}  // namespace

std::unique_ptr<SubjectView> field_view() { return std::make_unique<FieldView>(); }

}  // namespace snug::app
