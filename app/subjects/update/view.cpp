#include "app/subjects/update/view.hpp"

#include <algorithm>

#include "app/subjects/update/draw.hpp"
#include "app/subjects/update/turn_panel.hpp"

namespace snug::app {
namespace {

// Room around the sphere about the pivot, for rulers and knobs; and around the volume, for its name.
constexpr double kRoomInPlane = 1.3, kRoomInSpace = 1.5, kRoomForVolume = 1.12;

class UpdateView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool) override { shown_ = update_shown_at(session); }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_update_of_body(brush, shown_); }
  void draw_marks(Brush& brush) const override {
    SubjectView::draw_marks(brush);
    mark_climb(brush, shown_);
  }
  void name_marks(PointNames& names) const override {
    name_climb(names, shown_);
    for (const Index i : shown_.spoken_of) names.plain(i);
    SubjectView::name_marks(names);
  }
  /// About the pivot, so that the picture stands still while the body rotates.
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    const lesson::UpdateSubject& body = lesson::body_of(session.stage().subject());
    const Point3& pivot = body.pose().translation;
    double radius = (session.stage().subject().dim() == 2 ? kRoomInPlane : kRoomInSpace) * body.reach();
    for (const int slot : {0, 1}) {
      if (session.player().method(slot) == nullptr) continue;
      const fit::Volume3* volume = session.player().run(slot).volume(session.player().run(slot).steps());
      for (int axis = 0; volume != nullptr && axis < session.stage().subject().dim(); ++axis)
        for (const Point3& way : {Point3(Point3::Unit(axis)), Point3(-Point3::Unit(axis))})
          radius = std::max(radius, kRoomForVolume *
                                        way.dot(farthest_in(*volume, way, session.stage().subject().dim()) - pivot));
    }
    return {pivot, radius};
  }
  [[nodiscard]] bool is_point(const lesson::Session& session, Index i) const override {
    return i < lesson::count_of(session.stage().subject());
  }
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override { return is_point(session, i); }
  [[nodiscard]] bool names_answers_alone() const override { return true; }
  [[nodiscard]] int axis_in_use(const lesson::Session&) const override {
    return shown_.climb && shown_.run->strategy().k == 0 ? shown_.climb->axis : -1;
  }
  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    return draw_turn_panel(look, session, at, width);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session&) const override {
    return {.replaced = "volume updated", .best = "bound found"};
  }

 private:
  UpdateShown shown_;
};

}  // namespace

std::unique_ptr<SubjectView> update_view() { return std::make_unique<UpdateView>(); }

}  // namespace snug::app
