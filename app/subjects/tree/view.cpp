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

  float draw_panels(const Look& look, lesson::Session&, ImVec2 at, float width) const override {
    return shown_.run != nullptr ? draw_tree_panel(look, shown_, at, width) : 0;
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    const bool query = shown_.run != nullptr && shown_.run->is_query();
    return {.grew = "node made", .replaced = query ? "box met" : "rotation", .best = "left out or taken"};
  }

 private:
  TreeShown shown_;
};

}  // namespace

std::unique_ptr<SubjectView> tree_view() { return std::make_unique<TreeView>(); }

}  // namespace snug::app
