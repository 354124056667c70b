#include "app/subjects/pair/view.hpp"

#include <algorithm>
#include <array>

#include "app/polytope.hpp"
#include "app/subjects/pair/axis_table.hpp"
#include "app/subjects/pair/draw.hpp"
#include "app/subjects/pair/frame_panel.hpp"
#include "app/subjects/pair/pair_table.hpp"
#include "app/subjects/pair/random_panel.hpp"
#include "lesson/subjects/pair/box_figures.hpp"
#include "lesson/subjects/pair/volumes.hpp"

namespace snug::app {
namespace {

constexpr double kRoomForAxis = 1.15;                              // room for the axis with its bars beside the boxes
constexpr float kRoomForIntervals = 64, kRoomForDifference = 200;  // pixels
constexpr float kUnderRuler = 320;  // the height that the boxes need below the second picture of an axis
// On a narrower stage the difference is above the volumes, if they have so much height below it. Between the two is
// room for the marks on the uppermost vertex.
constexpr float kStageForBoth = 560, kUnderDifference = 178, kAroundDifference = 34;

class PairView final : public SubjectView, private LocalFrame {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = pair_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_pair(brush, lit_or_shown(brush), seen_from(brush.session), in_frame_); }
  /// Not in a lesson whose file says where to look.
  [[nodiscard]] LocalFrame* local_frame(const lesson::Session& session) override {
    const lesson::StageView& wish = session.lesson().view;
    return wish.inset || wish.look_at ? nullptr : this;
  }
  [[nodiscard]] std::string_view button() const override { return "A's frame"; }
  [[nodiscard]] bool is_shown() const override { return in_frame_; }
  void show(bool on) override { in_frame_ = on; }
  [[nodiscard]] Point3 place_shown(const lesson::Session& session, const Point3& at) const override {
    return seen_from(session).at(at);
  }
  [[nodiscard]] Point3 place_meant(const lesson::Session& session, const Point3& shown) const override {
    return seen_from(session).back(shown);
  }
  [[nodiscard]] Point3 place_of(const lesson::Session& session, Index i) const override {
    return place_shown(session, session.stage().subject().at(i));
  }
  /// In its own frame A stands still: only what may be an answer is left of it. An exercise turns nothing.
  [[nodiscard]] bool shows(const lesson::Session& session, Index i) const override {
    if (!is_point(session, i)) return false;
    return !in_frame_ || answered_on_stage(session) || lesson::place_of(session.stage().subject().dim(), i).box == 1;
  }
  [[nodiscard]] bool is_point(const lesson::Session& session, Index i) const override {
    return !session.stage().conduct().decides ||
           lesson::place_of(session.stage().subject().dim(), i).kind != lesson::BoxHandle::Kind::kTurn;
  }

  /// In space the axis has a second picture, where there is room above the boxes.
  [[nodiscard]] float room_of_inset(const Look& look, const lesson::Session& session,
                                    const Rect& stage) const override {
    const bool tested = shown_.axis && !shown_.axis->skipped && !shown_.axis_asked;
    const bool wanted =
        session.stage().subject().dim() == 3 && tested && !session.lesson().view.inset && stage.width >= kStageForBoth;
    ruler_ = wanted && room_over_picture(look, stage, ruler_height(look), kUnderRuler) > 0;
    return ruler_ ? ruler_height(look) : 0;
  }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override {
    if (!ruler_) return {};
    const PairShown shown = lit_or_shown(brush);
    return shown.axis && !shown.axis->skipped ? draw_ruler(brush, *shown.axis, at) : Rect{};
  }

  void light(std::string_view mark) override { light_.mark = mark; }

  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const auto ball = [&](int box) {
      return ball_around(lesson::boxes_of(session.stage().subject()).boxes[box], session.stage().subject().dim());
    };
    const fit::Sphere3 both = ball_around(ball(0), ball(1));
    return {place_shown(session, both.center), kRoomForAxis * both.radius};
  }
  /// A close-up has a corner of the stage: beside it the boxes are framed as a ball.
  [[nodiscard]] std::optional<Outline> outline(const lesson::Session& session, const Camera& camera) const override {
    if (session.lesson().view.inset) return std::nullopt;
    const SeenFrom seen = seen_from(session);
    PairShown shown = shown_;
    seen.turn(shown);
    return outline_of(seen.boxes(lesson::boxes_of(session.stage().subject())), shown, camera);
  }
  /// A centre has its box's name, a knob its arc.
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override {
    return lesson::place_of(session.stage().subject().dim(), i).kind == lesson::BoxHandle::Kind::kCorner;
  }
  [[nodiscard]] bool writes_name(const lesson::Session& session, Index i) const override {
    return lesson::place_of(session.stage().subject().dim(), i).kind == lesson::BoxHandle::Kind::kCenter;
  }
  [[nodiscard]] bool names_answers_alone() const override { return true; }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    const float frames = draw_frame_panel(look, session, light_, at, width);
    const TableUnit unit = table_unit(lesson::boxes_of(session.stage().subject()));
    const float axes = frames + draw_axis_panel(look, session, unit, {at.x, at.y + frames}, width, &light_),
                gap = look.px(20);
    const float counts = draw_random_panel(look, session, {at.x, at.y + axes + gap}, width);
    return counts > 0 ? axes + gap + counts : axes;
  }
  [[nodiscard]] std::vector<PanelWords> panel_words(const lesson::Session& session) const override {
    std::vector<PanelWords> all;
    for (auto panel : {frames_in_words(session), random_in_words(session)})
      if (panel) all.push_back(std::move(*panel));
    return all;
  }
  /// The lit row of the table has them.
  [[nodiscard]] bool in_panels(const lesson::Figure& figure) const override {
    return lesson::is_along_axis(figure.key) || figure.key.starts_with(lesson::kRandomFigure);
  }
  /// Two boxes in space have fifteen axes.
  [[nodiscard]] bool fills_column(const lesson::Session& session) const override {
    return session.stage().subject().dim() == 3;
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "verdict", .best = "separating axis", .wrong = "wrong"};
  }

 private:
  [[nodiscard]] SeenFrom seen_from(const lesson::Session& session) const {
    if (!in_frame_) return {};
    const Obb<double, 3>& a = lesson::boxes_of(session.stage().subject()).boxes[0];
    return {a.axes, a.center};
  }

  /// What the step shows, or the row of the table that is pointed at.
  [[nodiscard]] PairShown lit_or_shown(const Brush& brush) const {
    PairShown shown = shown_;
    const int row = light_.row(brush.dim());
    if (row >= 0 && !answered_on_stage(brush.session)) show_row(shown, brush.session, row);
    return shown;
  }

  PairShown shown_;
  mutable bool ruler_ = false;  // whether the axis has its second picture
  bool in_frame_ = false;       // A's, instead of the world
  mutable AxisLight light_;     // the panel says which row is pointed at
};

/// Any two volumes and their test.
class VolumesView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override {
    shown_ = shown_at(session);
    shown_.spoken_of = named_now(session);
  }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override {
    draw_untested(brush, steps_shown(brush.session));
    draw_volumes(brush, steps_shown(brush.session));
  }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override {
    return draw_difference(brush, steps_shown(brush.session), at);
  }
  [[nodiscard]] float room_of_inset(const Look& look, const lesson::Session& session,
                                    const Rect& stage) const override {
    const float room =
        has_difference(session) && stage.width < kStageForBoth
            ? room_over_picture(look, stage, difference_height(look, stage) + kAroundDifference, kUnderDifference)
            : 0;
    above_ = room > 0;
    return room;
  }

  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const lesson::VolumePair& pair = pair_of(session);
    const fit::Sphere3 both =
        ball_around(ball_around(pair.held[0].volume, pair.dim), ball_around(pair.held[1].volume, pair.dim));
    if (!pair.any || pair.dim == 3) return {both.center, kRoomForAxis * both.radius};
    // The difference is at the left.
    return {both.center - Point3(0.25 * both.radius, 0, 0), 1.25 * kRoomForAxis * both.radius};
  }
  /// An interval test needs room for the axes beside the volumes, GJK for the difference. Separating axes may have any
  /// direction: they have no outline.
  [[nodiscard]] std::optional<Outline> outline(const lesson::Session& session, const Camera& camera) const override {
    const lesson::VolumePair& pair = pair_of(session);
    const std::string_view test = session.player().method(0)->name;
    if (test == "separating_axes") return std::nullopt;
    const auto range = [&](const Point3& way) {
      const auto reach = [&](const Point3& along) {
        double most = std::max(lesson::reach_along(pair.held[0], along), lesson::reach_along(pair.held[1], along));
        if (pair.dim == 2)  // in space the knobs leave the outline as the view turns
          for (const lesson::HeldVolume& held : pair.held)
            for (const lesson::Handle& handle : lesson::handles_of(held))
              most = std::max(most, along.dot(lesson::at_handle(held, handle)));
        return most;
      };
      return std::array{-reach(-way), reach(way)};
    };
    Outline seen = outline_within(camera, range);
    if (reports<query::SlabTested>(session))
      seen.left = pair.dim == 3 ? kRoomForIntervals : 0, seen.right = seen.below = kRoomForIntervals;
    if (has_difference(session) && !above_) seen.left = kRoomForDifference;
    return seen;
  }
  [[nodiscard]] bool working() const override { return working_; }
  [[nodiscard]] bool shows_points(const lesson::Session&) const override { return false; }
  /// What turns a volume, or changes its radius, does nothing where the volumes are given.
  [[nodiscard]] bool shows(const lesson::Session& session, Index i) const override { return is_point(session, i); }
  [[nodiscard]] bool is_point(const lesson::Session& session, Index i) const override {
    const lesson::Handle::Kind kind = subject_of(session).handle(i).kind;
    return !session.stage().conduct().decides || kind == lesson::Handle::Kind::kVertex ||
           kind == lesson::Handle::Kind::kCenter;
  }
  /// The table of all pairs needs room.
  [[nodiscard]] bool fills_column(const lesson::Session& session) const override { return pair_of(session).any; }
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override {
    return subject_of(session).handle(i).kind == lesson::Handle::Kind::kVertex;
  }
  [[nodiscard]] bool writes_name(const lesson::Session& session, Index i) const override {
    return subject_of(session).handle(i).kind == lesson::Handle::Kind::kCenter;
  }
  [[nodiscard]] bool names_answers_alone() const override { return true; }
  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    work(session);
    const float pairs = draw_pair_table(look, session, at, width), gap = pairs > 0 ? look.px(20) : 0;
    return pairs + gap + draw_axis_panel(look, session, {}, {at.x, at.y + pairs + gap}, width);
  }
  void work(lesson::Session& session) const override { working_ = work_on_pairs(session); }
  [[nodiscard]] std::vector<PanelWords> panel_words(const lesson::Session& session) const override {
    if (auto pairs = pairs_in_words(session)) return {*pairs};
    return {};
  }
  bool command(lesson::Session& session, std::string_view name) const override {
    return name == kMeasurePairs && measure_pairs(session);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "verdict", .best = "decides"};
  }

 private:
  static const lesson::VolumesSubject& subject_of(const lesson::Session& session) {
    return *lesson::as<lesson::VolumesSubject>(session.stage().subject());
  }
  static const lesson::VolumePair& pair_of(const lesson::Session& session) { return subject_of(session).pair(); }
  template <class Fact>
  static bool reports(const lesson::Session& session) {
    const lesson::PairSteps steps = lesson::pair_run(session.player().run(0)).trace();
    return std::any_of(steps.begin(), steps.end(),
                       [](const auto& one) { return std::holds_alternative<Fact>(one.step.fact); });
  }

  static bool has_difference(const lesson::Session& session) {
    return pair_of(session).dim == 2 && reports<query::NearestFound>(session);
  }

  Shown shown_;
  mutable bool working_ = false;  // on the costs of all pairs
  mutable bool above_ = false;    // whether the difference is above the volumes
};

}  // namespace

std::unique_ptr<SubjectView> volumes_view() { return std::make_unique<VolumesView>(); }
std::unique_ptr<SubjectView> pair_view() { return std::make_unique<PairView>(); }

}  // namespace snug::app
