#include "app/subjects/scene/view.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "app/brush.hpp"
#include "app/subjects/scene/draw.hpp"
#include "app/subjects/scene/effects.hpp"
#include "app/subjects/scene/owner.hpp"
#include "app/subjects/scene/panel.hpp"
#include "app/subjects/scene/search.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;

class SceneView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override {
    shown_ = shown_at(session);
    shown_.spoken_of = named_now(session);
  }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override {
    draw_scene(brush);
    draw_effects(brush, *frame_of(brush.session));
    SubjectView::draw(brush);
  }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override {
    const Rect graph = draw_graph_inset(brush, at);
    graph_on_stage_ = graph.width > 0;
    if (lesson::set_of(brush.session).graph) return graph;  // such a lesson is not about the search
    const SceneFrame& frame = *frame_of(brush.session);
    const auto search = search_at(brush, frame);
    return search ? draw_sweep_inset(brush, frame, *search, at) : Rect{};
  }
  [[nodiscard]] float room_of_inset(const Look& look, const lesson::Session& session,
                                    const Rect& stage) const override {
    const float graph = graph_room(look, session, stage);
    return graph > 0 ? graph : sweep_room(look, session, stage);
  }
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override { return whole(session).ball; }
  /// A body of points is framed by its outline; other scenes are not, because the corners of their box are empty.
  [[nodiscard]] std::optional<Outline> outline(const lesson::Session& session, const Camera& camera) const override {
    if (!shows_points(session)) return std::nullopt;
    const Aabb<double, 3>& box = whole(session).box;
    return outline_within(camera, [&](const Point3& way) {
      const double middle = way.dot(box.min / 2 + box.max / 2), half = way.cwiseAbs().dot(box.max / 2 - box.min / 2);
      return std::array{middle - half, middle + half};
    });
  }
  [[nodiscard]] int axis_in_use(const lesson::Session& session) const override {
    return frame_of(session)->swept_along;
  }

  [[nodiscard]] Point3 place_of(const lesson::Session& session, Index i) const override;
  /// Not if there is a body at each point, which is drawn instead.
  [[nodiscard]] bool shows_points(const lesson::Session& session) const override {
    return owner_of(lesson::set_of(session)).of_points;
  }

  [[nodiscard]] bool names_over_bodies(const lesson::Session& session) const override {
    return owner_of(lesson::set_of(session)).at_points;
  }
  [[nodiscard]] float reach_of(const Brush& brush, Index i) const override {
    const Owner owner = owner_of(lesson::set_of(brush.session));
    if (!owner.at_points) return 0;
    const double reach = members_of(brush.session)[owner.body + i].shape.reach;
    return static_cast<float>(reach * brush.canvas.camera.scale_at(place_of(brush.session, i)));
  }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    return draw_scene_panel(look, session, at, width, !graph_on_stage_);
  }
  [[nodiscard]] bool fills_column(const lesson::Session& session) const override {
    return lesson::set_of(session).graph;
  }
  /// The figures of the funnel.
  [[nodiscard]] bool in_panels(const lesson::Figure& figure) const override { return figure.unit == "pairs"; }

 private:
  /// What the view has to show of all frames.
  struct Extent {
    std::uint64_t trace;
    const lesson::Method* beside;
    Aabb<double, 3> box;
    fit::Sphere3 ball;
  };
  [[nodiscard]] const Extent& whole(const lesson::Session& session) const;
  [[nodiscard]] Aabb<double, 3> box_around_run(const lesson::Session& session) const;

  Shown shown_;
  mutable bool graph_on_stage_ = true;    // in the last frame; else it is in the panel
  mutable std::optional<Extent> extent_;  // computed once for each run, over all bodies and frames
};

/// The point moves with the body that it belongs to, or with the body at it.
Point3 SceneView::place_of(const lesson::Session& session, Index i) const {
  const SceneFrame& frame = *frame_of(session);
  const Owner owner = owner_of(lesson::set_of(session));
  if (owner.of_points) {
    const SceneFrame::Placed& body = frame.bodies[owner.body];
    return body.position + body.rotation() * members_of(session)[owner.body].shape.corners[i];
  }
  return owner.at_points ? frame.bodies[owner.body + i].position : session.stage().subject().at(i);
}

/// How deep the view reaches: below the lowest fixed body half as far as the scene rises above it. A body that misses
/// the floor falls for as long as there are frames, and a view of all of its way would show the others as dots.
double depth_shown(const lesson::Session& session, double least, double greatest) {
  const std::span<const scene::Member> members = members_of(session);
  const SceneFrame* frame = frame_of(session);
  double floor = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; frame != nullptr && i < members.size(); ++i)
    if (members[i].fixed) floor = std::min(floor, frame->bodies[i].position.y());
  return floor <= greatest ? std::max(least, floor - (greatest - floor) / 2) : least;
}

/// Around the scene in all of its frames.
Aabb<double, 3> SceneView::box_around_run(const lesson::Session& session) const {
  auto [least, greatest] = lesson::recorded_scene(session, 0)->bodies;
  least.y() = depth_shown(session, least.y(), greatest.y());
  for (const int slot : {0, 1})
    if (const auto* run = lesson::recorded_scene(session, slot); run != nullptr && shows_points(session))
      least = least.cwiseMin(run->volumes.min), greatest = greatest.cwiseMax(run->volumes.max);
  return {least, greatest};
}

const SceneView::Extent& SceneView::whole(const lesson::Session& session) const {
  if (extent_ && session.player().view().in_hand)
    return *extent_;  // that of all frames, which wait until the hand rests
  const std::uint64_t trace = session.player().trace_hash();
  const lesson::Method* beside = session.player().method(1);
  if (extent_ && extent_->trace == trace && extent_->beside == beside) return *extent_;
  const Aabb<double, 3> box = box_around_run(session);
  const Point3 size = box.max - box.min;
  // The corners of the box around bodies are empty in nearly every frame, so the ball leaves them out.
  const double radius = 0.5 * (shows_points(session) ? size.norm() : size.maxCoeff());
  return extent_.emplace(Extent{trace, beside, box, {box.min / 2 + box.max / 2, radius}});
}

}  // namespace

std::unique_ptr<SubjectView> scene_view() { return std::make_unique<SceneView>(); }

}  // namespace snug::app
