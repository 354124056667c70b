#include "app/subjects/cloud/view.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "app/marks.hpp"
#include "app/polytope.hpp"
#include "app/subjects/cloud/call_panel.hpp"
#include "app/subjects/cloud/call_tree_view.hpp"
#include "app/subjects/cloud/census_panel.hpp"
#include "app/subjects/cloud/certificate_panel.hpp"
#include "app/subjects/cloud/draw.hpp"
#include "app/subjects/cloud/hand.hpp"
#include "app/subjects/cloud/matrix_inset.hpp"
#include "app/subjects/cloud/products_panel.hpp"
#include "app/subjects/cloud/ulp_inset.hpp"
#include "lesson/subjects/cloud/certificate_figures.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

// The tree of calls is in the stage's upper left corner: the points are framed with room for it there.
constexpr double kRoomForTree = 1.4, kAsideOfTree = -0.38, kBelowTree = 0.12;  // times the radius around the points

constexpr double kNearVertex = 1.12;  // by how much a box's nearest vertex looks larger than its middle

std::string_view button_for(const lesson::Session& session) {
  const auto* cloud = lesson::as<lesson::CloudSubject>(session.stage().subject());
  const lesson::Method* than = cloud != nullptr ? cloud->compared_with() : nullptr;
  if (cloud != nullptr && (than == nullptr || is_itself(*than, session))) return {};
  if (than != nullptr && than->volume == "hull") return "Hull";
  if (than == nullptr || (than->exact && than->volume == session.lesson().volume)) return "Smallest";
  return "Reference";
}

bool leaves_points_outside(const lesson::Session& session) {
  const fit::Recording* run = lesson::recording_of(session, 0);
  return run != nullptr && !run->certificate.contains;
}

/// Widened to the points that a naive run leaves outside its volume.
fit::Sphere3 with_left_outside(fit::Sphere3 all, const lesson::Session& session) {
  if (!leaves_points_outside(session)) return all;
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    all.radius = std::max(all.radius, (session.stage().subject().at(i) - all.center).norm());
  return all;
}

/// The results and what the step shows; none if one of them is a sphere.
std::vector<const fit::Volume3*> volumes_at_stake(const lesson::Session& session, const CloudShown& shown) {
  std::vector<const fit::Volume3*> volumes;
  for (const int slot : {0, 1})
    if (session.player().method(slot) != nullptr)
      volumes.push_back(session.player().run(slot).volume(session.player().run(slot).steps()));
  for (const auto* one : {&shown.volume, &shown.rival, &shown.optimum})
    if (*one) volumes.push_back(&**one);
  const auto is_round = [](const fit::Volume3* one) {
    return one == nullptr || std::holds_alternative<fit::Sphere3>(*one);
  };
  return std::any_of(volumes.begin(), volumes.end(), is_round) ? std::vector<const fit::Volume3*>() : volumes;
}

/// How far the volumes, points outside and what is set by hand reach along a direction.
double reach_of_all(const lesson::Session& session, std::span<const fit::Volume3* const> volumes, const Point3& way) {
  if (session.stage().subject().dim() == 2 && way.head<2>().isZero()) return 0;  // the plane has no depth
  double most = -std::numeric_limits<double>::infinity();
  for (const fit::Volume3* one : volumes)
    most = std::max(most, way.dot(farthest_in(*one, way, session.stage().subject().dim())));
  for (Index i = leaves_points_outside(session) ? 0 : lesson::count_of(session.stage().subject());
       i < session.stage().subject().size(); ++i)
    if (shows_handle(session, i)) most = std::max(most, way.dot(session.stage().subject().at(i)));
  return most;
}

class CloudView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool want_optimum) override {
    shown_ = cloud_shown_at(session, want_optimum);
    button_ = button_for(session);
  }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override {
    draw_cloud(brush, shown_);
    draw_hand(brush);
    draw_image(brush);
  }
  void draw_marks(Brush& brush) const override {
    mark_cloud(brush, shown_);
    if (pointed_ == kNoIndex || !shown_.certificate || pointed_ >= brush.session.stage().subject().size()) return;
    ring(brush.list, brush.at(brush.point(pointed_)), 14 * brush.p.mark, brush.p.current, brush.stroke());
  }
  void name_marks(PointNames& names) const override { name_cloud(names, shown_); }
  [[nodiscard]] Rect draw_inset(Brush& brush, ImVec2 at) const override {
    Rect inset = draw_call_tree(brush, at);
    if (!(inset.width > 0)) inset = draw_matrix_inset(brush, at);
    return inset.width > 0 ? inset : draw_ulp_inset(brush, shown_, at);
  }
  [[nodiscard]] float room_of_inset(const Look& look, const lesson::Session& session,
                                    const Rect& stage) const override {
    return matrix_room(look, session, stage);
  }
  [[nodiscard]] fit::Sphere3 extent(const lesson::Session& session) override {
    fit::Sphere3 all = with_hand(session, with_left_outside(SubjectView::extent(session), session));
    if (!shows_calls(session)) return all;
    all.center += Point3(kAsideOfTree, kBelowTree, 0) * all.radius;
    all.radius *= kRoomForTree;
    return all;
  }
  /// Not of spheres, which look alike from everywhere, nor beside the tree of calls.
  [[nodiscard]] std::optional<Outline> outline(const lesson::Session& session, const Camera& camera) const override {
    const std::vector<const fit::Volume3*> volumes = volumes_at_stake(session, shown_);
    if (volumes.empty() || shows_calls(session)) return std::nullopt;
    Outline seen = outline_within(camera, [&](const Point3& way) {
      return std::array{-reach_of_all(session, volumes, -way), reach_of_all(session, volumes, way)};
    });
    seen.nearer = kNearVertex;
    return seen;
  }
  [[nodiscard]] bool shows(const lesson::Session& session, Index i) const override { return shows_handle(session, i); }
  [[nodiscard]] bool is_point(const lesson::Session& session, Index i) const override {
    return i < lesson::count_of(session.stage().subject());
  }
  /// What is set by hand is named where it is selected or pointed at.
  [[nodiscard]] bool bears_name(const lesson::Session& session, Index i) const override { return is_point(session, i); }
  [[nodiscard]] std::string_view optimum_button() const override { return button_; }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    // At the end no call is open, and the certificate stands in the list's place.
    float height = draw_certificate_panel(look, session, shown_, at, width, pointed_);
    if (height == 0) height = draw_call_panel(look, session, at, width);
    if (height == 0) height = draw_call_stack(look, session, at, width);
    if (height == 0) height = draw_products_panel(look, session, at, width);
    return height > 0 ? height : draw_census_panel(look, session, at, width);
  }
  [[nodiscard]] bool in_panels(const lesson::Figure& figure) const override {
    return shown_.certificate && lesson::is_of_support(figure.key);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session& session) const override {
    MarkWords words;
    if (session.player().method(0)->volume == "sphere")
      words.grew = lesson::ball_word(session.stage().subject().dim()) + std::string(" grew");
    return words;
  }

 private:
  CloudShown shown_;
  std::string_view button_;
  mutable Index pointed_ = kNoIndex;  // the point whose row of the certificate the pointer is on
};

}  // namespace

std::unique_ptr<SubjectView> cloud_view() { return std::make_unique<CloudView>(); }

}  // namespace snug::app
