#include "app/subjects/pair/view.hpp"

#include "app/polytope.hpp"
#include "app/subjects/pair/axis_table.hpp"
#include "app/subjects/pair/draw.hpp"

namespace snug::app {
namespace {

constexpr double kRoomForAxis = 1.15;  // beside the boxes stands the axis with its bars

class PairView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = pair_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_pair(brush, shown_); }

  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const auto ball = [&](int box) { return ball_around(session.subject().boxes()->boxes[box], session.dim()); };
    const fit::Sphere3 both = ball_around(ball(0), ball(1));
    return {both.center, kRoomForAxis * both.radius};
  }
  /// A centre bears its box's name, a knob its arc.
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override {
    return lesson::place_of(session.dim(), i).kind == lesson::Place::Kind::kCorner;
  }
  [[nodiscard]] bool names_answers_alone() const override { return true; }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    return draw_axis_panel(look, session, at, width);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "verdict", .best = "separating axis"};
  }

 private:
  PairShown shown_;
};

}  // namespace

std::unique_ptr<SubjectView> pair_view() { return std::make_unique<PairView>(); }

}  // namespace snug::app
