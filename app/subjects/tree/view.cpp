#include "app/subjects/tree/view.hpp"

#include "app/point_marks.hpp"
#include "app/subjects/tree/draw.hpp"

namespace snug::app {
namespace {

constexpr double kRoom = 1.12;         // around what is on the stage, for the nodes' outlines and the names
constexpr float kWideForTree = 1.75f;  // width over height from which the tree stands beside the boxes

class TreeView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = tree_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_tree(brush, shown_, place_); }

  bool take_room(const Rect& stage, double shape) override {
    const TreePlace place = stage.width > kWideForTree * stage.height ? TreePlace::kBeside : TreePlace::kBelow;
    shape = place == TreePlace::kBeside ? std::max(shape, 1.0) : 1;
    const bool same = place == place_ && shape == shape_;
    place_ = place, shape_ = shape;
    return !same;
  }
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const lesson::Box2 boxes = stage_room(session), tree = tree_room(session, place_);
    const lesson::Box2 all{boxes.min.cwiseMin(tree.min), boxes.max.cwiseMax(tree.max)};
    const lesson::Point2 middle = (all.min + all.max) / 2, half = (all.max - all.min) / 2;
    return {{middle[0], middle[1], 0}, kRoom * std::max(half[0] / shape_, half[1])};
  }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    float y = draw_hands(look, session, at, width);
    const float gap = y > 0 ? 12.0f : 0;
    const float high = draw_tree_panel(look, tree_shown_at(session), {at.x, at.y + y + gap}, width);
    y += high > 0 ? gap + high : 0;
    work(session);
    if (!shows_times(session)) return y;
    const float above = y > 0 ? 16.0f : 0;
    return y + above + draw_times_panel(look, session, times_, {at.x, at.y + y + above}, width);
  }
  /// A run by hand ends where the next choice is due.
  [[nodiscard]] std::string_view figures_are(const lesson::Session& session) const override {
    const lesson::TreeRun& run = lesson::tree_run(session.player().run(0));
    if (session.player().step() < session.player().steps()) return SubjectView::figures_are(session);
    if (run.is_steered() && run.undecided() != kNoIndex) return "So far: the next choice is yours";
    if (run.is_by_hand() && run.forest(run.steps()).roots.size() > 1) return "So far: the next merger is yours";
    return SubjectView::figures_are(session);
  }
  /// What is chosen by hand must be in view, and so must the times.
  [[nodiscard]] bool fills_column(const lesson::Session& session) const override {
    const lesson::TreeRun& run = lesson::tree_run(session.player().run(0));
    return run.is_by_hand() || run.is_steered() || shows_times(session);
  }
  void work(lesson::Session& session) const override {
    if (shows_times(session)) times_.measure(session);
    else times_.pause();
  }
  [[nodiscard]] std::vector<PanelWords> panel_words(const lesson::Session& session) const override {
    if (!shows_times(session)) return {};
    return {times_in_words(session, times_)};
  }
  [[nodiscard]] bool working() const override { return times_.working(); }
  [[nodiscard]] MarkWords mark_words(const lesson::Session& session) const override {
    const lesson::TreeRun& run = lesson::tree_run(session.player().run(0));
    if (run.pairing() != nullptr) return {.replaced = "boxes overlap", .best = "left out"};
    return {.grew = "node made", .replaced = run.is_query() ? "box met" : "rotation", .best = "left out or taken"};
  }
  /// A point query has no second place.
  [[nodiscard]] bool shows(const lesson::Session& session, Index i) const override {
    const auto& subject = *lesson::as<lesson::TreeSubject>(session.stage().subject());
    if (!subject.stage().query || i + 1 < subject.size()) return true;
    const auto reads = [&](int slot) {
      const lesson::Method* method = session.player().method(slot);
      return method != nullptr && lesson::shape_of_query(method->name) != lesson::QueryShape::kPoint;
    };
    return reads(0) || reads(1);
  }
  [[nodiscard]] bool is_point(const lesson::Session& session, Index i) const override { return shows(session, i); }
  /// Leaves have the names of their boxes.
  [[nodiscard]] bool needs_name(const lesson::Session& session, Index i) const override {
    return i < lesson::as<lesson::TreeSubject>(session.stage().subject())->boxes();
  }
  /// The places of a query have their names in any crowd: the text tells to drag them.
  void name_marks(PointNames& names) const override {
    const lesson::Session& session = names.brush.session;
    const auto& subject = *lesson::as<lesson::TreeSubject>(session.stage().subject());
    if (subject.stage().query && !answered_on_stage(session)) {
      for (Index i = subject.boxes(); i < subject.size(); ++i)
        if (shows(session, i))
          names.name(i, session.stage().subject().name_of(i), names.brush.p.ink, Face::kSemiBold, 9, 13);
    }
    SubjectView::name_marks(names);
  }

 private:
  /// What is done by hand. Returns the height.
  float draw_hands(const Look& look, lesson::Session& session, ImVec2 at, float width) const {
    const TreeShown shown = tree_shown_at(session);  // an edit in this frame has ended the run that was drawn
    if (session.conversation().asked() != nullptr) return 0;
    if (shown.run->is_by_hand()) return draw_hand_panel(look, session, shown, at, width, first_);
    return shown.run->is_steered() ? draw_order_panel(look, session, shown, at, width) : 0;
  }

  TreeShown shown_;
  TreePlace place_ = TreePlace::kBelow;
  double shape_ = 1;  // of the room for both, width over height; 1 where the tree is below
  mutable TreeTimes times_;
  mutable Index first_ = kNoIndex;  // of two nodes that are to be merged by hand
};

}  // namespace

std::unique_ptr<SubjectView> tree_view() { return std::make_unique<TreeView>(); }

}  // namespace snug::app
