#include "app/subjects/tree/view.hpp"

#include "app/point_marks.hpp"
#include "app/subjects/tree/draw.hpp"

namespace snug::app {
namespace {

constexpr double kRoom = 1.12;  // around what is on the stage, for the nodes' outlines and the names

class TreeView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = tree_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_tree(brush, shown_); }

  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const lesson::Box2 boxes = stage_room(session), tree = tree_room(session);
    const lesson::Box2 all{boxes.min.cwiseMin(tree.min), boxes.max.cwiseMax(tree.max)};
    const lesson::Point2 middle = (all.min + all.max) / 2, half = (all.max - all.min) / 2;
    return {{middle[0], middle[1], 0}, kRoom * half.maxCoeff()};
  }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    const TreeShown shown = tree_shown_at(session);  // an edit in this frame has ended the run that was drawn
    if (shown.run->is_by_hand() && session.asked() == nullptr)
      return draw_hand_panel(look, session, shown, at, width, first_);
    return draw_tree_panel(look, shown, at, width);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session& session) const override {
    const bool query = lesson::tree_run(session.run(0)).is_query();
    return {.grew = "node made", .replaced = query ? "box met" : "rotation", .best = "left out or taken"};
  }

 private:
  TreeShown shown_;
  mutable Index first_ = kNoIndex;  // of two nodes that are to be merged by hand
};

}  // namespace

std::unique_ptr<SubjectView> tree_view() { return std::make_unique<TreeView>(); }

}  // namespace snug::app
